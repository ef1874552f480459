"""The shipped robot as numbers: its model, what moves it, its start, and settings of a short run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

import tmodes
from tmodes.integrate.settings import Integration
from tmodes.kinds.signals.schedule import Schedule
from tmodes.sheet import Robot
from tmodes.simulation.batch.simulate import simulate_lanes
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.start import run_setup

VARIED = (
    "payload.mass",
    "gear.stiffness",
    "motor.resistance",
    "link.modes.1.bending_stiffness",
    "controller.position_gain",
)


@dataclass
class Seed:
    """A robot, and nine of its kind with numbers a little off."""

    robot: Robot
    model: LoopModel
    schedule: Schedule
    start: np.ndarray
    settings: Integration
    many: np.ndarray

    def run(self, lanes: Any = slice(None), **how: Any) -> Any:
        """A batch of some of the nine."""
        return simulate_lanes(self.model, self.many[lanes], self.schedule, self.start, self.settings, **how)

    def place(self, name: str) -> np.ndarray:
        """Where the numbers stand that follow from one of the sheet."""
        factors = [run_setup(self.robot.with_({"real": {name: factor}}).pair().real).model for factor in (1.0, 1.1)]
        one, other = (model.numbers for model in factors)
        return np.flatnonzero(one != other)


@pytest.fixture(scope="session")
def seed() -> Seed:
    """The paper's robot over its first 20 ms."""
    robot = tmodes.load("filipovic2010")
    setup, rng = run_setup(robot), np.random.default_rng(1)
    settings = robot.integration.model_copy(update={"duration": 0.02, "output_step": 5e-4})
    factors = 1 + 0.05 * rng.normal(size=(9, len(VARIED)))
    robots = [robot.with_({"real": dict(zip(VARIED, row.tolist(), strict=True))}).pair().real for row in factors]
    many = np.array([run_setup(one).model.numbers for one in robots])
    return Seed(robot, setup.model, setup.planned.schedule, setup.start, settings, many)
