#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""bundle_rgl.py OUT_DIR FILE_rgb.bsdf ...: RGL files for resources/library, a thirteenth of their size.

Keeps the fields that core/rgl/rgl_file cannot compute from others, with the colours as half floats. The distribution that
vndf was made from, which differs from ndf toward the horizon, is kept as `visible_ndf`.
"""
import math
import pathlib
import struct
import sys

MAGIC = b"tensor_file\0\1\0"
UINT8, FLOAT16, FLOAT32 = 1, 9, 10
TYPES = {UINT8: "B", FLOAT32: "f"}
KEPT = {"description", "jacobian", "ndf", "phi_i", "rgb", "sigma", "theta_i"}


def read_fields(data):
    (count,) = struct.unpack_from("<I", data, len(MAGIC))
    position = len(MAGIC) + 4
    for _ in range(count):
        (length,) = struct.unpack_from("<H", data, position)
        name = data[position + 2 : position + 2 + length].decode()
        position += 2 + length
        dimensions, kind, offset = struct.unpack_from("<HBQ", data, position)
        shape = struct.unpack_from(f"<{dimensions}Q", data, position + 11)
        position += 11 + 8 * dimensions
        size = 1
        for extent in shape:
            size *= extent
        if name in KEPT or name == "vndf":
            yield name, kind, shape, struct.unpack_from(f"<{size}{TYPES[kind]}", data, offset)


def visible_ndf(vndf, shape, theta):
    """D of vndf = D(m) max(0, w_i . m) u sin(theta_m), along the row that faces the incident direction of slice `theta`."""
    _, _, rows, columns = shape
    slice_index, theta_i = theta
    row = (rows - 1) // 2
    azimuth = 2 * math.pi * row / (rows - 1) - math.pi
    values = []
    for column in range(columns):
        u = column / (columns - 1)
        polar = u * u * math.pi / 2
        cosine = math.cos(theta_i) * math.cos(polar) + math.sin(theta_i) * math.sin(polar) * math.cos(azimuth)
        value = vndf[(slice_index * rows + row) * columns + column]
        values.append(value / (cosine * u * math.sin(polar)) if column else 0.0)
    values[0] = values[1]  # the pole has no area
    return values


def bundled(data):
    fields = {name: (kind, shape, values) for name, kind, shape, values in read_fields(data)}
    _, shape, vndf = fields.pop("vndf")
    angles = fields["theta_i"][2]
    if shape[0] != 1:
        sys.exit("found an anisotropic material, expected one incident azimuth")
    middle = len(angles) // 2
    values = visible_ndf(vndf, shape, (middle, angles[middle]))
    fields["visible_ndf"] = (FLOAT32, (2, shape[3]), values + values)
    return [packed(name, *field) for name, field in fields.items()]


def packed(name, kind, shape, values):
    if name == "rgb":
        return name, FLOAT16, shape, struct.pack(f"<{len(values)}e", *values)
    return name, kind, shape, struct.pack(f"<{len(values)}{TYPES[kind]}", *values)


def file_of(fields):
    offset = len(MAGIC) + 4 + sum(13 + len(name) + 8 * len(shape) for name, _, shape, _ in fields)
    directory, contents = b"", b""
    for name, kind, shape, data in fields:
        padding = b"\0" * (-(offset + len(contents)) % 8)
        contents += padding
        directory += struct.pack("<H", len(name)) + name.encode()
        directory += struct.pack(f"<HBQ{len(shape)}Q", len(shape), kind, offset + len(contents), *shape)
        contents += data
    return MAGIC + struct.pack("<I", len(fields)) + directory + contents


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    out = pathlib.Path(sys.argv[1])
    for path in map(pathlib.Path, sys.argv[2:]):
        data = path.read_bytes()
        if not data.startswith(MAGIC):
            sys.exit(f"{path}: no tensor file of version 1.0")
        (out / path.name.replace("_rgb.bsdf", ".bsdf")).write_bytes(file_of(bundled(data)))


main()
