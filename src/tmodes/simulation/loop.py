"""LoopModel: an arm in a run as functions of numbers, native underneath; what a trajectory is integrated with."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.compile.lanes import lane_kernels
from tmodes.compile.loops import loops
from tmodes.equations.loop.closed_loop import ClosedLoop
from tmodes.equations.loop.plan import LoopPlan, StateLayout
from tmodes.integrate.method import EULER, IMPLICIT, JACOBIAN
from tmodes.integrate.registry import integrator
from tmodes.integrate.settings import Integration
from tmodes.model.evaluator import derivatives, evaluate
from tmodes.simulation.batch.result import BatchRun
from tmodes.simulation.batch.simulate import How, Schedules, simulate_lanes

__all__ = ["LoopModel", "LoopNumbers", "Loops"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class LoopNumbers:
    """All numbers of an arm and of what moves it, as the compiled code reads them."""

    vector: Array


@dataclass(frozen=True)
class Loops:
    """The native time loops of an arm by the name of their method, each kind compiled when it is first asked for."""

    loop: ClosedLoop

    def __getitem__(self, method: str) -> Any:
        """The function of a method; KeyError for a name that is none."""
        count, loop = self.loop.parts.size, self.loop
        asks = integrator(method).asks
        if asks in (IMPLICIT, EULER):
            rate = loop.euler_rate if asks == EULER else loop.implicit_rate
            return loops.implicit_loops("arm implicit loops", rate, 2 * count, count)[method]
        if asks == JACOBIAN:
            columns = loop.layout.works.start
            return loops.rosenbrock_loop("arm rosenbrock", loop.rate, 2 * count, count, columns)[method]
        return loops.schedule_loops("arm loops", loop.rate, guarded=2 * count)[method]


@dataclass(frozen=True, eq=False)
class LoopModel:
    """The native code of one plan's structure.

    Arrays are of n instants: time (n,) [s], state (n, size), row (n, row).
    """

    plan: LoopPlan

    @cached_property
    def loop(self) -> ClosedLoop:
        """The schedules."""
        return ClosedLoop(self.plan)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the coordinates."""
        return tuple(self.loop.parts.names)

    @property
    def layout(self) -> StateLayout:
        """Where a state holds what."""
        return self.loop.layout

    @cached_property
    def numbers(self) -> LoopNumbers:
        """The numbers of the plan's chain, drives, loads and contact."""
        return LoopNumbers(self.loop.parts.numbers.vector)

    @cached_property
    def loops(self) -> Any:
        """The native time loop of each method, by its name."""
        return Loops(self.loop)

    @cached_property
    def lane_loops(self) -> Any:
        """The native loop over arms side by side of each explicit method."""
        return lane_kernels.schedule_lane_loops("arm lane loops", self.loop.rate, guarded=2 * len(self.coordinates))

    @property
    def batch_widths(self) -> dict[str, int]:
        """Numbers that compiled code reads of each lane of a batch."""
        parameters, size = self.loop.rate.parameters, self.layout.size
        return {"parameters": parameters, "states": size, "schedules": self.plan.row_size}

    def simulate_batch(
        self, parameters: ArrayLike, schedules: Schedules, states: ArrayLike, settings: Integration, **how: Unpack[How]
    ) -> BatchRun:
        """Many robots of this structure at once, as :func:`tmodes.simulation.batch.simulate.simulate_lanes` reports."""
        return simulate_lanes(self, parameters, schedules, states, settings, **how)

    def rate(self, time: ArrayLike, state: ArrayLike, row: ArrayLike, parameters: LoopNumbers | None = None) -> Array:
        """Derivative of the state by time, (n, size) [the state's units over s]."""
        blocks = self._blocks(time, state, row)
        return evaluate((parameters or self.numbers).vector, self.loop.rate, blocks, len(blocks["time"]))["rate"]

    def observe(self, time: ArrayLike, state: ArrayLike, row: ArrayLike) -> dict[str, Array]:
        """What is shown of n instants.

        ``q``, ``v``, ``a`` (n, nq); ``drives`` (n, drives, 4): effort [N*m], voltage [V], current [A], wanted;
        ``controls`` (n, states) of controllers, after the samples at that time; ``gear``
        (n, drives) [N*m]; ``contact`` (n, 6): force by the point (3), its normal part [N], penetration [m], its rate;
        ``base`` (n, 24); ``powers`` (n, works) [W].
        """
        blocks = self._blocks(time, state, row)
        found = evaluate(self.numbers.vector, self.loop.observe, blocks, len(blocks["time"]))
        return found | {"drives": found["drives"].reshape(len(found["drives"]), -1, 4)}

    def jacobian(self, time: float, state: Array, row: Array) -> Array:
        """Derivative of the rates by the state (without works) at one instant, exact, (m, m)."""
        m = self.layout.works.start
        blocks = self._blocks(np.full(m, time), np.tile(state, (m, 1)), np.tile(row, (m, 1)))
        directions = {"state": np.eye(m, self.layout.size)}
        return derivatives(self.numbers.vector, self.loop.rate, blocks, directions, m)["rate"][:, :m].T

    def _blocks(self, time: ArrayLike, state: ArrayLike, row: ArrayLike) -> dict[str, Array]:
        times = np.asarray(time, dtype=float).reshape(-1, 1)
        count = len(times)
        states = np.asarray(state, dtype=float).reshape(count, self.layout.size)
        rows = np.asarray(row, dtype=float).reshape(count, self.plan.row_size)
        return {"time": times, "state": states, "row": rows, "step": np.zeros((count, 1))}
