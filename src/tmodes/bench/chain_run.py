"""The rigid chain falls from rest: time per simulated second at equal error of its coordinates, engine by engine."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.bench import peer_mujoco
from tmodes.bench.contender import needed, now
from tmodes.bench.equal_error import STEPS, TOLERANCES, Runner, adaptive_methods, solved, tolerances_of
from tmodes.bench.rigid import RigidChain
from tmodes.equations.loop.plan import LoopPlan
from tmodes.integrate.settings import Integration
from tmodes.kinds.signals.schedule import Schedule
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.trajectory import integrate

__all__ = ["DURATION", "ERROR", "ChainRun"]

DURATION = 0.5
"""Simulated time [s]."""

ERROR = 1e-6
"""Largest error of a coordinate at the end [rad]."""

_NO_SIGNAL = Schedule(np.array([0.0, DURATION]), np.zeros((1, 0)))


class ChainRun:
    """The chain, stretched and at rest, left to gravity; the exact end is ours at a tolerance of 1e-13."""

    def __init__(self, robot: RigidChain) -> None:
        self.robot = robot
        self.model = LoopModel(LoopPlan(robot.chain(), (), signals=0, degree=0))
        self.start = np.zeros(self.model.layout.size)
        self.exact = self._run(self._adaptive(1e-13))[1]

    def runners(self) -> Iterator[Runner]:
        """Ours, and SciPy on our accelerations."""
        for method in adaptive_methods(self.model.loops):
            run = self._judged(partial(self._adaptive, method=method))
            yield Runner(f"tmodes, {method}", run, tolerances_of(method), "rtol {:.0e}")
        yield Runner("tmodes, rk4", self._judged(self._fixed), STEPS, "{:g} steps")
        yield Runner("SciPy DOP853 on tmodes' rate", self._scipy, TOLERANCES, "rtol {:.0e}")

    def peers(self) -> Iterator[Runner]:
        """MuJoCo's RK4; raises :class:`PeerMissing` where it is absent."""
        peer_mujoco.model(self.robot)
        yield Runner("MuJoCo, RK4", self._mujoco, STEPS, "{:g} steps")

    def _judged(self, settings: Any) -> Any:
        def run(setting: float) -> tuple[float, float]:
            seconds, state = self._run(settings(setting))
            return seconds, self._error(state)

        return run

    def _error(self, q: NDArray[np.float64]) -> float:
        return float(np.abs(q[: self.robot.joints] - self.exact[: self.robot.joints]).max())

    def _adaptive(self, tolerance: float, method: str = "dormand_prince") -> Integration:
        return Integration(
            method=method, duration=DURATION, output_step=DURATION,
            relative_tolerance=tolerance, absolute_tolerance=tolerance * 1e-3,
        )  # fmt: skip

    def _fixed(self, steps: float) -> Integration:
        return Integration(method="rk4", duration=DURATION, output_step=DURATION, step=DURATION / steps)

    def _run(self, settings: Integration) -> tuple[float, NDArray[np.float64]]:
        began = now()
        run = integrate(self.model, self.model.numbers, _NO_SIGNAL, self.start, settings)
        seconds = now() - began
        return seconds, run.states[-1] if run.status == "finished" else np.full_like(self.start, np.inf)

    def _scipy(self, tolerance: float) -> tuple[float, float]:
        def rate(t: float, state: NDArray[np.float64], row: NDArray[np.float64]) -> Any:
            return self.model.rate([t], state, row)[0]

        seconds, state = solved(
            rate, self.start, [0.0, DURATION], [np.zeros(1)], "DOP853", tolerance, np.array([DURATION])
        )
        return seconds, self._error(state[-1])

    def _mujoco(self, steps: float) -> tuple[float, float]:
        mujoco, made = peer_mujoco.model(self.robot, DURATION / steps)
        data, kind = mujoco.MjData(made), mujoco.mjtState.mjSTATE_FULLPHYSICS
        start = np.zeros((1, mujoco.mj_stateSize(made, kind)))
        rollout = needed("mujoco.rollout", "mujoco").rollout
        began = now()
        states, _ = rollout(made, data, start, nstep=int(steps))
        seconds = now() - began
        return seconds, self._error(np.asarray(states)[0, -1, 1:])
