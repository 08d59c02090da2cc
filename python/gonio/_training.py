# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Training of dictionaries."""
from __future__ import annotations

import os
from typing import Any, NamedTuple, Sequence

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arguments import PathLike
from ._materials import Material, Progress
from ._representations import Dictionary, dictionary


def train_dictionary(sources: Sequence[PathLike], out: PathLike, excluded: Sequence[str] = (), dictionaries: int = 8,
                     sparsities: Sequence[int] = (32, 64, 128, 256), iterations: int = 24, passes: int = 4,
                     tolerance: float = 5e-4, subspace_loss: float = 3e-5, as_published: bool = False,
                     normalise: bool = False, extend: PathLike | None = None, seed: int = 1,
                     progress: Progress = None) -> Dictionary:
    """Learns an ensemble of orthonormal dictionaries from a training set, writes it to a file and opens it: alternately, each
    signal is assigned to the dictionary that represents it best, and each dictionary is fitted to its signals (Miandji et al.
    2019; Tongbuasirilai 2023, Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition, section 4.3.2). A
    signal is one channel of a material after one transform, in both orders of the directions if the material is not
    reciprocal (with as_published, their mean). 137 materials take about 6 minutes on two cores; a
    training that is interrupted writes nothing (`goniotool dictionary train --checkpoint` can resume one).

    Args:
        sources: Measured materials: files, or folders of them. All tables must have the same grid.
        out: The .dictionary file to write; an existing file is replaced in one step.
        excluded: Names of materials to exclude.
        dictionaries: Number K of dictionaries for each sparsity.
        sparsities: Numbers of coefficients per signal; the dictionaries of each sparsity are learned together.
        iterations: Maximum number of rounds per sparsity.
        passes: Number of times per round that each dictionary is fitted to its signals before the signals are assigned again.
        tolerance: The rounds of a sparsity end when one lowers the relative squared error by less than this fraction.
        subspace_loss: Maximum fraction of the energy that the subspace shared by all dictionaries may omit.
        as_published: Whether to learn from transformed values without cell scaling.
        normalise: Whether to divide each signal by its norm, so that dark materials count as much as bright ones.
        extend: A .dictionary file whose dictionaries precede the learned ones in the file that is written; None: none.
        seed: Seed of the first assignment of signals to dictionaries.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: A file cannot be read or written, grids or cell scaling differ, or an argument is out of range.
    """
    _core.train_dictionary([os.fsencode(source) for source in sources], os.fsencode(out), list(excluded), dictionaries,
                           list(sparsities), iterations, passes, tolerance, subspace_loss, as_published, normalise,
                           b"" if extend is None else os.fsencode(extend), seed, progress)
    return dictionary(out)


class PatchCode(NamedTuple):
    """Result of PatchDictionary.encode()."""

    material: Material
    """The decoded material, a table."""
    bytes: int
    """Size of the quantised and compressed code."""


class PatchDictionary:
    """One unstructured dictionary for patches (blocks of cells) of tables, learned by K-SVD, see gonio.learn_patches(). It is the
    baseline for the codes of gonio.encode()."""

    __slots__ = ("_handle",)

    def __init__(self, handle: Any) -> None:
        """Made by gonio.learn_patches(), not directly."""
        self._handle = handle

    def __repr__(self) -> str:
        return f"<gonio.PatchDictionary: {len(self.atoms)} atoms on {self.grid}>"

    @property
    def atoms(self) -> NDArray[np.float32]:
        """The atoms, shape (atoms, theta_h, theta_d, phi_d), each of Euclidean norm 1."""
        return self._handle.atoms

    @property
    def grid(self) -> tuple[int, int, int]:
        """Numbers of nodes of the tables (theta_h, theta_d, phi_d)."""
        return self._handle.grid

    @property
    def training_set(self) -> list[str]:
        """Names of the training materials."""
        return self._handle.training_set

    @property
    def bytes(self) -> int:
        """Size of the atoms in single precision."""
        return self._handle.bytes

    def encode(self, material: Material, coefficients: int = 1024, name: str = "patches", progress: Progress = None) -> PatchCode:
        """Represents each patch of a material by few atoms, chosen by orthogonal matching pursuit, so that all patches of a channel
        have about the same error.

        Args:
            material: The material; its table must have the grid of the dictionary.
            coefficients: Maximum number of coefficients per channel.
            name: Name of the decoded material.
            progress: Called with the fraction that is done, 0 to 1; None: not reported.

        Raises:
            Error: The table of the material has another grid.
        """
        decoded, size = self._handle.encode(material._handle, coefficients, name, progress)
        return PatchCode(Material(decoded), size)


def learn_patches(sources: Sequence[PathLike] = (), excluded: Sequence[str] = (), progress: Progress = None) -> PatchDictionary:
    """Learns 256 atoms for patches of 12 x 9 x 9 cells (phi_d, theta_d, theta_h) by K-SVD (Aharon, Elad and Bruckstein 2006,
    "K-SVD: An Algorithm for Designing Overcomplete Dictionaries for Sparse Representation"), from 8,000 patches at random
    positions of the signals log(1 + rho) with cell scaling (docs/dictionaries.md). About 20 s on two cores.

    Args:
        sources: The training set: files, folders of files, or names of bundled materials; (): the measured and near-measured
            bundled materials.
        excluded: Names of materials to leave out of the training set; (): none.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: A file cannot be read, grids differ, a grid is not a multiple of the patches (12, 9, 9), or a name in `excluded`
            matches no material.
    """
    return PatchDictionary(_core.learn_patches([os.fsencode(source) for source in sources], list(excluded), progress))
