"""The driver of runs: one case by itself, many by an executor; stop conditions, checkpoints, steps for adjoints."""

from __future__ import annotations

import time as clock
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, overload

from tmodes.simulation.case_results import CaseResults
from tmodes.simulation.event_detection import WatchedRun
from tmodes.simulation.native_run import NativeRun, pieces
from tmodes.simulation.parts import Journal, Trajectory
from tmodes.simulation.problem import Problem
from tmodes.simulation.stops import Stops

if TYPE_CHECKING:
    from tmodes.simulation.batch.executor import Executor
    from tmodes.simulation.recording import Recording

__all__ = ["Progress", "solve"]

Progress = Callable[[float], None]


@overload
def solve(
    problem: Problem, *, events: Stops | None = None, journal: Journal | None = None, progress: Progress = ...
) -> Trajectory: ...
@overload
def solve(problem: Problem, *, adjoint: float) -> Recording: ...
@overload
def solve(
    problem: Sequence[Problem], cases: int, *, executor: Executor | None = None, threads: int = 1,
    progress: Progress = ...,
) -> CaseResults: ...  # fmt: skip
def solve(
    problem: Problem | Sequence[Problem], cases: int = 1, *, events: Stops | None = None, adjoint: float | None = None,
    journal: Journal | None = None, executor: Executor | None = None, threads: int = 1,
    progress: Progress = lambda share: None,
) -> Any:  # fmt: skip
    """Integrate a problem: one case by itself, or many ``cases`` in problems of one structure each.

    One case runs over its duration, or until the first of its ``events`` triggers; with a ``journal`` it continues
    where that ends. With ``adjoint`` it is recorded for derivatives, in so many bytes at most
    (:func:`tmodes.simulation.recording.record`). Many cases run by an ``executor`` (None: ``threads`` of the
    processor), and their samples, or the outputs that are wanted in place of them, go where their problems say; a case
    at no place of any problem has no status. ``progress`` is given the share of the time that is done. Ctrl-C ends all
    with what they have (``interrupted``). Stopping, continuing from a journal, the pieces in which a loop is called,
    the other cases and the threads change no bit of the samples.

    Raises :class:`tmodes.errors.SimulationError` where a stop condition holds at the start already.
    """
    if isinstance(problem, Problem):
        if adjoint is None:
            return _single(problem, events, journal, progress)
        from tmodes.simulation.recording import record

        return record(problem, adjoint)
    from tmodes.simulation.batch.executor import PROCESSOR

    results = CaseResults.of_all(cases)
    (executor or PROCESSOR).run(problem, results, threads, progress)
    return results


def _single(problem: Problem, events: Stops | None, journal: Journal | None, progress: Progress) -> Trajectory:
    run = NativeRun(problem)
    run.keep_changes()
    going = WatchedRun(run, events) if events else run
    if journal and (record := journal.restore()):
        going.resume(record)
    begun, began = run.cell("t"), clock.monotonic()
    done = _advanced(run, going, progress, journal, began)
    return replace(done, seconds=(clock.monotonic() - began) / max(run.cell("t") - begun, 1e-300))


def _advanced(
    run: NativeRun,
    going: NativeRun | WatchedRun,
    progress: Callable[[float], None],
    journal: Journal | None,
    began: float,
) -> Trajectory:
    """Advance a run to its end; ``going``: the same, watched for conditions where there are some."""
    try:
        for piece in pieces():
            if not run.running:
                break
            going.advance(piece)
            progress(run.cell("t") / run.settings.duration)
            if journal:
                journal.keep(going.record(), last=not run.running)
            reason = run.exhausted(clock.monotonic() - began)
            if reason and run.running:
                return run.trajectory("stopped", reason)
    except KeyboardInterrupt:
        if journal:
            journal.keep(going.record(), now=True)
        return run.trajectory("interrupted", f"interrupted at t = {run.cell('t'):.6g} s; what was done is kept")
    return going.end()
