# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Training of dictionaries."""
from __future__ import annotations

import os
from typing import Sequence

from . import _core
from ._materials import PathLike, Progress
from ._representations import Dictionary, dictionary


def train_dictionary(sources: Sequence[PathLike], out: PathLike, excluded: Sequence[str] = (), dictionaries: int = 8,
                     sparsities: Sequence[int] = (32, 64, 128, 256), iterations: int = 12, passes: int = 4,
                     tolerance: float = 5e-4, subspace_loss: float = 3e-5, as_published: bool = False, seed: int = 1,
                     progress: Progress = None) -> Dictionary:
    """Learns an ensemble of orthonormal dictionaries from a training set, writes it to a file and opens it: alternately, each
    signal is assigned to the dictionary that represents it best, and each dictionary is fitted to its signals (Miandji et al.
    2019; Tongbuasirilai 2023, Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition, section 4.3.2). A
    signal is one channel of a material after one transform. 137 materials take about 20 minutes on two cores; a
    training that is interrupted writes nothing (`goniotool dictionary train --checkpoint` can resume one).

    Args:
        sources: Measured materials: files, or folders of them. All tables must have the same grid.
        out: The .dictionary file to write; an existing file is replaced in one step.
        excluded: Names of materials to exclude.
        dictionaries: Number of dictionaries for each sparsity, K.
        sparsities: Numbers of coefficients per signal; the dictionaries of each sparsity are learned together.
        iterations: Maximum number of rounds per sparsity.
        passes: Number of times per round that each dictionary is fitted to its signals before the signals are assigned again.
        tolerance: The rounds of a sparsity end when one lowers the relative squared error by less than this fraction.
        subspace_loss: Maximum fraction of the energy that the subspace shared by all dictionaries may omit.
        as_published: Whether to learn from transformed values without cell scaling.
        seed: Seed of the first assignment of signals to dictionaries.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: A file cannot be read or written, grids differ, or an argument is out of range.
    """
    _core.train_dictionary([os.fspath(source) for source in sources], os.fspath(out), list(excluded), dictionaries,
                           list(sparsities), iterations, passes, tolerance, subspace_loss, as_published, seed, progress)
    return dictionary(out)
