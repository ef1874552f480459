"""Works of a batch with random numbers, and programs that need more than Python: an assembler, a compiler."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

import tmodes
from simulation.sheets import pendulum, torque
from tmodes.integrate.settings import Integration
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.simulation.case_results import CaseResults
from tmodes.simulation.gpu.run import run_on_gpu
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.problem import Problem, problem_of
from tmodes.simulation.solve import solve

EVERY = "TMODES_EVERY_KERNEL"

NIGHTLY = pytest.mark.skipif(
    not os.environ.get(EVERY), reason=f"the same claim for one more robot, method or GPU: runs with {EVERY}=1"
)


@dataclass(frozen=True)
class Cases:
    """Cases of one structure: what moves them, where they start, and settings of a short run."""

    model: LoopModel
    schedules: tuple[SignalPieces, ...]
    starts: np.ndarray
    settings: Integration
    numbers: np.ndarray

    def by(self, method: str, **settings: Any) -> Cases:
        """The same by another method."""
        chosen = self.settings.model_copy(update={"method": method, **settings})
        return Cases(self.model, self.schedules, self.starts, chosen, self.numbers)

    def work(self) -> Problem:
        """As a work whose states are not filled yet."""
        return problem_of(self.model, self.numbers, self.schedules, self.starts, self.settings)

    def alone(self, case: int) -> Any:
        """A case by the native loop of single runs."""
        schedule = self.schedules[case if len(self.schedules) > 1 else 0]
        start = self.starts[case if len(self.starts) > 1 else 0]
        return solve(problem_of(self.model, self.numbers[case], schedule, start, self.settings))


def on_device(works: list[Problem], *given: Any, **how: Any) -> CaseResults:
    """How the cases of works ended on a device."""
    results = CaseResults.of_all(sum(work.size for work in works))
    run_on_gpu(works, results, *given, **how)
    return results


def varied(setup: Any, settings: Integration, count: int, share: float) -> Cases:
    """Cases whose numbers are off by a share at most, each by its own."""
    numbers = setup.model.numbers
    factors = 1 + share * np.random.default_rng(15).uniform(-1, 1, size=(count, len(numbers)))
    return Cases(setup.model, (setup.planned.schedule,), setup.start[None], settings, numbers * factors)


@pytest.fixture(scope="session")
def published() -> Cases:
    """The paper's robot over 5 ms, 100 times."""
    return published_cases()


def published_cases() -> Cases:
    """The same, for programs that tests start."""
    robot = tmodes.load("filipovic2010")
    settings = robot.integration.model_copy(update={"duration": 0.005, "output_step": 2.5e-4, "step": 2e-5})
    return varied(run_setup(robot), settings, 100, 0.02)


@pytest.fixture(scope="session")
def swinging() -> Cases:
    """An elastic pendulum over 0.3 s, 100 times; samples lie between the steps."""
    settings = {"duration": 0.3, "output_step": 0.013, "relative_tolerance": 1e-9, "absolute_tolerance": 1e-11}
    robot = pendulum({"inertia": 0.3}, {"stiffness": 100.0}, torque(2.0), integration=settings)
    return varied(run_setup(robot), robot.integration.model_copy(update={"step": 1e-3}), 100, 0.05)
