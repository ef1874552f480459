"""The paper's robot."""

from __future__ import annotations

import pytest

import tmodes
from lagrange.robot2010 import symbols
from tmodes.sheet.robot import Robot


@pytest.fixture(scope="session")
def robot() -> Robot:
    """The paper's robot as shipped."""
    return tmodes.load("filipovic2010")


@pytest.fixture(scope="session")
def numbers(robot: Robot) -> dict[str, float]:
    """Its numbers as known, by the paper's symbols."""
    return symbols(robot)
