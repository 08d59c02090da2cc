# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Extreme tables through every command that reads a material."""

import struct


def merl(folder, name, value):
    """A MERL file of 90 x 90 x 180 cells; value(channel, cell) or a number, raw."""
    counts = (90, 90, 180)
    cells = counts[0] * counts[1] * counts[2]
    with open(folder / name, "wb") as file:
        file.write(struct.pack("<3i", *counts))
        for channel in range(3):
            if callable(value):
                file.write(value(channel, cells))
            else:
                file.write(struct.pack("<d", value) * cells)
    return name


def extreme_tables(folder):
    def spike(channel, cells):
        data = bytearray(struct.pack("<d", 0.1) * cells)
        data[8 * 5000:8 * 5001] = struct.pack("<d", 1e30)
        return bytes(data)

    def empty_channel(channel, cells):
        return struct.pack("<d", 0.0 if channel == 1 else 100.0) * cells

    def grazing(channel, cells):  # only the largest theta_h and theta_d have data
        rows = []
        for h in range(90):
            for d in range(90):
                rows.append(struct.pack("<d", 50.0 if h > 70 or d > 80 else -1.0) * 180)
        return b"".join(rows)

    return [merl(folder, "zero.binary", 0.0), merl(folder, "spike.binary", spike), merl(folder, "huge.binary", 1e300),
            merl(folder, "empty-channel.binary", empty_channel), merl(folder, "invalid.binary", -1.0),
            merl(folder, "grazing.binary", grazing)]


EXTREME = [["info"], ["check"], ["fit", "--model", "ggx"], ["fit", "--model", "lambert"],
           ["factor", "--terms", "2", "--out", "x.pdv"], ["factor", "--method", "hosvd"], ["encode", "--out", "x.code"],
           ["encode", "--method", "components"], ["render", "--size", "16", "--samples", "2", "--out", "x.png"],
           ["export", "x", "--for", "glsl"], ["evaluate", "--wi", "0.1", "0", "--wo", "0.2", "0"]]


def extreme(attack, _):
    for table in extreme_tables(attack.folder):
        for command in EXTREME:
            arguments = [command[0], table, *command[1:]]
            code, output, error = attack.run(arguments, limit_memory=True)
            if code not in (0, 1, 2):
                attack.finding(arguments, f"exit code {code}: {error.strip()[:300]}")
            if code == 1 and command[0] != "check" and len(error.strip().splitlines()) != 1:
                attack.finding(arguments, f"not one line: {error.strip()[:300]}")
            if "nan" in output.lower().replace("finance", ""):
                attack.finding(arguments, "NaN in the output")
