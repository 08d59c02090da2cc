#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Draws how a material outside the training set is reconstructed from more and more measured directions: its images,
and the SNR by three methods that choose the directions. The training set consists of near-measured copies of MERL
materials. Takes about two minutes."""
import argparse

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import gonio


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("material", nargs="?", default="library:rgl/satin_purple", help="a file or library:SOURCE/NAME")
    parser.add_argument("--samples", nargs="+", type=int, default=[2, 5, 10, 20, 40])
    parser.add_argument("--materials", type=int, default=40,
                        help="approximate number of materials in the training set")
    parser.add_argument("--out", default="samples_of_a_reconstruction.png", help="PNG, PDF or SVG to write")
    options = parser.parse_args()

    material = gonio.open(options.material)
    training = [entry.path for entry in gonio.library() if entry.path.startswith("library:merl-copy/")]
    basis = gonio.learn_basis(training[::max(1, len(training) // options.materials)])

    def reconstructed(method, samples):
        plan = gonio.plan(samples, basis, method=method)
        return gonio.reconstruct(plan, gonio.measure(material, plan), basis).material

    figure = plt.figure(figsize=(7.5, 5), layout="constrained")
    grid = figure.add_gridspec(2, len(options.samples) + 1, height_ratios=(1, 2))
    axes = figure.add_subplot(grid[1, :])

    def show(column, picture, title):
        place = figure.add_subplot(grid[0, column])
        place.imshow(np.clip(picture, 0, 1) ** (1 / 2.2))
        place.set_title(title, fontsize=8)
        place.axis("off")

    for method in ("somp", "uniform", "random"):
        snr = []
        for column, samples in enumerate(options.samples):
            found = gonio.compare(material, reconstructed(method, samples), size=96, samples=32, pictures=method == "somp")
            snr.append(found.rendered_snr)
            if found.pictures:
                show(column, found.pictures[1], f"{samples} samples")
                measured = found.pictures[0]
        axes.plot(options.samples, snr, "o-", markersize=4, label=method)
    show(len(options.samples), measured, "measured")
    axes.set_xscale("log")
    axes.set_xticks(options.samples, [str(samples) for samples in options.samples])
    axes.minorticks_off()
    axes.set_xlabel("measured directions")
    axes.set_ylabel("rendered SNR [dB]")
    axes.set_title(f"{material.name}, reconstructed with {len(basis)} components of {len(basis.training_set)} other materials",
                   fontsize=10)
    axes.grid(alpha=0.3)
    axes.legend()
    figure.savefig(options.out, dpi=160)


if __name__ == "__main__":
    main()
