"""The closed loop of the 2010 robot over two seconds: our integrators, and SciPy's on the rate called from Python."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.bench.contender import now
from tmodes.bench.equal_error import STEPS, TOLERANCES, Runner, adaptive_methods, solved, tolerances_of
from tmodes.integrate.settings import Integration
from tmodes.robots.load import load
from tmodes.simulation.start import run_setup
from tmodes.simulation.trajectory import integrate

__all__ = ["DURATION", "ERROR", "PAPER_STEPS", "SeedRun"]

DURATION = 2.0
"""Simulated time [s]."""

ERROR = 1e-6
"""Largest distance of the tip from the exact one along the run [m]."""

SAMPLES = np.linspace(0.0, DURATION, 201)[1:]
"""Times at which tips are compared [s]."""

PAPER_STEPS = 37_500
"""Equal steps of the paper's own simulation."""


class SeedRun:
    """The robot with its real characteristics in free space, from rest; ``exact`` is SciPy's DOP853 at 1e-12."""

    def __init__(self) -> None:
        robot = load("filipovic2010", {"contact": False, "integration.duration": DURATION}).pair().real
        setup = run_setup(robot)
        self.model, self.mechanics, self.start = setup.model, setup.mechanics, setup.start
        self.schedule = setup.planned.schedule

    @cached_property
    def exact(self) -> NDArray[np.float64]:
        """The tips [m], (samples, 3)."""
        return self._tips(self._solved("DOP853", 1e-12)[1])

    def runners(self) -> Iterator[Runner]:
        """Ours, at equal error and at the paper's step; SciPy's."""
        for method in adaptive_methods(self.model.loops):
            yield Runner(f"tmodes, {method}", partial(self._adaptive, method), tolerances_of(method), "rtol {:.0e}")
        yield Runner("tmodes, rk4", lambda steps: self._ours(self._fixed(steps)), STEPS, "{:g} steps")
        yield Runner(
            "tmodes, rk4, the paper's step", lambda steps: self._ours(self._fixed(steps)), (PAPER_STEPS,),
            "{:g} steps", given=True,
        )  # fmt: skip
        for method in ("RK45", "DOP853"):
            yield Runner(f"SciPy {method} on tmodes' rate", self._scipy(method), TOLERANCES, "rtol {:.0e}")

    def _adaptive(self, method: str, tolerance: float) -> tuple[float, float]:
        return self._ours(_settings(method=method, relative_tolerance=tolerance, absolute_tolerance=tolerance * 1e-3))

    def _fixed(self, steps: float) -> Integration:
        return _settings(method="rk4", step=DURATION / steps)

    def _ours(self, settings: Integration) -> tuple[float, float]:
        began = now()
        run = integrate(self.model, self.model.numbers, self.schedule, self.start, settings)
        seconds = now() - began
        return seconds, self._error(run.states[1:]) if run.status == "finished" else np.inf

    def _scipy(self, method: str) -> Any:
        def run(tolerance: float) -> tuple[float, float]:
            seconds, states = self._solved(method, tolerance)
            return seconds, self._error(states)

        return run

    def _solved(self, method: str, tolerance: float) -> tuple[float, NDArray[np.float64]]:
        def rate(t: float, state: NDArray[np.float64], row: NDArray[np.float64]) -> Any:
            return self.model.rate([t], state, row)[0]

        knots, rows = self.schedule.knots, list(self.schedule.rows_at(self.schedule.knots[:-1]))
        return solved(rate, self.start, knots.tolist(), rows, method, tolerance, SAMPLES)

    def _tips(self, states: NDArray[np.float64]) -> NDArray[np.float64]:
        return self.mechanics.points(states[:, self.model.layout.q]).position[:, 0]

    def _error(self, states: NDArray[np.float64]) -> float:
        return float(np.linalg.norm(self._tips(states) - self.exact, axis=1).max())


def _settings(**chosen: Any) -> Integration:
    return Integration(duration=DURATION, output_step=DURATION / len(SAMPLES), **chosen)
