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
from ._materials import Material, PathLike, Progress

Box = Sequence[Sequence[float]]


class Basis:
    """Principal components of materials: what is known before one is measured (Nielsen et al. 2015, "On Optimal, Minimal
    BRDF Sampling for Reflectance Acquisition"). Made by gonio.bundled_basis(), learn_basis() and open_basis()."""

    __slots__ = ("_handle",)

    def __init__(self, handle: Any) -> None:
        """Bases are made by gonio.bundled_basis(), learn_basis() and open_basis(), not directly."""
        if not isinstance(handle, _core.Basis):
            raise TypeError("make a basis by gonio.bundled_basis() or gonio.learn_basis()")
        self._handle = handle

    def __repr__(self) -> str:
        return f"<gonio.Basis: {len(self)} components on {self.grid}>"

    def __len__(self) -> int:
        """Number of components."""
        return len(self._handle)

    @property
    def grid(self) -> tuple[int, int, int]:
        """Nodes along theta_h, theta_d, phi_d of its tables."""
        return self._handle.grid

    @property
    def singular_values(self) -> NDArray[np.float64]:
        """Singular values of the mapped training signals, falling."""
        return self._handle.singular_values

    @property
    def learned_from(self) -> list[str]:
        """Names of the training materials; empty of the bundled basis."""
        return self._handle.learned_from

    def encode(self, material: Material, components: int, progress: Progress = None) -> NDArray[np.float32]:
        """The coefficients of a material in the first components: the nearest by mapped values. Shape (3, components).

        Raises:
            Error: The table of the material has another grid.
        """
        return self._handle.encode(material._handle, components, progress)

    def decode(self, code: ArrayLike, name: str = "components", progress: Progress = None) -> Material:
        """The table that coefficients of shape (3, components) stand for. Raises Error where there are too many."""
        return Material(self._handle.decode(np.asarray(code, dtype=np.float32), name, progress))

    def save(self, path: PathLike) -> None:
        """Writes a .basis file, atomically, in half precision. Raises Error naming the file."""
        self._handle.save(os.fspath(path))


def bundled_basis(progress: Progress = None) -> Basis:
    """The components of the bundled materials on a grid of 45 x 45 x 45 nodes; learned at the first call (5 s)."""
    return Basis(_core.bundled_basis(progress))


def learn_basis(sources: Sequence[PathLike] = (), excluded: Sequence[str] = (), components: int = 1024,
                progress: Progress = None) -> Basis:
    """The principal components of measured materials, on the grid of MERL tables.

    Memory: 13 MB per material; time: about 1 s per material and some more.

    Args:
        sources: Files, or folders of measured materials; none: the bundled library.
        excluded: Names of materials to leave out.
        components: That are kept, at most.
        progress: Called with the fraction that is done. An exception that it raises stops the work.

    Raises:
        Error: A file cannot be read, its grid is another, or a name excludes nothing.
    """
    return Basis(_core.learn_basis([os.fspath(source) for source in sources], list(excluded), components, progress))


def open_basis(path: PathLike) -> Basis:
    """Reads a .basis file, such as lies beside a plan of `goniotool plan`. Raises Error naming the file."""
    return Basis(_core.read_basis(os.fspath(path)))


@dataclass(frozen=True)
class Readings:
    """What was measured at the samples of a plan."""

    values: NDArray[np.float64]
    """Linear RGB in 1/sr, without the cosine, shape (samples, 3)."""
    noise: Optional[NDArray[np.float64]] = None
    """Standard deviations of these, or None where they are not known."""


class Plan:
    """Pairs of directions to measure, the most informative first, see gonio.plan()."""

    __slots__ = ("_handle", "condition_number", "residuals", "warning")

    def __init__(self, wi: ArrayLike, wo: ArrayLike) -> None:
        """A plan of given directions.

        Args:
            wi: Directions toward the light, shape (samples, 3), unit vectors.
            wo: Directions toward the viewer, likewise.

        Raises:
            Error: The shapes do not fit, or a direction is no unit vector above the horizon.
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
        """Directions toward the light, shape (samples, 3). Of isotropic materials both may be turned about the normal."""
        return self._handle.directions[0]

    @property
    def wo(self) -> NDArray[np.float64]:
        """Directions toward the viewer, shape (samples, 3)."""
        return self._handle.directions[1]

    @property
    def order(self) -> list[int]:
        """The numbers of the samples, from 0, in an order of measurement along a short path of a goniometer's arms."""
        return self._handle.order

    @property
    def method(self) -> str:
        """How the samples were chosen, "" where they were given."""
        return self._handle.method

    def save(self, path: PathLike) -> None:
        """Writes the plan as CSV, atomically (docs/acquisition.md). Raises Error naming the file."""
        self._handle.save(os.fspath(path))

    def save_values(self, readings: Readings, path: PathLike) -> None:
        """Writes readings as CSV, for `goniotool reconstruct`. Raises Error naming the file."""
        self._handle.save_values(readings.values, readings.noise, os.fspath(path))

    def open_values(self, path: PathLike) -> Readings:
        """Reads values of the plan from a CSV, of a goniometer for example. Raises Error naming the file and the line."""
        return Readings(*self._handle.read_values(os.fspath(path)))


def plan(samples: int = 20, basis: Optional[Basis] = None, method: str = "somp", components: int = 0,
         max_polar_angle: float = math.radians(85), min_separation: float = 0.0, forbidden: Sequence[Box] = (), seed: int = 1,
         restarts: int = 5, progress: Progress = None) -> Plan:
    """The directions at which to measure a material.

    Args:
        samples: How many.
        basis: What is known of materials; None: gonio.bundled_basis().
        method: "somp" (FROST; Tongbuasirilai 2023, Algorithm 4), "somp-first-columns" (the authors' code),
            "condition-number" (Nielsen et al. 2015), "random" or "uniform".
        components: That the choice looks at; 0: as many as samples.
        max_polar_angle: Largest polar angle of both directions, rad.
        min_separation: Smallest angle between light and viewer, rad.
        forbidden: Boxes that a goniometer cannot reach: ranges of theta_i, theta_o and |phi_i - phi_o| in rad,
            ((low, high), (low, high), (low, high)) each.
        seed: Of "condition-number" and "random".
        restarts: Of "condition-number".
        progress: Called with the fraction that is done. An exception that it raises stops the work.

    Returns:
        A plan with condition_number (of the chosen rows), residuals (of "somp") and warning (why there are fewer samples
        than were asked for, or "").

    Raises:
        Error: An option is out of its range, or nothing can be measured.
    """
    boxes = [[float(number) for limits in box for number in limits] for box in forbidden]
    known = basis or bundled_basis(progress)
    return Plan.__new__(Plan)._set(*_core.plan(known._handle, samples, method, components, max_polar_angle, min_separation,
                                               boxes, seed, restarts, progress))


def open_plan(path: PathLike) -> Plan:
    """Reads the CSV of a plan. Raises Error naming the file and the line."""
    return Plan.__new__(Plan)._set(_core.read_plan(os.fspath(path)))


def measure(material: Material, plan: Plan, noise: float = 0.0, floor: float = 0.0, misalignment: float = 0.0,
            seed: int = 1) -> Readings:
    """A material at the directions of a plan, as a goniometer reads it. All errors are Gaussian.

    Args:
        material: What is measured.
        plan: Where.
        noise: Standard deviation of a reading as a fraction of it.
        floor: Standard deviation beside that, 1/sr.
        misalignment: Standard deviation of each arm along each of two axes, rad.
        seed: Of the errors; the numbers that are drawn do not depend on their sizes.

    Raises:
        Error: A standard deviation is negative or not finite.
    """
    return Readings(*_core.measure(material._handle, plan._handle, noise, floor, misalignment, seed))


@dataclass(frozen=True)
class Reconstruction:
    """A whole material from few measurements, see gonio.reconstruct()."""

    material: Material
    """The material, a table on the grid of the basis."""
    ridge: float
    """Ridge that was used; 0 of "sparse"."""
    components: int
    """Components that could be used."""
    leave_one_out_error: float
    """Root of the mean squared error with which each mapped value is predicted from the others; NaN of "sparse"."""
    deviation: Optional[NDArray[np.float32]] = field(repr=False)
    """Standard deviation of the mapped value of each cell, NaN where nothing is known; None of "sparse"."""


def reconstruct(plan: Plan, readings: Readings, basis: Optional[Basis] = None, method: str = "ridge",
                ridge: Optional[float] = None, components: int = 0, atoms: int = 0, name: str = "reconstruction",
                progress: Progress = None) -> Reconstruction:
    """A whole material from few measurements and what is known of other materials (Nielsen et al. 2015; Tongbuasirilai
    2023, eq. 5.14).

    Args:
        plan: Where was measured.
        readings: What was read there, by gonio.measure() or of a goniometer.
        basis: What is known of materials; None: gonio.bundled_basis().
        method: "ridge", or "sparse": few components by orthogonal matching pursuit.
        ridge: Ridge parameter eta, such as the published 40; None: chosen by leave-one-out.
        components: Of the basis; 0: all of them.
        atoms: Of "sparse", components per channel; 0: by leave-one-out.
        name: Name of the material.
        progress: Called with the fraction that is done. An exception that it raises stops the work.

    Raises:
        Error: The numbers of samples and values differ, a value is negative or not finite, or an option is out of its range.
    """
    known = basis or bundled_basis(progress)
    row = _core.reconstruct(known._handle, plan._handle, np.asarray(readings.values, dtype=np.float64), readings.noise, method,
                            ridge, components, atoms, name, progress)
    row["material"] = Material(row["material"])
    return Reconstruction(**row)
