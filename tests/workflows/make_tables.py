# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""make_tables.py FOLDER: four small tables in the format of MERL, of a closed form, for the test of the workflows."""
import array
import math
import struct
import sys
from pathlib import Path

THETA_H, THETA_D, PHI_D = 30, 30, 36
MERL_SCALES = 1.0 / 1500, 1.15 / 1500, 1.66 / 1500


def write_table(path, albedo, width):
    values = array.array("d")
    for scale in MERL_SCALES:
        for h in range(THETA_H):
            theta_h = math.pi / 2 * ((h + 0.5) / THETA_H) ** 2
            lobe = math.exp(-((theta_h / width) ** 2)) / width**2
            for d in range(THETA_D):
                fresnel = 0.04 + 0.96 * (1 - math.cos((d + 0.5) / THETA_D * math.pi / 2)) ** 5
                for p in range(PHI_D):
                    azimuth = 1 + 0.1 * math.cos(2 * math.pi * (p + 0.5) / PHI_D)
                    values.append((albedo / math.pi + fresnel * lobe * azimuth) / scale)
    with open(path, "wb") as file:
        file.write(struct.pack("<3i", THETA_H, THETA_D, PHI_D))
        values.tofile(file)


folder = Path(sys.argv[1])
folder.mkdir(parents=True, exist_ok=True)
for i in range(4):
    write_table(folder / f"table-{i}.binary", 0.1 + 0.2 * i, 0.15 + 0.1 * i)
