# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""The same bytes with any number of threads and at any addresses of the memory."""

import os

from runner import digest

THREADS = (1, 2, 3, 7, 64)
SEEDS = (1, 2, 3)

TRAIN = ["a.binary", "b.binary", "c.binary"]
COMMANDS = [(["fit", "library:merl-copy/aluminium", "--model", "cook-torrance"], "x.binary"),
            (["edit", "library:merl-copy/chrome", "--model", "ggx", "--control", "roughness=0.5"], "x.binary"),
            (["factor", "library:merl-copy/aluminium", "--terms", "5"], "x.pdv"),
            (["factor", "library:merl-copy/aluminium", "--terms", "3", "--joint"], "x.pdv"),
            (["encode", "library:merl-copy/aluminium"], "x.code"),
            (["encode", "b.binary", "--method", "basis-pursuit"], "x.code"),
            (["dictionary", "train", *TRAIN, "--dictionaries", "2", "--sparsities", "32", "--iterations", "2"],
             "x.dictionary"),
            (["plan", "--samples", "10"], "x.csv"),
            (["plan", "--train", *TRAIN, "--samples", "2"], "plan.csv"),
            (["measure", "library:merl-copy/steel", "--plan", "plan.csv"], "values.csv"),
            (["reconstruct", "--plan", "plan.csv", "--values", "values.csv"], "x.binary"),
            (["convert", "library:rgl/paper_blue"], "x.binary"),
            (["render", "library:rgl/paper_blue", "--size", "64", "--samples", "16"], "x.exr"),
            (["interpolate", "library:merl-copy/aluminium", "library:merl-copy/chrome", "--weights", "0.5", "0.5",
              "--space", "dictionary"], "x.binary")]


def same_bytes(attack, ways):
    """ways: names, each with options of goniotool and an environment."""
    for name, file in zip(("chrome", "red-fabric", "aluminium"), TRAIN):
        attack.run(["convert", f"library:merl-copy/{name}", file])
    for arguments, out in COMMANDS:
        digests = {}
        for way, (options, environment) in ways.items():
            path = attack.folder / out
            path.unlink(missing_ok=True)
            target = [out] if arguments[0] == "convert" else ["--out", out]
            code, _, error = attack.run([*options, *arguments, *target], environment=environment)
            if code != 0 or not path.exists():
                attack.finding(arguments, f"{way}: {error.strip()[:300]}")
                break
            digests[way] = digest(path)
        if len(set(digests.values())) > 1:
            attack.finding(arguments, f"different bytes: {digests}")


def threads(attack, _):
    same_bytes(attack, {f"{count} threads": (["--threads", count], None) for count in THREADS})


def addresses(attack, _):
    allocator = os.environ.get("GONIO_SHIFTED_ALLOCATOR")
    if not allocator:
        raise SystemExit("addresses: GONIO_SHIFTED_ALLOCATOR names tests/attack/libshifted_allocator.so of the build")
    ways = {"allocator of the system": ([], None)}
    for seed in SEEDS:
        ways[f"seed {seed}"] = ([], {"LD_PRELOAD": os.path.abspath(allocator), "GONIO_SHIFT_SEED": str(seed)})
    same_bytes(attack, ways)
