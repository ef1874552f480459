"""The shipped robot."""

from __future__ import annotations

import pytest

import tmodes
from tmodes.sheet import Robot


@pytest.fixture(scope="session")
def robot() -> Robot:
    """The paper's robot as shipped."""
    return tmodes.load("filipovic2010")
