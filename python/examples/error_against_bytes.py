#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Draws the rendered SNR of representations of a material against their size, with the Pareto front."""
import argparse

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import gonio


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("material", nargs="?", default="library:rgl/vch_golden_yellow", help="a file or library:SOURCE/NAME")
    parser.add_argument("--models", nargs="+", default=["lambert", "ward", "ggx", "layered"])
    parser.add_argument("--out", default="error_against_bytes.png", help="PNG, PDF or SVG to write")
    options = parser.parse_args()

    material = gonio.open(options.material)
    records = gonio.study(material, ["fits", "factors", "codes"], models=options.models, terms=[1, 2, 3, 5, 10],
                          coefficients=[32, 128, 512, 2048], size=64, samples=16, timed=False)

    figure, axes = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
    for name in dict.fromkeys(record.representation if record.family != "fits" else "fits" for record in records):
        rows = [record for record in records if name in (record.representation, record.family)]
        line = "" if name == "fits" else "-"
        axes.plot([row.bytes for row in rows], [row.rendered_snr for row in rows], "o" + line, markersize=4,
                  label="fitted models" if name == "fits" else rows[0].label)
    for row in records:
        if row.family == "fits":
            axes.annotate(row.label, (row.bytes, row.rendered_snr), xytext=(5, -3), textcoords="offset points", fontsize=7)
    front = sorted(records, key=lambda record: (record.bytes, -record.rendered_snr))
    best = np.maximum.accumulate([record.rendered_snr for record in front])
    axes.step([record.bytes for record in front], best, where="post", color="0.7", zorder=0, label="Pareto front")
    axes.set_xscale("log")
    axes.set_xlabel("size [bytes]")
    axes.set_ylabel("rendered SNR [dB]")
    axes.set_title(material.name, fontsize=10)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    figure.savefig(options.out, dpi=160)


if __name__ == "__main__":
    main()
