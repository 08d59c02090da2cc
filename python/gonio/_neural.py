# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Neural BRDFs."""
from __future__ import annotations

import os
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import PathLike
from ._materials import Material, Progress


class NeuralBrdf:
    """A material as a network of 675 weights, see gonio.train_neural(): 6 inputs (half vector and difference vector), two layers
    of 21 units with max(0, x), 3 outputs x; the BRDF value is max(0, exp(x) - 1) (Sztrajman et al. 2021). It does not change after
    it is made."""

    __slots__ = ("_handle",)

    def __init__(self, handle: Any) -> None:
        """Neural BRDFs are made by gonio.train_neural(), gonio.neural_brdf() and gonio.open_neural(), not directly."""
        if not isinstance(handle, _core.NeuralFit):
            raise TypeError("make a neural BRDF with gonio.train_neural()")
        self._handle = handle

    def __repr__(self) -> str:
        return f"<gonio.NeuralBrdf: {len(self.weights)} weights>"

    @property
    def weights(self) -> NDArray[np.float32]:
        """The weights, a copy of shape (675,): layer by layer, first the matrix [input][output], then the bias."""
        return self._handle.weights

    @property
    def losses(self) -> NDArray[np.float64]:
        """Mean loss over each twentieth of the training steps; empty if it was not trained here."""
        return self._handle.losses

    @property
    def seconds(self) -> float:
        """Time of the training, s; 0 if it was not trained here."""
        return self._handle.seconds

    @property
    def bytes(self) -> int:
        """Size of the file that save() writes, bytes."""
        return _core.neural_bytes

    def material(self, name: str = "neural BRDF") -> Material:
        """The network as a material, which is evaluated without a table."""
        return Material(self._handle.material(name))

    def save(self, path: PathLike) -> None:
        """Writes a .nbrdf file; an existing file is replaced in one step. Raises Error if it cannot be written."""
        self._handle.save(os.fsencode(path))


def train_neural(material: Material, steps: int = 40000, learning_rate: float = 0.01, seed: int = 1,
                 progress: Progress = None) -> NeuralBrdf:
    """Trains a network to reproduce a material, by Adam on the loss of Sztrajman et al. 2021: the mean of
    |ln(1 + rho_net cos theta_i) - ln(1 + rho cos theta_i)|, rho_net the BRDF value of the network. Takes 0.15 to 0.3 ms
    per step, 6 to 12 s with the defaults.

    Args:
        material: The material. A material that is not a table is sampled as a table first (1 s).
        steps: Number of steps, each with 512 pairs of directions.
        learning_rate: Learning rate at the first step; it decays to 1/1000 of it.
        seed: Seed of the first weights and of the directions.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: An argument is not positive.
    """
    return NeuralBrdf(_core.train_neural(material._handle, steps, learning_rate, seed, progress))


def neural_brdf(weights: ArrayLike) -> NeuralBrdf:
    """Makes a neural BRDF from weights, for example from published ones.

    Args:
        weights: 675 numbers in the order of NeuralBrdf.weights.

    Raises:
        Error: The number of weights is not 675, or a weight is not finite.
    """
    return NeuralBrdf(_core.neural_from_weights(np.asarray(weights, dtype=np.float32).ravel()))


def open_neural(path: PathLike) -> NeuralBrdf:
    """Reads a .nbrdf file. Raises Error if it cannot be read."""
    return NeuralBrdf(_core.read_neural(os.fsencode(path)))
