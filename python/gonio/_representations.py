# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Factors, sparse codes, interpolation."""
from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._materials import Material, PathLike, Progress


class Factors:
    """A material as sums of products of curves over projected-deviation coordinates (PDV), see gonio.factorize():

        y(theta_R, |Dp|, |phi|) = sum_l F1_l(theta_R) F2_l(|Dp|) F3_l(|phi|)

    with y the transformed BRDF value (Tongbuasirilai et al. 2017 and 2019; docs/factors.md). Immutable.
    """

    __slots__ = ("_handle",)

    def __init__(self, handle: Any) -> None:
        """Factors are made by gonio.factorize() and gonio.open_factors(), not directly."""
        if not isinstance(handle, _core.Factors):
            raise TypeError("make factors by gonio.factorize()")
        self._handle = handle

    def __repr__(self) -> str:
        return f"<gonio.Factors: {self.terms} terms, {self.form}, {self.bytes} bytes>"

    @property
    def form(self) -> str:
        """"2d": F1 and F2 (round highlights); "3d": F1, F2 and F3."""
        return self._handle.form

    @property
    def transform(self) -> str:
        """Transform of BRDF values: "log-plus", "cosine-log", "root" or "none"."""
        return self._handle.transform

    @property
    def terms(self) -> int:
        """Number of products that are summed, in each channel."""
        return self._handle.terms

    @property
    def bytes(self) -> int:
        """Size of the file that save() writes."""
        return self._handle.bytes

    @property
    def residuals(self) -> NDArray[np.float64]:
        """|y - y^| / |y| for 0, 1, .. terms in the weighted norm; empty of factors that were read or changed."""
        return self._handle.residuals

    @property
    def seconds(self) -> float:
        """Time of the factorisation; 0 of factors that were read or changed."""
        return self._handle.seconds

    @property
    def theta_nodes(self) -> NDArray[np.float64]:
        """Nodes of theta_R in rad: the polar angle of the viewer."""
        return self._handle.theta_nodes

    @property
    def deviation_nodes(self) -> NDArray[np.float64]:
        """Nodes of |Dp|: the distance of wi from the mirror direction, projected to the surface."""
        return self._handle.deviation_nodes

    @property
    def phi_nodes(self) -> NDArray[np.float64]:
        """Nodes of |phi| in rad; one node in the form "2d"."""
        return self._handle.phi_nodes

    @property
    def f1(self) -> NDArray[np.float64]:
        """F1, specular strength over theta_R: a copy of shape (3, terms, nodes)."""
        return self._handle.f1

    @property
    def f2(self) -> NDArray[np.float64]:
        """F2, highlight profile over |Dp|, of largest value 1 in size: a copy of shape (3, terms, nodes)."""
        return self._handle.f2

    @property
    def f3(self) -> NDArray[np.float64]:
        """F3 over |phi|, of largest value 1 in size: a copy of shape (3, terms, nodes)."""
        return self._handle.f3

    def with_curves(self, f1: Optional[ArrayLike] = None, f2: Optional[ArrayLike] = None,
                    f3: Optional[ArrayLike] = None) -> Factors:
        """The factors with other curves, each of the shape that it has; None: as they are.

        Raises:
            Error: A shape does not fit, or a value is not finite.
        """
        return Factors(self._handle.with_curves(f1, f2, f3))

    def truncated(self, terms: int) -> Factors:
        """The factors with their first terms alone: the same as a factorisation with so many."""
        return Factors(self._handle.truncated(terms))

    def material(self, name: str = "factors") -> Material:
        """The material that the factors stand for, evaluated from the curves without a table."""
        return Material(self._handle.material(name))

    def save(self, path: PathLike) -> None:
        """Writes a .pdv file, atomically, in single precision. Raises Error naming the file."""
        self._handle.save(os.fspath(path))


def factorize(material: Material, terms: int = 10, form: str = "3d", transform: str = "log-plus",
              deviation_nodes: Sequence[float] = (), progress: Progress = None) -> Factors:
    """Factorises a material into curves of projected-deviation coordinates. About 1 s for ten terms.

    Args:
        material: What is factorised; one that is no table is sampled first (1 s).
        terms: Products of curves that are summed, 1 to 20. Fewer are the first ones of more.
        form: "2d" (Tongbuasirilai et al. 2017) or "3d" (2019; Tongbuasirilai 2023, eq. 4.25).
        transform: "log-plus" (ln(1 + rho)), "cosine-log", "root" or "none".
        deviation_nodes: Nodes of |Dp|, strictly increasing from 0; none: those that suit the material.
        progress: Called with the fraction that is done. An exception that it raises stops the work.

    Raises:
        Error: An option is out of its range.
    """
    return Factors(_core.factorize(material._handle, terms, form, transform, list(deviation_nodes), progress))


def open_factors(path: PathLike) -> Factors:
    """Reads a .pdv file. Raises Error naming the file."""
    return Factors(_core.read_factors(os.fspath(path)))


class Dictionary:
    """An ensemble of orthonormal dictionaries for sparse codes (Miandji et al. 2019; Tongbuasirilai 2023, section 4.3.2;
    docs/dictionaries.md), see gonio.dictionary()."""

    __slots__ = ("_handle",)

    def __init__(self, handle: Any) -> None:
        """Dictionaries are opened by gonio.dictionary(), not directly."""
        if not isinstance(handle, _core.Dictionary):
            raise TypeError("open a dictionary by gonio.dictionary()")
        self._handle = handle

    def __repr__(self) -> str:
        return f"<gonio.Dictionary {self.id:016x}: {len(self)} dictionaries>"

    def __len__(self) -> int:
        """Number of dictionaries; each channel of a code is over one of them."""
        return len(self._handle)

    @property
    def id(self) -> int:
        """What codes call it by: the first eight bytes of the SHA-256 of its file."""
        return self._handle.id

    @property
    def bytes(self) -> int:
        """Size in single precision."""
        return self._handle.bytes

    @property
    def grid(self) -> tuple[int, int, int]:
        """Nodes along theta_h, theta_d, phi_d of the tables that it encodes."""
        return self._handle.grid

    @property
    def learned_from(self) -> list[str]:
        """Names of the training materials."""
        return self._handle.learned_from

    def atoms(self, number: int) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        """The orthonormal matrices of one dictionary for phi_d, theta_d and theta_h; columns are atoms. Copies."""
        return self._handle.atoms(number)


def dictionary(path: PathLike = "") -> Dictionary:
    """A .dictionary file that `goniotool dictionary train` has written; "": the one that comes with Gonio."""
    return Dictionary(_core.dictionary(os.fspath(path)))


@dataclass(frozen=True)
class ChannelCode:
    """Coefficients of one channel of a code."""

    dictionary: int
    """Number of the dictionary in its ensemble."""
    indices: NDArray[np.int64]
    """Atoms along phi_d, theta_d, theta_h of each coefficient, shape (n, 3)."""
    values: NDArray[np.float32]
    """Coefficients, larger in size first, shape (n,)."""


class Code:
    """A material as a sparse code over a dictionary, in half precision, see gonio.encode(). Immutable."""

    __slots__ = ("_handle",)

    def __init__(self, handle: Any) -> None:
        """Codes are made by gonio.encode() and gonio.open_code(), not directly."""
        if not isinstance(handle, _core.Code):
            raise TypeError("make a code by gonio.encode()")
        self._handle = handle

    def __repr__(self) -> str:
        return f"<gonio.Code: {self.coefficients} coefficients per channel, {self.bytes} bytes>"

    @property
    def coefficients(self) -> int:
        """Coefficients of the channel that has most."""
        return self._handle.count

    @property
    def transform(self) -> str:
        """Transform of BRDF values: "log-plus" or "cosine-log"."""
        return self._handle.transform

    @property
    def bytes(self) -> int:
        """Size of the file that save() writes."""
        return self._handle.bytes

    @property
    def seconds(self) -> float:
        """Time of the encoding; 0 of a code that was read."""
        return self._handle.seconds

    @property
    def rendered_snr(self) -> float:
        """Rendered SNR in dB where the code was made for one, else NaN."""
        return self._handle.rendered_snr

    @property
    def channels(self) -> list[ChannelCode]:
        """The coefficients of red, green and blue."""
        return [ChannelCode(*channel) for channel in self._handle.channels]

    def material(self, as_table: bool = True, name: str = "code") -> Material:
        """The material that the code stands for.

        Args:
            as_table: Whether a table is decoded (50 ms); False: evaluated from the coefficients, under 1 us per pair.
            name: Name of the material.
        """
        return Material(self._handle.material(as_table, name))

    def save(self, path: PathLike) -> None:
        """Writes a .code file, atomically. Raises Error naming the file."""
        self._handle.save(os.fspath(path))


def encode(material: Material, coefficients: int = 262, dictionary: Optional[Dictionary] = None,
           transforms: Sequence[str] = ("log-plus", "cosine-log"), gamma: float = 2.0,
           relative_error: Optional[float] = None, max_bytes: Optional[int] = None,
           rendered_snr: Optional[float] = None, progress: Progress = None) -> Code:
    """A material as a sparse code: about 1 s; a minute where a rendered SNR is asked for.

    Args:
        material: What is encoded; one that is no table is sampled first (1 s).
        coefficients: Of each channel, at most.
        dictionary: The dictionary; None: the one that comes with Gonio.
        transforms: Transforms that are tried; the one of least gamma error is chosen.
        gamma: Of that error, 1 to 3 (Tongbuasirilai 2023, section 4.3.2.4).
        relative_error: Fewer coefficients where the squared error is at most this fraction of the energy.
        max_bytes: Fewer coefficients where the file would be larger.
        rendered_snr: As few coefficients as reach this rendered SNR in dB.
        progress: Called with the fraction that is done. An exception that it raises stops the work.

    Raises:
        Error: An option is out of its range, or the grid does not fit.
    """
    return Code(_core.encode(material._handle, coefficients, dictionary._handle if dictionary else None, list(transforms),
                             gamma, relative_error, max_bytes, rendered_snr, progress))


def open_code(path: PathLike, dictionary: Optional[Dictionary] = None) -> Code:
    """Reads a .code file. Raises Error naming the file, and where it is over another dictionary."""
    return Code(_core.read_code(os.fspath(path), dictionary._handle if dictionary else None))


def decode(code: Union[Code, PathLike], dictionary: Optional[Dictionary] = None) -> Material:
    """The table that a code, or a .code file over a dictionary, stands for (50 ms)."""
    return (code if isinstance(code, Code) else open_code(code, dictionary)).material()


class Interpolation:
    """Materials prepared for blending: fits, factorisations and codes are made once, so that each blend is quick.

    Spaces (docs/interpolation.md): "linear" mixes BRDF values; "parameters" those of a fitted model, without the measured
    detail; "differential" moves each material by a differential edit, which keeps its detail (Tongbuasirilai and Unger
    2016); "factors" mixes curves; "dictionary" sparse codes.
    """

    __slots__ = ("_handle", "_names")

    def __init__(self, materials: Sequence[Material], space: str = "linear", model: str = "ggx", terms: int = 10,
                 coefficients: int = 1024, dictionary: Optional[Dictionary] = None, progress: Progress = None) -> None:
        """Prepares materials: about 1 s each, nothing in the space "linear".

        Args:
            materials: Two or more.
            space: "linear", "parameters", "differential", "factors" or "dictionary".
            model: Of "parameters" and "differential".
            terms: Of "factors".
            coefficients: Of "dictionary", a channel, at most.
            dictionary: Of "dictionary"; None: the one that comes with Gonio.
            progress: Called with the fraction that is done. An exception that it raises stops the work.

        Raises:
            Error: There is no such space, or materials cannot be blended in it.
        """
        self._names = [material.name for material in materials]
        self._handle = _core.prepare_interpolation([material._handle for material in materials], space, model, terms,
                                                   coefficients, dictionary._handle if dictionary else None, progress)

    def blend(self, weights: Sequence[float], name: str = "") -> Material:
        """The blend of weights, evaluated directly.

        Args:
            weights: One per material, in [0, 1], of sum 1. A weight of 1 gives that material itself, bit for bit.
            name: Name of the material; "": those of the blended ones.

        Raises:
            Error: The weights are none.
        """
        return Material(_core.blend(self._handle, [float(weight) for weight in weights], name or " + ".join(self._names)))


def interpolate(materials: Sequence[Material], weights: Sequence[float], space: str = "linear", model: str = "ggx",
                terms: int = 10, coefficients: int = 1024, dictionary: Optional[Dictionary] = None,
                progress: Progress = None) -> Material:
    """One blend of materials; for several use Interpolation, which has the arguments too."""
    return Interpolation(materials, space, model, terms, coefficients, dictionary, progress).blend(weights)
