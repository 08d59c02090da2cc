# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Measured materials (BRDFs) for NumPy: open, evaluate, fit, edit, factorise, encode, acquire, render, compare.

Conventions of all functions:

- Directions are unit vectors of shape (..., 3) that point away from the surface; z is the normal. `wi` points toward the
  light, `wo` toward the viewer.
- A BRDF value is linear RGB (sRGB primaries) in 1/sr, without the cosine.
- Angles are radians, times seconds, sizes bytes.
- The same arguments and seeds give the same bits for any number of threads.
- Work that takes time runs on all cores without the GIL, can be interrupted by Ctrl+C, and where it takes `progress`
  calls it on the calling thread with the fraction that is done.
- Bad input raises gonio.Error (a ValueError), which states what was found and what was expected.
"""
from ._core import Error, version as __version__
from ._materials import (Check, GridDirections, LibraryEntry, Material, check, from_table, grid_directions, library, open,
                         set_threads)
from ._representations import (ChannelCode, Code, Dictionary, Factors, Interpolation, decode, dictionary, encode, factorize,
                               interpolate, open_code, open_factors)
from ._models import (Fit, Metric, Model, Parameter, artist_controls, edit, edit_factors, fit, fit_all, metrics, models)
from ._acquisition import (Basis, Plan, Readings, Reconstruction, bundled_basis, learn_basis, measure, open_basis, open_plan,
                           plan, reconstruct)
from ._pictures import (Comparison, Effect, Export, Record, Target, compare, effects, export, render, scenes, study, targets)

__all__ = [
    "Error",
    # Materials
    "open", "library", "from_table", "grid_directions", "check", "set_threads", "Material", "GridDirections",
    "LibraryEntry", "Check",
    # Models, fits, edits
    "models", "fit", "fit_all", "edit", "edit_factors", "artist_controls", "metrics", "Model", "Parameter", "Fit", "Metric",
    # Factors, codes, interpolation
    "factorize", "open_factors", "encode", "decode", "open_code", "dictionary", "interpolate", "Factors", "Code",
    "ChannelCode", "Dictionary", "Interpolation",
    # Acquisition
    "plan", "open_plan", "measure", "reconstruct", "bundled_basis", "learn_basis", "open_basis", "Plan", "Readings",
    "Reconstruction", "Basis",
    # Pictures, studies, exports
    "render", "scenes", "effects", "compare", "study", "export", "targets", "Comparison", "Effect", "Record", "Export",
    "Target",
]

Error.__doc__ = "What all functions raise for bad input: the message states the file, what was found and what was expected."
for _name in __all__:
    globals()[_name].__module__ = __name__
del _name
