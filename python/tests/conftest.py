# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
import json
import os
import subprocess

import numpy as np
import pytest

import gonio


@pytest.fixture
def directions():
    """directions(count, seed): unit vectors above the horizon, uniform over the hemisphere."""

    def make(count, seed=1):
        random = np.random.default_rng(seed)
        z, phi = random.uniform(0.02, 1, count), random.uniform(0, 2 * np.pi, count)
        r = np.sqrt(1 - z * z)
        return np.stack((r * np.cos(phi), r * np.sin(phi), z), axis=-1)

    return make


@pytest.fixture(scope="session")
def chrome():
    """A table: the published SGD fit of a shiny metal, on a small grid."""
    return small_table(gonio.open("library:sgd/chrome"))


@pytest.fixture(scope="session")
def paint():
    """A table of a rough paint."""
    return small_table(gonio.open("library:sgd/blue-metallic-paint"))


def small_table(material, shape=(30, 20, 24)):
    nodes = gonio.grid_directions(shape)
    return gonio.from_table(material.evaluate(nodes.wi, nodes.wo), nodes.valid, name=material.name)


@pytest.fixture
def goniotool():
    """goniotool(arguments ..): the JSON that it prints."""
    program = os.environ.get("GONIOTOOL", "")
    if not program:
        pytest.skip("GONIOTOOL names no program")

    def run(*arguments):
        return json.loads(subprocess.run([program, "--json", *map(str, arguments)], check=True, capture_output=True).stdout)

    return run
