"""The shipped robot as numbers: its model, what moves it, its start, and settings of a short run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from tmodes.paper.mechanism import Drive, Parameters
from tmodes.paper.model import PaperModel

from tmodes.integrate.settings import Integration
from tmodes.kinds.signals.schedule import Schedule
from tmodes.robots import load_robot


@dataclass
class Seed:
    """A robot, and nine of its kind with numbers a little off."""

    model: PaperModel
    parameters: Parameters
    schedule: Schedule
    start: np.ndarray
    settings: Integration
    many: np.ndarray

    def run(self, lanes: Any = slice(None), **how: Any) -> Any:
        """A batch of some of the nine."""
        return self.model.simulate_batch(self.many[lanes], self.schedule, self.start, self.settings, **how)

    def place(self, name: str) -> int:
        """Where a number stands."""
        return self.parameters.names.index(name)


@pytest.fixture(scope="session")
def seed() -> Seed:
    """The paper's robot over its first 20 ms."""
    robot = load_robot("filipovic2010")
    mechanism, parameters = robot.split(Drive.CONTROLLED)
    model = PaperModel(mechanism)
    settings = robot.integration.model_copy(update={"duration": 0.02, "output_step": 5e-4})
    many = parameters.vector * (1 + 0.05 * np.random.default_rng(1).normal(size=(9, len(parameters))))
    start = model.rest(robot.reference.start, parameters)
    return Seed(model, parameters, robot.reference.schedule(), start, settings, many)
