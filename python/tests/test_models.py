# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Models, fits and edits."""
import numpy as np
import pytest

import gonio


def test_registry_describes_itself():
    models = gonio.models()
    assert len(models) > 30 and models["ggx"].name == "GGX"
    for model in models.values():
        assert model.reference and model.parameters
        for parameter in model.parameters:
            low, high = parameter.hard_range
            assert low <= parameter.default <= high
    for control in gonio.artist_controls():
        assert control.description


def test_fit_recovers_known_parameters():
    truth = {"roughness": 0.3, "diffuse": [0.1, 0.2, 0.3]}
    ggx = gonio.models()["ggx"]
    nodes = gonio.grid_directions((40, 30, 36))
    material = ggx.material(**truth)
    table = gonio.from_table(material.evaluate(nodes.wi, nodes.wo), nodes.valid)
    fit = gonio.fit(table, "ggx")
    assert fit.parameters["roughness"] == pytest.approx(0.3, rel=0.01)
    np.testing.assert_allclose(fit.parameters["diffuse"], truth["diffuse"], rtol=0.02)
    assert set(fit.errors) == set(gonio.metrics()) and fit.errors["log"] < 1e-3
    np.testing.assert_allclose(fit.material().evaluate(nodes.wi[5, 5], nodes.wo[5, 5]), material.evaluate(nodes.wi[5, 5], nodes.wo[5, 5]),
                               rtol=0.05)


def test_unknown_names_are_errors(paint):
    with pytest.raises(gonio.Error, match="ggx"):
        gonio.fit(paint, "nothing")
    with pytest.raises(gonio.Error, match="log"):
        gonio.fit(paint, "ggx", metric="nothing")
    with pytest.raises(gonio.Error, match="rough"):
        gonio.models()["ggx"].material(rough=1)
    with pytest.raises(gonio.Error, match="roughness"):
        gonio.models()["ggx"].material(roughness="a lot")


def test_ranking_is_by_the_metric(paint):
    ranking = gonio.fit_all(paint, ["lambert", "ggx", "blinn-phong"], size=16, samples=4)
    errors = [fit.errors["log"] for fit in ranking]
    assert errors == sorted(errors) and ranking[-1].model.id == "lambert"
    assert all(np.isfinite(fit.rendered_snr) for fit in ranking)


@pytest.fixture(scope="module")
def fitted(paint):
    return gonio.fit(paint, "ggx")


def test_an_edit_that_changes_nothing_is_the_identity(paint, fitted):
    for composition in ("additive", "log-plus", "lobes"):
        same = gonio.edit(paint, fitted, composition=composition)
        np.testing.assert_array_equal(same.values, paint.values)
    np.testing.assert_array_equal(gonio.edit(paint, fitted, set={"roughness": 0.5}, strength=0).values, paint.values)


def test_additive_edit_is_its_formula(paint, fitted):
    """edited = max(0, measured + model(edited) - model(fitted)): Tongbuasirilai 2023, eq. 4.40-4.41."""
    edited = gonio.edit(paint, fitted, set={"roughness": 0.6}, composition="additive")
    nodes = gonio.grid_directions(paint.grid)
    after = fitted.model.material(**{**fitted.parameters, "roughness": 0.6}).evaluate(nodes.wi, nodes.wo)
    before = fitted.material().evaluate(nodes.wi, nodes.wo)
    expected = np.where(paint.valid[..., None], np.maximum(0, paint.values + after - before), 0)
    np.testing.assert_allclose(edited.values, expected, rtol=1e-4, atol=1e-6)


def test_edits_add_up_and_controls_act(paint, fitted):
    tinted = gonio.edit(paint, fitted, controls={"tint": [0.5, 1, 1]})
    np.testing.assert_allclose(tinted.values[..., 0], paint.values[..., 0] / 2, rtol=1e-5, atol=1e-7)
    np.testing.assert_array_equal(tinted.values[..., 1], paint.values[..., 1])
    assert gonio.edit(tinted, "ggx", set={"roughness": 0.4}).edit_count == 2


def test_documents_hold_edits(paint, tmp_path):
    paint.save(tmp_path / "paint.binary")
    measured = gonio.open(tmp_path / "paint.binary")
    edited = gonio.edit(measured, "ggx", set={"roughness": 0.6})
    edited.save(tmp_path / "rough.gonio")
    again = gonio.open(tmp_path / "rough.gonio")
    assert again.edit_count == 1
    np.testing.assert_array_equal(again.values, edited.values)
    with pytest.raises(gonio.Error, match="has no file"):
        gonio.edit(paint, "lambert").save(tmp_path / "none.gonio")


def test_bad_edits_are_errors(paint, fitted):
    with pytest.raises(gonio.Error, match="composition"):
        gonio.edit(paint, fitted, composition="magic")
    with pytest.raises(gonio.Error, match="strength"):
        gonio.edit(paint, fitted, strength=2)
    with pytest.raises(gonio.Error, match="^roughness is -1, expected 0.0001 to 1$"):
        gonio.edit(paint, fitted, set={"roughness": -1})
    with pytest.raises(gonio.Error, match="shine"):
        gonio.edit(paint, fitted, controls={"shine": 1})
