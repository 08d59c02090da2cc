#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Draws five fits against a measurement in the plane of incidence, polar: BRDF values to the power of 1/3."""
import argparse

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import gonio


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("material", nargs="?", default="library:rgl/satin_purple", help="a file or library:SOURCE/NAME")
    parser.add_argument("--models", nargs="+", default=["blinn-phong", "ward", "cook-torrance", "ggx", "abc"])
    parser.add_argument("--incidence", type=float, default=45, help="polar angle of the light, degrees")
    parser.add_argument("--out", default="polar_fits.png", help="PNG, PDF or SVG to write")
    options = parser.parse_args()

    material = gonio.open(options.material)
    theta = np.radians(np.linspace(-85, 85, 1001))
    viewer = np.stack((np.sin(theta), 0 * theta, np.cos(theta)), axis=-1)
    incidence = np.radians(options.incidence)
    light = [-np.sin(incidence), 0, np.cos(incidence)]

    def lobe(shown):
        return np.cbrt(np.maximum(0, shown.evaluate(light, viewer) @ [0.2126, 0.7152, 0.0722]))

    figure, axes = plt.subplots(figsize=(7, 4.6), subplot_kw={"projection": "polar"}, layout="constrained")
    axes.fill(theta, lobe(material), color="0.85", label=f"{material.name}, measured")
    for fit in gonio.fit_all(material, options.models, size=64, samples=16):
        label = f"{fit.model.name}: log error {fit.errors['log']:.3f}, {fit.rendered_snr:.1f} dB"
        axes.plot(theta, lobe(fit.material()), linewidth=1.2, label=label)
    axes.axvline(-incidence, color="0.4", linewidth=0.8, linestyle="--")
    axes.annotate("light", (-incidence, axes.get_rmax()), ha="right", color="0.3")
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(-1)
    axes.set_thetalim(-np.pi / 2, np.pi / 2)
    axes.set_title(f"{material.name}, light at {options.incidence:g} degrees: (luminance of the BRDF, 1/sr)$^{{1/3}}$", fontsize=10, y=0.88)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, 0.16), ncols=2, fontsize=8, frameon=False)
    figure.savefig(options.out, dpi=160)


if __name__ == "__main__":
    main()
