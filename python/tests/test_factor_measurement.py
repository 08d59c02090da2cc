# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Materials predicted from two curves."""
import numpy as np
import pytest

import gonio

ALL_AXES = ["projected-deviation", "symmetric-deviation", "half-difference", "half-out"]


@pytest.mark.parametrize("axes", ALL_AXES)
def test_readings_are_predicted_exactly(axes, paint):
    """At the readings themselves the printed product is the reading."""
    plan = gonio.plan_factors(axes, fixed_angle=np.radians(40))
    readings = gonio.measure(paint, plan)
    found = gonio.predict_from_factors(plan, readings, bound="none")
    value = found.material.evaluate(plan.wi, plan.wo)
    along = np.array(plan.curves) == "along"
    np.testing.assert_allclose(value[along], readings.values[along], rtol=1e-9)
    if axes != "symmetric-deviation":
        np.testing.assert_allclose(value, readings.values, rtol=1e-6)
    assert len(found.angles) + len(found.distances) == len(plan) == 180 - plan.blocked
    assert found.along.shape == (len(found.angles), 3) and found.across.shape == (len(found.distances), 3)


def test_bounded_predictions_never_exceed_the_readings(paint):
    plan = gonio.plan_factors("projected-deviation", fixed_angle=np.radians(30))
    readings = gonio.measure(paint, plan, noise=0.02)
    bounded, printed = (gonio.predict_from_factors(plan, readings, bound=bound).material for bound in ("readings", "none"))
    rng = np.random.default_rng(1)
    theta, phi = rng.uniform(0, 1.5, (2, 1000)), rng.uniform(0, 6, (2, 1000))
    wi, wo = (np.stack([np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)], axis=-1) for t, p in zip(theta, phi))
    value = bounded.evaluate(wi, wo)
    assert np.all(value <= readings.values.max(axis=0) * (1 + 1e-9))
    assert np.all(value <= printed.evaluate(wi, wo) * (1 + 1e-9))
    np.testing.assert_allclose(value, bounded.evaluate(wo, wi), rtol=1e-9)


def test_adaptive_axes_are_the_default_and_more_accurate(paint):
    """As many readings as two curves; the material is fitted to all of them."""
    plan = gonio.plan_factors()
    assert plan.axes == "adaptive" and len(plan) + plan.blocked == 180 and set(plan.curves) == {"along", "across", "further"}
    found = gonio.predict_from_factors(plan, gonio.measure(paint, plan))
    assert found.contradicted == 0 and found.warnings == []
    product = gonio.plan_factors("projected-deviation")
    published = gonio.predict_from_factors(product, gonio.measure(paint, product), bound="none")
    fitted, printed = (gonio.compare(paint, one.material, size=48, samples=4).rendered_snr for one in (found, published))
    assert fitted > printed + 3


def test_files_and_errors(paint, tmp_path):
    plan = gonio.plan_factors("projected-deviation", angles=20, distances=25)
    readings = gonio.measure(paint, plan, noise=0.01)
    path = tmp_path / "readings.csv"
    plan.save_readings(readings, path)
    again, values = gonio.open_factor_readings(path, "projected-deviation")
    np.testing.assert_array_equal(values.values, readings.values)
    np.testing.assert_array_equal(values.noise, readings.noise)
    assert again.curves == plan.curves
    symmetric, _ = gonio.open_factor_readings(path, "symmetric-deviation")
    assert gonio.predict_from_factors(symmetric, values).contradicted == 0
    with pytest.raises(gonio.Error, match='curve "across"'):
        gonio.predict_from_factors(gonio.open_factor_readings(path, "half-difference")[0], values)
    with pytest.raises(gonio.Error, match="expected projected-deviation"):
        gonio.plan_factors("pdv")
    with pytest.raises(gonio.Error, match="readings or none"):
        gonio.predict_from_factors(plan, readings, bound="some")


def test_warnings_state_the_cause():
    plan = gonio.plan_factors("projected-deviation")
    found = gonio.predict_from_factors(plan, gonio.measure(gonio.open("library:rgl/acrylic_felt_green"), plan))
    assert found.contradicted > 0.1 and "exchanging light and viewer" in found.warnings[0]
