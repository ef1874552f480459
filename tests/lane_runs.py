"""Many runs of one structure as a batch, from the numbers that native code reads."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from tmodes.integrate.settings import Integration, refuse_stops
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.simulation.batch.executor import thread_count
from tmodes.simulation.batch.result import BatchRun, room_for, stored
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.problem import problem_of
from tmodes.simulation.solve import solve

__all__ = ["simulate_lanes"]


def simulate_lanes(
    model: LoopModel,
    parameters: ArrayLike,
    schedules: SignalPieces | Sequence[SignalPieces],
    states: ArrayLike,
    settings: Integration,
    *,
    threads: int | None = None,
    out: str | os.PathLike[str] | None = None,
    progress: Callable[[float], None] = lambda share: None,
) -> BatchRun:
    """Run k robots of one structure, with ``parameters`` (k, size), from ``states`` (k, nx) on, by k schedules."""
    refuse_stops(settings, "all lanes of a batch run")
    count, folder = thread_count(threads), None if out is None else Path(out)
    problem = problem_of(model, parameters, schedules, states, settings, np.empty((0, 0, 0)))
    with room_for((problem.size, len(problem.times), problem.starts.shape[1]), folder) as room:
        results = solve([replace(problem, states=room)], problem.size, threads=count, progress=progress)
        batch = BatchRun.of(model.coordinates, problem.times, room, results)
    return stored(batch, folder)
