# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Measured materials (BRDFs) for NumPy: open, evaluate, fit, edit, factorise, encode, acquire, render, compare.

Conventions of all functions:

- Directions are unit vectors of shape (..., 3) that point away from the surface; z is the normal. `wi` points toward the
  light, `wo` toward the viewer. theta_i and theta_o are their polar angles from the normal, phi_i and phi_o their azimuths.
- A BRDF value rho is linear RGB (sRGB primaries) in 1/sr, without the cosine. A last dimension of 3 is red, green, blue.
- Angles are in radians, times in seconds, sizes of data in bytes, sizes of images in pixels, SNRs in dB.
- theta_h, theta_d, phi_d are the half-difference angles of a pair of directions (Rusinkiewicz 1998). A table contains BRDF
  values on a grid of these angles; a table of the MERL database has 90 x 90 x 180 cells. A cell without data is invalid.
- Every optional argument that defaults to None, 0, () or "" states what that default does.
- The same arguments and seeds give the same bits for any number of threads.
- Long computations run on all cores, release the GIL, and can be interrupted by Ctrl+C.
- Bad input raises gonio.Error, a ValueError. Its message states what was found and what was expected. Numbers that are not
  finite are bad input for every argument, except in invalid cells of a table.

Types in the signatures:

- `ArrayLike` (of numpy.typing): anything that numpy.asarray() accepts: an array, a list of lists, a number. Arrays that
  functions return are `NDArray`, with the type of their elements in brackets.
- `PathLike`: a file name as str, bytes or os.PathLike, such as pathlib.Path, as for Python's own open(). Where the text says
  so, also the name of something bundled, such as "library:rgl/satin_purple".
- `Progress`: None, or a function of one number. It is called on the calling thread with the fraction that is done, from 0
  to 1. If it raises an exception, the computation stops and the exception is passed on.
- `Value`: the value of a model's parameter: a number; three numbers (red, green, blue) for a parameter with a value per
  channel; the name or index of a choice.
- `Box`: ranges (low, high) of theta_i, theta_o and |phi_i - phi_o| in rad: ((low, high), (low, high), (low, high)).
- `Optional[X]`: an X or None. `Union[X, Y]`: an X or a Y. `Sequence[X]`: a list or tuple of X. `Iterable[X]`: the same, or a
  generator. `Mapping[str, X]`: a dict with names as keys.
"""
from inspect import isfunction as _isfunction

from ._arguments import checked as _checked
from ._core import Error, version as __version__
from ._materials import (Check, GridDirections, LibraryEntry, Material, check, coordinates, from_coordinates, from_table,
                         grid_directions, library, open, set_threads, to_coordinates)
from ._representations import (BaselineFactors, ChannelCode, Code, Dictionary, Factors, Interpolation, baselines, decode,
                               dictionary, encode, factorize, factorize_baseline, interpolate, open_code, open_factors,
                               published_deviation_nodes)
from ._training import PatchCode, PatchDictionary, learn_patches, train_dictionary
from ._neural import NeuralBrdf, neural_brdf, open_neural, train_neural
from ._models import (Fit, Metric, Model, Parameter, artist_controls, edit, edit_factors, fit, fit_all, metrics, models)
from ._acquisition import (Basis, Plan, Readings, Reconstruction, SeparatedBasis, bundled_basis, learn_atoms, learn_basis,
                           learn_separated_basis, measure, open_basis, open_plan, plan, reconstruct, separate)
from ._factor_measurement import (FactorPlan, FactorPrediction, open_factor_readings, plan_factors, predict_from_factors)
from ._photographs import ImagePlan, ImageReconstruction, InputCheck, from_images, plan_images
from ._pictures import (Comparison, Effect, Export, Record, Target, compare, effects, export, render, scenes, study, targets)

__all__ = [
    "Error",
    # Materials
    "open", "library", "from_table", "grid_directions", "coordinates", "to_coordinates", "from_coordinates", "check",
    "set_threads", "Material", "GridDirections",
    "LibraryEntry", "Check",
    # Models, fits, edits
    "models", "fit", "fit_all", "edit", "edit_factors", "artist_controls", "metrics", "Model", "Parameter", "Fit", "Metric",
    # Factors, codes, interpolation
    "factorize", "published_deviation_nodes", "open_factors", "factorize_baseline", "baselines", "encode", "decode",
    "open_code", "dictionary", "train_dictionary", "interpolate", "Factors", "BaselineFactors", "Code", "ChannelCode", "Dictionary",
    "learn_patches", "PatchDictionary", "PatchCode", "Interpolation", "train_neural", "neural_brdf", "open_neural", "NeuralBrdf",
    # Acquisition
    "plan_factors", "open_factor_readings", "predict_from_factors", "FactorPlan", "FactorPrediction",
    "plan", "open_plan", "measure", "reconstruct", "bundled_basis", "learn_basis", "learn_atoms", "open_basis", "separate",
    "learn_separated_basis", "SeparatedBasis", "Plan", "Readings",
    "Reconstruction", "Basis",
    # Photographs
    "from_images", "plan_images", "ImageReconstruction", "ImagePlan", "InputCheck",
    # Images, studies, exports
    "render", "scenes", "effects", "compare", "study", "export", "targets", "Comparison", "Effect", "Record", "Export",
    "Target",
]

Error.__doc__ = "Raised by all functions for bad input. The message states the file, what was found and what was expected."
for _name in __all__:
    _item = globals()[_name]
    _item.__module__ = __name__
    if not isinstance(_item, type):
        globals()[_name] = _checked(_item)
        continue
    for _key, _member in list(vars(_item).items()):
        if _isfunction(_member) and (not _key.startswith("_") or _key == "__init__" and not hasattr(_item, "__dataclass_fields__")):
            setattr(_item, _key, _checked(_member))
del _name, _item, _key, _member
