# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Materials from images of a sphere, a cylinder or a flat sample under known light."""
from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from typing import Any, Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._acquisition import Basis, _library_basis
from ._arguments import PathLike
from ._materials import Material, Progress


@dataclass(frozen=True)
class InputCheck:
    """By how much a property of the input seems to differ from what is stated, see ImageReconstruction."""

    property: str
    """"exposure", "gamma", "outline x", "outline y", "outline radius" or "rotation"."""
    estimate: float
    """Difference from the stated value: of a natural logarithm (exposure, gamma), in pixels, or in rad (rotation)."""
    deviation: float
    """Standard deviation of the estimate."""
    evidence: float
    """Half the squared ratio of estimate and deviation."""
    snr: float
    """SNR of the regions of pixels with the difference corrected, without their noise, dB."""
    suspicious: bool
    """Whether the difference is significant, large enough to matter, and explains the pixels."""


@dataclass(frozen=True)
class ImageReconstruction:
    """A material reconstructed from images, see gonio.from_images()."""

    material: Material
    """The reconstructed material, a table on the grid of the basis."""
    exposure: float
    """Common factor of the pixel values; 1 if it is known."""
    exposure_deviation: float
    """Standard deviation of its natural logarithm; 0 if it is known."""
    grey_exposure: tuple[float, float, float]
    """Factor of the pixel values of red, green and blue by grey patches; 1 without them."""
    outlines: list[Optional[tuple[float, float, float]]]
    """x, y and radius of the sphere's outline in each image, pixels; None for other shapes."""
    residual_snr: list[float]
    """Energy of the regions of pixels of each image relative to that of their differences from the reconstruction, dB."""
    bandwidth: float
    """Bandwidth h of the weights of the training materials; infinite if all have the same weight."""
    model_noise: float
    """Relative standard deviation of a pixel value that the model does not explain."""
    lost_light: float
    """Fraction of the light in directions without training data."""
    deviation: NDArray[np.float32] = field(repr=False)
    """Uncertainty: standard deviation of the mapped value (see Basis) of each cell and channel, shape (n_h, n_d, n_phi, 3); NaN
    in invalid cells."""
    checks: list[InputCheck] = field(repr=False)
    """Checks of the input."""
    warnings: list[str] = field(repr=False)
    """Problems of the input, one sentence each: clipped pixels, conversions, the strongest suspicious check; usually empty."""


@dataclass(frozen=True)
class ImagePlan:
    """Which images to take next, see gonio.plan_images(). Deviations are expected standard deviations of mapped values (see
    Basis): the root of the mean variance over cells, channels and training materials."""

    chosen: list[str]
    """The files of the chosen candidates, the most useful one first."""
    description: dict[str, Any] = field(repr=False)
    """The description with the chosen candidates as further images, for the camera's files or for
    `goniotool photograph simulate`."""
    before: dict[str, float]
    """Deviation without images: "all", "diffuse" and "glossy" training materials."""
    images: list[tuple[str, dict[str, float]]] = field(repr=False)
    """Deviations after the images of the description and the chosen ones, one more in each row: (file, deviation)."""
    candidates: list[tuple[str, dict[str, float]]] = field(repr=False)
    """Deviation after the images of the description and this candidate: (file, deviation)."""


def _text_of(description: Any) -> tuple[str, bytes, list[tuple[str, NDArray[np.float32]]]]:
    """The JSON text, the folder to which its paths are relative, and images by the names that replace their files."""
    if isinstance(description, (str, bytes, os.PathLike)):
        path = os.fsencode(description)
        return _core.read_description(path), os.path.dirname(path), []
    given = dict(description) if isinstance(description, Mapping) else {"images": list(description)}
    arrays = []
    entries = []
    for number, entry in enumerate(given.get("images", ())):
        entry = dict(entry)
        if "image" in entry:
            entry.setdefault("file", f"image-{number}")
            arrays.append((entry["file"], np.ascontiguousarray(entry.pop("image"), dtype=np.float32)))
        entries.append(entry)
    given = {"format": "gonio photographs", "version": 1, **given, "images": entries}
    return json.dumps(given, default=_plain), b"", arrays


def _plain(value: Any) -> Any:
    """NumPy's numbers and arrays, and paths, as JSON has them."""
    return value.tolist() if isinstance(value, (np.ndarray, np.generic)) else os.fspath(value)


def from_images(description: Union[PathLike, Mapping[str, Any], Sequence[Mapping[str, Any]]], basis: Optional[Basis] = None,
                components: int = 64, regions: int = 600, name: str = "photograph", progress: Progress = None) -> ImageReconstruction:
    """Reconstructs a material from linear images of a sphere, a cylinder or a flat sample under known light, with its
    uncertainty (docs/photographs.md). The result is isotropic and reciprocal. About 10 s for an image of 256 x 256 pixels under
    an environment, on two cores.

    Args:
        description: A JSON file that describes the images (docs/photographs.md), the same as a dict, or the list of its images.
            The entry of an image may have the linear pixels themselves instead of a file: "image", an array of shape
            (height, width, 3).
        basis: Principal components of the training set; None: gonio.learn_basis(). It should not contain the material itself if
            you report the error.
        components: Maximum number of components to use.
        regions: Maximum number of regions of pixels, of all images.
        name: Name of the material.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: The description has a fault (the message states the member), or an image cannot be read or has no usable pixels.
    """
    known = basis or _library_basis(progress)
    row = _core.from_images(*_text_of(description), known._handle, components, regions, name, progress)
    row["material"] = Material(row["material"])
    row["checks"] = [InputCheck(*check) for check in row["checks"]]
    return ImageReconstruction(**row)


def plan_images(description: Union[PathLike, Mapping[str, Any], Sequence[Mapping[str, Any]]], images: int = 1, rotations: int = 0,
                lights: int = 0, cameras: int = 0, basis: Optional[Basis] = None, components: int = 64,
                model_noise: float = 0.08, materials: int = 24, progress: Progress = None) -> ImagePlan:
    """Chooses the next images of a sample: those that reduce the expected uncertainty of materials most, by greedy A-optimal
    design (docs/photographs.md). The pixels of the images are not used, so that they need not exist.

    Args:
        description: As for gonio.from_images(). Its member "candidates" lists images that can be taken next.
        images: Number of images to choose.
        rotations: Number of further candidates: rotations of the first image's environment.
        lights: Number of further candidates: directions of the first image's light, up to 120 degrees from the camera.
        cameras: Number of further candidates: positions of the first image's camera about the vertical axis.
        basis: Principal components of the training set; None: gonio.learn_basis().
        components: Maximum number of components to use.
        model_noise: Standard deviation of pixel values that the model does not explain, as a fraction of the value.
        materials: Maximum number of training materials for which the images are compared.
        progress: Called with the fraction that is done, 0 to 1; None: not reported.

    Raises:
        Error: The description has a fault (the message states the member), or there is no candidate.
    """
    known = basis or _library_basis(progress)
    text, folder, _ = _text_of(description)
    row = _core.plan_images(text, folder, images, (rotations, lights, cameras), known._handle, components, model_noise, materials,
                            progress)
    row["description"] = json.loads(row["description"])
    return ImagePlan(**row)
