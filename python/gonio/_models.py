# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Parametric models, fits and edits."""
from __future__ import annotations

import json
import math
from dataclasses import dataclass, field
from typing import Any, Iterable, Mapping, Optional, Union

import numpy as np

from . import _core
from ._materials import Material, Progress
from ._representations import Factors

Value = Union[float, int, str, "list[float]", "tuple[float, ...]", "np.ndarray[Any, Any]"]


@dataclass(frozen=True)
class Parameter:
    """One parameter of a model."""

    name: str
    """Key of parameters: "roughness"."""
    label: str
    """Name for people."""
    symbol: str
    """Symbol in formulas."""
    unit: str
    """"1/sr", "rad", or "" of a plain number."""
    soft_range: tuple[float, float]
    """The range that sliders cover."""
    hard_range: tuple[float, float]
    """The range that is valid; values outside are cut to it."""
    default: float
    """Default value."""
    scale: str
    """How a slider spreads the range: "linear", "logarithmic", "angle" or "lightness"."""
    per_channel: bool
    """Whether it has a value for each of red, green, blue."""
    linear: bool
    """Whether the BRDF is linear in it."""
    description: str
    """One sentence."""
    formula: str
    """Formula, one line."""
    reference: str
    """Author, year, equation."""
    choices: tuple[str, ...] = ()
    """Names of a choice between conventions; the value is an index into them or the name itself."""


@dataclass(frozen=True)
class Model:
    """A parametric reflectance model, see gonio.models()."""

    id: str
    """What functions take as `model`: "ggx"."""
    name: str
    """Name for people."""
    description: str
    """What it is for, and its limits."""
    formula: str
    """Its formula."""
    reference: str
    """Author, title, year, equation."""
    family: str
    """"empirical", "analytic" or "series"."""
    is_reciprocal: bool
    """Whether values stay when wi and wo are exchanged, for all parameters."""
    conserves_energy: bool
    """Whether the albedo is at most 1 where the strengths add up to 1 at most."""
    parameters: tuple[Parameter, ...] = field(repr=False)
    """Its parameters, in order."""

    def material(self, name: str = "", **parameters: Value) -> Material:
        """The model as a material.

        Args:
            name: Name of the material; "" for that of the model.
            parameters: Values by name: a number, or red, green, blue of one that is per_channel; a choice by its name or
                index. Those that are left out have their default.

        Raises:
            Error: The model has no such parameter, or a value is none.
        """
        return Material(_core.instantiate(self.id, _text(self, parameters), name or self.name))


def _text(model: Model, parameters: Mapping[str, Value]) -> str:
    """Parameters as JSON."""
    choices = {parameter.name: parameter.choices for parameter in model.parameters}

    def plain(name: str, value: Value) -> Any:
        if isinstance(value, str):
            if value not in choices.get(name, ()):
                expected = ", ".join(choices.get(name, ())) or "a number"
                raise _core.Error(f"{name}: found {value!r}, expected {expected}")
            return choices[name].index(value)
        array = np.asarray(value, dtype=np.float64)
        if not np.all(np.isfinite(array)):
            raise _core.Error(f"{name}: found a value that is not finite")
        return array.tolist()

    return json.dumps({name: plain(name, value) for name, value in parameters.items()})


def _described(row: dict[str, Any]) -> Model:
    row["parameters"] = tuple(Parameter(**parameter) for parameter in row["parameters"])
    return Model(**row)


def models() -> dict[str, Model]:
    """All parametric models by id, in the order of lists (docs/models.md)."""
    return {row["id"]: _described(row) for row in _core.models()}


def artist_controls() -> tuple[Parameter, ...]:
    """The controls that mean the same for every model, for gonio.edit(controls=...)."""
    return _described(_core.artist_controls()).parameters


@dataclass(frozen=True)
class Metric:
    """A distance between two BRDFs, see gonio.metrics()."""

    id: str
    """What functions take as `metric`, and key of errors."""
    name: str
    """Name for people."""
    formula: str
    """Formula; x = rho cos theta_i, d the difference, <> the weighted mean over cells."""
    unit: str
    """Unit of the error, "" of a plain number."""
    reference: str
    """Author, year."""
    is_minimisable: bool
    """Whether gonio.fit() can minimise it."""


def metrics() -> dict[str, Metric]:
    """All metrics by id, in the order in which errors are listed."""
    return {row[0]: Metric(*row) for row in _core.metrics()}


@dataclass(frozen=True)
class Fit:
    """A model fitted to a material, see gonio.fit()."""

    model: Model = field(repr=False)
    """The model."""
    parameters: dict[str, Any]
    """Fitted values by name: a number, or [red, green, blue]."""
    errors: dict[str, float]
    """Error of the fit by every metric (gonio.metrics())."""
    seconds: float
    """Time of the fit."""
    used_cells: int = field(repr=False)
    """Cells of the material that counted."""
    warnings: list[str] = field(repr=False)
    """Sentences about a degenerate measurement; usually none."""
    rendered_snr: float = math.nan
    """Rendered SNR in dB, of gonio.fit_all(); else NaN."""

    def material(self, name: str = "") -> Material:
        """The fitted model as a material."""
        return self.model.material(name, **self.parameters)


def _fit(row: dict[str, Any]) -> Fit:
    row["model"] = models()[row["model"]]
    return Fit(**row)


def fit(material: Material, model: str = "ggx", metric: str = "log", gamma: float = 2.0,
        max_polar_angle: float = math.radians(85), progress: Progress = None) -> Fit:
    """Fits a model to a material: under 3 s of a table, twice that of anisotropic data.

    Linear parameters are solved in closed form inside (variable projection), the others by bounded least squares from
    several starts. Deterministic.

    Args:
        material: What is fitted; one that is no table is sampled first (1 s).
        model: Id of a model (gonio.models()).
        metric: Id of the metric that is minimised (gonio.metrics()).
        gamma: Of the metric "gamma", 1 to 3.
        max_polar_angle: Cells with a polar angle beyond this (rad) are left out.
        progress: Called with the fraction that is done. An exception that it raises stops the work.

    Raises:
        Error: There is no such model or metric, or the metric cannot be minimised.
    """
    return _fit(_core.fit(material._handle, model, metric, gamma, max_polar_angle, progress))


def fit_all(material: Material, models: Iterable[str] = (), metric: str = "log", gamma: float = 2.0,
            max_polar_angle: float = math.radians(85), size: int = 128, samples: int = 32,
            progress: Progress = None) -> list[Fit]:
    """Fits several models and ranks them: best first by the metric. About a minute for all models on 2 cores.

    Args:
        material: What is fitted.
        models: Ids of the models; none: all of them.
        metric: Id of the metric that is minimised and ranks.
        gamma: Of the metric "gamma", 1 to 3.
        max_polar_angle: Cells with a polar angle beyond this (rad) are left out.
        size: Width and height in pixels of the pictures by which rendered_snr is measured.
        samples: Samples a pixel of these.
        progress: Called with the fraction that is done. An exception that it raises stops the work.
    """
    rows = _core.fit_all(material._handle, list(models), metric, gamma, max_polar_angle, size, samples, progress)
    return [_fit(row) for row in rows]


def edit(material: Material, model: Union[Fit, str], set: Optional[Mapping[str, Value]] = None,
         controls: Optional[Mapping[str, Value]] = None, composition: str = "", strength: float = 1.0,
         progress: Progress = None) -> Material:
    """A differential edit: the change of a fitted model is brought to the material, so that what the model does not
    explain survives (Tongbuasirilai 2023, Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition,
    section 4.4.1). Edits of a table make a table (0.5 s); others are evaluated with the material.

    An edit that changes nothing leaves the material as it is, bit for bit. Edits add up: the result can be edited again,
    and Material.save() writes all of them to a .gonio document.

    Args:
        material: What is edited.
        model: A fit of the material, or the id of a model, which is fitted first.
        set: New values of parameters by name; the others stay as they were fitted.
        controls: Values of gonio.artist_controls() by name, such as roughness=2: twice as rough.
        composition: "additive" (as published), "log-plus" (a ratio at the highlight) or "lobes" (each lobe carries what
            the fit does not explain along; models that are sums of lobes); "" for the default of the model.
        strength: Fraction of the change that is applied, 0 to 1.
        progress: Called with the fraction that is done. An exception that it raises stops the work.

    Raises:
        Error: There is no such model, parameter, control or composition. Values outside their hard range are errors too.
    """
    fitted = model if isinstance(model, Fit) else fit(material, model, progress=progress)
    spec = _described(_core.artist_controls())
    texts = [_text(fitted.model, {**fitted.parameters, **(change or {})}) for change in (None, set)]
    handle, cut = _core.edit(material._handle, fitted.model.id, *texts, _text(spec, controls or {}), composition, strength,
                             progress)
    if cut:
        raise _core.Error(f"outside the hard range: {', '.join(cut)}")
    return Material(handle)


def edit_factors(material: Material, original: Factors, edited: Factors, keep_detail: bool = True, strength: float = 1.0,
                 progress: Progress = None) -> Material:
    """An edit of the factor curves of a material (Tongbuasirilai 2023, eq. 4.25).

    Args:
        material: What is edited.
        original: The factors of the material, by gonio.factorize().
        edited: The same with other curves: Factors.with_curves().
        keep_detail: Whether the change of the factors is added to the material; False: the factors replace it.
        strength: Fraction of the change that is applied, 0 to 1.
        progress: Called with the fraction that is done. An exception that it raises stops the work.
    """
    return Material(_core.edit_factors(material._handle, original._handle, edited._handle, keep_detail, strength, progress))
