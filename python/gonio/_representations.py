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
from ._arguments import PathLike
from ._materials import Material, Progress


class Factors:
    """A material as sums of products of curves over projected-deviation coordinates (PDV), see gonio.factorize():

        y(theta_R, |Dp|, |phi|) = sum_l F1_l(theta_R) F2_l(|Dp|) F3_l(|phi|)

    y is the transformed BRDF value of one channel, theta_R the polar angle of the viewer, Dp the vector from the mirror
    direction of the viewer to the light, both projected onto the surface, and phi its azimuth (Tongbuasirilai et al. 2017 and
    2019; docs/factors.md). Factors do not change after they are made.
    """

    __slots__ = ("_handle",)

    def __init__(self, handle: Any) -> None:
        """Factors are made by gonio.factorize() and gonio.open_factors(), not directly."""
        if not isinstance(handle, _core.Factors):
            raise TypeError("make factors with gonio.factorize()")
        self._handle = handle

    def __repr__(self) -> str:
        return f"<gonio.Factors: {self.terms} terms, {self.form}, {self.bytes} bytes>"

    @property
    def form(self) -> str:
        """"2d": F1 and F2 (highlights that are round on the projected disk). "3d": F1, F2 and F3."""
        return self._handle.form

    @property
    def transform(self) -> str:
        """Transform of BRDF values, such as "log-plus" (see gonio.factorize())."""
        return self._handle.transform

    @property
    def terms(self) -> int:
        """Number of terms (products of curves) per channel."""
        return self._handle.terms

    @property
    def bytes(self) -> int:
        """Size of the file that save() writes, bytes."""
        return self._handle.bytes

    @property
    def residuals(self) -> NDArray[np.float64]:
        """Relative errors |y - f| / |y| of the sum f of 0, 1, ... terms, in the weighted norm of the factorisation;
        empty for factors that were read from a file or changed."""
        return self._handle.residuals

    @property
    def seconds(self) -> float:
        """Time of the factorisation, s; 0 for factors that were read from a file or changed."""
        return self._handle.seconds

    @property
    def theta_nodes(self) -> NDArray[np.float64]:
        """Nodes of theta_R in rad, shape (n,)."""
        return self._handle.theta_nodes

    @property
    def deviation_nodes(self) -> NDArray[np.float64]:
        """Nodes of |Dp|, a length on the unit disk, shape (n,)."""
        return self._handle.deviation_nodes

    @property
    def phi_nodes(self) -> NDArray[np.float64]:
        """Nodes of |phi| in rad, shape (n,); one node in the form "2d"."""
        return self._handle.phi_nodes

    @property
    def f1(self) -> NDArray[np.float64]:
        """F1, specular strength over theta_R: a copy, shape (3, terms, nodes of theta_R)."""
        return self._handle.f1

    @property
    def f2(self) -> NDArray[np.float64]:
        """F2, highlight profile over |Dp|, scaled to a largest absolute value of 1: a copy, shape (3, terms, nodes of
        |Dp|)."""
        return self._handle.f2

    @property
    def f3(self) -> NDArray[np.float64]:
        """F3 over |phi|, scaled to a largest absolute value of 1: a copy, shape (3, terms, nodes of |phi|)."""
        return self._handle.f3

    def with_curves(self, f1: Optional[ArrayLike] = None, f2: Optional[ArrayLike] = None,
                    f3: Optional[ArrayLike] = None) -> Factors:
        """The factors with some curves replaced.

        Args:
            f1: New F1, of the shape of `f1`; None: unchanged.
            f2: New F2, of the shape of `f2`; None: unchanged.
            f3: New F3, of the shape of `f3`; None: unchanged.

        Raises:
            Error: A shape differs, or a value is not finite.
        """
        return Factors(self._handle.with_curves(f1, f2, f3))

    def truncated(self, terms: int) -> Factors:
        """The factors with only their first terms: the same as a factorisation with this number of terms, except for joint
        terms."""
        return Factors(self._handle.truncated(terms))

    def material(self, name: str = "factors") -> Material:
        """The factors as a material, which is evaluated from the curves without a table."""
        return Material(self._handle.material(name))

    def save(self, path: PathLike) -> None:
        """Writes a .pdv file in single precision; an existing file is replaced in one step. Raises Error if it cannot be
        written."""
        self._handle.save(os.fsencode(path))


def factorize(material: Material, terms: int = 10, form: str = "3d", transform: str = "log-plus",
              weights: str = "projected-solid-angle", deviation_nodes: Sequence[float] = (), joint: bool = False,
              compact: bool = False, progress: Progress = None) -> Factors:
    """Factorises a material into curves over projected-deviation coordinates. Takes about 1 s for ten terms. The published
    method is `factorize(material, terms, form, weights="equal", deviation_nodes=gonio.published_deviation_nodes())`.

    Args:
        material: The material to factorise. A material that is not a table is sampled as a table first (1 s).
        terms: Number of terms (products of curves) per channel, 1 to 20. The first terms do not depend on the number.
        form: "2d" (two curves per term; Tongbuasirilai et al. 2017) or "3d" (three; Tongbuasirilai et al. 2019;
            Tongbuasirilai 2023, Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition, eq. 4.25).
        transform: Transform of BRDF values rho before the factorisation: "log-plus", ln(1 + rho); "cosine-log",
            ln(1 + rho w) with w = max(cos theta_i cos theta_o, 0.001); "log-plus-0.1" and "log-plus-0.01",
            ln(1 + rho / e); "gamma-1.5", "root" (gamma 2), "gamma-2.5" and "gamma-3", rho^(1 / gamma); or "none"
            (docs/factors.md).
        weights: Weights of the squared errors of cells: "projected-solid-angle" (their contribution to images;
            docs/factors.md) or "equal" (as in the papers).
        deviation_nodes: Nodes of |Dp|, strictly increasing from 0; (): chosen for the material.
        joint: Fit all terms together after they were found one after the other (docs/factors.md). Takes a few seconds. The
            first terms then depend on the number.
        compact: Use 60 nodes of theta_R and 30 of |phi| instead of 90 and 180, which halves the bytes per term.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: An argument is out of its range.
    """
    return Factors(_core.factorize(material._handle, terms, form, transform, weights, list(deviation_nodes), joint, compact, progress))


def published_deviation_nodes(materials: Sequence[Material] = (), energy: str = "log-plus",
                              progress: Progress = None) -> NDArray[np.float64]:
    """Computes common nodes of |Dp| for all materials of a database, for gonio.factorize(): quantiles of the mean energy over
    the materials (Tongbuasirilai 2023, eq. 4.24). Takes about 0.1 s per material.

    Args:
        materials: The database; (): the 137 measured and near-measured bundled materials. Their nodes are stored with Gonio
            and not computed again.
        energy: "log-plus": ln(1 + rho), the non-linear energy of the text. "none": rho, as the equation is printed; highlights
            then take nearly all nodes.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Returns:
        90 nodes, lengths on the unit disk from 0 to about 2.
    """
    return _core.published_deviation_nodes([material._handle for material in materials], energy, progress)


def open_factors(path: PathLike) -> Factors:
    """Reads a .pdv file. Raises Error if it cannot be read."""
    return Factors(_core.read_factors(os.fsencode(path)))


@dataclass(frozen=True)
class BaselineFactors:
    """A material as a factorisation of the literature, see gonio.factorize_baseline()."""

    material: Material
    """The material that the factors represent."""
    bytes: int
    """Size of the factors in single precision, without the nodes of their axes."""
    seconds: float
    """Time of the factorisation, s."""


def baselines() -> dict[str, str]:
    """The publications of the methods of gonio.factorize_baseline(), by the method's id."""
    return _core.baselines()


def factorize_baseline(material: Material, method: str, bytes: int = 44680, progress: Progress = None) -> BaselineFactors:
    """Factorises a material by a method of the literature, to compare with gonio.factorize() at equal size. Takes up
    to a few seconds.

    Args:
        material: The material to factorise. A material that is not a table is sampled as a table first (1 s).
        method: "kautz-mccool", "mccool", "lawrence", "bivariate", "bilgili", "bilgili-luminance", "nonparametric", "cp", "hosvd",
            "cosine-series", "nmf" or "gaussian-process" ([command line](command-line.md#baselines)).
        bytes: Maximum size of the factors: as many terms, or as fine a table, as fit. By default that of a .pdv file of ten terms.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: The method is unknown, or bytes is not positive.
    """
    handle, size, seconds = _core.factorize_baseline(material._handle, method, bytes, progress)
    return BaselineFactors(Material(handle), size, seconds)


class Dictionary:
    """An ensemble of orthonormal dictionaries for sparse codes, see gonio.dictionary() (Miandji et al. 2019; Tongbuasirilai
    2023, section 4.3.2; docs/dictionaries.md). len() is the number of dictionaries."""

    __slots__ = ("_handle",)

    def __init__(self, handle: Any) -> None:
        """Dictionaries are opened by gonio.dictionary(), not directly."""
        if not isinstance(handle, _core.Dictionary):
            raise TypeError("open a dictionary with gonio.dictionary()")
        self._handle = handle

    def __repr__(self) -> str:
        return f"<gonio.Dictionary {self.id:016x}: {len(self)} dictionaries>"

    def __len__(self) -> int:
        """Number of dictionaries in the ensemble; each channel of a code uses one of them."""
        return len(self._handle)

    @property
    def id(self) -> int:
        """Identifier that codes store: the first eight bytes of the SHA-256 of the file."""
        return self._handle.id

    @property
    def bytes(self) -> int:
        """Size in single precision, bytes."""
        return self._handle.bytes

    @property
    def grid(self) -> tuple[int, int, int]:
        """Shape (n_h, n_d, n_phi) of the tables that it encodes."""
        return self._handle.grid

    @property
    def training_set(self) -> list[str]:
        """Names of the training materials."""
        return self._handle.learned_from

    def atoms(self, number: int) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        """The three orthonormal matrices of one dictionary, for phi_d, theta_d and theta_h, as copies. Their columns are the
        one-dimensional atoms: an atom of the dictionary is a product of three columns.

        Args:
            number: Index of the dictionary, from 0 to len() - 1.
        """
        return self._handle.atoms(number)


def dictionary(path: PathLike = "") -> Dictionary:
    """Opens an ensemble of dictionaries.

    Args:
        path: A .dictionary file written by `goniotool dictionary train`; "": the bundled ensemble.
    """
    return Dictionary(_core.dictionary(os.fsencode(path)))


@dataclass(frozen=True)
class ChannelCode:
    """The coefficients of one channel of a code."""

    dictionary: int
    """Index of the dictionary in the ensemble, from 0."""
    indices: NDArray[np.int64]
    """Indices of the columns for phi_d, theta_d and theta_h of each coefficient's atom, shape (n, 3) (see
    Dictionary.atoms())."""
    values: NDArray[np.float32]
    """Coefficients in descending order of absolute value, shape (n,)."""


class Code:
    """A material as a sparse code over a dictionary, see gonio.encode(). The values are quantised as in its file. A code does
    not change after it is made."""

    __slots__ = ("_handle",)

    def __init__(self, handle: Any) -> None:
        """Codes are made by gonio.encode() and gonio.open_code(), not directly."""
        if not isinstance(handle, _core.Code):
            raise TypeError("make a code with gonio.encode()")
        self._handle = handle

    def __repr__(self) -> str:
        return f"<gonio.Code: {self.coefficients} coefficients per channel, {self.bytes} bytes>"

    @property
    def coefficients(self) -> int:
        """Number of coefficients of the channel with the most."""
        return self._handle.count

    @property
    def transform(self) -> str:
        """Transform of BRDF values before encoding: "log-plus" or "cosine-log"."""
        return self._handle.transform

    @property
    def scaled(self) -> bool:
        """Cell scaling: whether the code represents values multiplied by a weight of each cell, so that errors count by
        the projected solid angle of the cell (docs/dictionaries.md); False if `as_published`."""
        return self._handle.scaled

    @property
    def bytes(self) -> int:
        """Size of the file that save() writes, bytes."""
        return self._handle.bytes

    @property
    def seconds(self) -> float:
        """Time of the encoding, s; 0 for a code that was read from a file."""
        return self._handle.seconds

    @property
    def rendered_snr(self) -> float:
        """Rendered SNR in dB if encode() was given one to reach; otherwise NaN."""
        return self._handle.rendered_snr

    @property
    def warnings(self) -> list[str]:
        """Problems that encode() found: a sentence for each channel in which the brightest cell decodes to less than a
        tenth. Empty for a code that was read from a file."""
        return self._handle.warnings

    @property
    def dictionary(self) -> Dictionary:
        """The ensemble of dictionaries that it was encoded with."""
        return Dictionary(self._handle.dictionary)

    @property
    def channels(self) -> list[ChannelCode]:
        """The coefficients of red, green and blue, a list of three."""
        return [ChannelCode(*channel) for channel in self._handle.channels]

    def material(self, as_table: bool = True, name: str = "code") -> Material:
        """The code as a material.

        Args:
            as_table: True: the code is decoded to a table (50 ms), which is fast to evaluate. False: values are computed from
                the coefficients when they are evaluated, about 0.2 to 0.7 µs per pair of directions for 64 to 1,024
                coefficients.
            name: Name of the material.
        """
        return Material(self._handle.material(as_table, name))

    def save(self, path: PathLike) -> None:
        """Writes a .code file; an existing file is replaced in one step. Raises Error if it cannot be written."""
        self._handle.save(os.fsencode(path))


def encode(material: Material, coefficients: int = 1024, dictionary: Optional[Dictionary] = None,
           transforms: Sequence[str] = ("log-plus", "cosine-log"), gamma: float = 2.0,
           relative_error: Optional[float] = None, max_bytes: Optional[int] = None,
           rendered_snr: Optional[float] = None, method: str = "iterative-hard-thresholding", as_published: bool = False,
           progress: Progress = None) -> Code:
    """Encodes a material as a sparse code. Takes about 1 s, or a minute if `rendered_snr` is given.

    Args:
        material: The material to encode. A material that is not a table is sampled as a table first (1 s). A table on another
            grid than that of the dictionary is resampled.
        coefficients: Maximum number of coefficients per channel.
        dictionary: The ensemble of dictionaries; None: the bundled one.
        transforms: Transforms to try, "log-plus" or "cosine-log" or both; the one with the smallest gamma error is used, or
            with `rendered_snr` the one that needs fewer coefficients.
        gamma: g of the gamma error, 1 to 3: values are raised to the power 1/g (Tongbuasirilai 2023, section 4.3.2.4).
        relative_error: Use fewer coefficients if the squared error of the transformed values is then at most this fraction of
            their energy; None: no such limit.
        max_bytes: Use fewer coefficients if the file would be larger than this; None: no such limit.
        rendered_snr: Use the smallest number of coefficients that reaches this rendered SNR in dB; None: no such limit.
        method: "iterative-hard-thresholding" (the largest coefficients) or "basis-pursuit" (the coefficients are chosen by minimising half the squared error plus lambda times the sum of their absolute values;
            docs/dictionaries.md).
        as_published: Encode the transformed values without cell scaling, by one projection for each channel, over the bundled
            dictionaries that were learned so if `dictionary` is None; values are neither limited to the range of the material
            nor, without `max_bytes`, quantised (Tongbuasirilai 2023, eq. 4.37 to 4.39; docs/dictionaries.md).
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: An argument is out of its range.
    """
    return Code(_core.encode(material._handle, coefficients, dictionary._handle if dictionary else None, list(transforms),
                             gamma, relative_error, max_bytes, rendered_snr, method, as_published, progress))


def open_code(path: PathLike, dictionary: Optional[Dictionary] = None) -> Code:
    """Reads a .code file.

    Args:
        path: Name of the file.
        dictionary: The ensemble of dictionaries that it was encoded with; None: the bundled one.

    Raises:
        Error: The file cannot be read, or was encoded over another ensemble of dictionaries.
    """
    return Code(_core.read_code(os.fsencode(path), dictionary._handle if dictionary else None))


def decode(code: Union[Code, PathLike], dictionary: Optional[Dictionary] = None) -> Material:
    """Decodes a code to a material that is a table (50 ms).

    Args:
        code: A code, or the name of a .code file.
        dictionary: The ensemble of dictionaries for a file; None: the bundled one. A Code has its own.
    """
    return (code if isinstance(code, Code) else open_code(code, dictionary)).material()


class Interpolation:
    """Materials prepared for blending: fits, factorisations and codes are made once, so that each blend is fast.

    A blend is computed in one of five spaces (docs/interpolation.md): "linear" mixes BRDF values; "parameters" mixes the
    parameters of a fitted model; "differential" edits each material toward the mixed parameters,
    so that its detail is preserved (Tsirikoglou et al. 2016, "Differential Appearance Editing for Measured BRDFs"); "factors"
    mixes factor curves; "dictionary" mixes sparse codes. In "parameters", "factors" and "dictionary", the detail that the
    representation of each material misses is added by the weight of the material, so that a blend begins and ends at the
    materials (keep_detail).
    """

    __slots__ = ("_handle", "_names")

    def __init__(self, materials: Sequence[Material], space: str = "linear", model: str = "ggx", terms: int = 10,
                 coefficients: int = 1024, dictionary: Optional[Dictionary] = None, keep_detail: bool = True,
                 progress: Progress = None) -> None:
        """Prepares materials. Takes about 1 s per material; the space "linear" needs no preparation.

        Args:
            materials: Two or more materials.
            space: "linear", "parameters", "differential", "factors" or "dictionary".
            model: Id of the model for "parameters" and "differential"; other spaces do not use it.
            terms: Number of terms for "factors".
            coefficients: Maximum number of coefficients per channel for "dictionary".
            dictionary: The ensemble of dictionaries for "dictionary"; None: the bundled one.
            keep_detail: True: blends in "parameters", "factors" and "dictionary" contain the measured detail of each material,
                by its weight, and are evaluated from the materials in their native form. False: the fits, factors or codes
                alone, as published.
            progress: Called with the fraction that is done, 0 to 1; None: not reported.

        Raises:
            Error: The space is unknown, or the materials cannot be blended in it.
        """
        self._names = [material.name for material in materials]
        self._handle = _core.prepare_interpolation([material._handle for material in materials], space, model, terms,
                                                   coefficients, dictionary._handle if dictionary else None,
                                                   keep_detail, progress)

    def blend(self, weights: Sequence[float], name: str = "") -> Material:
        """The blend with the given weights.

        Args:
            weights: One per material, each in [0, 1], with the sum 1. A weight of 1 returns that material, bit for bit.
            name: Name of the blend; "": the names of the materials, joined by " + ".

        Raises:
            Error: The number of weights differs from that of the materials, or their sum is not 1.
        """
        return Material(_core.blend(self._handle, [float(weight) for weight in weights], name or " + ".join(self._names)))


def interpolate(materials: Sequence[Material], weights: Sequence[float], space: str = "linear", model: str = "ggx",
                terms: int = 10, coefficients: int = 1024, dictionary: Optional[Dictionary] = None, keep_detail: bool = True,
                progress: Progress = None) -> Material:
    """One blend of materials. For several blends of the same materials, use Interpolation.

    Args:
        materials: Two or more materials.
        weights: One per material, each in [0, 1], with the sum 1.
        space: "linear", "parameters", "differential", "factors" or "dictionary" (see Interpolation).
        model: Id of the model for "parameters" and "differential"; other spaces do not use it.
        terms: Number of terms for "factors".
        coefficients: Maximum number of coefficients per channel for "dictionary".
        dictionary: The ensemble of dictionaries for "dictionary"; None: the bundled one.
        keep_detail: Whether the blend contains the measured detail of each material (see Interpolation).
        progress: Called with the fraction that is done, 0 to 1; None: not reported.
    """
    return Interpolation(materials, space, model, terms, coefficients, dictionary, keep_detail, progress).blend(weights)
