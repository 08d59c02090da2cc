# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Every public name has a docstring and types, each argument is documented, and the page of the reference has them all."""
import ast
import importlib.util
import inspect
import os
import pathlib
import re
import subprocess
import sys
import textwrap
import typing

import numpy as np
import pytest

import gonio

ROOT = pathlib.Path(__file__).resolve().parents[2]


def members(owner):
    """Public functions and properties of a class."""
    for name, member in vars(owner).items():
        if not name.startswith("_") and (inspect.isfunction(member) or isinstance(member, property)):
            yield name, member


def callables():
    for name in gonio.__all__:
        item = getattr(gonio, name)
        if inspect.isfunction(item):
            yield name, item
        elif item is not gonio.Error:
            yield from ((f"{name}.{member}", function) for member, function in members(item) if inspect.isfunction(function))
            if "__init__" in vars(item) and "not directly" not in (item.__init__.__doc__ or "not directly"):
                yield name, item.__init__


def test_every_public_name_is_documented():
    for name in gonio.__all__:
        item = getattr(gonio, name)
        assert inspect.getdoc(item), name
        if inspect.isclass(item) and item is not gonio.Error:
            for member, value in members(item):
                assert inspect.getdoc(value), f"{name}.{member}"
    public = {name for name in vars(gonio) if not name.startswith("_")}
    assert public == set(gonio.__all__)


@pytest.mark.parametrize("name, function", list(callables()), ids=lambda value: value if isinstance(value, str) else "")
def test_every_argument_has_a_type(name, function):
    signature = inspect.signature(function)
    hints = typing.get_type_hints(function)
    for parameter in signature.parameters.values():
        assert parameter.name == "self" or parameter.name in hints, f"{name}: {parameter.name}"
    assert "return" in hints, name


@pytest.mark.parametrize("name, function", list(callables()), ids=lambda value: value if isinstance(value, str) else "")
def test_documented_arguments_are_those_of_the_signature(name, function):
    text = inspect.getdoc(function)
    if "Args:" not in text:
        return
    block = text.split("Args:\n", 1)[1].split("\n\n", 1)[0]
    documented = [line.strip().split(":", 1)[0] for line in block.splitlines() if line.startswith("    ") and line[4] != " "]
    actual = [parameter for parameter in inspect.signature(function).parameters if parameter != "self"]
    assert documented == actual, name


def test_fields_of_results_are_documented():
    reference = load_script()
    for name in gonio.__all__:
        item = getattr(gonio, name)
        if hasattr(item, "__dataclass_fields__"):
            assert set(reference.fields_of(item)) == set(item.__dataclass_fields__), name


def load_script():
    spec = importlib.util.spec_from_file_location("python_reference", ROOT / "scripts" / "python_reference.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_reference_page_does_not_need_the_module():
    script = ROOT / "scripts" / "python_reference.py"
    without = {**os.environ, "PYTHONPATH": ""}
    printed = subprocess.run([sys.executable, "-B", script], env=without, capture_output=True, check=True).stdout.decode()
    assert printed == load_script().page()
    for name in gonio.__all__:
        assert name == "Error" or f"`gonio.{name}(" in printed or f"class `{name}`" in printed, name


def calls_of(text):
    """The calls of gonio.NAME(...) in the code spans of a page."""
    for span in re.findall(r"`([^`]+)`", text):
        for part in span.split("; "):
            if "gonio." not in part or "goniotool" in part:
                continue
            for node in ast.walk(ast.parse(part)):
                if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) \
                        and isinstance(node.func.value, ast.Name) and node.func.value.id == "gonio":
                    yield node


def test_the_calls_of_the_systems_page_exist():
    calls = list(calls_of((ROOT / "docs" / "systems.md").read_text()))
    assert len(calls) > 30
    for call in calls:
        assert call.func.attr in gonio.__all__, ast.unparse(call)
        keywords = {keyword.arg: None for keyword in call.keywords}
        inspect.signature(getattr(gonio, call.func.attr)).bind(*call.args, **keywords)


def test_types_are_for_type_checkers():
    assert (pathlib.Path(gonio.__file__).parent / "py.typed").exists()
    assert gonio.__version__


def examples(page):
    """The indented blocks of Python before the reference of the page, in order."""
    blocks = re.findall(r"(?:^    .*\n|(?<=\n)\n(?=    ))+", page.split("## Reference")[0], re.MULTILINE)
    shell = ("PYTHONPATH=", "pip ")
    return [block for block in (textwrap.dedent(block).strip("\n") + "\n" for block in blocks) if not block.startswith(shell)]


def test_the_examples_of_the_page_run(tmp_path, monkeypatch):
    """With readings of a paint as the reader's own file, half of them near the mirror direction."""
    random = np.random.default_rng(2)
    theta = random.uniform(5, 70, (24, 2))
    theta[:12, 1] = theta[:12, 0] + random.normal(0, 4, 12)
    angles = np.column_stack((theta[:, 0], np.zeros(24), theta[:, 1], 180 + random.normal(0, 5, 24)))

    def unit(polar, azimuth):
        return np.stack((np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)), axis=-1)

    paint = gonio.open("library:sgd/blue-metallic-paint")
    light, viewer = unit(*np.radians(angles[:, :2]).T), unit(*np.radians(angles[:, 2:]).T)
    monkeypatch.chdir(tmp_path)
    np.savetxt("readings.csv", np.column_stack((angles, paint.evaluate(light, viewer))), delimiter=",", header="angles, values")

    names = {}
    blocks = examples((ROOT / "docs" / "python.md").read_text())
    assert len(blocks) >= 5
    for block in blocks:
        for written, quicker in (("size=256, samples=64", "size=32, samples=4"),
                                 ("fit.material())", "fit.material(), size=64, samples=8)")):
            block = block.replace(written, quicker)
        exec(block, names)
    assert names["table"].valid.sum() == len(np.unique(names["cells"], axis=0))
    assert gonio.compare(paint, names["found"].material, size=64, samples=16).rendered_snr > 15
    # The directions of a node lie in its own cell.
    nodes = gonio.grid_directions(tuple(names["shape"]))
    valid = nodes.valid.copy()
    valid[0], valid[:, 0] = False, False
    own = {**names, "wi": nodes.wi[valid], "wo": nodes.wo[valid], "values": np.zeros((valid.sum(), 3))}
    exec(next(block for block in blocks if "cells =" in block).split("count,")[0], own)
    np.testing.assert_array_equal(own["cells"], np.argwhere(valid))


def test_the_figure_of_the_tutorial_is_drawn(tmp_path, monkeypatch):
    pytest.importorskip("matplotlib").use("Agg")
    monkeypatch.chdir(tmp_path)
    page = (ROOT / "docs" / "tutorial-compare.md").read_text()
    names = {}
    for start in ("import matplotlib", "theta = np", "shown = ["):
        block = next(block for block in examples(page) if block.startswith(start))
        exec(block.replace("size=128, samples=64", "size=16, samples=4").replace(', "abc"]', "]"), names)
    assert [fit.model.id for fit in names["fits"]] == ["ggx", "cook-torrance", "ward", "blinn-phong"]
    assert (tmp_path / "five-models.png").stat().st_size > 10000
