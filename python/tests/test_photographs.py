# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Materials from images of a sphere, and which image to take next."""
import json

import numpy as np
import pytest

import gonio

CAMERA = {"position": [0, 0, 4], "fieldOfView": np.degrees(0.55)}
STUDIO = [{"environment": "studio", "rotation": 0}]
TRAINING = ["chrome", "blue-metallic-paint", "red-plastic", "teflon"]


@pytest.fixture(scope="module")
def basis(tmp_path_factory):
    """Four materials on a small grid."""
    folder = tmp_path_factory.mktemp("training")
    nodes = gonio.grid_directions((45, 15, 18))
    for name in TRAINING:
        gonio.from_table(gonio.open(f"library:sgd/{name}").evaluate(nodes.wi, nodes.wo), nodes.valid).save(folder / f"{name}.binary")
    return gonio.learn_basis([folder])


@pytest.fixture(scope="module")
def picture():
    """A training material under the studio."""
    return gonio.render(gonio.open("library:sgd/red-plastic"), "sphere", size=64, samples=32)


def entry(picture, **members):
    return {"image": picture, "camera": CAMERA, "lights": STUDIO, **members}


def test_a_training_material_comes_back(basis, picture):
    fractions = []
    found = gonio.from_images([entry(picture)], basis, regions=200, name="red", progress=fractions.append)
    assert found.material.name == "red" and found.material.values.shape == (*basis.grid, 3)
    assert found.exposure == 1 and found.exposure_deviation == 0 and found.grey_exposure == (1, 1, 1)
    assert found.residual_snr[0] > 20
    assert found.deviation.shape == (*basis.grid, 3)
    valid = np.isfinite(found.deviation)
    assert valid.any() and np.all(found.deviation[valid] >= 0)
    again = gonio.render(found.material, "sphere", size=64, samples=32)
    assert np.sum((again - picture) ** 2) < 0.02 * np.sum(picture ** 2)
    assert {check.property for check in found.checks} >= {"exposure", "rotation"}
    assert np.all(np.diff(fractions) > -1e-9) and fractions[-1] > 0.9
    x, y, radius = found.outlines[0]
    assert (x, y) == (32, 32) and 25 < radius < 32


def test_an_unknown_exposure_is_estimated(basis, picture):
    found = gonio.from_images({"exposure": "unknown", "images": [entry(5 * picture)]}, basis, regions=200)
    assert abs(np.log(found.exposure / 5)) < 4 * found.exposure_deviation


def test_other_shapes_have_no_outline(basis, picture):
    """The pixels beside the middle of a flat sample do not show a sphere: here only that the shape is read and used."""
    flat = {"flat": {"normal": [0, 0, 1], "width": 0.5, "height": 0.5}}
    found = gonio.from_images([entry(picture), entry(picture, shape=flat)], basis, regions=200)
    assert found.outlines[0] is not None and found.outlines[1] is None
    assert len(found.residual_snr) == 2
    with pytest.raises(gonio.Error, match=r"images\[0\].sphere"):
        gonio.from_images([entry(picture, shape=flat, sphere="find")], basis)


def test_a_grey_card_fixes_the_exposure(basis, picture):
    """Under a distant light that falls straight on the card: its radiance is 0.2 * 3 / pi."""
    shown = picture.copy()
    shown[:4, :4] = 0.2 * 3 / np.pi
    lights = [{"toLight": [0, 0, 1], "irradiance": [3, 3, 3]}]
    patch = {"x": 0, "y": 0, "width": 4, "height": 4, "reflectance": 0.2, "normal": [0, 0, 1]}
    found = gonio.from_images([entry(7 * shown, lights=lights, greyPatch=patch)], basis, regions=100)
    np.testing.assert_allclose(found.grey_exposure, 7, rtol=1e-5)


def test_next_images(basis, tmp_path):
    description = {"images": [{"file": "front.exr", "camera": CAMERA, "lights": [{"toLight": [0, 0, 1], "irradiance": [1, 1, 1]}]}]}
    plan = gonio.plan_images(description, images=2, lights=6, basis=basis, materials=4)
    assert len(plan.chosen) == 2 and len(plan.candidates) == 6
    deviations = [plan.before["all"]] + [deviation["all"] for _, deviation in plan.images]
    assert len(deviations) == 4 and np.all(np.diff(deviations) < 0)
    assert min(deviation["all"] for _, deviation in plan.candidates) == plan.images[1][1]["all"]
    assert set(plan.before) == {"all", "diffuse", "glossy"}
    assert [image["file"] for image in plan.description["images"]] == ["front.exr", *plan.chosen]
    # The same from a file.
    path = tmp_path / "description.json"
    path.write_text(json.dumps({"format": "gonio photographs", "version": 1, **description}))
    assert gonio.plan_images(path, images=2, lights=6, basis=basis, materials=4).chosen == plan.chosen
    with pytest.raises(gonio.Error, match="candidate"):
        gonio.plan_images(description, basis=basis)


def test_faults_are_named(basis, picture, tmp_path):
    with pytest.raises(gonio.Error, match=r"images\[0\].lights"):
        gonio.from_images([entry(picture, lights=[])], basis)
    with pytest.raises(gonio.Error, match="shape"):
        gonio.from_images([entry(picture[..., 0])], basis)
    with pytest.raises(gonio.Error, match="nowhere"):
        gonio.from_images(tmp_path / "nowhere.json", basis)
    with pytest.raises(gonio.Error, match="missing.exr"):
        gonio.from_images([{"file": "missing.exr", "camera": CAMERA, "lights": STUDIO}], basis)
