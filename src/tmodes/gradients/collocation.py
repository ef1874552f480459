"""Torques from rest to rest by direct collocation: of least effort, or in the least time; checked by native runs."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from tmodes.equations.loop.collocation import Collocated, Transcription
from tmodes.errors import InputError
from tmodes.gradients.lowering import lowered
from tmodes.gradients.optimal import Found, RestToRest, under_torques
from tmodes.sheet import Robot

__all__ = ["collocated"]

Array = NDArray[np.float64]

_FIRST, _MOST, _TOLERANCE = 20, 160, 1e-10
"""Intervals: at first, at most; largest relative tolerance of a run."""

_KEPT = 1e-6
"""Share by which a limit may be passed between rows."""


def collocated(
    robot: Robot, move: Callable[[float], RestToRest], duration: float, tolerance: float, *, least_time: bool,
    progress: Callable[[float], None] = lambda share: None,
) -> tuple[RestToRest, Found]:  # fmt: skip
    """The move and its torques, linear between even rows, of least mean square or in the least time from ``duration``.

    Intervals are halved until a run leaves a swing of at most ``tolerance`` [m], or there are too many.

    Raises :class:`tmodes.errors.InputError` for the least time without limits of torque, and
    :class:`tmodes.errors.SimulationError` where none is found.
    """
    own = move(duration)
    if least_time and not np.isfinite(own.torque).all():
        hint = "add `limits: {effort: 100.0}` to its joints, or --torque JOINT=VALUE"
        raise InputError("--least-time", "a joint without a limit of effort", "a limit of each that moves", hint)
    problem = _transcribed(own)
    count = _FIRST
    shares = np.linspace(0.0, 1.0, 2 * count + 1)[:, None]
    torques = np.array(
        [np.interp(shares[::2, 0] * duration, own.functions.knots, row) for row in own.torques(own.guess)]
    )
    here = Collocated(duration, problem.first + shares * (problem.last - problem.first), torques.T)
    while True:
        progress(count / _MOST / 2)
        here = problem.solved(here, least_time=least_time)
        if least_time:
            own = move(here.duration)
        found = _replayed(robot, own, here.controls.T)
        if found.swing <= tolerance or 2 * count > _MOST:
            return own, found
        count *= 2
        at = [np.linspace(0.0, 1.0, rows) for rows in (len(here.states), 2 * count + 1, len(here.controls), count + 1)]
        states, controls = (
            np.array([np.interp(new, old, column) for column in part.T]).T
            for part, old, new in ((here.states, at[0], at[1]), (here.controls, at[2], at[3]))
        )
        here = Collocated(here.duration, states, controls)


def _transcribed(move: RestToRest) -> Transcription:
    here = move.runs.here
    layout, plan, row = here.model.layout, here.model.plan, here.setup.first_row.copy()
    width, signals = plan.degree + 1, {drive.joint: drive.signal for drive in plan.drives}
    places = [1 + signals[joint] * width for joint in move.joints]
    for place in places:
        row[place : place + width] = 0.0
    q, v = (np.arange(len(here.start))[part] for part in (layout.q, layout.v))
    moving, fastest = np.concatenate([q, v]), np.full(len(q) + len(v), np.inf)
    fastest[len(q) + np.array(move.places)] = move.speed
    last = np.concatenate([move.goal.q, np.zeros(len(v))])
    return Transcription(
        here.model.loop.rate, here.parameters, row, moving.tolist(), places, here.start[moving], last, move.torque,
        fastest, move.sizes,
    )  # fmt: skip


def _replayed(robot: Robot, move: RestToRest, torques: Array) -> Found:
    """The torques (drives, rows), which hold the goal afterwards, and the swing that a run leaves."""
    rows = np.append(np.linspace(0.0, move.duration, torques.shape[1]), move.duration)
    values = np.column_stack([torques, move.base[:, -1]])
    found = Found(rows, values, np.zeros(0), 0.0, 0.0, 1, 0, "linear")
    driven = under_torques(robot, move.start, found.signals(move.joints), move.duration)[0]
    own = driven.integration
    update = {"relative_tolerance": min(own.relative_tolerance, _TOLERANCE), "check_error": False}
    done = lowered(driven.model_copy(update={"integration": own.model_copy(update=update)})).recorded()
    samples = done.recording.samples
    speeds = np.abs(samples[:, move.runs.here.model.layout.v][:, move.places] / move.speed).max()
    excess = max(float(np.abs(torques / move.torque[:, None]).max()), float(speeds)) - 1
    swing = move.goal.swing(move.left(samples[-1]) * move.far)
    return found._replace(swing=swing, excess=excess if excess > _KEPT else 0.0)
