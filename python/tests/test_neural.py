# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Neural BRDFs."""
import numpy as np
import pytest

import gonio


def values_of(weights, wi, wo):
    """The network in NumPy: half and difference vector, two layers of 21 units, exp(x) - 1. wi and wo in the plane y = 0."""
    half = (wi + wo) / np.linalg.norm(wi + wo, axis=-1, keepdims=True)
    sign = np.where(half[:, :1] < 0, -1, 1)  # azimuth 0
    half, wi = half * [1, 1, 1] * np.hstack([sign, sign, np.ones_like(sign)]), wi * np.hstack([sign, sign, np.ones_like(sign)])
    x = half[:, 2] * wi[:, 0] - half[:, 0] * wi[:, 2]
    z = (half * wi).sum(axis=1)
    # The azimuth of the difference vector is folded to [0, 180) degrees.
    layer = np.stack([half[:, 0], 0 * z, half[:, 2], np.abs(x), 0 * z, z], axis=1)
    at = 0
    for inputs, outputs in ((6, 21), (21, 21), (21, 3)):
        matrix = weights[at:at + inputs * outputs].reshape(inputs, outputs)
        bias = weights[at + inputs * outputs:at + (inputs + 1) * outputs]
        at += (inputs + 1) * outputs
        layer = layer @ matrix + bias
        if outputs > 3:
            layer = np.maximum(layer, 0)
    return np.maximum(np.expm1(layer), 0)


def test_network_is_its_formula():
    weights = np.random.default_rng(2).uniform(-0.4, 0.4, 675)
    network = gonio.neural_brdf(weights)
    np.testing.assert_array_equal(network.weights, weights.astype(np.float32))
    theta_i, theta_o = np.meshgrid(np.linspace(-1.4, 1.4, 9), np.linspace(-1.3, 1.5, 8))
    wi, wo = (np.stack([np.sin(t), 0 * t, np.cos(t)], axis=-1).reshape(-1, 3) for t in (theta_i, theta_o))
    np.testing.assert_allclose(network.material().evaluate(wi, wo), values_of(weights, wi, wo), rtol=1e-4, atol=1e-5)


def test_training_and_files(paint, tmp_path):
    network = gonio.train_neural(paint, steps=300)
    assert len(network.losses) == 20 and network.losses[-1] < network.losses[0] and network.seconds > 0
    np.testing.assert_array_equal(gonio.train_neural(paint, steps=300).weights, network.weights)
    network.save(tmp_path / "paint.nbrdf")
    assert (tmp_path / "paint.nbrdf").stat().st_size == network.bytes == 2712
    np.testing.assert_array_equal(gonio.open_neural(tmp_path / "paint.nbrdf").weights, network.weights)
    assert gonio.open(tmp_path / "paint.nbrdf").format == "neural BRDF"


def test_bad_input(paint):
    for weights in (np.zeros(674), np.full(675, np.nan)):
        with pytest.raises(gonio.Error):
            gonio.neural_brdf(weights)
    with pytest.raises(gonio.Error):
        gonio.train_neural(paint, steps=0)
