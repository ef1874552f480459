"""A run with all its steps: where each starts, how long it is, and which samples lie in it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.loops.time_loop import Status
from tmodes.compile.replay.record_loop import Steps, record_steps
from tmodes.compile.replay.tables import SamplePlaces, replay_methods, table_of
from tmodes.errors import InputError, SimulationError
from tmodes.integrate.registry import integrator
from tmodes.integrate.settings import Integration, refuse_stops
from tmodes.simulation.native_run import NativeRun
from tmodes.simulation.problem import Problem

__all__ = ["MOST_BYTES", "Recording", "record"]

Array = NDArray[np.float64]
Counts = NDArray[np.int64]

MOST_BYTES = 200_000_000
"""Memory for the states of all steps; where they are more, some are kept and those between computed again."""

_AT_ONCE = 20_000
"""Steps that are recorded in one call."""


@dataclass(frozen=True, eq=False)
class Recording:
    """Steps of a run: ``t`` and ``h`` (steps,) [s], ``segments`` (steps,), state at the start of every ``every``-th.

    ``times`` (n,) and ``samples`` (n, size): what the run gave; ``first_sample`` (steps + 1): which of them lie in a
    step, the start aside; ``weights`` (n, stages) of its stages in each; ``used``: how many stages, or rows, it needs;
    ``contact_changes``: how often a contact started or ended.
    """

    method: str
    t: Array
    h: Array
    segments: Counts
    every: int
    kept: Array
    rows: Array
    times: Array
    samples: Array
    first_sample: Counts
    weights: Array
    used: Counts
    contact_changes: int


def record(problem: Problem, most_bytes: float = MOST_BYTES) -> Recording:
    """Run the case of a problem, and keep the steps.

    Raises :class:`tmodes.errors.InputError` for a method whose steps are no tableau and for no memory, and
    :class:`tmodes.errors.SimulationError` for a run that does not reach its end.
    """
    settings = problem.settings
    refuse_stops(settings, "a run is differentiated")
    if not most_bytes > 0:
        raise InputError("most_bytes", f"{most_bytes!r}", "a number above 0 [bytes]", f"the usual is {MOST_BYTES}")
    method = settings.method
    if method not in replay_methods():
        names = " or ".join(", ".join(replay_methods()).rsplit(", ", 1))
        raise InputError("integration.method", method, names, "name one of them: its steps can be differentiated")
    run = NativeRun(problem, alone=False)
    steps, every = _steps(run, settings, most_bytes)
    if run.status is not Status.FINISHED:
        reason = run.exhausted(0.0) if run.status is Status.RUNNING else run.end().message
        raise SimulationError(f"derivatives of a run: it did not reach its end: {reason}; shorten it")
    t, h = steps.t, np.diff(steps.t, append=run.times[-1])
    sampled = _sampled(method, steps, h, run.times)
    kept, info = (steps.segments, every, steps.states, run.rows), (run.times, run.samples, *sampled)
    return Recording(method, t, h, *kept, *info, int(run.cell("events")))


def _steps(run: NativeRun, settings: Integration, most_bytes: float) -> tuple[Steps, int]:
    """The starts of all steps, and which part of the states is kept: one of so many."""
    parts: list[Steps] = []
    total, every = 0, 1
    while run.status is Status.RUNNING and not run.exhausted(0.0):
        capacity = min(_AT_ONCE, settings.max_steps)
        part = record_steps(run.loop, run.arguments(1), capacity=capacity, every=every, total=total)
        parts, total = [*parts, part], total + len(part.t)
        while sum(part.states.nbytes for part in parts) > most_bytes and sum(len(part.states) for part in parts) > 1:
            joined = _joined(parts)
            parts, every = [joined._replace(states=joined.states[::2])], 2 * every
    return _joined(parts), every


def _joined(parts: list[Steps]) -> Steps:
    return Steps(*(np.concatenate(arrays) for arrays in zip(*parts, strict=True)))


def _sampled(method: str, steps: Steps, h: Array, times: Array) -> tuple[Counts, Array, Counts]:
    """First sample of each step, weights of the stages in each sample, and the stages that each step needs."""
    tableau, t = table_of(integrator(method)), steps.t
    step = np.clip(np.searchsorted(t + h * (1 + 1e-9), times), 0, len(t) - 1)
    places = SamplePlaces(step, (times - t[step]) / h[step], h[step])
    used, weights = tableau.weighted(tableau.used(steps.evaluations), places)
    first = 1 + np.searchsorted(step[1:], np.arange(len(t) + 1))
    return first.astype(np.int64), np.ascontiguousarray(weights), used
