"""LoopModel: a robot in a run as functions of numbers, native underneath; what a trajectory is integrated with."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.compile.loops.loops import goes_side_by_side, lane_loop, schedule_loop
from tmodes.compile.loops.switches import MOST_SWITCHES
from tmodes.compile.native import Library
from tmodes.equations.loop.closed_loop import ClosedLoop, LeanLoop
from tmodes.equations.loop.layout import StateLayout
from tmodes.equations.loop.outputs import Output, Outputs, Series, output_schedule
from tmodes.equations.loop.plan import LoopPlan
from tmodes.errors import InputError
from tmodes.integrate.method import EULER, EXPLICIT, JACOBIAN
from tmodes.integrate.registry import integrator
from tmodes.model.passes import derivatives, evaluate
from tmodes.simulation.plan import Planned

__all__ = ["Blocks", "LoopModel", "Loops", "loop_numbers", "refuse_switches", "whole"]

Array = NDArray[np.float64]
Blocks = dict[str, Array]


@dataclass(frozen=True)
class Loops:
    """The native time loops of a robot by the name of their method, each compiled when it is first asked for."""

    loop: ClosedLoop

    def __getitem__(self, method: str) -> Any:
        """The function of a method; KeyError for a name that is none."""
        schedule, guarded, more = self.stated(method)
        return schedule_loop(schedule, guarded, method, **more)[method]

    def stated(self, method: str) -> tuple[Any, int, dict[str, int]]:
        """The schedule that a method integrates, how many of its first numbers are watched, and what more it takes."""
        loop, asks, more = self.loop, integrator(method).asks, {}
        count, rate = loop.parts.size, "rate"
        if asks != EXPLICIT:
            more["pairs"] = count
        if asks == JACOBIAN:
            more["columns"] = loop.layout.works.start
        elif asks != EXPLICIT:
            rate = "euler_rate" if asks == EULER else "implicit_rate"
        if asks == EULER and loop.modes:
            more["modes"] = loop.modes
        return getattr(loop, rate), 2 * count, more


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

    @cached_property
    def layout(self) -> StateLayout:
        """Where a state holds what."""
        return self.loop.layout

    @cached_property
    def numbers(self) -> Array:
        """The numbers of the plan's chain, drives, loads and contact, as the compiled code reads them."""
        return self.loop.parts.numbers.vector

    @cached_property
    def loops(self) -> Loops:
        """The native time loop of each method, by its name."""
        return Loops(self.loop)

    def goes_side_by_side(self, method: str) -> bool:
        """Whether runs by a method can go side by side: it has a tableau, and nothing sticks at instants of its own."""
        return goes_side_by_side(method) and not self.loop.modes

    def lane_loop(self, method: str) -> Library:
        """The native loop over robots side by side of a method with a tableau."""
        return lane_loop(self.loop.rate, 2 * len(self.coordinates), method)

    def case_loop(self, method: str) -> Any:
        """The :class:`tmodes.compile.gpu.case_loop.CaseLoop` of a method: over cases, one per thread of a GPU."""
        from tmodes.compile.gpu.case_loop import CaseLoop

        schedule, guarded, more = self.loops.stated(method)
        return CaseLoop(schedule, guarded, method, more)

    def lean_case_loop(self, method: str, shown: tuple[Output, ...], given: int, *, folds: bool) -> Any:
        """The same of an explicit method, where nothing sticks, that writes outputs or reduces them (``folds``)."""
        from tmodes.compile.gpu.case_loop import CaseLoop, CaseSeries

        more = {"motion": True} if goes_side_by_side(method) else {}
        wanted = CaseSeries(self.series(shown, given, after=self.plan.is_sampled).schedule, given, folds)
        return CaseLoop(self.side(shown).rate, 2 * len(self.coordinates), method, more, wanted)

    @cached_property
    def lean(self) -> LeanLoop:
        """The same without works, for runs side by side of which only series are wanted."""
        return LeanLoop(self.plan)

    def side(self, shown: Sequence[Output]) -> ClosedLoop:
        """What integrates runs of which only some outputs are wanted: without works where none is among them."""
        return self.loop if any(one.is_work for one in shown) else self.lean

    @cached_property
    def settles(self) -> LoopModel:
        """The same for states at rest (:attr:`tmodes.equations.loop.plan.LoopPlan.settles`); itself where it is so."""
        return LoopModel(self.plan.settles) if self.loop.modes or self.plan.is_sampled else self

    @cached_property
    def outputs(self) -> Outputs:
        """All that can be asked for by name of an instant."""
        return Outputs(self.loop)

    @cached_property
    def _series(self) -> dict[Any, Series]:
        return {}

    def series(self, shown: tuple[Output, ...], given: int = 0, *, after: bool = False, lean: bool = True) -> Series:
        """The schedule of some outputs, ``series``; see :func:`tmodes.equations.loop.outputs.output_schedule`.

        ``lean``: of states without works where none is among them, see :meth:`side`.
        """
        key = tuple((one.of, one.places) for one in shown), given, after, lean
        if key not in self._series:
            loop = self.side(shown) if lean else self.loop
            self._series[key] = output_schedule(loop, {"series": shown}, given, after=after, often=lean)
        return self._series[key]

    def seen(
        self, shown: Sequence[Output], time: ArrayLike, state: ArrayLike, row: ArrayLike, given: Array | None = None,
        *, after: bool | None = None,
    ) -> Array:  # fmt: skip
        """Outputs at n instants, (n, outputs); ``given`` (n, numbers): what distances are from.

        Controllers are shown after the samples at each time; ``after`` False: the states are after them already.
        """
        blocks, more = self._blocks(time, state, row), np.zeros((0, 0)) if given is None else given
        wanted = self.series(
            tuple(shown), more.shape[1], after=self.plan.is_sampled if after is None else after, lean=False
        )
        if given is not None:
            blocks["state"] = np.hstack([blocks["state"], given])
        numbers, count = np.concatenate([self.numbers, wanted.further]), len(blocks["time"])
        return evaluate(numbers, wanted.schedule, blocks, count)["series"]

    def lean_lane_loop(self, method: str, shown: tuple[Output, ...], given: int, *, folds: bool) -> Library:
        """The native loop over robots side by side that writes some outputs, or reduces them (``folds``)."""
        wanted = self.series(shown, given).schedule
        return lane_loop(self.side(shown).rate, 2 * len(self.coordinates), method, wanted, given=given, folds=folds)

    @property
    def batch_widths(self) -> dict[str, int]:
        """Numbers that compiled code reads of each lane of a batch."""
        parameters, size = self.loop.rate.parameters, self.layout.size
        return {"parameters": parameters, "states": size, "schedules": self.plan.row_size}

    def rate(self, time: ArrayLike, state: ArrayLike, row: ArrayLike, parameters: Array | None = None) -> Array:
        """Derivative of the state by time, (n, size) [the state's units over s]."""
        blocks = self._blocks(time, state, row)
        numbers = self.numbers if parameters is None else parameters
        return evaluate(numbers, self.loop.rate, blocks, len(blocks["time"]))["rate"]

    def settled(self, state: ArrayLike, row: ArrayLike, parameters: Array | None = None) -> Array:
        """States (..., size) after all that sticks, slips or touches has switched as it must at time 0.

        Works begin with nothing: those of impulses at the start are before the run.
        """
        schedule, before = self.loop.switched, np.asarray(state, dtype=float)
        numbers = self.numbers if parameters is None else parameters
        for _ in range(MOST_SWITCHES if schedule else 0):
            blocks = self._blocks(np.zeros(before.size // self.layout.size), before, row)
            after = evaluate(numbers, schedule, blocks, len(blocks["time"]))["state"].reshape(before.shape)
            if np.array_equal(after, before, equal_nan=True):
                break
            before = after
        if schedule:
            before[..., self.layout.works] = 0.0
        return before

    def observe(
        self, time: ArrayLike, state: ArrayLike, row: ArrayLike, parameters: Array | None = None
    ) -> dict[str, Array]:
        """What is shown of n instants.

        ``q``, ``v``, ``a`` (n, nq); ``drives`` (n, drives, 4): effort [N*m], voltage [V], current [A], wanted;
        ``controls`` (n, states) of controllers, after the samples at that time; ``gear``
        (n, drives) [N*m]; ``contact`` (n, 6): force by the point (3), its normal part [N], penetration [m], its rate;
        ``base`` (n, 24); ``powers`` (n, works) [W].
        """
        blocks = self._blocks(time, state, row)
        numbers = self.numbers if parameters is None else parameters
        found = evaluate(numbers, self.loop.observe, blocks, len(blocks["time"]))
        return found | {"drives": found["drives"].reshape(len(found["drives"]), -1, 4)}

    def event_data(self, time: ArrayLike, state: ArrayLike, row: ArrayLike) -> dict[str, Array]:
        """What distinguishes events, of n instants: gates, contact, sliding speed, rates of gears with play."""
        blocks = self._blocks(time, state, row)
        return evaluate(self.numbers, self.loop.event_data, blocks, len(blocks["time"]))

    def jacobian(self, time: float, state: Array, row: Array, parameters: Array | None = None) -> Array:
        """Derivative of the rates by the state (without works), exact, (..., m, m) of states (..., size)."""
        m = self.layout.works.start
        return self.slopes(time, state, row, parameters, np.arange(m))[..., :m, :]

    def slopes(self, time: float, state: Array, row: Array, parameters: Array | None, which: NDArray[np.intp]) -> Array:
        """Derivatives of the rates at an instant by some numbers of the state, exact, (..., size, which)."""
        m, each = len(which), state.size // self.layout.size
        numbers, rows = self.numbers if parameters is None else parameters, row.reshape(-1, self.plan.row_size)
        repeated = np.repeat(state.reshape(each, -1), m, axis=0), np.repeat(rows, m * each // len(rows), axis=0)
        blocks = self._blocks(np.full(each * m, time), *repeated)
        directions = {"state": np.tile(np.eye(self.layout.size)[which], (each, 1))}
        numbers = np.repeat(numbers, m, axis=0) if numbers.ndim > 1 else numbers
        found = derivatives(numbers, self.loop.rate, blocks, directions, each * m)["rate"]
        return found.reshape(*state.shape[:-1], m, -1).swapaxes(-1, -2)

    def _blocks(self, time: ArrayLike, state: ArrayLike, row: ArrayLike) -> dict[str, Array]:
        times = np.asarray(time, dtype=float).reshape(-1, 1)
        count = len(times)
        states = np.asarray(state, dtype=float).reshape(count, self.layout.size)
        rows = np.asarray(row, dtype=float).reshape(count, self.plan.row_size)
        return {"time": times, "state": states, "row": rows, "step": np.zeros((count, 1))}


def refuse_switches(model: LoopModel, asked: str, otherwise: str) -> None:
    """Refuse what switches at instants, where ``asked`` has none; ``otherwise``: what else may be done.

    Raises :class:`tmodes.errors.InputError` for a given motion whose rate jumps, dry friction that sticks, and a
    surface with mass that only pushes.
    """
    plan = model.plan
    if plan.jolts:
        got, expected = "a given motion whose rate jumps", f"given motions without jumps of their rates, for {asked}"
        raise InputError("drives", got, expected, f"smooth the motion, or {otherwise}")
    for axis, _ in model.loop.slipping.values():
        expected = f"dry friction that is a smooth function of the rate, for {asked}"
        hint = f"set `smoothing` of the friction, or {otherwise}"
        raise InputError(f"joints.{axis.axis.joint.name}.friction", "dry friction that sticks", expected, hint)
    if plan.touch and plan.touch.touch.sheet.sticks:
        hint = f"add `friction_velocity: 0.001`, or {otherwise}"
        raise InputError("contact.friction_velocity", "friction that sticks", f"a speed, for {asked}", hint)
    if plan.touch and plan.touch.touch.lands:
        got = f"{plan.touch.touch.sheet.moving_mass:g} kg on a surface that only pushes"
        raise InputError("contact.mass", got, f"none, for {asked}: speeds jump at a touch", otherwise)


def loop_numbers(loop: ClosedLoop, rest: Planned) -> Blocks:
    """``parameters`` of a closed loop; those of its rest (``rest``, ``rest_row``), in which every drive stands."""
    return {
        "parameters": loop.parts.numbers.vector,
        "rest": ClosedLoop(rest.plan).parts.numbers.vector,
        "rest_row": rest.first_row,
    }


def whole(blocks: Blocks) -> tuple[Array, dict[str, Any]]:
    """All blocks in one vector; and where each is: its start and shape."""
    places: dict[str, Any] = {}
    start = 0
    for name, values in blocks.items():
        places[name] = {"start": start, "shape": list(values.shape)}
        start += values.size
    return np.concatenate([np.zeros(0), *(values.ravel() for values in blocks.values())]), places
