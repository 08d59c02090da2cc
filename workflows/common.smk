# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# What all workflows share: the materials, their folds, and the needs of a job.
import hashlib
import shlex
from pathlib import Path

MEASURED_SUFFIXES = {".binary", ".bsdf", ".bin"}
OUT = config["out"]
GONIOTOOL = shlex.quote(config["goniotool"])


def materials_of(sources):
    """The paths by the names of the materials, in the order in which goniotool reads the sources."""
    paths = {}
    for source in sources:
        folder = Path(source)
        files = [source]
        if folder.is_dir():
            files = sorted(str(file) for file in folder.iterdir() if file.suffix in MEASURED_SUFFIXES)
        for file in files:
            if paths.setdefault(Path(file).stem, file) != file:
                raise WorkflowError(f"two materials have the name {Path(file).stem}: {paths[Path(file).stem]}, {file}")
    if len(paths) < 2:
        raise WorkflowError("materials: found fewer than two, expected files, folders or bundled materials")
    return paths


SOURCES = config["materials"]
MATERIALS = materials_of(SOURCES)
# Bundled materials are no files.
MATERIAL_FILES = [path for path in MATERIALS.values() if not path.startswith("library:")]
SOURCE_ARGUMENTS = " ".join(shlex.quote(str(source)) for source in SOURCES)

FOLDS = range(config["folds"])
# NAME_rgb is a measured file of RGL, NAME a copy of it: both belong to one fold.
SUBJECT_OF = {name: name.removesuffix("_rgb") for name in MATERIALS}
SUBJECTS = list(dict.fromkeys(SUBJECT_OF.values()))
FOLD_OF = {name: SUBJECTS.index(subject) % len(FOLDS) for name, subject in SUBJECT_OF.items()}
if len(SUBJECTS) <= len(FOLDS):
    raise WorkflowError(f"folds: found {len(FOLDS)} for {len(SUBJECTS)} materials, expected fewer")


def held_out(fold):
    """The names of a fold for --exclude."""
    return shlex.quote(",".join(name for name in MATERIALS if FOLD_OF[name] == int(fold)))


def threads_of(job):
    return config["resources"][job]["threads"]


def need(job, resource):
    """Of the attempt: a job that ran out of memory or time gets more."""
    return lambda wildcards, attempt: attempt * config["resources"][job][resource]


def digest(*settings):
    """A short name for settings."""
    return hashlib.sha256(repr(settings).encode()).hexdigest()[:12]


def listed(values):
    return ",".join(str(value) for value in values)


def file_of(wildcards):
    """Bundled materials are no files."""
    path = MATERIALS[wildcards.name]
    return [] if path.startswith("library:") else [path]


def material_of(wildcards):
    return MATERIALS[wildcards.name]


def folder_of_output(wildcards, output):
    return str(Path(output[0]).parent)


wildcard_constraints:
    fold="[0-9]+",
    name="[^/]+",
    samples="[0-9]+",
    seed="[0-9]+",
