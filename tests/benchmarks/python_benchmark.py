#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""The time of a million evaluations from Python beside that of the same batch in C++, both on all cores and on one:

    PYTHONPATH=build/release/python tests/benchmarks/python_benchmark.py [MATERIAL ...]

The C++ time is of evaluating pairs that lie ready in memory, its result included; the Python time is of Material.evaluate()
on NumPy arrays. The smallest of several runs counts, the two in turn.
"""
import sys
import time

import numpy as np

import gonio

COUNT, RUNS = 1_000_000, 9


def directions(seed):
    random = np.random.default_rng(seed)
    z, phi = random.random(COUNT), random.uniform(0, 2 * np.pi, COUNT)
    r = np.sqrt(1 - z * z)
    return np.stack((r * np.cos(phi), r * np.sin(phi), z), axis=-1)


def seconds_of(work):
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def compare(material, wi, wo):
    pairs = [(seconds_of(lambda: material.evaluate(wi, wo)), material._handle.batch_seconds(wi, wo)) for _ in range(RUNS)]
    return (min(times) for times in zip(*pairs))


def main():
    materials = sys.argv[1:] or ["library:sgd/chrome", "library:rgl/satin_purple"]
    wi, wo = directions(1), directions(2)
    print(f"{'material':40} {'threads':>7} {'Python, ms':>11} {'C++, ms':>9} {'ratio':>6}")
    for path in materials:
        for material in (gonio.open(path), gonio.open(path).tabulated()):
            for threads in (0, 1):
                gonio.set_threads(threads)
                python, native = compare(material, wi, wo)
                form = f"{material.name}, {'table' if material.is_table else material.format}"
                print(f"{form:40} {threads or 'all':>7} {python * 1e3:11.1f} {native * 1e3:9.1f} {python / native:6.2f}")


if __name__ == "__main__":
    main()
