# SPDX-License-Identifier: MIT
"""What the tests of the Python package share."""

import pathlib

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SAMPLES = ROOT / "examples" / "data"


@pytest.fixture
def samples():
    return SAMPLES


@pytest.fixture
def root():
    return ROOT


@pytest.fixture
def cube():
    """The corners of a cube with sides of 2."""
    return np.array([[x, y, z] for x in (0, 2) for y in (0, 2) for z in (0, 2)], dtype=float)


@pytest.fixture
def cloud():
    return np.random.default_rng(7).random((200, 3))


@pytest.fixture
def plane():
    return np.random.default_rng(8).random((150, 2))
