"""Whole runs at equal error: the rigid chain that falls, and the closed loop of the 2010 robot."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from functools import cached_property, partial
from typing import Any, ClassVar

import numpy as np
from benchmarks.engines.contender import STEPS, TOLERANCES, Runner, adaptive_methods, needed, now, solved, tolerances_of
from benchmarks.engines.peers import mujoco_model
from benchmarks.engines.rigid import RigidChain
from numpy.typing import NDArray

from tmodes.equations.loop.plan import LoopPlan
from tmodes.integrate.settings import Integration
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.robots.load import load
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.problem import problem_of
from tmodes.simulation.solve import solve

__all__ = ["ChainRun", "Run", "SeedRun"]

Array = NDArray[np.float64]


class Run(ABC):
    """A run that our integrators and SciPy's repeat; each call returns its time [s] and its error [``unit``]."""

    duration: ClassVar[float]
    """Simulated time [s]."""

    samples: ClassVar[Array]
    """Times at which errors are found [s], evenly spaced, the last one at the end."""

    error: ClassVar[float] = 1e-6
    """Largest error that is asked for [``unit``]."""

    unit: ClassVar[str]
    scipy: ClassVar[Sequence[str]]
    """SciPy's methods, called from Python on our rate."""

    given_steps: ClassVar[int] = 0
    """Equal steps of somebody else's simulation, timed whatever their error; 0: none."""

    model: LoopModel
    schedule: SignalPieces
    start: Array

    @cached_property
    @abstractmethod
    def exact(self) -> Array:
        """What errors are measured against."""

    @abstractmethod
    def error_of(self, states: Array) -> float:
        """Largest error [``unit``] of ``states`` (samples, size)."""

    def runners(self) -> Iterator[Runner]:
        """Ours, at equal error and at the given step; SciPy's."""
        for method in adaptive_methods(self.model.loops):
            yield Runner(f"tmodes, {method}", partial(self._adaptive, method), tolerances_of(method), "rtol {:.0e}")
        yield Runner("tmodes, rk4", self._fixed, STEPS, "{:g} steps")
        if self.given_steps:
            yield Runner("tmodes, rk4, the paper's step", self._fixed, (self.given_steps,), "{:g} steps", given=True)
        for method in self.scipy:
            yield Runner(f"SciPy {method} on tmodes' rate", partial(self._scipy, method), TOLERANCES, "rtol {:.0e}")

    def _adaptive(self, method: str, tolerance: float) -> tuple[float, float]:
        return self._judged(*self.ours(method=method, relative_tolerance=tolerance))

    def _fixed(self, steps: float) -> tuple[float, float]:
        return self._judged(*self.ours(method="rk4", step=self.duration / steps))

    def _scipy(self, method: str, tolerance: float) -> tuple[float, float]:
        return self._judged(*self.solved(method, tolerance))

    def _judged(self, seconds: float, states: Array | None) -> tuple[float, float]:
        return seconds, np.inf if states is None else self.error_of(states)

    def ours(self, **chosen: Any) -> tuple[float, Array | None]:
        """Time [s] of a run of ours and its states at the samples; None where it did not finish.

        ``chosen``: settings of :class:`Integration`; the absolute tolerance is a thousandth of the relative one.
        """
        if "relative_tolerance" in chosen:
            chosen["absolute_tolerance"] = chosen["relative_tolerance"] * 1e-3
        settings = Integration(duration=self.duration, output_step=self.duration / len(self.samples), **chosen)
        began = now()
        run = solve(problem_of(self.model, self.model.numbers, self.schedule, self.start, settings))
        seconds = now() - began
        return seconds, run.states[1:] if run.status == "finished" else None

    def solved(self, method: str, tolerance: float) -> tuple[float, Array]:
        """Time [s] of SciPy's run and its states at the samples."""

        def rate(t: float, state: Array, row: Array) -> Any:
            return self.model.rate([t], state, row)[0]

        knots = self.schedule.knots
        rows = list(self.schedule.rows_at(knots[:-1]))
        return solved(rate, self.start, knots.tolist(), rows, method, tolerance, self.samples)


class ChainRun(Run):
    """The chain, stretched and at rest, left to gravity; the exact end is ours at a tolerance of 1e-13."""

    duration, samples, unit, scipy = 0.5, np.array([0.5]), "rad", ("DOP853",)

    def __init__(self, robot: RigidChain) -> None:
        self.robot = robot
        self.model = LoopModel(LoopPlan(robot.chain(), (), signals=0, degree=0))
        self.schedule = SignalPieces(np.array([0.0, self.duration]), np.zeros((1, 0)))
        self.start = np.zeros(self.model.layout.size)

    @cached_property
    def exact(self) -> Array:
        """The coordinates at the end [rad], (joints,)."""
        _, states = self.ours(method="dormand_prince", relative_tolerance=1e-13)
        return np.full(self.robot.joints, np.inf) if states is None else states[-1, : self.robot.joints]

    def error_of(self, states: Array) -> float:
        """Largest error of a coordinate at the end [rad]."""
        return float(np.abs(states[-1, : self.robot.joints] - self.exact).max())

    def peers(self) -> Iterator[Runner]:
        """MuJoCo's RK4; raises :class:`PeerMissing` where it is absent."""
        mujoco_model(self.robot)
        yield Runner("MuJoCo, RK4", self._mujoco, STEPS, "{:g} steps")

    def _mujoco(self, steps: float) -> tuple[float, float]:
        mujoco, made = mujoco_model(self.robot, self.duration / steps)
        data, kind = mujoco.MjData(made), mujoco.mjtState.mjSTATE_FULLPHYSICS
        start = np.zeros((1, mujoco.mj_stateSize(made, kind)))
        rollout = needed("mujoco.rollout", "mujoco").rollout
        began = now()
        states, _ = rollout(made, data, start, nstep=int(steps))
        seconds = now() - began
        return seconds, self.error_of(np.asarray(states)[0, -1:, 1:])


class SeedRun(Run):
    """The 2010 robot with its real characteristics in free space, from rest; ``exact`` is SciPy's DOP853 at 1e-12."""

    duration, samples, unit, scipy = 2.0, np.linspace(0.0, 2.0, 201)[1:], "m", ("RK45", "DOP853")
    given_steps = 37_500

    def __init__(self) -> None:
        robot = load("filipovic2010", {"contact": False, "integration.duration": self.duration}).pair().real
        setup = run_setup(robot)
        self.model, self.mechanics, self.start = setup.model, setup.mechanics, setup.start
        self.schedule = setup.planned.schedule

    @cached_property
    def exact(self) -> Array:
        """The tips [m], (samples, 3)."""
        return self._tips(self.solved("DOP853", 1e-12)[1])

    def error_of(self, states: Array) -> float:
        """Largest distance of the tip from the exact one along the run [m]."""
        return float(np.linalg.norm(self._tips(states) - self.exact, axis=1).max())

    def _tips(self, states: Array) -> Array:
        return self.mechanics.points(states[:, self.model.layout.q]).position[:, 0]
