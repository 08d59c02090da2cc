# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""python -m gonio [--version] [MATERIAL ...]: the version, or what the files or bundled materials are."""
import argparse
import sys

import gonio


def described(material: gonio.Material) -> str:
    grid = " x ".join(map(str, material.grid))
    kind = "isotropic" if material.is_isotropic else "anisotropic"
    order = "reciprocal" if material.is_reciprocal else "not reciprocal"
    return ", ".join(text for text in (material.format, grid, kind, order) if text)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m gonio", description="Describes measured materials (BRDFs).")
    parser.add_argument("materials", nargs="*", metavar="MATERIAL", help="a file, or a bundled material such as library:rgl/satin_purple")
    parser.add_argument("--version", action="version", version=f"gonio {gonio.__version__}")
    arguments = parser.parse_args()
    if not arguments.materials:
        print(f"gonio {gonio.__version__}: {len(gonio.library())} bundled materials; help(gonio) in Python is the reference")
    for path in arguments.materials:
        try:
            print(f"{path}: {described(gonio.open(path))}")
        except gonio.Error as error:
            print(f"python -m gonio: {error}", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
