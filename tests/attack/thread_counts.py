# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""The same bytes with any number of threads."""

from runner import digest

THREADS = (1, 2, 3, 7, 64)

SAME_BITS = [(["fit", "library:merl-copy/aluminium", "--model", "cook-torrance", "--out", "x.binary"],
              "x.binary"),
             (["factor", "library:merl-copy/aluminium", "--terms", "5", "--out", "x.pdv"], "x.pdv"),
             (["factor", "library:merl-copy/aluminium", "--terms", "3", "--joint", "--out", "x.pdv"], "x.pdv"),
             (["encode", "library:merl-copy/aluminium", "--out", "x.code"], "x.code"),
             (["dictionary", "train", "a.binary", "b.binary", "--dictionaries", "2", "--sparsities", "32", "--iterations", "2",
               "--out", "x.dictionary"], "x.dictionary"),
             (["plan", "--samples", "10", "--out", "x.csv"], "x.csv"),
             (["convert", "library:rgl/paper_blue", "x.binary"], "x.binary"),
             (["render", "library:rgl/paper_blue", "--size", "64", "--samples", "16", "--out", "x.exr"], "x.exr"),
             (["interpolate", "library:merl-copy/aluminium", "library:merl-copy/chrome", "--weights", "0.5", "0.5",
               "--space", "dictionary", "--out", "x.binary"], "x.binary")]


def threads(attack, _):
    attack.run(["convert", "library:merl-copy/chrome", "a.binary"])
    attack.run(["convert", "library:merl-copy/red-fabric", "b.binary"])
    for arguments, out in SAME_BITS:
        digests = {}
        for count in THREADS:
            path = attack.folder / out
            path.unlink(missing_ok=True)
            code, _, error = attack.run(["--threads", count, *arguments])
            if code != 0 or not path.exists():
                attack.finding(arguments, f"{count} threads: {error.strip()[:300]}")
                break
            digests[count] = digest(path)
        if len(set(digests.values())) > 1:
            attack.finding(arguments, f"different bytes: {digests}")
