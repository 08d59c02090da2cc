# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""The same values from goniotool built for any x86-64 processor as from the one with AVX2 and FMA."""

import os
import pathlib
import re
import shutil

import numpy

TOLERANCE = 1e-6  # relative, of every value
NEGLIGIBLE = 1e-6  # of the mean of the absolute values: differences are relative to at least this

# Fewer materials would leave directions of the space without data, which rounding alone decides.
TRAIN = ["chrome", "red-fabric", "aluminium", "gold-metallic-paint", "alumina-oxide", "blue-rubber", "delrin", "pvc",
         "ipswich-pine-221"]
FILES = [f"{name}.binary" for name in TRAIN]

SAME_VALUES = [
    (["fit", "library:merl-copy/aluminium", "--model", "cook-torrance"], "x.binary"),
    (["fit", "library:merl-copy/chrome", "--model", "ggx"], "x.binary"),
    (["factor", "library:merl-copy/aluminium", "--terms", "5"], "x.binary"),
    (["factor", "library:merl-copy/aluminium", "--terms", "3", "--joint"], "x.binary"),
    (["edit", "library:merl-copy/chrome", "--model", "ggx", "--control", "roughness=0.5"], "x.binary"),
    (["encode", "chrome.binary"], "x.code"),
    (["encode", "red-fabric.binary"], "x.code"),
    (["encode", "pvc.binary", "--method", "basis-pursuit"], "x.code"),
    (["encode", "library:merl-copy/steel", "--rendered-snr", "30"], "x.code"),
    (["dictionary", "train", *FILES, "--dictionaries", "2", "--sparsities", "32", "--iterations", "5"], "x.dictionary"),
    (["plan", "--train", *FILES, "--samples", "6"], "plan.csv"),
    (["measure", "library:merl-copy/steel", "--plan", "plan.csv"], "values.csv"),
    (["reconstruct", "--plan", "plan.csv", "--values", "values.csv"], "x.binary"),
    (["interpolate", "library:merl-copy/aluminium", "library:merl-copy/chrome", "--weights", "0.5", "0.5", "--space",
      "dictionary"], "x.binary"),
    (["convert", "library:rgl/paper_blue"], "x.binary"),
    (["render", "library:rgl/paper_blue", "--size", "64", "--samples", "16"], "x.exr")]


def merl(path):
    return numpy.fromfile(path, "<f8", offset=12)


def matrices(path):
    """The numbers of a dictionary file (docs/formats.md)."""
    data = path.read_bytes()
    return numpy.frombuffer(data, "<f4", offset=16 + int.from_bytes(data[12:16], "little")).astype(float)


def numbers(path):
    rows = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    return numpy.array([float(x) for x in re.findall(r"-?\d+\.?\d*(?:e[-+]?\d+)?", "\n".join(rows))])


def values_of(attack, path):
    if path.suffix == ".code":
        attack.run(["--force", "decode", path, "decoded.binary"])
        return merl(attack.folder / "decoded.binary")
    return {".binary": merl, ".dictionary": matrices, ".csv": numbers}[path.suffix](path)


def largest_difference(a, b):
    if a.shape != b.shape:
        return float("inf")
    size = numpy.maximum(numpy.abs(a), numpy.abs(b))
    return float((numpy.abs(a - b) / numpy.maximum(size, NEGLIGIBLE * size.mean())).max(initial=0))


def instruction_sets(attack, _):
    other = os.environ.get("GONIOTOOL_ANY_PROCESSOR")
    if not other:
        raise SystemExit("instructions: GONIOTOOL_ANY_PROCESSOR names a goniotool built with GONIO_MODERN_PROCESSOR=OFF")
    for name in TRAIN:
        attack.run(["convert", f"library:merl-copy/{name}", f"{name}.binary"])
    tools = (attack.tool, str(pathlib.Path(other).resolve()))
    for arguments, out in SAME_VALUES:
        files = []
        for number, attack.tool in enumerate(tools):
            path = attack.folder / out
            path.unlink(missing_ok=True)
            target = [out] if arguments[0] == "convert" else ["--out", out]
            code, _, error = attack.run(["--force", *arguments, *target])
            if code != 0 or not path.exists():
                attack.finding(arguments, error.strip()[:300])
                break
            files.append(attack.folder / f"{number}{path.suffix}")
            shutil.copy(path, files[-1])
        attack.tool = tools[0]
        if len(files) < 2 or files[0].read_bytes() == files[1].read_bytes():
            continue
        if files[0].suffix == ".exr":
            attack.finding(arguments, "different images")
            continue
        difference = largest_difference(*(values_of(attack, file) for file in files))
        if not difference <= TOLERANCE:
            attack.finding(arguments, f"values differ by {difference:.2g}")
