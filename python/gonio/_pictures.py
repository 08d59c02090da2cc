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
from ._materials import Material, PathLike, Progress
from ._representations import Dictionary


def scenes() -> list[str]:
    """Names of the scenes that come with Gonio (docs/scenes.md)."""
    return _core.scenes()


def _handles(materials: Union[Material, Sequence[Material]]) -> list[Any]:
    listed = [materials] if isinstance(materials, Material) else materials
    return [material._handle for material in listed]


def render(materials: Union[Material, Sequence[Material]], scene: PathLike = "sphere", size: Union[int, tuple[int, int]] = 256,
           samples: int = 64, environment: PathLike = "", rotation: float = 0.0, seed: int = 1, alpha: bool = False,
           progress: Progress = None) -> NDArray[np.float32]:
    """A path-traced picture, with the effects that the scene calls for. The same bits for any number of threads.

    Args:
        materials: One material, or one for each slot of the scene.
        scene: Name of a bundled scene (gonio.scenes()), a scene file (.json) or a mesh.
        size: Width and height in pixels, or one number for both.
        samples: Samples a pixel.
        environment: Bundled environment or latitude-longitude picture in place of the scene's own; "": its own.
        rotation: Of the environment about the vertical axis, rad.
        seed: Of the random numbers.
        alpha: Whether the fourth channel is the coverage, by which the colours are multiplied.
        progress: Called with the fraction that is done. An exception that it raises stops the work.

    Returns:
        Linear RGB radiance, float32 of shape (height, width, 3), or 4 with alpha; the first row is the top.

    Raises:
        Error: There is no such scene or environment, or it shows fewer materials.
    """
    width, height = (size, size) if isinstance(size, int) else size
    picture, coverage = _core.render(_handles(materials), os.fspath(scene), os.fspath(environment), rotation, width, height,
                                     samples, seed, progress)
    return np.dstack((picture, coverage)) if alpha else picture


@dataclass(frozen=True)
class Effect:
    """A decision of the effect plan of a scene, see gonio.effects()."""

    name: str
    """"direct-light", "cast-shadows", "interreflection", .."""
    simulated: bool
    """Whether the renderer simulates it."""
    reason: str
    """Why, or why not."""


def effects(materials: Union[Material, Sequence[Material]], scene: PathLike = "sphere", environment: PathLike = "") -> list[Effect]:
    """Which effects can change a pixel of a scene with these materials, so that they are simulated. Arguments of render()."""
    return [Effect(*row) for row in _core.effects(_handles(materials), os.fspath(scene), os.fspath(environment))]


@dataclass(frozen=True)
class Comparison:
    """Differences of two materials, see gonio.compare()."""

    errors: dict[str, float]
    """Error by every metric (gonio.metrics()), over the cells of the reference's table."""
    brdf_snr: float
    """SNR in dB of rho cos theta_i cos theta_o over valid cells; infinite for equal materials."""
    rendered_snr: float
    """SNR in dB of pictures in the scene "sphere-studio", without their noise; infinite for equal pictures."""
    rendered_psnr: float
    """PSNR of the same."""
    pictures: Optional[tuple[NDArray[np.float32], NDArray[np.float32]]] = field(repr=False)
    """Pictures of the reference and of the other material, linear RGB of shape (size, size, 3), where asked for."""


def compare(reference: Material, other: Material, max_polar_angle: float = math.radians(85), size: int = 256, samples: int = 64,
            pictures: bool = False, progress: Progress = None) -> Comparison:
    """Every metric between two materials, and the SNR of pictures. Some seconds.

    Args:
        reference: The reference.
        other: What is compared with it; where it is anisotropic, metrics take its mean over the azimuths.
        max_polar_angle: Cells with a polar angle beyond this (rad) do not count in `errors`.
        size: Width and height of the pictures in pixels.
        samples: Samples a pixel.
        pictures: Whether the result holds the pictures.
        progress: Called with the fraction that is done. An exception that it raises stops the work.
    """
    return Comparison(**_core.compare(reference._handle, other._handle, max_polar_angle, size, samples, pictures, progress))


@dataclass(frozen=True)
class Record:
    """A representation of a material at one budget, measured, see gonio.study()."""

    family: str
    """"table", "fits", "factors", "codes" or "nonparametric"."""
    representation: str
    """"ggx", "factors-3d", "code", .."""
    label: str
    """Name for people."""
    budget: float
    """Terms, coefficients or fitted numbers; 0 where nothing is counted."""
    bytes: int
    """Size of its file, or of its numbers in single precision."""
    encode_seconds: float
    """Time from the table to the representation."""
    evaluation_ns: float
    """Time of an evaluation on one thread, in batches; of timed studies."""
    frame_ms: float
    """Time of a frame of "sphere-studio"; of timed studies."""
    errors: dict[str, float] = field(repr=False)
    """Error by every metric."""
    rendered_snr: float
    """SNR in dB of pictures in "sphere-studio"."""


def study(material: Material, representations: Sequence[str] = ("table", "fits", "factors", "codes", "nonparametric"),
          models: Iterable[str] = (), terms: Sequence[int] = (1, 2, 3, 5, 8, 10, 14, 20),
          coefficients: Sequence[int] = (32, 64, 128, 256, 512, 1024, 2048), dictionary: Optional[Dictionary] = None,
          size: int = 128, samples: int = 32, timed: bool = True, progress: Progress = None) -> list[Record]:
    """Accuracy against cost: representations of a material over their budgets, measured. About 2 s each.

    Args:
        material: What is represented.
        representations: Families that are measured.
        models: Ids of the models of "fits"; none: all.
        terms: Budgets of "factors".
        coefficients: Budgets of "codes", a channel.
        dictionary: Of "codes"; None: the one that comes with Gonio.
        size: Width and height of the pictures in pixels.
        samples: Samples a pixel.
        timed: Whether evaluations and frames are timed.
        progress: Called with the fraction that is done. An exception that it raises stops the work.

    Raises:
        Error: There is no such family or model.
    """
    rows = _core.study(material._handle, list(representations), list(models), list(terms), list(coefficients),
                       dictionary._handle if dictionary else None, size, samples, timed, progress)
    return [Record(**row) for row in rows]


@dataclass(frozen=True)
class Target:
    """A renderer or format that materials are exported to, see gonio.targets()."""

    id: str
    """What gonio.export() takes: "mitsuba"."""
    label: str
    """Name for people."""
    description: str
    """What is written and how it is used."""
    holds: str
    """What the files can hold and what not."""
    has_scenes: bool
    """Whether a scene can be written with the material."""


def targets() -> dict[str, Target]:
    """All targets of gonio.export() by id (docs/exports.md)."""
    return {row[0]: Target(*row) for row in _core.targets()}


@dataclass(frozen=True)
class Export:
    """Files that gonio.export() has written."""

    files: list[str]
    """Paths of the files."""
    snr: float
    """Rendered SNR in dB of what the renderer shows against the material; infinite for equal pictures."""
    bytes: int
    """Size of all files."""
    facts: dict[str, Any] = field(repr=False)
    """Numbers of the target."""
    warnings: list[str]
    """Sentences about what the files do not hold."""
    material: Material = field(repr=False)
    """What the renderer shows of the files, by the target's own formula."""


def export(material: Material, path: PathLike, target: str, snr: float = 40.0, grid: Optional[tuple[int, int]] = None,
           scene: PathLike = "", environment: PathLike = "", overwrite: bool = False, progress: Progress = None) -> Export:
    """Writes a material, with its edits, as the files of a renderer. Some seconds.

    Args:
        material: What is exported.
        path: Name of the files without their suffix.
        target: Id of a target (gonio.targets()).
        snr: Rendered SNR in dB that files should reach, where their size can be chosen.
        grid: Of .bsdf files, the number of incident polar angles and of nodes along each side of a slice; None: the
            smallest that reach the SNR.
        scene: Scene to write with the material; "": none.
        environment: In place of the scene's own.
        overwrite: Whether files that exist are replaced.
        progress: Called with the fraction that is done. An exception that it raises stops the work.

    Raises:
        Error: There is no such target, a file exists, or one cannot be written; then none is.
    """
    theta_count, side = grid or (0, 0)
    row = _core.export(material._handle, os.fspath(path), target, snr, theta_count, side, os.fspath(scene),
                       os.fspath(environment), overwrite, progress)
    row["material"] = Material(row["material"])
    return Export(**row)
