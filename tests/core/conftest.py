"""The shipped robot, and a run of it without the rest of a result."""

from __future__ import annotations

import pytest
from tmodes.paper.sheet import PaperRobot

from tmodes.robots import load_robot


@pytest.fixture(scope="session")
def robot() -> PaperRobot:
    """The paper's robot as shipped."""
    return load_robot("filipovic2010")
