"""Robots as numbers: their model, what moves them, their start, and settings of a short run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

import tmodes
from lane_runs import simulate_lanes
from simulation.sheets import pendulum, torque
from tmodes.integrate.settings import Integration
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.loop import LoopModel

VARIED = (
    "payload.mass",
    "gear.stiffness",
    "motor.resistance",
    "link.modes.1.bending_stiffness",
    "controller.position_gain",
)


@dataclass
class Lot:
    """A robot, and nine of its kind with numbers a little off."""

    robot: Robot
    model: LoopModel
    schedule: SignalPieces
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
def lot(request: pytest.FixtureRequest) -> Lot:
    """The paper's robot over its first 20 ms, or by ``indirect`` parametrisation an elastic pendulum."""
    return {"filipovic2010": _published, "pendulum": _pendulum}[getattr(request, "param", "filipovic2010")]()


def _published() -> Lot:
    robot = tmodes.load("filipovic2010")
    setup, rng = run_setup(robot), np.random.default_rng(1)
    settings = robot.integration.model_copy(update={"duration": 0.02, "output_step": 5e-4})
    factors = 1 + 0.05 * rng.normal(size=(9, len(VARIED)))
    robots = [robot.with_({"real": dict(zip(VARIED, row.tolist(), strict=True))}).pair().real for row in factors]
    many = np.array([run_setup(one).model.numbers for one in robots])
    return Lot(robot, setup.model, setup.planned.schedule, setup.start, settings, many)


def _pendulum() -> Lot:
    settings = {"duration": 0.3, "output_step": 0.013, "relative_tolerance": 1e-9, "absolute_tolerance": 1e-11}
    robot = pendulum({"inertia": 0.3}, {"stiffness": 100.0}, torque(2.0), integration=settings)
    setup = run_setup(robot)
    vector = setup.model.numbers
    many = vector * (1 + 0.05 * np.random.default_rng(3).uniform(-1, 1, size=(9, len(vector))))
    chosen = robot.integration.model_copy(update={"method": "dormand_prince"})
    return Lot(robot, setup.model, setup.planned.schedule, setup.start, chosen, many)
