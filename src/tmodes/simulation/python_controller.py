"""Runs with a Python function as controller, integrated in Python: about a thousand times slower than native loops.

Its efforts replace those of all drives that do not follow their signals exactly. It is asked at every stage of every
step, so it must answer the same to the same question; steps end on every sample and on every jump of a signal.
"""

from __future__ import annotations

import time as clock
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.equations.loop.control_kernels import WINDING, Servo
from tmodes.errors import SimulationError, error_words
from tmodes.integrate.settings import Integration
from tmodes.simulation.balance import begun, frozen
from tmodes.simulation.initial_state import RunSetup
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.native_run import BOUND
from tmodes.simulation.parts import Trajectory, completed, sample_times, used_up
from tmodes.simulation.stops import STOPPED, Instants, SetIn, Stops

__all__ = [
    "Controller",
    "Guarded",
    "controller_error",
    "controller_name",
    "driven_by",
    "fixed_steps",
    "run_with_controller",
]

Array = NDArray[np.float64]


Controller = Callable[[float, Array, Array], ArrayLike]
"""(time [s], q (nq,), v (nq,)) -> effort (m,) [N*m, N] of each drive that follows no signal, in their order."""


@dataclass
class Guarded:
    """Validates the return values and exceptions of a Python controller, and reports them with name and time."""

    controller: Controller
    joints: tuple[str, ...]
    size: int

    def __call__(self, time: float, q: Array, v: Array) -> Array:
        """The efforts (m,); raises :class:`tmodes.errors.SimulationError` for an answer that is none."""
        q, v = q.copy(), v.copy()
        q.flags.writeable = v.flags.writeable = False
        try:
            effort = np.asarray(self.controller(time, q, v), dtype=float)
        except Exception as error:
            raise controller_error(self.controller, time, error_words(error), "an answer") from error
        wanted = f"an array of shape ({len(self.joints)},), the efforts of {', '.join(self.joints)}"
        if effort.shape != (len(self.joints),):
            raise controller_error(self.controller, time, f"an array of shape {effort.shape}", wanted)
        if not np.isfinite(effort).all():
            bad = int(np.flatnonzero(~np.isfinite(effort))[0])
            raise controller_error(
                self.controller, time, f"{effort[bad]} for joint {self.joints[bad]}", "finite numbers"
            )
        return effort


def controller_name(controller: object) -> str:
    """What a controller is called."""
    return getattr(controller, "__qualname__", type(controller).__qualname__)


def controller_error(controller: object, time: float, got: str, expected: str) -> SimulationError:
    """The error of an answer that is none, with name and time [s]."""
    name = controller_name(controller)
    return SimulationError(
        f"controller {name} at t = {time:.6g} s must return {expected}, got {got}; correct the function"
    )


def driven_by(setup: RunSetup, *, volts: bool = False) -> RunSetup:
    """The setup with the efforts of its servos taken from the rows; ``volts``: commands, voltages where they are."""
    plan = setup.planned.plan
    drives = tuple(
        replace(
            drive,
            servo=Servo(None, driven=volts and drive.servo.driven, winding=drive.winding),
            numbers=drive.numbers[:WINDING],
            noise=-1,
            clock=-1,
        )
        if drive.servo
        else drive
        for drive in plan.drives
    )
    own = replace(plan, drives=drives)
    model = LoopModel(own)
    start = np.zeros(model.layout.size)
    start[: 2 * len(model.coordinates)] = setup.held[: 2 * len(model.coordinates)]
    start[model.layout.controls] = own.controls
    start = begun(model, start[None], frozen(model, setup.first_row[None]), model.numbers)[0]
    start = model.settled(start, setup.first_row)
    return replace(setup, planned=replace(setup.planned, plan=own), model=model, start=start, callback=True)


_STEPS = 0.1
"""Fixed step times the fastest eigenvalue."""

_MOST_SHORT, _SHORT_STEPS = 1e8, 200
"""Steps that would take a whole run, and how many of that length in a row are too many."""


def fixed_steps(setup: RunSetup, highest: float) -> tuple[RunSetup, str]:
    """The setup at fixed steps that resolve its fastest eigenvalue [1/s], and why in words.

    Noise in a controller's answers makes the steps of an adaptive method collapse; these it only passes through.
    """
    settings = setup.robot.integration
    step = min(settings.output_step, _STEPS / highest if highest else np.inf)
    robot = setup.robot.model_copy(update={"integration": settings.model_copy(update={"step": step})})
    why = f"rk4 chosen: a Python function controls; fixed steps of {step:.2g} s"
    return replace(setup, robot=robot).by("rk4", None), why


@dataclass
class _Run:
    """A run in Python: what is done so far."""

    setup: RunSetup
    guarded: Guarded
    settings: Integration
    places: list[int]
    stops: Stops = field(default_factory=Stops)
    rows: list[Array] = field(default_factory=list)
    states: list[Array] = field(default_factory=list)
    evaluations: int = 0
    steps: int = 0
    short: int = 0
    kept: float = 0.0
    began: float = field(default_factory=clock.monotonic)

    def row(self, time: float, state: Array, piece: float) -> Array:
        """The row of the signals at a time, of the piece that starts at ``piece``, with the controller's efforts."""
        row = self.setup.planned.schedule.rows_at(np.array([piece]))[0]
        n = len(self.setup.model.coordinates)
        effort = self.guarded(time, state[:n], state[n : 2 * n])
        for place, value in zip(self.places, effort, strict=True):
            row[place], row[place + 1 : place + self.setup.planned.plan.degree + 1] = value, 0.0
        return row

    def rate(self, time: float, state: Array, piece: float) -> Array:
        """Right-hand side."""
        self.evaluations += 1
        return self.setup.model.rate([time], state, self.row(time, state, piece))[0]

    def keep(self, time: float, state: Array) -> None:
        """A sample."""
        self.kept = time
        self.rows.append(self.row(time, state, time))
        self.states.append(state)

    def end_at(self, time: float, state: Array) -> None:
        """The last sample is at a time [s], in place of one that is there already."""
        if self.kept == time:
            del self.states[-1], self.rows[-1]
        self.keep(time, state)

    def refuse_collapse(self, time: float, length: float) -> None:
        """Raises where steps have long been so short [s] that the end is out of reach: the answers are not smooth."""
        self.short = self.short + 1 if length * _MOST_SHORT < self.settings.duration else 0
        if self.short > _SHORT_STEPS:
            name = controller_name(self.guarded.controller)
            raise SimulationError(
                f"stopped at t = {time:.6g} s, at steps of {length:.2g} s: what the controller {name} answers is not "
                "smooth (noise, a switch); take fixed steps, --integrator rk4, or method auto"
            )

    def count_step(self, time: float) -> None:
        """Count a step that begins at ``time`` [s]; raises where no steps or seconds of computing are left for it."""
        s = self.settings
        spent = {"max_steps": self.steps, "max_wall_time": clock.monotonic() - self.began}
        for name, value in spent.items():
            if value >= getattr(s, name):
                raise SimulationError(used_up(time, s.duration, name, f"{getattr(s, name):g}"))
        self.steps += 1


def run_with_controller(
    setup: RunSetup,
    controller: Controller,
    progress: Callable[[float], None] = lambda share: None,
    stops: Stops | None = None,
) -> tuple[Trajectory, Array]:
    """Integrate with a Python controller; the trajectory, and the rows (n, row) with the efforts at its samples.

    ``setup`` is one of :func:`driven_by`. Raises :class:`tmodes.errors.SimulationError` for a controller that raises,
    or whose answer is of the wrong shape or not finite, at its first call; later the run stops and keeps what it has.
    """
    plan, settings = setup.planned.plan, setup.robot.integration
    places = [1 + drive.signal * (plan.degree + 1) for drive in plan.drives if drive.servo]
    names = tuple(drive.joint for drive in plan.drives if drive.servo)
    guarded = Guarded(controller, names, len(setup.model.coordinates))
    run = _Run(setup, guarded, settings, places, stops or Stops())
    times = sample_times(settings)
    run.keep(0.0, setup.start)
    run.stops.refuse_at_start(Instants(times[:1], np.array(run.states), np.array(run.rows)))
    status, message = _advance(run, times, progress)
    done = len(run.states)
    times[done - 1] = run.kept
    method = settings.method if settings.method in ("rk4", "dop853") else "dormand_prince"
    counts = {"steps": run.steps, "evaluations": run.evaluations, "rejected": 0, "method": method}
    return Trajectory(times[:done], np.array(run.states), status, message, counts), np.array(run.rows)


def _advance(run: _Run, times: Array, progress: Callable[[float], None]) -> tuple[str, str]:
    state, length, end = run.states[0], 0.0, float(times[-1])
    try:
        for before, after, is_sample in _intervals(run.setup.planned.schedule.knots, times):
            begun = state, length
            state, length = _across(run, before, after, *begun)
            lost = _lost(run, after, state)
            if lost:
                return "diverged", lost
            if run.stops and (found := _set_in(run, (before, after), begun, state)):
                run.end_at(*found[:2])
                return STOPPED, found[2]
            if is_sample:
                run.keep(after, state)
                progress(after / end)
    except KeyboardInterrupt:
        return "interrupted", f"interrupted after t = {times[len(run.states) - 1]:.6g} s; what was done is kept"
    except SimulationError as error:
        return "stopped", str(error)
    return "finished", completed(end)


def _intervals(knots: Array, times: Array) -> Iterator[tuple[float, float, bool]]:
    """Start and end of each interval between samples and knots, and whether its end is a sample."""
    stops = np.union1d(times, knots[(knots > 0) & (knots < times[-1])])
    samples = set(times.tolist())
    for before, after in zip(stops[:-1].tolist(), stops[1:].tolist(), strict=True):
        yield before, after, after in samples


def _across(run: _Run, before: float, after: float, state: Array, length: float) -> tuple[Array, float]:
    """The state at the end of an interval without jumps, and the length of step to begin the next with."""
    if run.settings.method == "rk4":
        return _rk4(run, before, after, state), length
    from scipy.integrate import DOP853, RK45

    s = run.settings
    first, wish = min(length, after - before) if length > 0 else None, length
    with np.errstate(over="ignore", invalid="ignore"):  # where a trial step leaves the numbers, a shorter one is taken
        solver = (DOP853 if s.method == "dop853" else RK45)(
            lambda t, y: run.rate(t, y, before), before, state, after,
            rtol=max(s.relative_tolerance, 3e-14), atol=s.absolute_tolerance, first_step=first,
        )  # fmt: skip
        while solver.status == "running":
            run.count_step(solver.t)
            # From a length that is no number, SciPy would look for a shorter one for ever.
            if not np.isfinite(solver.h_abs) or solver.step():
                raise SimulationError(f"stopped at t = {solver.t:.6g} s: no step is small enough")
            run.refuse_collapse(solver.t, solver.h_abs)
            wish = max(wish if solver.status != "running" else 0.0, solver.h_abs)
            if _lost(run, solver.t, solver.y):
                break
    return solver.y, wish


def _set_in(run: _Run, ends: tuple[float, float], begun: tuple[Array, float], state: Array) -> tuple[Any, ...] | None:
    """Time and state where a condition triggers within an interval, and the words; what is tried is not counted."""
    counts = run.steps, run.evaluations
    find = SetIn(run.stops, lambda time, at: run.row(time, at, ends[0]), run.settings.duration)
    found = find.within(ends, (begun[0], state), lambda time: _across(run, ends[0], time, *begun)[0])
    run.steps, run.evaluations = counts
    return found


def _rk4(run: _Run, before: float, after: float, state: Array) -> Array:
    count = max(1, int(np.ceil((after - before) / run.settings.step * (1 - 1e-12))))
    h = (after - before) / count
    for k in range(count):
        t = before + k * h
        run.count_step(t)
        k1 = run.rate(t, state, before)
        k2 = run.rate(t + h / 2, state + h / 2 * k1, before)
        k3 = run.rate(t + h / 2, state + h / 2 * k2, before)
        k4 = run.rate(t + h, state + h * k3, before)
        state = state + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        if _lost(run, t, state):
            break
    return state


def _lost(run: _Run, time: float, state: Array) -> str:
    """Where the motion was lost; empty while it is one."""
    names = run.setup.model.coordinates
    bad = np.flatnonzero(~(np.abs(state[: 2 * len(names)]) < BOUND))
    if not len(bad):
        return ""
    return f"diverged before t = {time:.6g} s in coordinate {names[bad[0] % len(names)]}, which leaves {BOUND:g}"
