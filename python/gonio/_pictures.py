# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Rendering, comparison, study, export."""
from __future__ import annotations

import math
import os
from dataclasses import dataclass, field
from typing import Any, Iterable, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arguments import PathLike
from ._acquisition import Basis
from ._materials import Material, Progress
from ._representations import Dictionary
from ._training import PatchDictionary


def scenes() -> list[str]:
    """Names of the bundled scenes (docs/scenes.md)."""
    return _core.scenes()


def _handles(materials: Union[Material, Sequence[Material]]) -> list[Any]:
    listed = [materials] if isinstance(materials, Material) else materials
    return [material._handle for material in listed]


def render(materials: Union[Material, Sequence[Material]], scene: PathLike = "sphere", size: Union[int, tuple[int, int]] = 256,
           samples: int = 64, environment: PathLike = "", rotation: float = 0.0, seed: int = 1, alpha: bool = False,
           progress: Progress = None, up: str = "y", sampling: str = "auto") -> NDArray[np.float32]:
    """Renders an image by path tracing. Only the effects that can change a pixel are simulated (gonio.effects()).

    Args:
        materials: One material, or one for each material slot of the scene.
        scene: Name of a bundled scene (gonio.scenes()), a scene file (.json), or a mesh (.obj, .ply, .stl, .gltf, .glb).
        size: Width and height in pixels, or one number for both.
        samples: Samples per pixel.
        environment: Name of a bundled environment ("studio", "rim-lights", "sky", "sunset", "window", "furnace") or of a latitude-longitude
            image (.hdr, .exr); "": the environment of the scene.
        rotation: Rotation of the environment about the vertical axis, rad; positive angles turn it from -z toward +x, clockwise seen from above.
        seed: Seed of the random numbers.
        alpha: Whether to add the coverage as a fourth channel. The colours are multiplied by it (premultiplied alpha).
        progress: Called with the fraction that is done, 0 to 1; None: not reported.
        up: Axis of a mesh that points up, "y" or "z". Bundled scenes are y up, and scene files state the axis of each mesh.
        sampling: Density from which directions are sampled for the materials, to compare methods: "auto" (the one with the least
            noise at equal time), "pdv", "published", "lawrence", "bilgili", "ggx" or "cosine" (docs/scenes.md).

    Returns:
        Linear RGB radiance (sRGB primaries), shape (height, width, 3), or (height, width, 4) with alpha; row 0 is the top.

    Raises:
        Error: The scene, environment or sampling method is unknown or cannot be read, there are more materials than slots, or
            `up` is "z" for a scene that is not a mesh.
    """
    width, height = (size, size) if isinstance(size, int) else size
    picture, coverage = _core.render(_handles(materials), os.fsencode(scene), up, os.fsencode(environment), rotation, width,
                                     height, samples, sampling, seed, progress)
    return np.dstack((picture, coverage)) if alpha else picture


@dataclass(frozen=True)
class Effect:
    """An effect of light transport and whether a scene needs it, see gonio.effects()."""

    name: str
    """"direct-light", "cast-shadows", "interreflection", ... (docs/scenes.md)."""
    simulated: bool
    """Whether the renderer simulates it."""
    reason: str
    """The reason for it, one sentence."""


def effects(materials: Union[Material, Sequence[Material]], scene: PathLike = "sphere", environment: PathLike = "",
            up: str = "y") -> list[Effect]:
    """Determines which effects can change a pixel of a scene with these materials: the renderer simulates those.

    Args:
        materials: One material, or one for each material slot of the scene.
        scene: As in gonio.render().
        environment: As in gonio.render(); "": the environment of the scene.
        up: As in gonio.render().
    """
    return [Effect(*row) for row in _core.effects(_handles(materials), os.fsencode(scene), up, os.fsencode(environment))]


@dataclass(frozen=True)
class Comparison:
    """Differences of two materials, see gonio.compare()."""

    errors: dict[str, float]
    """Error by the id of the metric, for every metric (gonio.metrics()), over the cells of the reference's table."""
    brdf_snr: float
    """SNR in dB of rho cos theta_i cos theta_o over the valid cells; infinite for equal materials."""
    rendered_snr: float
    """SNR in dB of images in the scene "sphere-studio", corrected for their noise; infinite for equal images."""
    rendered_psnr: float
    """PSNR in dB of the same images; the peak is the largest value of the reference's image."""
    image_metrics: dict[str, float]
    """Further metrics of the same images, with their noise: "mse", "log-mse" and "relative-mse" of linear radiance; "ssim" of
    the luminance encoded as sRGB (NaN for images below 11 pixels); "flip" and "ciede2000" of the displayed colours ([formulas
    and sources](command-line.md#image-metrics))."""
    evaluation_ns: tuple[float, float]
    """Time of one evaluation in ns on one core, of the reference and of the other material, measured on this machine."""
    frame_ms: tuple[float, float]
    """Time of a frame in ms (128 x 128 pixels, 32 samples per pixel, "sphere-studio") with all cores, of the reference and of
    the other material."""
    pictures: Optional[tuple[NDArray[np.float32], NDArray[np.float32]]] = field(repr=False)
    """Images of the reference and of the other material, linear RGB, shape (size, size, 3) each; None unless compare() was
    called with pictures=True."""


def compare(reference: Material, other: Material, max_polar_angle: float = math.radians(85), size: int = 128, samples: int = 32,
            pictures: bool = False, progress: Progress = None) -> Comparison:
    """Computes every metric between two materials and between their images. Takes a few seconds.

    Args:
        reference: The reference.
        other: The material to compare with the reference.
        max_polar_angle: Maximum polar angle of both directions in rad; `errors` leave out cells beyond it.
        size: Width and height of the images in pixels. Studies, exports and goniotool measure with the defaults of `size` and
            `samples`, which give the same numbers.
        samples: Samples per pixel of the images.
        pictures: Whether the result contains the images.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.
    """
    return Comparison(**_core.compare(reference._handle, other._handle, max_polar_angle, size, samples, pictures, progress))


@dataclass(frozen=True)
class Record:
    """Accuracy and cost of a representation of a material at one budget, see gonio.study()."""

    family: str
    """"table", "fits", "factors", "codes", "components", "patches", "nonparametric", "published-nonparametric",
    "baselines", "published", "alternatives" or "neural"."""
    representation: str
    """Id of the representation: "ggx", "factors-3d", "code", "lawrence", ..."""
    label: str
    """Display name."""
    budget: float
    """Number of terms, of coefficients or components per channel, or of fitted numbers; for a baseline, maximum size of its
    factors in bytes; 0 for representations without a budget."""
    bytes: int
    """Size in bytes of its file; for a table, of its memory; for a fit, of its numbers in single precision."""
    encode_seconds: float
    """Time from the table to the representation, s; NaN for "published-nonparametric", which was fitted elsewhere."""
    evaluation_ns: float
    """Time of one evaluation on one thread, in batches, ns; NaN if the study was not timed."""
    frame_ms: float
    """Time of a frame of the scene "sphere-studio" on all threads, ms; NaN if the study was not timed."""
    errors: dict[str, float] = field(repr=False)
    """Error by the id of the metric, for every metric."""
    rendered_snr: float
    """SNR in dB of images in the scene "sphere-studio"; infinite for equal images."""


def study(material: Material, representations: Sequence[str] = ("table", "fits", "factors", "codes", "nonparametric"),
          models: Iterable[str] = (), baselines: Iterable[str] = (), terms: Sequence[int] = (1, 2, 3, 5, 8, 10, 14, 20),
          coefficients: Sequence[int] = (32, 64, 128, 256, 512, 1024, 2048), dictionary: Optional[Dictionary] = None,
          components: Sequence[int] = (4, 8, 16, 32, 64, 128), basis: Optional[Basis] = None, size: int = 128, samples: int = 32,
          timed: bool = True, npf: PathLike = "", patches: Optional[PatchDictionary] = None, progress: Progress = None) -> list[Record]:
    """Measures accuracy against cost for several representations of a material, each at several budgets (docs/study.md). About
    2 s per record.

    Args:
        material: The material to represent.
        representations: Families of representations, or single ones by their ids, such as "factors-3d" or "ggx". Families: "table",
            "fits", "factors", "codes", "components", "patches", "nonparametric" (a non-parametric microfacet model), "baselines" (factorisations of the literature), "published" (PDV
            factors and codes as the papers describe them), "alternatives" (PDV factors with jointly fitted terms, over all nodes or compact; codes
            by basis pursuit), "neural" (gonio.train_neural()).
        models: Ids of the models for "fits"; (): all models.
        baselines: Ids of the methods for "baselines" (gonio.baselines()); (): all except "nonparametric".
        terms: Numbers of terms for "factors", "published" and "alternatives". They also set the budgets of "baselines": the sizes of .pdv
            files with as many terms in the form "3d".
        coefficients: Numbers of coefficients per channel for the codes of "codes", "patches", "published" and "alternatives".
        dictionary: The ensemble of dictionaries for the codes of "codes", "published" and "alternatives"; None: the bundled one.
        components: Numbers of principal components per channel for "components"; numbers larger than the basis are omitted.
        basis: Principal components for "components", on the grid of the material's table (gonio.learn_basis()); required
            for "components".
        size: Width and height of the images in pixels.
        samples: Samples per pixel of the images.
        timed: Whether to measure the times of evaluations and frames.
        npf: Table of published non-parametric factors, the npf.bin of Bagher et al. 2016 (docs/formats.md); "": none. If one
            of its rows has the name of the material, that row is measured too, as "published-nonparametric".
        patches: Dictionary of patches for "patches", on the grid of the material's table (gonio.learn_patches()); required for
            "patches".
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: A family, a model or a baseline is unknown, the basis for "components" or the dictionary for "patches" is
            missing or on another grid, or the table `npf` cannot be read.
    """
    request = _core.StudyRequest()
    request.representations, request.models, request.baselines = list(representations), list(models), list(baselines)
    request.terms, request.coefficients = list(terms), list(coefficients)
    request.npf = os.fsencode(npf)
    request.components = [count for count in components if basis is None or count <= len(basis)]
    rows = _core.study(material._handle, request, dictionary._handle if dictionary else None, basis._handle if basis else None,
                       patches._handle if patches else None, size, samples, timed, progress)
    return [Record(**row) for row in rows]


@dataclass(frozen=True)
class Target:
    """A renderer or format that materials are exported to, see gonio.targets()."""

    id: str
    """Argument `target` of gonio.export(), such as "mitsuba"."""
    label: str
    """Display name."""
    description: str
    """What is written, and how to use it."""
    holds: str
    """What the files can and cannot represent."""
    has_scenes: bool
    """Whether a scene can be written with the material."""


def targets() -> dict[str, Target]:
    """All targets of gonio.export(), a dict by id (docs/exports.md)."""
    return {row[0]: Target(*row) for row in _core.targets()}


@dataclass(frozen=True)
class Export:
    """Result of gonio.export()."""

    files: list[str]
    """Paths of the files that were written."""
    snr: float
    """Rendered SNR in dB of the exported material, as the renderer shows it, against the material; infinite for equal
    images, nan for "csv" and "slices", which contain values at individual directions."""
    brdf_snr: float
    """BRDF SNR in dB of the exported material; infinite for equal values, nan as `snr`."""
    losses: list[str]
    """What the files do not hold, one sentence each."""
    bytes: int
    """Size of all files, bytes."""
    facts: dict[str, Any] = field(repr=False)
    """Further properties of the export, by name, which depend on the target."""
    warnings: list[str]
    """Warnings, one sentence each: a low SNR, or a material that reflects more light than it
    receives; usually empty."""
    material: Optional[Material] = field(repr=False)
    """The exported material as the renderer shows it, by the formula of the target; None for "csv" and "slices"."""


def export(material: Material, path: PathLike, target: str, snr: float = 40.0, grid: Optional[tuple[int, int]] = None,
           scene: PathLike = "", environment: PathLike = "", overwrite: bool = False, progress: Progress = None,
           up: str = "y", blender: int = 4) -> Export:
    """Writes a material, with its edits, as files for a renderer. Takes a few seconds.

    Args:
        material: The material to export.
        path: Name of the files without the suffixes that the target adds.
        target: Id of the target (gonio.targets()).
        snr: Rendered SNR in dB to reach, for targets that can choose the size of their files.
        grid: Size of .bsdf files: the number of incident polar angles, and the number of nodes along each side of
            the grid for each incident direction; None: the smallest size that reaches the SNR.
        scene: Name of a scene to write with the material, for targets with `has_scenes`; "": none.
        environment: Environment of this scene; "": its own.
        overwrite: Whether existing files are replaced.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.
        up: Axis of a mesh as the scene that points up, as in gonio.render().
        blender: Series of Blender, 3 or 4, whose shading the targets "blender" and "principled" fit.

    Raises:
        Error: The target or scene is unknown, a file exists and `overwrite` is False, or a file cannot be written. Then no
            file is written.
    """
    theta_count, side = grid or (0, 0)
    row = _core.export(material._handle, os.fsencode(path), target, snr, theta_count, side, os.fsencode(scene), up,
                       os.fsencode(environment), overwrite, progress, blender)
    if row["material"] is not None:
        row["material"] = Material(row["material"])
    return Export(**row)
