# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Damaged files of every format."""

import random
import shutil

RUNS = 150

READING = {  # suffix or name of a seed: the command that reads it; FILE is the damaged file, OUT an output
    "ensemble.dictionary": ["encode", "merl.binary", "--dictionary", "FILE", "--out", "OUT.code"],
    "figure.json": ["figure", "FILE", "--out", "OUT.svg"],
    "mesh.glb": ["render", "library:rgl/paper_blue", "--scene", "FILE", "--size", "8", "--samples", "1", "--out", "OUT.png"],
    "picture.exr": ["render", "library:rgl/paper_blue", "--environment", "FILE", "--size", "8", "--samples", "1", "--out",
                    "OUT.png"],
    "plan.csv": ["measure", "library:rgl/paper_blue", "--plan", "FILE", "--out", "OUT.csv"],
    "values.csv": ["reconstruct", "--plan", "plan.csv", "--values", "FILE", "--basis", "pca.basis", "--out", "OUT.binary"],
    "pca.basis": ["reconstruct", "--plan", "plan.csv", "--values", "values.csv", "--basis", "FILE", "--out", "OUT.binary"],
    "readings.csv": ["measure", "--factors", "symmetric-deviation", "--values", "FILE", "--predict", "OUT.pdv"],
    "npf.bin": ["info", "FILE#red"],
    "scene.json": ["render", "library:rgl/paper_blue", "--scene", "FILE", "--size", "8", "--samples", "1", "--out", "OUT.png"],
    "material": ["convert", "FILE", "OUT.binary"],
}
# Reading, without the table that takes most of the time.
INFO = ["info", "FILE"]
SAME_COMMAND = {"mesh.obj": "mesh.glb", "mesh.ply": "mesh.glb", "picture.hdr": "picture.exr"}


def damaged_bytes(data, rng):
    data = bytearray(data)
    kind = rng.randrange(6)
    at = rng.randrange(len(data))
    if kind == 0:
        return bytes(data[:at])
    if kind == 1:
        for _ in range(rng.randrange(1, 50)):
            data[rng.randrange(len(data))] = rng.randrange(256)
    if kind == 2:
        data[at:at] = rng.randbytes(rng.randrange(1, 200))
    if kind == 3:
        data[at:at + 64] = bytes(min(64, len(data) - at))
    if kind == 4:  # a huge number
        at = min(at, max(0, len(data) - 4))
        data[at:at + 4] = rng.choice([b"\xff\xff\xff\xff", b"\xff\xff\xff\x7f", b"\x00\x00\x80\x7f", b"9999"])
    if kind == 5:
        return rng.choice([b"", rng.randbytes(len(data)), bytes(data) * 2, b"[" * 200000])
    return bytes(data)


def damaged(attack, seeds):
    rng = random.Random(1)
    files = sorted(p for p in seeds.iterdir() if p.name != "spectra.csv")
    for file in files:
        shutil.copy(file, attack.folder)
    known = set(attack.folder.iterdir())
    for i in range(RUNS):
        seed = files[i % len(files)]
        name = SAME_COMMAND.get(seed.name, seed.name)
        file = attack.folder / f"damaged-{i}{seed.suffix}"
        file.write_bytes(damaged_bytes(seed.read_bytes(), rng))
        reading = READING.get(name) or (READING["material"] if i < len(files) else INFO)
        arguments = [a.replace("FILE", file.name).replace("OUT", "out") for a in reading]
        code, _, error = attack.run(arguments, limit_memory=True)
        left = attack.leftovers(known | {file})
        lines = error.strip().splitlines()
        if code not in (0, 1):
            attack.finding(arguments, f"exit code {code}: {error.strip()[:200]}")
        if code == 1 and (len(lines) != 1 or file.name not in error):
            attack.finding(arguments, f"{len(lines)} lines that should be one and name the file: {error.strip()[:300]}")
        if code == 1 and left:
            attack.finding(arguments, f"failed, and left {left}")
        for path in left:
            (attack.folder / path).unlink()
        file.unlink()
