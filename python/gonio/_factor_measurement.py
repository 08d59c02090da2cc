# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Materials predicted from two measured curves."""
from __future__ import annotations

import math
import os
from dataclasses import dataclass, field
from typing import Any, Sequence

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arguments import PathLike
from ._acquisition import Plan, Readings
from ._materials import Material


class FactorPlan(Plan):
    """The pairs of directions of a factor measurement, by gonio.plan_factors(): two curves in the plane of incidence.
    gonio.measure() simulates their readings. Besides the properties of a plan, it has `axes` (the name of its axes), `curves`
    (for each sample "along", in the mirror direction, "across", at the fixed angle, or "further", at other angles) and `blocked` (number of readings that
    were left out: a direction is below the horizon or beyond the maximum polar angle, or one arm occludes the other).
    """

    __slots__ = ("axes", "curves", "blocked")

    def __init__(self, handle: Any, axes: str, curves: Sequence[str], blocked: int) -> None:
        """Made by gonio.plan_factors() and gonio.open_factor_readings(), not directly."""
        self._set(handle)
        self.axes = axes
        self.curves = list(curves)
        self.blocked = blocked

    def save_readings(self, readings: Readings, path: PathLike) -> None:
        """Writes the directions and the readings as CSV (docs/formats.md). Raises Error if the numbers of directions and
        values differ, or the file cannot be written."""
        _core.write_factor_readings(self._handle, self.axes, self.curves, readings.values, readings.noise, os.fsencode(path))


def plan_factors(axes: str = "adaptive", fixed_angle: float = math.radians(60), angles: int = 90, distances: int = 90,
                 max_polar_angle: float = math.radians(89), min_separation: float = math.radians(2)) -> FactorPlan:
    """The readings of a factor measurement (Tongbuasirilai et al. 2017): the curve "along", in the mirror direction at
    increasing angles, and the curve "across", at a fixed angle and increasing distances from the mirror direction.

    Args:
        axes: "adaptive": readings also at further angles, and the material is fitted to all of them. Otherwise angle and
            distance from the mirror direction of a product of two curves: "projected-deviation" (theta_R, |Dp|; published),
            "symmetric-deviation" (theta_d, |Dp|, from the same readings), "half-difference" (theta_d, theta_h) or
            "half-out" (theta_o, theta_h).
        fixed_angle: Fixed angle of the "across" curve, rad.
        angles: Number of "along" readings, evenly spaced in the angle. With "adaptive" only the sum angles + distances
            counts: two ninths are on each curve, the others at up to five further angles.
        distances: Number of "across" readings, evenly spaced in the square root of the distance.
        max_polar_angle: Maximum polar angle of both directions, rad.
        min_separation: Minimum angle between light and viewer, rad.

    Raises:
        Error: An argument is out of its range, or a curve has no reading that the arms do not obstruct.
    """
    handle, curves, blocked = _core.plan_factors(axes, fixed_angle, angles, distances, max_polar_angle, min_separation)
    return FactorPlan(handle, axes, curves, blocked)


def open_factor_readings(path: PathLike, axes: str) -> tuple[FactorPlan, Readings]:
    """Reads the directions and values of a factor measurement from a CSV file (docs/formats.md).

    Args:
        path: The file.
        axes: The axes, see gonio.plan_factors(). The readings of "projected-deviation" also serve "symmetric-deviation",
            "half-out" and "adaptive".

    Raises:
        Error: The file cannot be read; the message states the line.
    """
    (handle, curves, blocked), values, noise = _core.read_factor_readings(os.fsencode(path), axes)
    return FactorPlan(handle, axes, curves, blocked), Readings(values, noise)


@dataclass(frozen=True)
class FactorPrediction:
    """A material predicted from two curves, see gonio.predict_from_factors(). Fractions refer to all pairs of directions,
    weighted by the cosines and solid angles."""

    material: Material
    """The predicted material."""
    angles: NDArray[np.float64] = field(repr=False)
    """Angles of the "along" readings, rad."""
    along: NDArray[np.float64] = field(repr=False)
    """Curve "along": z = ln(1 + rho) in the mirror direction, shape (angles, 3); 1 in a channel in which the mirror
    direction at the fixed angle is black (`unscaled`)."""
    distances: NDArray[np.float64] = field(repr=False)
    """Distances of the "across" readings from the mirror direction: |Dp|, or theta_h in rad, depending on the axes."""
    across: NDArray[np.float64] = field(repr=False)
    """Curve "across": z at the fixed angle divided by z in the mirror direction there, shape (distances, 3). For the axes
    "symmetric-deviation" and "adaptive" it is also multiplied by z(fixed angle) / z(theta_d) of the curve "along". In a channel that is
    `unscaled`, it is z itself."""
    contradicted: float
    """Fraction at which exchanging light and viewer changes the unbounded prediction by more than a factor of 2."""
    extrapolated: float
    """Fraction outside the readings, where the last reading of a curve is used."""
    bounded: float
    """Fraction at which the product is more than twice the larger of the readings at the same angle and at the same distance."""
    unscaled: tuple[bool, bool, bool]
    """For each channel, whether the mirror direction at the fixed angle is black; the curve "across" is then used for all
    angles without scaling."""
    warnings: list[str]
    """Sentences that state where and why the prediction is unreliable."""


def predict_from_factors(plan: FactorPlan, readings: Readings, bound: str = "readings",
                         name: str = "prediction") -> FactorPrediction:
    """Predicts a whole material from the readings of a factor measurement. With the axes "adaptive", it is fitted to all
    readings (docs/factors.md). Otherwise it is a product of two curves: z_ij = z_mj z_i1 / z_m1 with z = ln(1 + rho)
    (Tongbuasirilai 2023, Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition, eq. 5.6), which is exact if
    z is such a product.

    Args:
        plan: The directions, by gonio.plan_factors() or gonio.open_factor_readings().
        readings: The values, by gonio.measure() or gonio.Readings(values).
        bound: "readings" limits the prediction: at most the larger of the readings at the same angle and at the same
            distance, and at most the prediction with light and viewer exchanged. With "adaptive" only the first
            limit applies. "none" is the printed equation, or no limit.
        name: Name of the material.

    Raises:
        Error: The numbers of directions and values differ, the readings do not lie on two curves, or `bound` is unknown.
    """
    row = _core.predict_from_factors(plan._handle, plan.axes, plan.curves, np.asarray(readings.values, dtype=np.float64),
                                     readings.noise, bound, name)
    row["material"] = Material(row["material"])
    return FactorPrediction(**row)
