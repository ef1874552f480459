"""The ladder of link models, climbed: one robot with every model of its links, what each costs and how far it is off.

A rung is compared with the finest one: by its first frequency, and by its tip along a short move that the motors follow
exactly, over the largest deflection of the tip in it. The cheapest rung within the tolerance is recommended: that with
the fewest coordinates, of equal ones the faster.
"""

from __future__ import annotations

import time as clock
from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.hierarchy.move import Move, chosen_move, followed
from tmodes.analysis.hierarchy.variants import moved_chain, rungs, whole_chain
from tmodes.analysis.quasistatic import held_shape
from tmodes.errors import InputError, SimulationError
from tmodes.model.model import Model
from tmodes.sheet import Robot

__all__ = ["FINEST", "Ladder", "Rung", "ladder"]

Array = NDArray[np.float64]

FINEST = 6
"""Functions of each direction of bending of the finest rung."""

_STEP = 1e-6
"""Step of central differences [rad]."""

_BATCHES, _REPEATS = (100, 1100), 15
"""States in a short and a long timing of the forward dynamics, and pairs of timings, of which the median counts."""

_STILL = 1e-12
"""Deflection [m] below which the tip does not deflect."""

_SHARE = 1e-2
"""Error of a step of the integration, over tolerance times the largest deflection."""


@dataclass(frozen=True)
class Rung:
    """One model of the links.

    ``coordinates``: how many the robot has; ``frequencies_Hz``: the first three with the motors locked, about its rest;
    ``sag_m``: tip at rest, off the undeformed robot's; ``cost_us``: one forward dynamics, native, median;
    ``highest_eigenvalue`` [1/s]: what bounds explicit steps. Against the finest rung: ``tip_difference_m``, largest
    along the move; ``tip_error`` and ``frequency_error`` [-], None where there is nothing to compare. ``why``: why
    there is no move, else empty.
    """

    model: str
    coordinates: int
    frequencies_Hz: tuple[float, ...]
    sag_m: float
    cost_us: float
    highest_eigenvalue: float
    tip_difference_m: float | None
    tip_error: float | None
    frequency_error: float | None
    why: str = ""

    def within(self, tolerance: float) -> bool:
        """True where it makes the move and its errors, as far as there are any, are at most ``tolerance``."""
        known = [error for error in (self.tip_error, self.frequency_error) if error is not None]
        return not self.why and bool(known) and max(known) <= tolerance


@dataclass(frozen=True)
class Ladder:
    """All rungs from rigid to finest; ``recommended``: the cheapest within ``tolerance``.

    ``move``: the test move in words; ``deflection_m``: largest deflection of the tip in it, by the finest rung.
    ``converged``: the rung before the finest is within the tolerance too.
    """

    robot: str
    tolerance: float
    move: str
    deflection_m: float
    rungs: tuple[Rung, ...]
    recommended: str
    converged: bool

    def as_data(self) -> dict[str, Any]:
        """Plain data."""
        return asdict(self)


@dataclass(frozen=True, eq=False)
class _Start:
    """A rung at rest: the model whose gear inputs are given, its pose, and what is known of it."""

    name: str
    model: Model
    whole: Model
    q: Array
    sag: float
    frequencies: tuple[float, ...]
    highest: float


def ladder(
    robot: Robot,
    tolerance: float = 1e-3,
    *,
    finest: int = FINEST,
    progress: Callable[[str, float], None] = lambda stage, share: None,
) -> Ladder:
    """Climb the ladder of an arm.

    Raises :class:`tmodes.errors.InputError` for a robot without beams, or a tolerance that is none;
    :class:`tmodes.errors.SimulationError` where the finest rung has no rest.
    """
    if not 0 < tolerance < 1:
        raise InputError("tolerance", repr(tolerance), "a share between 0 and 1", "take 1e-3 for a thousandth")
    info = list(rungs(robot, finest))
    first = chosen_move(robot, np.inf)
    starts: list[_Start] = []
    for k, (name, sheet) in enumerate(info):
        progress("models", k / len(info))
        starts.append(_at_rest(name, sheet, first))
    move = chosen_move(robot, min(starts[-1].frequencies, default=np.inf))
    paths: list[Array | str] = []
    for k, start in enumerate(starts):
        progress("test moves", k / len(info))
        paths.append(_path(start, move, tolerance))
    return _compared(robot, tolerance, move, starts, paths)


def _at_rest(name: str, sheet: Robot, move: Move) -> _Start:
    chain = whole_chain(sheet)
    model = Model(moved_chain(chain), trials=True)
    undeformed = _posed(model, move.at(0.0)[None])
    q, held = held_shape(model, undeformed)
    if not held[0]:
        raise SimulationError(
            f"{name} has no rest under its own weight; hint: use a stiffer arm, or another first pose"
        )
    tips = model.points(np.stack([undeformed[0], q[0]])).position[:, 0]
    frequencies, highest = _vibrations(model, q[0])
    return _Start(name, model, Model(chain), q[0], float(np.linalg.norm(tips[1] - tips[0])), frequencies, highest)


def _posed(model: Model, inputs: Array) -> Array:
    """Undeformed poses (n, nq) of gear inputs (n, joints)."""
    q = np.zeros((len(inputs), model.nq))
    for axis in model.parts.axes:
        q[:, axis.angle] = inputs[:, axis.given] if axis.given >= 0 else axis.node.joint.rest
    return q


def _vibrations(model: Model, q: Array) -> tuple[tuple[float, ...], float]:
    """First three frequencies [Hz], gear inputs standing still, and the largest eigenvalue [1/s]."""
    from scipy.linalg import eigh

    given = model.parts.held
    free = np.setdiff1d(np.arange(model.nq), given)
    if not len(free):
        return (), 0.0
    moves = _STEP * np.eye(model.nq)[free]
    poses, still = np.concatenate([q + moves, q - moves]), np.zeros((2 * len(free), model.nq))
    by_q = model.inverse_dynamics(poses, still, still)[:, free]
    by_v = model.inverse_dynamics(np.tile(q, (2 * len(free), 1)), np.concatenate([moves, -moves]), still)[:, free]
    stiffness, damping = ((by[: len(free)] - by[len(free) :]).T / (2 * _STEP) for by in (by_q, by_v))
    mass = model.mass_matrix(q)[np.ix_(free, free)]
    squares = eigh((stiffness + stiffness.T) / 2, mass, eigvals_only=True)
    first = tuple(float(np.sqrt(max(square, 0.0)) / (2 * np.pi)) for square in squares[:3])
    solved = -np.linalg.solve(mass, np.hstack([stiffness, damping]))
    matrix = np.block([[np.zeros_like(mass), np.eye(len(free))], [solved]])
    return first, float(np.abs(np.linalg.eigvals(matrix)).max())


def _path(start: _Start, move: Move, tolerance: float) -> Array | str:
    """Tip (n, 3) [m] along the move; or why there is none."""
    model = start.model
    poses = _posed(model, move.at(move.times))
    rates, gains = (_posed(model, move.at(move.times, k)) for k in (1, 2))
    if len(poses[0]) == move.mix.shape[0]:
        return model.points(poses).position[:, 0]
    quasi, _ = held_shape(model, poses, rates, gains)
    scale = float(np.abs(quasi - poses).max())
    try:
        q, _ = followed(model, move, start.q, max(_SHARE * tolerance * scale, 1e-13))
    except SimulationError as error:
        return str(error)
    return model.points(q).position[:, 0]


def _compared(robot: Robot, tolerance: float, move: Move, starts: list[_Start], paths: list[Array | str]) -> Ladder:
    best, last = paths[-1], starts[-1]
    if isinstance(best, str):
        raise SimulationError(best)
    undeformed = last.model.points(_posed(last.model, move.at(move.times))).position[:, 0]
    deflection = float(np.linalg.norm(best - undeformed, axis=1).max())
    info = tuple(_rung(start, path, best, deflection, last) for start, path in zip(starts, paths, strict=True))
    good = [rung for rung in info if rung.within(tolerance)]
    cheapest = min(good or info[-1:], key=lambda rung: (rung.coordinates, rung.cost_us))
    converged = len(info) > 1 and info[-2].within(tolerance)
    return Ladder(robot.name, tolerance, move.words, deflection, info, cheapest.model, converged)


def _rung(start: _Start, path: Array | str, best: Array, deflection: float, last: _Start) -> Rung:
    gap = None if isinstance(path, str) else float(np.linalg.norm(path - best, axis=1).max())
    off = None
    if start.frequencies and last.frequencies and last.frequencies[0] > 0:
        off = abs(start.frequencies[0] / last.frequencies[0] - 1)
    error = None if gap is None or deflection < _STILL else gap / deflection
    return Rung(start.name, start.whole.nq, start.frequencies, start.sag, _cost(start.whole), start.highest,
                gap, error, off, path if isinstance(path, str) else "")  # fmt: skip


def _cost(model: Model) -> float:
    """Median time of one forward dynamics [us]: what more states in one native call take, so that the call is free."""
    rng = np.random.default_rng(0)
    q, v = 0.01 * rng.normal(size=(2, max(_BATCHES), model.nq))
    effort = np.zeros(len(model.efforts))
    taken = []
    for _ in range(_REPEATS):
        ends = [clock.perf_counter()]
        for count in _BATCHES:
            model.forward_dynamics(q[:count], v[:count], effort)
            ends.append(clock.perf_counter())
        taken.append((ends[2] - ends[1]) - (ends[1] - ends[0]))
    return max(float(np.median(taken)), 0.0) / (_BATCHES[1] - _BATCHES[0]) * 1e6
