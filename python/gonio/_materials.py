# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Materials: opening, evaluating, sampling, tables."""
from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import PathLike, check_finite

Progress = Optional[Callable[[float], object]]


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
    """A BRDF with its source: a measurement in its native form, a table, a model, factors, a code, or an edit of these.

    A material does not change after it is made; edits return new materials. It is made by gonio.open(), gonio.from_table(),
    Model.material(), Factors.material() and the functions that return materials. All methods may be called from several
    threads at once.
    """

    __slots__ = ("_handle",)

    def __init__(self, handle: Any) -> None:
        """Materials are made by gonio.open() and the other functions, not directly."""
        if not isinstance(handle, _core.Material):
            raise TypeError("open a material with gonio.open() or make one with gonio.from_table()")
        self._handle = handle

    def __repr__(self) -> str:
        return f"<gonio.Material {self.name!r}: {self.format}>"

    @property
    def name(self) -> str:
        """Name of the file without folder and suffix, or the name that the material was given."""
        return self._handle.name

    @property
    def format(self) -> str:
        """Format of the file ("MERL", "RGL", ...), or the kind of a material without a file ("GGX", "table", "blend", ...)."""
        return self._handle.format

    @property
    def path(self) -> str:
        """Absolute path of the file; "library:SOURCE/NAME" for a bundled material; "" for a material without a file."""
        return self._handle.path

    @property
    def sha256(self) -> str:
        """SHA-256 of the file in lower-case hex; "" for a material without a file."""
        return self._handle.sha256

    @property
    def description(self) -> str:
        """Description stored in the file or in the bundled library; "" if there is none."""
        return self._handle.description

    @property
    def notes(self) -> list[str]:
        """What was changed when the file was read, as sentences such as "12 negative values were set to 0"."""
        return self._handle.notes

    @property
    def grid(self) -> tuple[int, ...]:
        """Shape of the stored data, such as (90, 90, 180) for a MERL table; () if no data are stored on a grid."""
        return self._handle.grid

    @property
    def is_isotropic(self) -> bool:
        """Whether the BRDF depends on the azimuths only through phi_i - phi_o."""
        return self._handle.is_isotropic

    @property
    def is_reciprocal(self) -> bool:
        """Whether the BRDF is known to be the same after wi and wo are exchanged."""
        return self._handle.is_reciprocal

    @property
    def is_table(self) -> bool:
        """Whether the material is a table over half-difference angles, so that `values` and `valid` exist."""
        return self._handle.is_table

    @property
    def edit_count(self) -> int:
        """Number of edits, see gonio.edit()."""
        return self._handle.edit_count

    @property
    def values(self) -> NDArray[np.float32]:
        """The values of the table: a read-only view (no copy) of shape (n_h, n_d, n_phi, 3), linear RGB in 1/sr.

        Node (i, j, k) lies at theta_h = (i / n_h)^2 pi/2, theta_d = (j / n_d) pi/2, phi_d = (k / n_phi) P, where P is pi for
        a reciprocal table and 2 pi for others. Invalid cells are 0.

        Raises:
            Error: The material is not a table; see tabulated().
        """
        return self._table()[0]

    @property
    def valid(self) -> NDArray[np.bool_]:
        """Which cells of `values` are valid: measured and above the horizon. A read-only view of shape (n_h, n_d, n_phi).

        Raises:
            Error: The material is not a table; see tabulated().
        """
        return self._table()[1]

    def _table(self) -> tuple[NDArray[Any], NDArray[Any]]:
        table = self._handle.table()
        if table is None:
            raise _core.Error(f"{self.name}: the material is not a table ({self.format}); material.tabulated() samples it as a "
                              "table")
        return table

    def evaluate(self, wi: ArrayLike, wo: ArrayLike) -> NDArray[np.float64]:
        """BRDF values of pairs of directions, without the cosine.

        A table takes about 30 ns per pair on one core; edits and codes take longer. Large arrays are evaluated on all cores.

        Args:
            wi: Directions toward the light, shape (..., 3), unit vectors.
            wo: Directions toward the viewer, shape (..., 3), unit vectors. Both are broadcast as in NumPy: (n, 1, 3) and
                (m, 3) give values of shape (n, m, 3).

        Returns:
            Linear RGB in 1/sr, shape (..., 3); 0 where a direction is below the horizon.

        Raises:
            Error: The shapes do not broadcast, or a direction is not of length 1.
        """
        return self._handle.evaluate(*_rows(wi, wo, ("wi", "wo")))

    def sample(self, wo: ArrayLike, u: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Samples directions toward the light with a density about proportional to the BRDF times cos theta_i.

        The density is that of gonio.render(), chosen at the first call (up to 0.1 s): the material's own sampling method
        (models, factors, RGL files), or one estimated from the values of the material, whichever has less noise at equal time.

        The directional albedo at wo is the integral of the BRDF times cos theta_i over the hemisphere. Its Monte Carlo
        estimate from a million samples:

            wi, density = material.sample(wo, np.random.default_rng(1).random((1_000_000, 3)))
            weights = np.divide(wi[:, 2], density, out=np.zeros_like(density), where=density > 0)
            estimate = (material.evaluate(wi, wo) * weights[:, np.newaxis]).mean(axis=0)

        Args:
            wo: Directions toward the viewer, shape (..., 3), unit vectors; broadcast with u.
            u: Uniform random numbers in [0, 1), shape (..., 3): the first chooses a lobe, the others the direction.

        Returns:
            The directions wi, shape (..., 3), and their densities in 1/sr with respect to solid angle, shape (...). A sample
            with density 0 has failed, and its wi has no meaning: an estimator counts it with the value 0, as above.

        Raises:
            Error: The shapes do not broadcast, a direction is not of length 1, or a number lies outside [0, 1).
        """
        return self._handle.sample(*_rows(wo, u, ("wo", "u")))

    def pdf(self, wi: ArrayLike, wo: ArrayLike) -> NDArray[np.float64]:
        """Density with which sample() returns wi for the viewer wo, with respect to solid angle.

        Args:
            wi: Directions toward the light, shape (..., 3), unit vectors.
            wo: Directions toward the viewer, shape (..., 3), unit vectors; broadcast with wi.

        Returns:
            Densities in 1/sr, shape (...); 0 below the horizon. Their integral over wi is the fraction of samples with a
            density above 0.

        Raises:
            Error: The shapes do not broadcast, or a direction is not of length 1.
        """
        return self._handle.pdf(*_rows(wi, wo, ("wi", "wo")))

    def albedo(self, theta: ArrayLike) -> NDArray[np.float64]:
        """Directional albedo: the integral of the BRDF times cos theta_i over the hemisphere of wi.

        It is computed by quadrature, about 20 ms per angle, with the viewer at azimuth 0.

        Args:
            theta: Polar angles of the viewer in rad, an array of any shape or a number.

        Returns:
            Linear RGB without unit, shape theta.shape + (3,); at most 1 where the material conserves energy.

        Raises:
            Error: An angle is not finite.
        """
        angles = np.asarray(theta, dtype=np.float64)
        check_finite("theta", angles)
        return self._handle.albedo(angles.ravel().tolist()).reshape(angles.shape + (3,))

    def tabulated(self, progress: Progress = None) -> Material:
        """The material as a table over half-difference angles; a material that is a table is returned as it is.

        Other materials are evaluated at the nodes of the MERL grid, 90 x 90 x 180 (about 1 s). The table of a material that
        is not reciprocal, such as an RGL file, covers the whole circle of phi_d (90 x 90 x 360) and keeps negative values.
        The table of an anisotropic material is the mean over the azimuths.

        Args:
            progress: Called with the fraction that is done, 0 to 1; None: not reported.
        """
        return self if self.is_table else Material(self._handle.tabulated(progress))

    def info(self, progress: Progress = None) -> dict[str, Any]:
        """The facts that `goniotool info` prints.

        Args:
            progress: Called with the fraction that is done, 0 to 1; None: not reported.

        Returns:
            A dict with the properties name, format, grid, path, sha256, description and notes; `channels`, the (min, max) of
            the table's red, green and blue values in 1/sr; `invalid_fraction` of the table's cells; `dynamic_range`, the
            largest value over the smallest positive one; `albedo`, a dict from the viewer's polar angle in degrees (0, 30,
            60, 80) to [red, green, blue].
        """
        keys = ("name", "format", "grid", "path", "sha256", "description", "notes")
        facts = {key: getattr(self, key) for key in keys}
        facts.update(self._handle.statistics(progress))
        angles = (0, 30, 60, 80)
        facts["albedo"] = dict(zip(angles, self.albedo(np.radians(angles)).tolist()))
        return facts

    def save(self, path: PathLike, progress: Progress = None) -> dict:
        """Writes the material to a file in the format of its suffix; an existing file is replaced in one step.

        .binary is a MERL table, .bsdf an RGL file and .bin a UTIA file (docs/formats.md). .gonio stores the edits, and the path and hash of the file that they edit, without measured data. An unedited material that is
        written in its own format is copied byte for byte.

        Args:
            path: Name of the file with one of these suffixes.
            progress: Called with the fraction that is done, 0 to 1; None: not reported.

        Returns:
            A dict: "losses", what the file does not hold, one sentence each; "snr" and "brdf_snr", the rendered SNR and the
            BRDF SNR of the file against the material in dB, infinite if it holds the same values.

        Raises:
            Error: The suffix is unknown, or the file cannot be written.
        """
        return self._handle.save(os.fsencode(path), progress)


def open(path: PathLike, progress: Progress = None) -> Material:
    """Opens a material. The format is recognised by the content of the file, not by its suffix (docs/formats.md).

    Args:
        path: A file of any format that Gonio reads (docs/formats.md); a row of a table of non-parametric factors ("npf.bin#chrome"); a .gonio
            document, which is opened with its edits; or a bundled material, "library:rgl/NAME" (see gonio.library()).
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: No reader accepts the file (the message lists what each found and expected), or the file that a document edits
            has changed.
    """
    return Material(_core.open(os.fsencode(path), progress))


def from_table(values: ArrayLike, valid: Optional[ArrayLike] = None, reciprocal: bool = True, name: str = "table") -> Material:
    """A material from an array of values over half-difference angles. The array is copied.

    Args:
        values: Linear RGB in 1/sr, shape (n_h, n_d, n_phi, 3). Material.values describes the nodes, gonio.grid_directions()
            returns their directions. Negative values become 0.
        valid: Which cells have data, shape (n_h, n_d, n_phi); None: all cells above the horizon. Fits use valid cells only,
            evaluate() interpolates between them.
        reciprocal: True: phi_d covers [0, pi), and the material is reciprocal. False: phi_d covers [0, 2 pi).
        name: Name of the material.

    Raises:
        Error: The shapes do not match, or a value of a valid cell is not finite.
    """
    return Material(_core.from_table(np.asarray(values, dtype=np.float32), valid, reciprocal, name))


@dataclass(frozen=True)
class GridDirections:
    """The directions of the nodes of a table, see gonio.grid_directions()."""

    wi: NDArray[np.float64]
    """Directions toward the light, shape (n_h, n_d, n_phi, 3), with the half vector at azimuth 0."""
    wo: NDArray[np.float64]
    """Directions toward the viewer, of the same shape."""
    valid: NDArray[np.bool_]
    """Whether both directions lie above the horizon, shape (n_h, n_d, n_phi)."""
    measure: NDArray[np.float64]
    """Weight of each cell in an integral over wi and wo, up to a constant factor, shape (n_h, n_d, n_phi)."""


def grid_directions(shape: tuple[int, int, int] = (90, 90, 180), reciprocal: bool = True) -> GridDirections:
    """The directions of the nodes of a table, at which to compute its values for gonio.from_table().

    Args:
        shape: Numbers of nodes (n_h, n_d, n_phi) along theta_h, theta_d, phi_d; by default those of MERL tables (Matusik et
            al. 2003).
        reciprocal: True: phi_d covers [0, pi). False: phi_d covers [0, 2 pi).
    """
    return GridDirections(*_core.grid_directions(list(shape), reciprocal))


def coordinates() -> dict[str, tuple[str, ...]]:
    """The coordinate systems of gonio.to_coordinates() and gonio.from_coordinates() with the names of their coordinates, all
    angles except "deviation" (|Dp|, 0 to 2): "standard" (theta_i, phi_i, theta_o, phi_o), "half-difference" (theta_h, theta_d,
    phi_d; Rusinkiewicz 1998), "half-out" (theta_o, theta_h, phi_h; Lawrence et al. 2004), "projected-deviation" (theta_r,
    deviation, phi; Tongbuasirilai et al. 2017). Only "standard" keeps the azimuth of the viewer."""
    return _core.coordinates()


def to_coordinates(system: str, wi: ArrayLike, wo: ArrayLike) -> NDArray[np.float64]:
    """Coordinates of pairs of directions.

    Args:
        system: A name in gonio.coordinates().
        wi: Directions toward the light, shape (..., 3), unit vectors; broadcast with wo.
        wo: Directions toward the viewer, shape (..., 3), unit vectors.

    Returns:
        One number for each coordinate, shape (..., 3), or (..., 4) for "standard".

    Raises:
        Error: The system is unknown, the shapes do not broadcast, or a direction is not of length 1.
    """
    return _core.to_coordinates(system, *_rows(wi, wo, ("wi", "wo")))


def from_coordinates(system: str, values: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.bool_]]:
    """Pairs of directions that have the coordinates, the inverse of gonio.to_coordinates(). The viewer, or for
    "half-difference" the half vector, has azimuth 0.

    Args:
        system: A name in gonio.coordinates().
        values: One number for each coordinate, shape (..., 3), or (..., 4) for "standard".

    Returns:
        wi and wo, shape (..., 3), and whether a pair of directions above the horizon has the coordinates, shape (...). Where
        none has, wi and wo are the normal.

    Raises:
        Error: The system is unknown, the last dimension of `values` has another length, or a value is not finite.
    """
    array = np.asarray(values, dtype=np.float64)
    check_finite("values", array)
    rows = array.reshape(-1, array.shape[-1]) if array.ndim > 0 else array
    wi, wo, valid = _core.from_coordinates(system, rows)
    shape = array.shape[:-1]
    return wi.reshape(*shape, 3), wo.reshape(*shape, 3), valid.reshape(shape)


@dataclass(frozen=True)
class LibraryEntry:
    """A bundled material, see gonio.library()."""

    path: str
    """Argument for gonio.open(), such as "library:rgl/satin_purple"."""
    name: str
    """Name of the material."""
    description: str
    """Description, including who measured or fitted the material."""
    origin: str
    """"measured", "near-measured copy" (a neural fit of a measurement) or "published fit" (parameters from a paper)."""
    kind: str
    """Kind of material: "metal", "paint", ..."""


def library() -> list[LibraryEntry]:
    """The materials that are bundled with Gonio: measured ones, near-measured copies and published fits (docs/library.md)."""
    return [LibraryEntry(*row) for row in _core.library()]


@dataclass(frozen=True)
class Check:
    """Result of one test of physical plausibility, see gonio.check()."""

    name: str
    """"reciprocity", "energy", "negative" or "non-finite"."""
    passed: bool
    """Whether `worst` is at most `limit`."""
    worst: float
    """The largest violation. "reciprocity": relative difference after wi and wo are exchanged. "energy": directional albedo.
    "negative": size of a negative value, 1/sr. "non-finite": number of pairs of directions."""
    limit: float
    """The largest value of `worst` that passes."""
    fraction: float
    """Fraction of the tested directions that exceed the limit."""
    where: str
    """The directions at which `worst` was found, in degrees, as text; may be empty."""


def check(material: Material, progress: Progress = None) -> list[Check]:
    """Tests the plausibility of a material over a fixed set of directions: reciprocity, energy, negative and non-finite
    values. Takes about 0.1 s.

    Args:
        material: The material to test.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.
    """
    return [Check(**row) for row in material._handle.check(progress)]


def set_threads(count: int) -> None:
    """Sets the number of threads that Gonio uses in this process. Results do not depend on it.

    Args:
        count: Maximum number of threads; 0: one per core.
    """
    _core.set_threads(count)
