# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Files, tables and facts of materials."""
import gc

import numpy as np
import pytest

import gonio


def test_library_opens():
    entries = gonio.library()
    assert {entry.origin for entry in entries} == {"measured", "near-measured copy", "published fit"}
    entry = next(entry for entry in entries if entry.name == "satin_purple" and entry.origin == "measured")
    material = gonio.open(entry.path)
    assert (material.name, material.path) == (entry.name, entry.path)
    assert not material.is_table and material.is_isotropic


def test_missing_and_foreign_files_are_errors(tmp_path):
    with pytest.raises(gonio.Error, match="nowhere.binary"):
        gonio.open(tmp_path / "nowhere.binary")
    (tmp_path / "text.binary").write_text("no material")
    with pytest.raises(gonio.Error, match="text.binary"):
        gonio.open(tmp_path / "text.binary")


def test_table_is_a_view_that_outlives_its_material(chrome):
    table = gonio.from_table(chrome.values, chrome.valid, name="copy")
    values, again = table.values, table.values
    assert values.__array_interface__["data"] == again.__array_interface__["data"]
    assert not values.flags.writeable and values.dtype == np.float32
    del table, again
    gc.collect()
    np.testing.assert_array_equal(values, chrome.values)


def test_table_round_trip_of_an_array():
    shape = (6, 5, 8)
    values = np.random.default_rng(1).random(shape + (3,)).astype(np.float32)
    nodes = gonio.grid_directions(shape)
    material = gonio.from_table(values, nodes.valid)
    np.testing.assert_array_equal(material.values[nodes.valid], values[nodes.valid])
    assert not material.values[~nodes.valid].any()
    # At the nodes the table is its values, but for those of theta_h = 0 or theta_d = 0: directions do not give phi_d there.
    inside = nodes.valid & (nodes.wi[..., 2] > 0.05) & (nodes.wo[..., 2] > 0.05)
    inside[0] = inside[:, 0] = False
    np.testing.assert_allclose(material.evaluate(nodes.wi[inside], nodes.wo[inside]), values[inside], rtol=1e-4)


def test_cells_measure_the_hemispheres():
    """The weights of the cells of a fine grid are proportional to solid angles: cos theta_i cos theta_o integrates to pi^2."""
    nodes = gonio.grid_directions((90, 90, 90))
    cosines = np.where(nodes.valid, nodes.wi[..., 2] * nodes.wo[..., 2], 0)
    mean = (cosines * nodes.measure).sum() / (nodes.measure * nodes.valid).sum()
    assert mean == pytest.approx(0.25, rel=0.02)


def test_coordinates_round_trip():
    """Each system determines the pair up to a rotation about the normal, and half-out is its definition."""
    random = np.random.default_rng(2)
    wi, wo = random.normal(size=(2, 4, 50, 3))
    for directions in (wi, wo):
        directions[..., 2] = abs(directions[..., 2]) + 0.05
        directions /= np.linalg.norm(directions, axis=-1, keepdims=True)
    for system, names in gonio.coordinates().items():
        values = gonio.to_coordinates(system, wi, wo)
        assert values.shape == (4, 50, len(names))
        found_wi, found_wo, valid = gonio.from_coordinates(system, values)
        assert valid.all() and valid.shape == (4, 50)
        np.testing.assert_allclose(found_wi[..., 2], wi[..., 2], atol=1e-9)
        np.testing.assert_allclose(found_wo[..., 2], wo[..., 2], atol=1e-9)
        np.testing.assert_allclose((found_wi * found_wo).sum(-1), (wi * wo).sum(-1), atol=1e-9)
    half = (wi + wo) / np.linalg.norm(wi + wo, axis=-1, keepdims=True)
    half_out = gonio.to_coordinates("half-out", wi, wo)
    np.testing.assert_allclose(half_out[..., 0], np.arccos(wo[..., 2]), atol=1e-7)
    np.testing.assert_allclose(half_out[..., 1], np.arccos(half[..., 2]), atol=1e-7)
    difference = np.arctan2(half[..., 1], half[..., 0]) - np.arctan2(wo[..., 1], wo[..., 0])
    np.testing.assert_allclose(np.cos(half_out[..., 2]), np.cos(difference), atol=1e-9)
    assert not gonio.from_coordinates("projected-deviation", [0.5, 1.9, 0.1])[2]
    with pytest.raises(gonio.Error, match="half-out"):
        gonio.to_coordinates("rusinkiewicz", wi, wo)
    with pytest.raises(gonio.Error, match="3 numbers"):
        gonio.from_coordinates("half-out", [1, 2])


def test_bad_tables_are_errors():
    with pytest.raises(gonio.Error, match="shape"):
        gonio.from_table(np.zeros((4, 4, 3)))
    with pytest.raises(gonio.Error, match="valid"):
        gonio.from_table(np.zeros((4, 4, 4, 3)), np.ones((4, 4)))
    with pytest.raises(gonio.Error):
        gonio.from_table(np.full((4, 4, 4, 3), np.nan))


def test_files_round_trip(chrome, tmp_path):
    assert chrome.save(tmp_path / "chrome.binary")["losses"] == []
    again = gonio.open(tmp_path / "chrome.binary")
    assert again.format == "MERL" and again.grid == chrome.grid
    np.testing.assert_allclose(again.values, chrome.values, rtol=1e-6)
    np.testing.assert_array_equal(again.valid, chrome.valid)


def test_a_table_of_an_edit_is_no_file():
    """A document of it would hold neither the edit nor the table."""
    measured = gonio.open("library:rgl/satin_purple")
    assert gonio.edit(measured, "lambert", set={"diffuse": 0.1}).tabulated().path == ""


def test_what_is_no_table_says_so():
    material = gonio.open("library:rgl/satin_purple")
    with pytest.raises(gonio.Error, match="tabulated"):
        material.values
    with pytest.raises(gonio.Error, match="suffix|format|expected"):
        material.save("material.png")


def test_info_is_that_of_goniotool(chrome, goniotool, tmp_path):
    chrome.save(tmp_path / "chrome.binary")
    expected = goniotool("info", tmp_path / "chrome.binary")
    info = gonio.open(tmp_path / "chrome.binary").info()
    assert info["format"] == expected["format"] and list(info["grid"]) == expected["grid"]
    assert info["sha256"] == expected["sha256"]
    for found, channel in zip(info["channels"], expected["channels"]):
        assert found == (channel["min"], channel["max"])
    for angle, albedo in info["albedo"].items():
        assert albedo == expected["albedo"][str(angle)]


def test_plausibility(chrome):
    checks = {check.name: check for check in gonio.check(chrome)}
    assert checks["reciprocity"].passed and checks["negative"].passed
    bright = gonio.from_table(chrome.values * 10, chrome.valid)
    assert not {check.name: check for check in gonio.check(bright)}["energy"].passed


def test_materials_are_not_made_from_anything():
    with pytest.raises(TypeError, match="gonio.open"):
        gonio.Material("chrome")
