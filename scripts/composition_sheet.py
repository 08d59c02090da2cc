#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""composition_sheet.py GONIOTOOL OUT_DIR [MODEL [COMPOSITION ...]]: twelve bundled materials with the roughness of a fit
at 1/4, 1/2, 1, 2 and 4 times its value, in the compositions (all three): one picture a cell, and a sheet a composition
(with ImageMagick).
"""
import json
import pathlib
import subprocess
import sys

MATERIALS = [
    "merl-copy/alum-bronze", "merl-copy/brass", "merl-copy/steel", "merl-copy/gold-metallic-paint",
    "merl-copy/blue-metallic-paint", "rgl/ilm_solo_m_68", "merl-copy/red-specular-plastic", "merl-copy/green-acrylic",
    "merl-copy/red-fabric", "rgl/acrylic_felt_green", "merl-copy/special-walnut-224", "rgl/cc_iris_purple_gem",
]
FACTORS = [0.25, 0.5, 1, 2, 4]
COMPOSITIONS = ["additive", "log-plus", "lobes"]


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def seed(tool, out, material, model):
    """The document of an edit of the fit; other edits of it are written by changing its control."""
    path = out / f"{material.replace('/', '-')}.gonio"
    run(tool, "edit", f"library:{material}", "--model", model, "--control", "roughness=2", "--out", str(path))
    return json.loads(path.read_text())


def edited(document, composition, factor):
    edit = document["edits"][0]
    edit["composition"] = composition
    edit["controls"] = {"roughness": factor}
    return document


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    tool, out = sys.argv[1], pathlib.Path(sys.argv[2])
    model = sys.argv[3] if len(sys.argv) > 3 else "layered"
    compositions = sys.argv[4:] or COMPOSITIONS
    out.mkdir(parents=True, exist_ok=True)
    seeds = {material: seed(tool, out, material, model) for material in MATERIALS}
    for composition in compositions:
        pictures = []
        for material in MATERIALS:
            for factor in FACTORS:
                name = out / f"{composition}-{material.replace('/', '-')}-{factor:g}"
                path = name.with_name(name.name + ".gonio")
                path.write_text(json.dumps(edited(seeds[material], composition, factor)))
                picture = str(name) + ".png"
                run(tool, "render", str(path), "--scene", "sphere", "--size", "112", "--samples", "64", "--out", picture)
                pictures.append(picture)
        sheet = str(out / f"sheet-{model}-{composition}.png")
        subprocess.run(["montage", "-tile", f"{len(FACTORS) * 2}x", "-geometry", "112x112+2+2",
                        "-background", "#303030", *pictures, sheet], check=True)


main()
