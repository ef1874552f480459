"""A run of one model over time: calls the native loop piece by piece, and says how it ended."""

from __future__ import annotations

import time as clock
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tmodes.integrate.choice import otherwise as later_settings
from tmodes.integrate.registry import AUTO
from tmodes.integrate.settings import Integration
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.native_run import NativeRun
from tmodes.simulation.parts import Journal, Trajectory
from tmodes.simulation.stops import Stops
from tmodes.simulation.watched_run import WatchedRun

__all__ = ["integrate"]

_PIECE_SECONDS = 0.05
_FIRST_PIECE = 500


def integrate(
    model: LoopModel,
    parameters: NDArray[np.float64],
    schedule: SignalPieces,
    state: NDArray[np.float64],
    settings: Integration,
    progress: Callable[[float], None] = lambda share: None,
    journal: Journal | None = None,
    otherwise: Integration | None = None,
    stops: Stops | None = None,
) -> Trajectory:
    """Integrate from ``state`` (size,) over ``settings.duration``, or until the first of ``stops`` triggers.

    Where no method is named, dormand_prince begins.

    ``otherwise``: the settings to continue with where the motion turns out stiff for an explicit method.
    ``progress`` is given the share of the time that is done. Ctrl-C ends the run with what it has (``interrupted``).
    Stopping, continuing from a journal, and the pieces in which the loop is called change no bit of the samples.
    Raises :class:`tmodes.errors.SimulationError` where a stop condition holds at the start already.
    """
    if settings.method == AUTO:
        otherwise = otherwise or later_settings(settings, "dormand_prince")
        settings = settings.chosen("dormand_prince")
    run = NativeRun(model, parameters, schedule.until(settings.duration), state, settings, otherwise=otherwise)
    run.keep_changes()
    going = WatchedRun(run, stops) if stops else run
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
    piece = _FIRST_PIECE
    try:
        while run.running:
            started = clock.monotonic()
            going.advance(piece)
            spent = clock.monotonic() - started
            piece = max(1, int(piece * min(4.0, _PIECE_SECONDS / max(spent, 1e-6))))
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
