# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Extreme tables through every command that reads a material."""

import itertools
import struct


MERL = (90, 90, 180)
SMALL = (30, 30, 60)


def merl(folder, name, counts, value):
    """A table of these numbers of cells; value(channel, cells) or a number, raw."""
    cells = counts[0] * counts[1] * counts[2]
    with open(folder / name, "wb") as file:
        file.write(struct.pack("<3i", *counts))
        for channel in range(3):
            if callable(value):
                file.write(value(channel, cells))
            else:
                file.write(struct.pack("<d", value) * cells)
    return name


def extreme_tables(folder, counts):
    """The names of the tables. Encoding needs as many cells as MERL has; the other commands get fewer, which is faster."""
    def spike(channel, cells):
        data = bytearray(struct.pack("<d", 0.1) * cells)
        data[8 * 5000:8 * 5001] = struct.pack("<d", 1e30)
        return bytes(data)

    def empty_channel(channel, cells):
        return struct.pack("<d", 0.0 if channel == 1 else 100.0) * cells

    def grazing(channel, cells):  # only the largest theta_h and theta_d have data
        rows = []
        for h in range(counts[0]):
            for d in range(counts[1]):
                is_grazing = h > 0.78 * counts[0] or d > 0.89 * counts[1]
                rows.append(struct.pack("<d", 50.0 if is_grazing else -1.0) * counts[2])
        return b"".join(rows)

    values = {"zero": 0.0, "spike": spike, "huge": 1e300, "empty-channel": empty_channel, "invalid": -1.0, "grazing": grazing}
    return [merl(folder, f"{name}-{counts[0]}.binary", counts, value) for name, value in values.items()]


EXTREME = [["info"], ["check"], ["fit", "--model", "ggx"], ["fit", "--model", "lambert"],
           ["factor", "--terms", "2", "--out", "x.pdv"], ["factor", "--method", "hosvd"], ["encode", "--out", "x.code"],
           ["encode", "--method", "components"], ["render", "--size", "16", "--samples", "2", "--out", "x.png"],
           ["export", "x", "--for", "glsl"], ["evaluate", "--wi", "0.1", "0", "--wo", "0.2", "0"]]


def extreme(attack, _):
    for counts in (MERL, SMALL):
        encodes = counts == MERL
        for table, command in itertools.product(extreme_tables(attack.folder, counts),
                                                [c for c in EXTREME if (c[0] == "encode") == encodes]):
            arguments = [command[0], table, *command[1:]]
            code, output, error = attack.run(arguments, limit_memory=True)
            if code not in (0, 1, 2):
                attack.finding(arguments, f"exit code {code}: {error.strip()[:300]}")
            if code == 1 and command[0] != "check" and len(error.strip().splitlines()) != 1:
                attack.finding(arguments, f"not one line: {error.strip()[:300]}")
            if "nan" in output.lower().replace("finance", ""):
                attack.finding(arguments, "NaN in the output")
