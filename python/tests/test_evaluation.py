# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Values, samples and densities against closed forms and goniotool."""
import csv

import numpy as np
import pytest

import gonio


def hemisphere(count_theta=400, count_phi=200):
    """Midpoint rule over the hemisphere: directions and solid angles."""
    z = (np.arange(count_theta) + 0.5) / count_theta
    phi = 2 * np.pi * (np.arange(count_phi) + 0.5) / count_phi
    z, phi = np.meshgrid(z, phi, indexing="ij")
    r = np.sqrt(1 - z * z)
    return np.stack((r * np.cos(phi), r * np.sin(phi), z), axis=-1), 2 * np.pi / (count_theta * count_phi)


def test_lambert_is_albedo_over_pi(directions):
    lambert = gonio.models()["lambert"]
    material = lambert.material(**{lambert.parameters[0].name: [0.2, 0.4, 0.6]})
    values = material.evaluate(directions(100), directions(100, seed=2))
    np.testing.assert_allclose(values, np.broadcast_to(np.array([0.2, 0.4, 0.6]) / np.pi, (100, 3)), rtol=1e-12)
    np.testing.assert_allclose(material.albedo([0, 1.0]), [[0.2, 0.4, 0.6]] * 2, rtol=1e-3)


def test_reciprocal_materials_are_reciprocal(chrome, directions):
    wi, wo = directions(1000), directions(1000, seed=2)
    for material in (chrome, gonio.models()["ggx"].material()):
        assert material.is_reciprocal
        np.testing.assert_allclose(material.evaluate(wi, wo), material.evaluate(wo, wi), rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("path", ["library:rgl/satin_purple", "library:sgd/chrome"])
def test_equals_goniotool(path, directions, goniotool, tmp_path):
    wi, wo = directions(300), directions(300, seed=2)
    angles = np.degrees([np.arccos(wi[:, 2]), np.arctan2(wi[:, 1], wi[:, 0]), np.arccos(wo[:, 2]), np.arctan2(wo[:, 1], wo[:, 0])]).T
    with open(tmp_path / "in.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(("theta_i", "phi_i", "theta_o", "phi_o"))
        writer.writerows([repr(float(value)) for value in row] for row in angles)
    goniotool("evaluate", path, "--directions", tmp_path / "in.csv", "--out", tmp_path / "out.csv")
    expected = np.genfromtxt(tmp_path / "out.csv", delimiter=",", names=True, comments="#")
    values = gonio.open(path).evaluate(wi, wo)
    # Angles in degrees lose the last digits of directions, which count at a highlight.
    np.testing.assert_allclose(values, np.stack([expected[c] for c in "rgb"], axis=-1), rtol=1e-6, atol=1e-9)


def test_directions_broadcast_without_copies(chrome, directions):
    wi, wo = directions(7), directions(11, seed=2)
    grid = chrome.evaluate(wi[:, None], wo[None])
    assert grid.shape == (7, 11, 3)
    for i in range(7):
        np.testing.assert_array_equal(grid[i], chrome.evaluate(np.repeat(wi[i:i + 1], 11, axis=0), wo))
    assert chrome.evaluate(wi[0], wo[0]).shape == (3,)
    assert chrome.evaluate(np.empty((0, 3)), wo[0]).shape == (0, 3)


def test_any_strides_and_many_blocks(chrome, directions):
    wi, wo = directions(100_000), directions(100_000, seed=2)
    values = chrome.evaluate(wi, wo)
    np.testing.assert_array_equal(chrome.evaluate(wi[::-7], wo[::-7]), values[::-7])
    np.testing.assert_array_equal(chrome.evaluate(np.asfortranarray(wi), wo), values)
    np.testing.assert_array_equal(chrome.evaluate(wi.reshape(100, 1000, 3), wo.reshape(100, 1000, 3)).reshape(-1, 3), values)


def test_below_the_horizon_is_black(chrome, directions):
    down = -directions(50)
    assert not chrome.evaluate(down, directions(50)).any()
    assert not chrome.pdf(down, directions(50)).any()


@pytest.mark.parametrize("wi, found", [(np.zeros((4, 2)), "(4, 2)"), ([0, 0, 2.0], "length 2"), ([0, 0, np.nan], "nan")])
def test_bad_directions_are_errors(chrome, wi, found):
    with pytest.raises(gonio.Error, match="wi") as error:
        chrome.evaluate(wi, [0, 0, 1.0])
    assert found in str(error.value)


def test_shapes_that_do_not_broadcast_are_errors(chrome, directions):
    with pytest.raises(ValueError, match="broadcast"):
        chrome.evaluate(directions(3), directions(4))


def test_densities_integrate_to_one(paint):
    wi, solid_angle = hemisphere(1500, 600)
    wo = np.array([np.sin(0.5), 0, np.cos(0.5)])
    for material in (paint, gonio.models()["ggx"].material(roughness=0.4), gonio.open("library:rgl/satin_purple")):
        lost = np.mean(material.sample(np.broadcast_to(wo, (20_000, 3)), np.random.default_rng(1).random((20_000, 3)))[1] == 0)
        assert material.pdf(wi, wo).sum() * solid_angle == pytest.approx(1 - lost, abs=0.01)


def test_samples_follow_their_density():
    """The albedo by importance sampling is that by quadrature, and the densities of samples are those of pdf()."""
    material = gonio.models()["ggx"].material(roughness=0.5)
    wo = np.array([np.sin(0.5), 0, np.cos(0.5)])
    wi, pdf = material.sample(wo, np.random.default_rng(1).random((100_000, 3)))
    assert wi.shape == (100_000, 3) and pdf.shape == (100_000,)
    drawn = pdf > 0
    np.testing.assert_allclose(np.linalg.norm(wi[drawn], axis=-1), 1, rtol=1e-9)
    np.testing.assert_allclose(material.pdf(wi[drawn], wo), pdf[drawn], rtol=1e-6)
    weights = material.evaluate(wi[drawn], wo) * wi[drawn][:, 2:] / pdf[drawn][:, None]
    grid, solid_angle = hemisphere()
    expected = (material.evaluate(grid, wo) * grid[..., 2:]).sum(axis=(0, 1)) * solid_angle
    np.testing.assert_allclose(weights.sum(axis=0) / len(pdf), expected, rtol=0.02)


def test_random_numbers_outside_the_unit_interval_are_errors(chrome):
    with pytest.raises(gonio.Error, match="u: "):
        chrome.sample([0, 0, 1.0], [0.5, 1.0, 0.5])
