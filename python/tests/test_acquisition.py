# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Plans, measurements, reconstructions."""
import numpy as np
import pytest

import gonio

TRAINING = ["chrome", "blue-metallic-paint"]


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """Training materials on the MERL grid."""
    folder = tmp_path_factory.mktemp("training")
    for name in TRAINING:
        gonio.open(f"library:sgd/{name}").save(folder / f"{name}.binary")
    return folder


@pytest.fixture(scope="module")
def basis(files):
    return gonio.learn_basis([files])


def test_a_training_material_is_in_the_span_of_its_basis(basis, files):
    assert basis.grid == (90, 90, 180) and basis.training_set == sorted(TRAINING)
    assert np.all(np.diff(basis.singular_values) <= 0)
    material = gonio.open(files / "chrome.binary")
    code = basis.encode(material, len(basis))
    assert code.shape == (3, len(basis))
    decoded = basis.decode(code)
    both = decoded.valid
    np.testing.assert_allclose(decoded.values[both], material.values[both], rtol=0.02, atol=2e-3)


def test_separation_adds_up_and_its_components_hold_the_training_set(files):
    material = gonio.open(files / "chrome.binary")
    diffuse, specular = gonio.separate(material)
    np.testing.assert_allclose(diffuse.values + specular.values, material.values, rtol=1e-6)
    assert diffuse.values.min() >= 0 and specular.values.min() >= 0
    separated = gonio.learn_separated_basis([files])
    assert separated.diffuse.training_set == sorted(TRAINING)
    code = separated.encode(material, 8)
    assert [part.shape for part in code] == [(3, 2), (3, min(6, len(separated.specular)))]
    decoded = separated.decode(code)
    both = decoded.valid & material.valid
    assert np.abs(np.log1p(decoded.values[both]) - np.log1p(material.values[both])).mean() < 0.05


def test_codes_of_patches(tmp_path):
    nodes = gonio.grid_directions((36, 36, 36))  # a multiple of the patches
    for name in TRAINING:
        values = gonio.open(f"library:sgd/{name}").evaluate(nodes.wi, nodes.wo)
        gonio.from_table(values, nodes.valid).save(tmp_path / f"{name}.binary")
    patches = gonio.learn_patches([tmp_path])
    assert sorted(patches.training_set) == sorted(TRAINING) and patches.bytes == patches.atoms.nbytes
    assert patches.grid == (36, 36, 36) and patches.atoms.shape == (256, 9, 9, 12)
    np.testing.assert_allclose(np.linalg.norm(patches.atoms.reshape(256, -1), axis=1), 1, rtol=1e-5)
    chrome = gonio.open(tmp_path / "chrome.binary")
    code = patches.encode(chrome, 2000)
    record, = gonio.study(chrome, ["patches"], coefficients=[2000], patches=patches, size=16, samples=4, timed=False)
    assert record.bytes == code.bytes and record.errors == gonio.compare(chrome, code.material, size=16, samples=4).errors


def test_plan_measure_reconstruct(basis, files, tmp_path):
    plan = gonio.plan(5, basis)
    assert len(plan) == 5 and plan.method == "a-optimal" and plan.warning == ""
    assert gonio.plan(5, basis, method="somp").method == "somp"
    assert np.all(np.diff(plan.residuals) <= 0) and np.isfinite(plan.condition_number)
    assert sorted(plan.order) == list(range(5))
    assert plan.wi[:, 2].min() > np.cos(np.radians(85)) - 1e-9
    material = gonio.open(files / "chrome.binary")
    readings = gonio.measure(material, plan)
    np.testing.assert_array_equal(readings.values, material.evaluate(plan.wi, plan.wo))
    assert readings.noise is None
    found = gonio.reconstruct(plan, readings, basis, ridge=0.0)
    both = found.material.valid & material.valid
    error = np.abs(np.log1p(found.material.values[both]) - np.log1p(material.values[both])).mean()
    assert error < 0.05
    assert found.components <= len(basis) and found.deviation.shape == basis.grid


def test_reconstruction_as_published(basis, paint):
    plan = gonio.plan(4, basis)
    readings = gonio.measure(paint, plan, noise=0.1)
    published = gonio.reconstruct(plan, readings, basis, ridge=40, components=len(plan), equal_noise=True)
    assert published.ridge == 40 and published.components == min(4, len(basis))
    # Known noise has no effect with equal weights.
    without = gonio.Readings(readings.values)
    same = gonio.reconstruct(plan, without, basis, ridge=40, components=len(plan), equal_noise=True)
    np.testing.assert_array_equal(published.material.values, same.material.values)
    weighted = gonio.reconstruct(plan, readings, basis, ridge=40, components=len(plan))
    assert not np.array_equal(weighted.material.values, published.material.values)


def test_files_of_plans_and_values(basis, paint, tmp_path):
    plan = gonio.plan(5, basis, max_polar_angle=1.0, forbidden=[((0, 0.2), (0, np.pi / 2), (0, np.pi))])
    cosines = plan.wi[:, 2]
    assert cosines.max() <= np.cos(0.2) + 1e-6 and cosines.min() >= np.cos(1.0) - 1e-6
    plan.save(tmp_path / "plan.csv")
    again = gonio.open_plan(tmp_path / "plan.csv")
    np.testing.assert_allclose(again.wi, plan.wi, atol=1e-7)
    readings = gonio.measure(paint, plan, noise=0.01, seed=3)
    plan.save_values(readings, tmp_path / "values.csv")
    np.testing.assert_allclose(again.open_values(tmp_path / "values.csv").values, readings.values, rtol=1e-12)


def test_noise_is_that_which_was_asked_for(paint):
    plan = gonio.Plan(np.tile([0, 0, 1.0], (4000, 1)), np.tile([np.sin(0.5), 0, np.cos(0.5)], (4000, 1)))
    readings = gonio.measure(paint, plan, noise=0.05)
    truth = paint.evaluate(plan.wi[0], plan.wo[0])
    assert np.std(readings.values[:, 0] / truth[0]) == pytest.approx(0.05, rel=0.1)
    np.testing.assert_allclose(readings.noise[:, 0].mean(), 0.05 * truth[0], rtol=0.01)


def test_bad_plans_are_errors(basis):
    with pytest.raises(gonio.Error, match="method"):
        gonio.plan(5, basis, method="guess")
    with pytest.raises(gonio.Error):
        gonio.plan(0, basis)
    with pytest.raises(gonio.Error, match="unit"):
        gonio.Plan([[0, 0, 2.0]], [[0, 0, 1.0]])
    plan = gonio.Plan([[0, 0, 1.0]], [[0, 0.6, 0.8]])
    with pytest.raises(gonio.Error):
        gonio.reconstruct(plan, gonio.Readings(np.ones((2, 3))), basis)
