# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Arguments of every public function: numbers that are not finite, file names of every kind."""
import inspect
import os
import pathlib
import re
from decimal import Decimal

import numpy as np
import pytest

import gonio
from test_interface import callables


def parameters(pattern):
    """(function's name, function, parameter) of the public functions whose parameter has a type that matches."""
    return [(name, function, parameter) for name, function in callables()
            for parameter in inspect.signature(function).parameters.values() if re.search(pattern, str(parameter.annotation))]


def call(function, parameter, value):
    """The function with one argument given, the others required ones None."""
    required = {other.name: None for other in inspect.signature(function).parameters.values()
                if other.default is other.empty and other.kind is not other.VAR_KEYWORD}
    keywords = {"roughness": value} if parameter.kind is parameter.VAR_KEYWORD else {parameter.name: value}
    return function(**{**required, **keywords})


def with_number(parameter, number):
    """A value of the parameter's type with the number in it."""
    text = str(parameter.annotation)
    if "Mapping" in text:
        return {"roughness": number}
    if "Box" in text:
        return [((0, 1), (0, number), (0, 3))]
    return [1, number] if "Sequence" in text or "tuple" in text else number


NUMERIC = parameters(r"\b(float|int|Value|Box)\b")


@pytest.mark.parametrize("name, function, parameter", NUMERIC, ids=[f"{name}-{parameter.name}" for name, _, parameter in NUMERIC])
def test_numbers_are_finite(name, function, parameter):
    for number in (np.nan, np.inf, -np.inf, np.float32("nan"), np.float64("nan"), np.array(np.nan), Decimal("nan")):
        with pytest.raises(gonio.Error, match="expected a? ?finite number") as error:
            call(function, parameter, with_number(parameter, number))
        named = "roughness" if "Value" in str(parameter.annotation) else parameter.name
        assert str(error.value).startswith(f"{named}: found "), error.value


def test_there_are_numbers():
    names = {f"{name}.{parameter.name}" for name, _, parameter in NUMERIC}
    assert len(names) > 60
    assert names >= {"render.rotation", "fit.max_polar_angle", "edit.set", "Model.material.parameters", "plan.forbidden",
                     "Interpolation.blend.weights", "factorize.deviation_nodes", "export.grid"}


def test_nan_in_an_array_of_nodes():
    nodes = np.linspace(0, 2, 90)
    nodes[3] = np.nan
    with pytest.raises(gonio.Error, match="^deviation_nodes: found nan"):
        gonio.factorize(None, deviation_nodes=nodes)


def test_arrays_are_finite(chrome):
    """Each argument that is an array: its own check may leave out invalid cells."""
    bad, unit = [[np.nan, 0, 1]], [[0.0, 0, 1]]
    factors = gonio.factorize(chrome, terms=1)
    basis = gonio.bundled_basis()
    values = chrome.values.copy()
    values[tuple(np.argwhere(chrome.valid)[0])] = np.nan
    calls = {
        "Material.evaluate.wi": lambda: chrome.evaluate(bad, unit),
        "Material.evaluate.wo": lambda: chrome.evaluate(unit, bad),
        "Material.sample.wo": lambda: chrome.sample(bad, unit),
        "Material.sample.u": lambda: chrome.sample(unit, bad),
        "Material.pdf.wi": lambda: chrome.pdf(bad, unit),
        "Material.pdf.wo": lambda: chrome.pdf(unit, bad),
        "Material.albedo.theta": lambda: chrome.albedo([0.1, np.nan]),
        "from_table.values": lambda: gonio.from_table(values, chrome.valid),
        "Factors.with_curves.f1": lambda: factors.with_curves(f1=factors.f1 * np.nan),
        "Factors.with_curves.f2": lambda: factors.with_curves(f2=factors.f2 * np.nan),
        "Factors.with_curves.f3": lambda: factors.with_curves(f3=factors.f3 * np.nan),
        "Basis.decode.code": lambda: basis.decode(np.full((3, 2), np.nan)),
        "SeparatedBasis.decode.code": lambda: gonio.SeparatedBasis(basis, basis).decode((np.full((3, 2), np.nan), np.zeros((3, 2)))),
        "Plan.wi": lambda: gonio.Plan(bad, unit),
        "Plan.wo": lambda: gonio.Plan(unit, bad),
        "to_coordinates.wi": lambda: gonio.to_coordinates("half-difference", bad, unit),
        "to_coordinates.wo": lambda: gonio.to_coordinates("half-difference", unit, bad),
        "from_coordinates.values": lambda: gonio.from_coordinates("half-difference", bad),
        "neural_brdf.weights": lambda: gonio.neural_brdf(np.full(675, np.nan)),
    }
    arrays = {f"{name}.{parameter.name}" for name, _, parameter in parameters("ArrayLike")}
    assert arrays - {"from_table.valid"} == set(calls)
    for name, refused in calls.items():
        with pytest.raises(gonio.Error) as error:
            refused()
        assert "nan" in str(error.value) or "finite" in str(error.value) or "[0, 1)" in str(error.value), (name, error.value)


def test_readings_are_finite(chrome, tmp_path):
    basis = gonio.bundled_basis()
    plan = gonio.plan(3, basis)
    factors = gonio.plan_factors("half-out", angles=5, distances=5)
    for directions, use in ((plan, lambda readings: gonio.reconstruct(plan, readings, basis)),
                            (plan, lambda readings: plan.save_values(readings, tmp_path / "values.csv")),
                            (factors, lambda readings: gonio.predict_from_factors(factors, readings)),
                            (factors, lambda readings: factors.save_readings(readings, tmp_path / "readings.csv"))):
        good = gonio.measure(chrome, directions, noise=0.1)
        for values, noise in ((good.values * np.nan, good.noise), (good.values, good.noise * np.nan)):
            with pytest.raises(gonio.Error, match=r"sample \d+: found a [a-z ]* of nan, expected a number"):
                use(gonio.Readings(values, noise))
        for values, noise in ((good.values[:1], good.noise[:1]), (good.values, good.noise[:1])):
            with pytest.raises(gonio.Error, match="values"):
                use(gonio.Readings(values, noise))
    assert list(tmp_path.iterdir()) == []


PATHS = parameters("PathLike")


@pytest.mark.parametrize("name, function, parameter", PATHS, ids=[f"{name}-{parameter.name}" for name, _, parameter in PATHS])
def test_a_null_character_does_not_end_a_path(name, function, parameter):
    for path in ("base.bsdf\0.x", b"base.bsdf\0.x", pathlib.Path("base.bsdf\0.x")):
        with pytest.raises(ValueError, match="embedded null byte"):
            call(function, parameter, [path] if "Sequence" in parameter.annotation else path)


def test_there_are_paths():
    assert len(PATHS) > 25


class Named:
    """An os.PathLike."""

    def __init__(self, path):
        self.path = path

    def __fspath__(self):
        return self.path


def forms(path):
    """A path of bytes in every type that Python's own open() takes."""
    text = os.fsdecode(path)
    return text, path, pathlib.Path(text), Named(text), Named(path)


def test_a_path_that_is_not_utf8_names_the_same_file(chrome, tmp_path):
    file = os.fsencode(tmp_path) + b"/caf\xe9 \xff.binary"
    assert chrome.save(os.fsdecode(file))["losses"] == []
    assert os.listdir(os.fsencode(tmp_path)) == [b"caf\xe9 \xff.binary"]
    for path in forms(file):
        material = gonio.open(path)
        np.testing.assert_array_equal(material.values, chrome.values)
        assert os.fsencode(material.path) == file
        assert material.name == "caf\\xe9 \\xff"
        material.info()
    written = os.fsencode(tmp_path) + b"/\xe9.pdv"
    for path in forms(written):
        gonio.factorize(material, terms=1).save(path)
        assert gonio.open_factors(path).terms == 1
        os.remove(path)
    files = gonio.export(material, os.fsencode(tmp_path) + b"/out \xe9", "merl", overwrite=True).files
    assert [os.path.exists(name) for name in files] == [True]


def test_errors_show_paths_that_are_not_utf8(tmp_path):
    for path in forms(os.fsencode(tmp_path) + b"/no \xe9.binary"):
        with pytest.raises(gonio.Error, match=r"no \\xe9\.binary: "):
            gonio.open(path)


def test_names_are_text(chrome):
    for call_with in (lambda name: gonio.from_table(chrome.values, name=name), lambda name: gonio.fit(chrome, name),
                      lambda name: gonio.learn_basis(excluded=["x", name])):
        with pytest.raises(gonio.Error, match=r"found 'caf\\udce9', expected text without surrogates"):
            call_with("caf\udce9")
    assert gonio.from_table(chrome.values, name="a\0b 金").name == "a\0b 金"


def test_what_is_no_path_is_a_type_error():
    for path in (3, None, ["a"]):
        with pytest.raises(TypeError):
            gonio.open(path)


def test_wrong_calls_name_the_function(chrome):
    with pytest.raises(TypeError, match=r"fit\(\) missing 1 required positional argument: 'material'"):
        gonio.fit()
    with pytest.raises(TypeError, match=r"fit\(\) got an unexpected keyword argument 'gama'"):
        gonio.fit(chrome, gama=2)
