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
    """Name in the dicts of parameters, such as "roughness"."""
    label: str
    """Display name."""
    symbol: str
    """Symbol in the formula."""
    unit: str
    """Unit: "1/sr", "rad", or "" for a number without unit."""
    soft_range: tuple[float, float]
    """Range (low, high) that the editor's slider covers."""
    hard_range: tuple[float, float]
    """Range (low, high) of valid values. Model.material() and gonio.edit() reject values outside."""
    default: float
    """Value that is used if none is given."""
    scale: str
    """Scale of the editor's slider: "linear", "logarithmic", "angle" or "lightness"."""
    per_channel: bool
    """Whether it has three values: red, green, blue."""
    linear: bool
    """Whether the BRDF, before clamping at 0, is linear in this parameter."""
    description: str
    """What it does, one sentence."""
    formula: str
    """Formula on one line; "" if there is none."""
    reference: str
    """Source: author, year, equation."""
    choices: tuple[str, ...] = ()
    """Names of the options if the parameter is a choice, such as the Fresnel term; () for a number. The value of a choice is
    its name or its index."""


@dataclass(frozen=True)
class Model:
    """A parametric reflectance model, see gonio.models()."""

    id: str
    """Argument `model` of gonio.fit() and others, such as "ggx"."""
    name: str
    """Display name."""
    description: str
    """What the model is suited for, and its limits."""
    formula: str
    """Formula."""
    reference: str
    """Source: author, title, year, equation."""
    family: str
    """Family: "empirical", "analytic" or "series"."""
    is_reciprocal: bool
    """Whether the BRDF is the same after wi and wo are exchanged, for all parameters."""
    conserves_energy: bool
    """Whether the directional albedo is at most 1 at every angle if the linear parameters are at most 1 with a sum of at
        most 1, the other parameters are in their soft ranges, and choices have their defaults."""
    parameters: tuple[Parameter, ...] = field(repr=False)
    """The parameters, each with its name, ranges, default and description."""

    def material(self, name: str = "", **parameters: Value) -> Material:
        """The model as a material.

        Args:
            name: Name of the material; "": the name of the model.
            parameters: Values by name, such as roughness=0.2, specular=[0.1, 0.1, 0.1] or fresnel="schlick"; a parameter that
                is not given has its default.

        Raises:
            Error: The model has no parameter of this name, or a value is not finite, outside its range, or not an option of
                the choice.
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
        return np.asarray(value, dtype=np.float64).tolist()

    return json.dumps({name: plain(name, value) for name, value in parameters.items()})


def _described(row: dict[str, Any]) -> Model:
    row["parameters"] = tuple(Parameter(**parameter) for parameter in row["parameters"])
    return Model(**row)


def models() -> dict[str, Model]:
    """All parametric models, a dict by id (docs/models.md)."""
    return {row["id"]: _described(row) for row in _core.models()}


def artist_controls() -> tuple[Parameter, ...]:
    """The controls for gonio.edit(controls=...): roughness, specular-strength, tint, saturation, contrast, coat-strength,
    edge-brightness. They have the same meaning for every model. A control has no effect if the model has no parameter for it,
    such as coat-strength for GGX; tint and saturation work for every model. At 1 each changes nothing; `description` states
    what other values do."""
    return _described(_core.artist_controls()).parameters


@dataclass(frozen=True)
class Metric:
    """An error measure between two BRDFs, see gonio.metrics()."""

    id: str
    """Argument `metric` of gonio.fit(), and key of the dicts of errors, such as "log"."""
    name: str
    """Display name."""
    formula: str
    """Formula: rho is a BRDF value, d a difference of the two BRDFs, mean a weighted mean over cells and channels."""
    unit: str
    """Unit of the error; "" for a number without unit."""
    reference: str
    """Source: author, year."""
    is_minimisable: bool
    """Whether gonio.fit() can minimise this metric."""


def metrics() -> dict[str, Metric]:
    """All metrics, a dict by id (docs/command-line.md, section Metrics)."""
    return {row[0]: Metric(*row) for row in _core.metrics()}


@dataclass(frozen=True)
class Fit:
    """A model fitted to a material, see gonio.fit()."""

    model: Model = field(repr=False)
    """The fitted model."""
    parameters: dict[str, Any]
    """Fitted values by name: a number, [red, green, blue] for a parameter per channel, or the index of a choice."""
    errors: dict[str, float]
    """Error of the fit by the id of the metric, for every metric (gonio.metrics())."""
    seconds: float
    """Time of the fit, s."""
    used_cells: int = field(repr=False)
    """Number of cells that the fit compared: valid, and within max_polar_angle."""
    warnings: list[str] = field(repr=False)
    """Problems of the measurement, one sentence each, such as a black channel; usually empty."""
    rendered_snr: float = math.nan
    """Rendered SNR in dB for a fit by gonio.fit_all(); NaN for one by gonio.fit()."""

    def material(self, name: str = "") -> Material:
        """The fitted model as a material.

        Args:
            name: Name of the material; "": the name of the model.
        """
        return self.model.material(name, **self.parameters)


def _fit(row: dict[str, Any]) -> Fit:
    row["model"] = models()[row["model"]]
    return Fit(**row)


def fit(material: Material, model: str = "ggx", metric: str = "log", gamma: float = 2.0,
        max_polar_angle: float = math.radians(85), progress: Progress = None) -> Fit:
    """Fits a model to a material by minimising a metric over the valid cells. Takes up to a few seconds for a table, and
    twice as long for anisotropic data.

    Linear parameters are solved in closed form (variable projection), the others by bounded least squares from several
    starts. The result is deterministic.

    Args:
        material: The material to fit. A material that is not a table is sampled as a table first (1 s); an anisotropic one is
            fitted over all azimuths.
        model: Id of a model (gonio.models()).
        metric: Id of the metric that is minimised (gonio.metrics()).
        gamma: g of the metric "gamma", 1 to 3: values are raised to the power 1/g; other metrics do not use it.
        max_polar_angle: Maximum polar angle of both directions in rad; cells beyond it are left out.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: The model or the metric is unknown, or the metric cannot be minimised.
    """
    return _fit(_core.fit(material._handle, model, metric, gamma, max_polar_angle, progress))


def fit_all(material: Material, models: Iterable[str] = (), metric: str = "log", gamma: float = 2.0,
            max_polar_angle: float = math.radians(85), size: int = 128, samples: int = 32,
            progress: Progress = None) -> list[Fit]:
    """Fits several models and sorts the fits by their error, smallest first. For a table, all models
    take 10 to 12 s on 2 cores.

    Args:
        material: The material to fit.
        models: Ids of the models; (): all models.
        metric: Id of the metric that is minimised, and by which the fits are sorted.
        gamma: g of the metric "gamma", 1 to 3: values are raised to the power 1/g; other metrics do not use it.
        max_polar_angle: Maximum polar angle of both directions in rad; cells beyond it are left out.
        size: Width and height in pixels of the images for Fit.rendered_snr.
        samples: Samples per pixel of these images.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.
    """
    rows = _core.fit_all(material._handle, list(models), metric, gamma, max_polar_angle, size, samples, progress)
    return [_fit(row) for row in rows]


def edit(material: Material, model: Union[Fit, str], set: Optional[Mapping[str, Value]] = None,
         controls: Optional[Mapping[str, Value]] = None, composition: str = "", strength: float = 1.0,
         keep_albedo: bool = True, progress: Progress = None) -> Material:
    """Edits a material differentially: the change from the fitted model to the edited model is applied to the measurement, so
    that the detail that the model does not explain is preserved (Tongbuasirilai 2023, Data-Driven Approaches for Sparse
    Reflectance Modeling and Acquisition, section 4.4.1). A table is edited at once, in 0.5 s; for other materials, the edit
    is computed when they are evaluated.

    An edit that changes nothing returns the same values bit for bit. The result can be edited again; Material.save() writes
    all edits to a .gonio document.

    Args:
        material: The material to edit.
        model: A fit of the material, or the id of a model, which is then fitted first.
        set: New values of parameters by name; other parameters have their fitted values. None: no change.
        controls: Values of gonio.artist_controls() by name, such as {"roughness": 2} for twice the roughness. None: no change.
        composition: How the change is combined with the measurement: "additive" (the difference is added, as published),
            "log-plus" (close to a ratio in the highlight) or "lobes" (the ratio of measurement and fit moves with each lobe;
            for models that are sums of lobes). "": the default of the model.
        strength: Fraction of the change that is applied, 0 to 1.
        keep_albedo: Whether highlights keep their directional albedo as their width changes, and peaks that the fit does not
            explain widen with them; only for the composition "lobes".
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: The model, a parameter, a control or the composition is unknown, or a value is outside its hard range.
    """
    fitted = model if isinstance(model, Fit) else fit(material, model, progress=progress)
    spec = _described(_core.artist_controls())
    texts = [_text(fitted.model, {**fitted.parameters, **(change or {})}) for change in (None, set)]
    return Material(_core.edit(material._handle, fitted.model.id, *texts, _text(spec, controls or {}), composition, strength,
                               keep_albedo, progress))


def edit_factors(material: Material, original: Factors, edited: Factors, keep_detail: bool = True, strength: float = 1.0,
                 progress: Progress = None) -> Material:
    """Edits a material by its factor curves (Tongbuasirilai 2023, eq. 4.25).

    Args:
        material: The material to edit.
        original: Its factors, by gonio.factorize().
        edited: The same factors with changed curves, by Factors.with_curves().
        keep_detail: True: the change of the factors is added to the measurement. False: the edited factors replace it.
        strength: Fraction of the change that is applied, 0 to 1.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.
    """
    return Material(_core.edit_factors(material._handle, original._handle, edited._handle, keep_detail, strength, progress))
