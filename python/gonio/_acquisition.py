# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Which directions to measure, and materials from few measurements."""
from __future__ import annotations

import math
import os
from dataclasses import dataclass, field
from typing import Any, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import PathLike, check_finite
from ._materials import Material, Progress, from_table
from ._representations import Dictionary

Box = Sequence[Sequence[float]]


class Basis:
    """Principal components of a training set of materials (Nielsen et al. 2015, "On Optimal, Minimal BRDF Sampling for
    Reflectance Acquisition"). Made by gonio.bundled_basis(), gonio.learn_basis() and gonio.open_basis(). len() is the
    number of components.

    The components are those of mapped values: each BRDF value rho is mapped to

        y = ln((rho w + 0.001) / (reference + 0.001)),  w = max(cos theta_i cos theta_o, 0.001)

    where reference is the median of rho w over the training set in the same cell (docs/acquisition.md). A difference of 0.1 in
    y is about 10 % of rho w + 0.001. Each channel of each training material is one training signal.
    """

    __slots__ = ("_handle",)

    def __init__(self, handle: Any) -> None:
        """Bases are made by gonio.bundled_basis(), learn_basis() and open_basis(), not directly."""
        if not isinstance(handle, _core.Basis):
            raise TypeError("make a basis with gonio.bundled_basis() or gonio.learn_basis()")
        self._handle = handle

    def __repr__(self) -> str:
        return f"<gonio.Basis: {len(self)} components on {self.grid}>"

    def __len__(self) -> int:
        """Number of components."""
        return len(self._handle)

    @property
    def grid(self) -> tuple[int, int, int]:
        """Shape (n_h, n_d, n_phi) of its tables."""
        return self._handle.grid

    @property
    def singular_values(self) -> NDArray[np.float64]:
        """Singular values of the mapped training signals less their mean, in descending order, shape (components,)."""
        return self._handle.singular_values

    @property
    def training_set(self) -> list[str]:
        """Names of the training materials; empty for the bundled basis."""
        return self._handle.learned_from

    def encode(self, material: Material, components: int, progress: Progress = None) -> NDArray[np.float32]:
        """Projects a material onto the first components, by least squares of the mapped values.

        Args:
            material: The material; its table must have the grid of the basis.
            components: Number of components.
            progress: Called with the fraction that is done, 0 to 1; None: not reported.

        Returns:
            Coefficients, shape (3, components).

        Raises:
            Error: The table of the material has another grid.
        """
        return self._handle.encode(material._handle, components, progress)

    def decode(self, code: ArrayLike, name: str = "components", progress: Progress = None) -> Material:
        """The material with the given coefficients, a table.

        Args:
            code: Coefficients, shape (3, components), for the first components.
            name: Name of the material.
            progress: Called with the fraction that is done, 0 to 1; None: not reported.

        Raises:
            Error: The shape is wrong, there are more coefficients than components, or a coefficient is not finite.
        """
        coefficients = np.asarray(code, dtype=np.float32)
        check_finite("code", coefficients)
        return Material(self._handle.decode(coefficients, name, progress))

    def save(self, path: PathLike) -> None:
        """Writes a .basis file in half precision; an existing file is replaced in one step. Raises Error if it cannot be
        written."""
        self._handle.save(os.fsencode(path))


def bundled_basis(progress: Progress = None) -> Basis:
    """The principal components of the bundled materials, on a grid of 45 x 45 x 45 nodes. They are computed at the first call
    in a process (5 s)."""
    return Basis(_core.bundled_basis(progress))


def learn_basis(sources: Sequence[PathLike] = (), excluded: Sequence[str] = (), components: int = 128,
                material_class: str = "all", progress: Progress = None) -> Basis:
    """Computes the principal components of a training set, on the grid of MERL tables. Takes up to 1 s and about 14 MB of
    memory per material; training sets that need more than 6 GB are stored in a temporary file instead. The result is kept in
    half precision in the user's cache folder (docs/acquisition.md), from which it is read in about a second the next time.

    Args:
        sources: The training set: files, folders of files, or names of bundled materials; (): the measured and near-measured
            bundled materials.
        excluded: Names of materials to leave out of the training set; (): none.
        components: Maximum number of components. There are never more than three per material.
        material_class: "all", or only the "diffuse" or "glossy" ones: a material is glossy if its luminance in the mirror
            direction at 15, 30 or 45 degrees is at least twice that beside the plane of incidence.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: A file cannot be read, its table has another grid, a name in `excluded` matches no material, or no material is of
            the class.
    """
    return Basis(_core.learn_basis([os.fsencode(source) for source in sources], list(excluded), components, material_class,
                                   progress))


def learn_atoms(sources: Sequence[PathLike] = (), excluded: Sequence[str] = (), dictionary: Optional[Dictionary] = None,
                atoms: int = 128, progress: Progress = None) -> Basis:
    """The atoms of dictionaries as signals for gonio.plan(), instead of the channels of training materials: those whose
    coefficients have the largest variances over a training set, each times its standard deviation (docs/acquisition.md). The
    result serves gonio.plan() alone. Takes about 4 MB of memory per atom, and the time of learning from the training set.

    Args:
        sources: The training set, as for gonio.learn_basis().
        excluded: Names of materials to leave out of the training set; (): none.
        dictionary: The dictionaries; None: the bundled ones.
        atoms: Number of atoms, at least the number of samples that gonio.plan() chooses.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: A file cannot be read, its table has another grid, or a name in `excluded` matches no material.
    """
    handle = dictionary._handle if dictionary is not None else None
    return Basis(_core.learn_atoms([os.fsencode(source) for source in sources], list(excluded), handle, atoms, progress))


_learned_library: Optional[Basis] = None


def _library_basis(progress: Progress) -> Basis:
    """gonio.learn_basis(), kept for the next call."""
    global _learned_library
    if _learned_library is None:
        _learned_library = learn_basis(progress=progress)
    return _learned_library


def separate(material: Material, progress: Progress = None) -> tuple[Material, Material]:
    """Separates a material into a diffuse and a specular part, two tables that add up to the table of the material
    (docs/dictionaries.md).

    Args:
        material: The material. A material that is not a table is sampled as a table first (1 s).
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Returns:
        The diffuse part, the specular part.
    """
    diffuse, specular = _core.separate(material._handle, progress)
    return Material(diffuse), Material(specular)


@dataclass(frozen=True)
class SeparatedBasis:
    """Principal components of the diffuse and of the specular part of a training set, after Sun, Jensen and Ramamoorthi 2018,
    "Connecting Measured BRDFs to Analytic BRDFs by Data-Driven Diffuse-Specular Separation"; the separation is that of
    gonio.separate(). See gonio.learn_separated_basis()."""

    diffuse: Basis
    """Components of the diffuse parts."""
    specular: Basis
    """Components of the specular parts."""

    def encode(self, material: Material, components: int, progress: Progress = None) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Separates a material and projects each part onto the first components of its basis.

        Args:
            material: The material; its table must have the grid of the basis.
            components: Number of components in all. A quarter, at least one, are diffuse.
            progress: Called with the fraction that is done, 0 to 1; None: not reported.

        Returns:
            Coefficients of the diffuse and of the specular part, shapes (3, n) and (3, components - n).

        Raises:
            Error: The table of the material has another grid.
        """
        diffuse, specular = separate(material, progress)
        count = min(max(1, components // 4), len(self.diffuse))
        return self.diffuse.encode(diffuse, count), self.specular.encode(specular, components - count)

    def decode(self, code: tuple[ArrayLike, ArrayLike], name: str = "components", progress: Progress = None) -> Material:
        """The material with the given coefficients, a table: the sum of both parts.

        Args:
            code: The result of encode().
            name: Name of the material.
            progress: Called with the fraction that is done, 0 to 1; None: not reported.

        Raises:
            Error: A shape is wrong, or there are more coefficients than components.
        """
        diffuse, specular = self.diffuse.decode(code[0], progress=progress), self.specular.decode(code[1])
        values = diffuse.values + specular.values
        return from_table(values, valid=diffuse.valid & specular.valid, name=name)


def learn_separated_basis(sources: Sequence[PathLike] = (), excluded: Sequence[str] = (), components: int = 1024,
                          progress: Progress = None) -> SeparatedBasis:
    """Computes the principal components of the diffuse and of the specular parts of a training set, as gonio.learn_basis() does
    of the whole. Takes twice the time and memory.

    Args:
        sources: The training set: files, folders of files, or names of bundled materials; (): the measured and near-measured
            bundled materials.
        excluded: Names of materials to leave out of the training set; (): none.
        components: Maximum number of components of each part.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: A file cannot be read, its table has another grid, or a name in `excluded` matches no material.
    """
    diffuse, specular = _core.learn_separated_basis([os.fsencode(source) for source in sources], list(excluded), components, progress)
    return SeparatedBasis(Basis(diffuse), Basis(specular))


def open_basis(path: PathLike) -> Basis:
    """Reads a .basis file, such as the one that `goniotool plan` writes beside a plan. Raises Error if it cannot be read."""
    return Basis(_core.read_basis(os.fsencode(path)))


@dataclass(frozen=True)
class Readings:
    """BRDF values that were measured at the directions of a plan, by gonio.measure() or by a goniometer."""

    values: NDArray[np.float64]
    """Linear RGB in 1/sr, without the cosine, shape (samples, 3); row i belongs to row i of Plan.wi and Plan.wo."""
    noise: Optional[NDArray[np.float64]] = None
    """Standard deviations of the values in 1/sr, shape (samples, 3); None: not known."""


class Plan:
    """A list of pairs of directions at which to measure a material, called its samples. gonio.plan() chooses them, the most
    informative first; the constructor takes directions at which you have measured.

    len() is the number of samples. Besides the properties, a plan has `condition_number`, `residuals` and `warning`, see
    gonio.plan().
    """

    __slots__ = ("_handle", "condition_number", "residuals", "warning")

    def __init__(self, wi: ArrayLike, wo: ArrayLike) -> None:
        """A plan with the given directions.

        Args:
            wi: Directions toward the light, shape (samples, 3), unit vectors.
            wo: Directions toward the viewer, shape (samples, 3), unit vectors.

        Raises:
            Error: The shapes differ, or a direction is not of length 1 or lies below the horizon.
        """
        self._set(_core.plan_of(np.asarray(wi, dtype=np.float64), np.asarray(wo, dtype=np.float64)))

    def _set(self, handle: Any, condition_number: float = math.nan, residuals: Sequence[float] = (), warning: str = "") -> Plan:
        self._handle = handle
        self.condition_number = condition_number
        self.residuals = np.asarray(residuals)
        self.warning = warning
        return self

    def __repr__(self) -> str:
        return f"<gonio.Plan: {len(self)} samples {self.method}>"

    def __len__(self) -> int:
        """Number of samples."""
        return len(self._handle)

    @property
    def wi(self) -> NDArray[np.float64]:
        """Directions toward the light, shape (samples, 3). For an isotropic material, you may rotate wi and wo
        together about the normal."""
        return self._handle.directions[0]

    @property
    def wo(self) -> NDArray[np.float64]:
        """Directions toward the viewer, shape (samples, 3)."""
        return self._handle.directions[1]

    @property
    def order(self) -> list[int]:
        """Indices of the samples, from 0, in the order of measurement, along a short path of the goniometer's arms. The column
        `order` of the CSV file contains the inverse: the rank of each sample, from 1."""
        return self._handle.order

    @property
    def method(self) -> str:
        """Method by which gonio.plan() chose the directions; "" for given directions."""
        return self._handle.method

    def save(self, path: PathLike) -> None:
        """Writes the plan as CSV (docs/formats.md); an existing file is replaced in one step. Raises Error if it
        cannot be written."""
        self._handle.save(os.fsencode(path))

    def save_values(self, readings: Readings, path: PathLike) -> None:
        """Writes readings as CSV, for `goniotool reconstruct`. Raises Error if the file cannot be written."""
        self._handle.save_values(readings.values, readings.noise, os.fsencode(path))

    def open_values(self, path: PathLike) -> Readings:
        """Reads the values measured at the directions of this plan from a CSV file (docs/formats.md). Raises Error with
        the file and the line."""
        return Readings(*self._handle.read_values(os.fsencode(path)))


def plan(samples: int = 20, basis: Optional[Basis] = None, method: str = "auto", components: int = 0,
         max_polar_angle: float = math.radians(85), min_separation: float = 0.0, forbidden: Sequence[Box] = (), seed: int = 1,
         restarts: int = 5, progress: Progress = None) -> Plan:
    """Chooses the directions at which to measure a material.

    Args:
        samples: Number of pairs of directions.
        basis: Principal components of the training set; None: gonio.learn_basis().
        method: "auto" ("a-optimal" for up to 20 samples, "somp" for more), "somp" (simultaneous orthogonal matching
            pursuit, FROST; Tongbuasirilai 2023, Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition,
            Algorithm 4), "somp-first-columns" (the same over the first training signals alone, as in the authors' code),
            "somp-unnormalised" (Algorithm 4 as printed, without the normalisation of the columns), "condition-number"
            (Nielsen et al. 2015), "random", "uniform" or "a-optimal" (the smallest expected variance of all cells,
            docs/acquisition.md).
        components: Number of components that the choice uses; 0: the number of samples, with "a-optimal" at least 30.
        max_polar_angle: Maximum polar angle of both directions, rad.
        min_separation: Minimum angle between light and viewer, rad; 0: no limit.
        forbidden: Boxes of angles that the goniometer cannot reach, each as ranges of theta_i, theta_o and |phi_i - phi_o| in
            rad: ((low, high), (low, high), (low, high)); (): none.
        seed: Seed of the random numbers of "condition-number" and "random".
        restarts: Number of searches of "condition-number", the best of which is used.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Returns:
        A plan with three more attributes: `condition_number`, the largest over the smallest singular value of the basis' rows
        at the samples; `residuals`, before the first sample and after each, shape (samples + 1,): for the
        methods whose names begin with "somp" the relative residual of the training signals, for "a-optimal" the square root
        of the expected variance of all cells, relative to that before the first sample; otherwise empty; `warning`, the
        reason if there are fewer samples than requested, otherwise "". A plan of given directions has NaN, an empty array
        and "".

    Raises:
        Error: An argument is out of its range, or no direction can be measured.
    """
    boxes = [[float(number) for limits in box for number in limits] for box in forbidden]
    known = basis or _library_basis(progress)
    return Plan.__new__(Plan)._set(*_core.plan(known._handle, samples, method, components, max_polar_angle, min_separation,
                                               boxes, seed, restarts, progress))


def open_plan(path: PathLike) -> Plan:
    """Reads a plan from a CSV file (docs/formats.md). Raises Error with the file and the line."""
    return Plan.__new__(Plan)._set(_core.read_plan(os.fsencode(path)))


def measure(material: Material, plan: Plan, noise: float = 0.0, floor: float = 0.0, misalignment: float = 0.0,
            seed: int = 1) -> Readings:
    """Simulates the measurement of a material by a goniometer. All errors are Gaussian; values below 0 become 0.

    Args:
        material: The material to measure.
        plan: The directions.
        noise: Standard deviation of each value as a fraction of the value.
        floor: Standard deviation of each value in the dark, 1/sr, in addition to `noise`.
        misalignment: Standard deviation of the pointing error of each arm, about each of two axes, rad.
        seed: Seed of the random numbers. They depend on it alone: twice the noise gives twice each error.

    Raises:
        Error: A standard deviation is negative or not finite.
    """
    return Readings(*_core.measure(material._handle, plan._handle, noise, floor, misalignment, seed))


@dataclass(frozen=True)
class Reconstruction:
    """A material reconstructed from measured values, see gonio.reconstruct()."""

    material: Material
    """The reconstructed material, a table on the grid of the basis."""
    ridge: float
    """Ridge parameter eta that was used; for "local-ridge" the noise variance s^2 of the combination with the largest weight
    (docs/acquisition.md), converted to eta; 0 for "sparse" and "basis-pursuit"."""
    components: int
    """Number of components of the basis that were used."""
    leave_one_out_error: float
    """Root mean square error of predicting each sample's mapped value (see Basis) from all other samples, for "local-ridge" in
    the combination with the largest weight; NaN for "sparse", "basis-pursuit", and for one sample."""
    assumption: str
    """What is assumed of light and viewer: a reading also stands for both exchanged, so that the material is reciprocal."""
    deviation: Optional[NDArray[np.float32]] = field(repr=False)
    """Uncertainty: standard deviation of the mapped value (see Basis) of each cell, shape (n_h, n_d, n_phi); NaN in invalid
    cells; None for "sparse" and "basis-pursuit"."""
    warnings: list[str] = field(repr=False)
    """Problems of the readings, one sentence each: several readings of one direction, nearly dependent directions; usually
    empty."""


def reconstruct(plan: Plan, readings: Readings, basis: Optional[Basis] = None, method: Optional[str] = None,
                ridge: Optional[float] = None, components: int = 0, atoms: int = 0, equal_noise: bool = False,
                name: str = "reconstruction", progress: Progress = None) -> Reconstruction:
    """Reconstructs a whole material from few measured values and the principal components of a training set (Nielsen et al.
    2015; Tongbuasirilai 2023, eq. 5.14). The result is isotropic and reciprocal. Each sample is read at the nearest node of the
    basis' grid. The published method is `reconstruct(plan, readings, basis, ridge=40, components=len(plan), equal_noise=True)`.

    Args:
        plan: The measured directions, by gonio.plan() or gonio.Plan(wi, wo).
        readings: The measured values, by gonio.measure() or gonio.Readings(values).
        basis: Principal components of the training set; None: gonio.learn_basis(). It should be the one that the directions
            were planned with, and should not contain the material itself if you report the error.
        method: "local-ridge" (ridge regression over the training materials that agree with the readings), "ridge" (over all
            training materials), "sparse" (few components, by orthogonal matching pursuit) or "basis-pursuit" (smallest sum
            of absolute coefficients); None: "ridge" if `ridge` or `equal_noise` is given, otherwise "local-ridge".
        ridge: Ridge parameter eta of "ridge", such as the published 40; None: chosen by leave-one-out.
        components: Number of components to use; 0: all of the basis.
        atoms: Number of components per channel that "sparse" chooses; 0: chosen by leave-one-out.
        equal_noise: Whether all samples have the same weight in "ridge", as in eq. 5.14 as printed. Otherwise the ridge of a
            sample includes the components that are not used and the standard deviation of the reading (docs/acquisition.md).
        name: Name of the material.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: The numbers of directions and values differ, a value is negative, not finite or above the largest float, a sample
            lies where a training material has no value (the message states its number, from 1), or an argument is out of its
            range.
    """
    known = basis or _library_basis(progress)
    if method is None:
        method = "ridge" if ridge is not None or equal_noise else "local-ridge"
    row = _core.reconstruct(known._handle, plan._handle, np.asarray(readings.values, dtype=np.float64), readings.noise, method,
                            ridge, components, atoms, equal_noise, name, progress)
    row["material"] = Material(row["material"])
    return Reconstruction(**row)
