# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Materials: opening, evaluating, sampling, tables."""
from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Callable, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core

Progress = Optional[Callable[[float], object]]
PathLike = Union[str, "os.PathLike[str]"]


def _rows(first: ArrayLike, second: ArrayLike, names: tuple[str, str]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Two arrays of rows of three numbers, broadcast to one shape without copies."""
    arrays = [np.asarray(array, dtype=np.float64) for array in (first, second)]
    for array, name in zip(arrays, names):
        if array.ndim == 0 or array.shape[-1] != 3:
            raise _core.Error(f"{name}: found shape {array.shape}, expected (..., 3)")
    try:
        shape = np.broadcast_shapes(*(array.shape for array in arrays))
    except ValueError:
        raise _core.Error(
            f"{names[0]} and {names[1]}: shapes {arrays[0].shape} and {arrays[1].shape} do not broadcast") from None
    return np.broadcast_to(arrays[0], shape), np.broadcast_to(arrays[1], shape)


class Material:
    """A BRDF with its source: a measurement in its own form, a table, a model, factors, a code, or an edit of these.

    Immutable. Made by gonio.open(), gonio.from_table(), Model.material(), Factors.material() and the functions that
    return materials. All methods may be called from several threads; they release the GIL and use all cores.
    """

    __slots__ = ("_handle",)

    def __init__(self, handle: Any) -> None:
        """Materials are made by gonio.open() and the other functions, not directly."""
        if not isinstance(handle, _core.Material):
            raise TypeError("open a material by gonio.open() or make one by gonio.from_table()")
        self._handle = handle

    def __repr__(self) -> str:
        return f"<gonio.Material {self.name!r}: {self.format}>"

    @property
    def name(self) -> str:
        """Name without folder and suffix."""
        return self._handle.name

    @property
    def format(self) -> str:
        """Format of the file ("MERL", "RGL", ..), or what a material without a file is ("GGX", "table", "blend", ..)."""
        return self._handle.format

    @property
    def path(self) -> str:
        """Absolute path of the file, "library:SOURCE/NAME" of a bundled material, "" where there is no file."""
        return self._handle.path

    @property
    def sha256(self) -> str:
        """SHA-256 of the source in lower-case hex, "" where there is no file."""
        return self._handle.sha256

    @property
    def description(self) -> str:
        """Description from the file, or of the bundled material."""
        return self._handle.description

    @property
    def notes(self) -> list[str]:
        """What the reader changed, in sentences: "12 negative values were set to 0"."""
        return self._handle.notes

    @property
    def grid(self) -> tuple[int, ...]:
        """Sizes of the stored data, (90, 90, 180) of a MERL table; () where nothing is stored on a grid."""
        return self._handle.grid

    @property
    def is_isotropic(self) -> bool:
        """Whether the value depends on the difference of the azimuths only."""
        return self._handle.is_isotropic

    @property
    def is_reciprocal(self) -> bool:
        """Whether the value is known to stay when wi and wo are exchanged."""
        return self._handle.is_reciprocal

    @property
    def is_table(self) -> bool:
        """Whether the material is a table over half-difference coordinates, so that `values` and `valid` exist."""
        return self._handle.is_table

    @property
    def edit_count(self) -> int:
        """Number of edits, see gonio.edit()."""
        return self._handle.edit_count

    @property
    def values(self) -> NDArray[np.float32]:
        """The table without a copy: read-only float32 of shape (theta_h, theta_d, phi_d, 3), linear RGB in 1/sr.

        Node (i, j, k) lies at theta_h = (i / n_h)^2 pi/2, theta_d = (j / n_d) pi/2, phi_d = (k / n_phi) P with P = pi of
        a reciprocal table and 2 pi of others. Invalid cells are 0. The array keeps the table alive.

        Raises:
            Error: The material is no table; see tabulated().
        """
        return self._table()[0]

    @property
    def valid(self) -> NDArray[np.bool_]:
        """Which cells of `values` were measured and lie above the horizon: read-only, shape (theta_h, theta_d, phi_d).

        Raises:
            Error: The material is no table; see tabulated().
        """
        return self._table()[1]

    def _table(self) -> tuple[NDArray[Any], NDArray[Any]]:
        table = self._handle.table()
        if table is None:
            raise _core.Error(f"{self.name}: {self.format} is no table; material.tabulated() samples one")
        return table

    def evaluate(self, wi: ArrayLike, wo: ArrayLike) -> NDArray[np.float64]:
        """BRDF values of pairs of directions, without the cosine.

        About 50 ns per pair and core of a table, more of edits and codes. Blocks of pairs are evaluated on all cores.

        Args:
            wi: Directions toward the light, shape (..., 3): unit vectors away from the surface, z is the normal.
            wo: Directions toward the viewer, likewise. Both shapes are broadcast, (n, 1, 3) with (m, 3) to (n, m, 3).

        Returns:
            Linear RGB (sRGB primaries) in 1/sr, shape (..., 3). 0 where a direction is below the horizon.

        Raises:
            Error: A shape does not fit, or a direction has another length than 1.
        """
        return self._handle.evaluate(*_rows(wi, wo, ("wi", "wo")))

    def sample(self, wo: ArrayLike, u: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Directions of light by importance sampling, about proportional to the BRDF times cos theta_i.

        Models, factors and RGL files have a sampler of their own; one for other materials is estimated from their values
        at the first call (up to 0.1 s).

        Args:
            wo: Directions toward the viewer, shape (..., 3), unit vectors.
            u: Uniform random numbers in [0, 1), shape (..., 3): the first chooses a lobe, the others the direction.

        Returns:
            wi of shape (..., 3) and its density in 1/sr of shape (...). Density 0 marks a sample that is lost: it counts,
            with the value 0.

        Raises:
            Error: A shape does not fit, a direction is no unit vector, or a number lies outside [0, 1).
        """
        return self._handle.sample(*_rows(wo, u, ("wo", "u")))

    def pdf(self, wi: ArrayLike, wo: ArrayLike) -> NDArray[np.float64]:
        """Density of sample() at wi, in 1/sr.

        Args:
            wi: Directions toward the light, shape (..., 3), unit vectors.
            wo: Directions toward the viewer, broadcast with wi.

        Returns:
            Densities of shape (...): 0 below the horizon. The integral over wi is the fraction of samples that are not
            lost.

        Raises:
            Error: A shape does not fit, or a direction has another length than 1.
        """
        return self._handle.pdf(*_rows(wi, wo, ("wi", "wo")))

    def albedo(self, theta: ArrayLike) -> NDArray[np.float64]:
        """Directional albedo: the integral of the BRDF times cos theta_i over the hemisphere of wi.

        About 20 ms per angle.

        Args:
            theta: Polar angles of the viewer in rad, of any shape.

        Returns:
            Albedo per channel, shape theta.shape + (3,); at most 1 where energy is conserved.
        """
        angles = np.asarray(theta, dtype=np.float64)
        return self._handle.albedo(angles.ravel().tolist()).reshape(angles.shape + (3,))

    def tabulated(self, progress: Progress = None) -> Material:
        """The material as a table over half-difference coordinates: itself where it is one.

        Other forms are sampled at the nodes of the MERL grid (about 1 s); anisotropic materials become their mean over
        the azimuths.

        Args:
            progress: Called with the fraction that is done. An exception that it raises stops the work.
        """
        return self if self.is_table else Material(self._handle.tabulated(progress))

    def info(self, progress: Progress = None) -> dict[str, Any]:
        """Facts about the material, those of `goniotool info`.

        Returns:
            name, format, grid, path, sha256, description, notes; of its table `channels` ((min, max) of red, green and
            blue, 1/sr), `invalid_fraction` and `dynamic_range`; `albedo` at viewer angles of 0, 30, 60, 80 degrees.
        """
        keys = ("name", "format", "grid", "path", "sha256", "description", "notes")
        facts = {key: getattr(self, key) for key in keys}
        facts.update(self._handle.statistics(progress))
        angles = (0, 30, 60, 80)
        facts["albedo"] = dict(zip(angles, self.albedo(np.radians(angles)).tolist()))
        return facts

    def save(self, path: PathLike, progress: Progress = None) -> list[str]:
        """Writes the material, atomically, in the format of the suffix.

        .binary (MERL), .bsdf (RGL; an edited RGL file in its own parameterisation), .bin (of UTIA files), or .gonio: the
        edits with the path and hash of the file that they edit, without measured data. What was only read and is written
        in its own format is copied byte for byte.

        Returns:
            Sentences about what the file cannot hold; usually none.

        Raises:
            Error: The suffix is of no such format, the format does not hold the material, or the file cannot be written.
        """
        return self._handle.save(os.fspath(path), progress)


def open(path: PathLike, progress: Progress = None) -> Material:
    """Opens a material of any format, found by the content of the file.

    Args:
        path: A MERL, RGL, UTIA, Zemax, LightTools, ASTM, pgII or CUReT file, PDV factors (.pdv), a sparse code (.code), a
            .gonio document, whose edits are applied, or a bundled material: "library:rgl/NAME" (see gonio.library()).
        progress: Called with the fraction that is done. An exception that it raises stops the work.

    Raises:
        Error: No format takes the file (what each found stands in the message), or a document's source has changed.
    """
    return Material(_core.open(os.fspath(path), progress))


def from_table(values: ArrayLike, valid: Optional[ArrayLike] = None, reciprocal: bool = True, name: str = "table") -> Material:
    """A material from an array of values over half-difference coordinates. The array is copied.

    Args:
        values: Linear RGB in 1/sr, shape (theta_h, theta_d, phi_d, 3); Material.values has the nodes, and
            gonio.grid_directions() the directions at which to evaluate them. Negative values become 0.
        valid: Which cells count, shape (theta_h, theta_d, phi_d); None: all above the horizon.
        reciprocal: Whether phi_d covers [0, pi), which makes the material reciprocal; False: the whole circle.
        name: Name of the material.

    Raises:
        Error: The shapes do not fit, or a valid value is not finite.
    """
    return Material(_core.from_table(np.asarray(values, dtype=np.float32), valid, reciprocal, name))


@dataclass(frozen=True)
class GridDirections:
    """Nodes of a grid of half-difference coordinates as directions, see gonio.grid_directions()."""

    wi: NDArray[np.float64]
    """Directions toward the light, shape (theta_h, theta_d, phi_d, 3); phi_h = 0."""
    wo: NDArray[np.float64]
    """Directions toward the viewer, likewise."""
    valid: NDArray[np.bool_]
    """Whether both lie above the horizon, shape (theta_h, theta_d, phi_d)."""
    measure: NDArray[np.float64]
    """Solid angles of each cell: its weight in an integral over wi and wo, but for a constant factor."""


def grid_directions(shape: tuple[int, int, int] = (90, 90, 180), reciprocal: bool = True) -> GridDirections:
    """The directions of the nodes of a table, to fill one by gonio.from_table(), or to weight errors over its cells.

    Args:
        shape: Numbers of nodes along theta_h, theta_d, phi_d; by default those of MERL tables (Matusik et al. 2003).
        reciprocal: Whether phi_d covers [0, pi) or the whole circle.
    """
    return GridDirections(*_core.grid_directions(list(shape), reciprocal))


@dataclass(frozen=True)
class LibraryEntry:
    """A material that comes with Gonio, see gonio.library()."""

    path: str
    """What gonio.open() takes: "library:rgl/NAME"."""
    name: str
    """Name of the material."""
    description: str
    """Description with the source."""
    origin: str
    """"measured", "near-measured copy" or "published fit"."""
    kind: str
    """"metal", "paint", ..."""


def library() -> list[LibraryEntry]:
    """The bundled materials: measured ones, near-measured copies, published fits (docs/library.md)."""
    return [LibraryEntry(*row) for row in _core.library()]


@dataclass(frozen=True)
class Check:
    """One test of physical plausibility, see gonio.check()."""

    name: str
    """"reciprocity", "energy", "negative" or "non-finite"."""
    passed: bool
    """Whether `worst` is at most `limit`."""
    worst: float
    """The largest violation: a relative difference, an albedo, a value in 1/sr, a number of directions."""
    limit: float
    """What passes."""
    fraction: float
    """Of the directions that were tried: beyond the limit."""
    where: str
    """The directions of the worst, in degrees."""


def check(material: Material, progress: Progress = None) -> list[Check]:
    """Tests of plausibility: reciprocity, energy, negative and non-finite values, over a fixed set of directions (0.1 s)."""
    return [Check(**row) for row in material._handle.check(progress)]


def set_threads(count: int) -> None:
    """Bounds the threads that Gonio uses in this process; 0: all cores. Results do not depend on it."""
    _core.set_threads(count)
