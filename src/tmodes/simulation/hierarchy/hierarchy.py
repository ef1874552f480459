"""The ladder of link models, climbed: one robot with every model of its links, what each costs and how far it is off.

A rung is compared with the finest one: by its first frequency, and by its tip in the motion of the sheet, whatever its
drives command (positions, efforts, voltages) and under all its loads, over the largest deflection of the tip in it. The
cheapest rung within the tolerance is recommended: that with the fewest coordinates, of equal ones the faster.
"""

from __future__ import annotations

import time as clock
from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.error_parts import tips, without_elasticity
from tmodes.analysis.modes.modes import modes_about
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.errors import InputError, SimulationError
from tmodes.model.model import Model
from tmodes.sheet import Robot
from tmodes.simulation.hierarchy.motion import Motion, moved, with_motion
from tmodes.simulation.hierarchy.variants import rungs, whole_chain

__all__ = ["FINEST", "Ladder", "Rung", "ladder"]

Array = NDArray[np.float64]

FINEST = 6
"""Functions of each direction of bending of the finest rung."""

_BATCHES, _REPEATS = (100, 1100), 15
"""States in a short and a long timing of the forward dynamics, and pairs of timings, of which the median counts."""

_STILL = 1e-12
"""Deflection [m] below which the tip does not deflect."""

_SHARE = 1e-2
"""Tolerance of the integration, over tolerance times the largest deflection."""


@dataclass(frozen=True)
class Rung:
    """One model of the links.

    ``coordinates``: how many the robot has; ``frequencies_Hz``: the first three with the motors locked, about its rest;
    ``sag_m``: tip at rest, off the undeformed robot's; ``cost_us``: one forward dynamics, native, median;
    ``highest_eigenvalue`` [1/s]: what bounds explicit steps. Against the finest rung: ``tip_difference_m``, largest
    in the motion; ``tip_error`` and ``frequency_error`` [-], None where there is nothing to compare. ``why``: why
    there is no motion, else empty.
    """

    model: str
    coordinates: int
    frequencies_Hz: tuple[float, ...]
    sag_m: float
    cost_us: float
    highest_eigenvalue: float | None
    tip_difference_m: float | None
    tip_error: float | None
    frequency_error: float | None
    why: str = ""

    def within(self, tolerance: float) -> bool:
        """True where it moves and its errors, as far as there are any, are at most ``tolerance``."""
        known = [error for error in (self.tip_error, self.frequency_error) if error is not None]
        return not self.why and bool(known) and max(known) <= tolerance


@dataclass(frozen=True)
class Ladder:
    """All rungs from rigid to finest; ``recommended``: the cheapest within ``tolerance``.

    ``move``: the motion in words; ``deflection_m``: largest deflection of the tip in it, by the finest rung.
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
    """A rung: its robot, its motion or why there is none, its pose at rest, and what is known of it."""

    name: str
    robot: Robot
    whole: Model
    sag: float
    frequencies: tuple[float, ...]
    motion: Motion | str


def ladder(
    robot: Robot,
    tolerance: float = 1e-3,
    *,
    finest: int = FINEST,
    progress: Callable[[str, float], None] = lambda stage, share: None,
) -> Ladder:
    """Climb the ladder of a robot, by the motion and the loads of its own sheet.

    Raises :class:`tmodes.errors.InputError` for a robot without beams, or a tolerance that is none;
    :class:`tmodes.errors.SimulationError` where the finest rung has no rest, or does not reach the end of its motion.
    """
    if not 0 < tolerance < 1:
        raise InputError("tolerance", repr(tolerance), "a share between 0 and 1", "take 1e-3 for a thousandth")
    info = list(rungs(robot, finest))
    lowest = min(_at_rest(info[-1][1])[1], default=np.inf)
    words, starts = "", list[_Start]()
    allowed = {}
    for k, (name, sheet) in enumerate(reversed(info)):  # the finest one first, which says how exact they must be
        progress("test motions", k / len(info))
        moving, words = with_motion(sheet, lowest)
        sag, frequencies = _at_rest(sheet)
        if not k:
            allowed = {"allowed": _SHARE * tolerance * float(moved(moving).deflection.max())}
        starts.insert(0, _Start(name, sheet, Model(whole_chain(sheet)), sag, frequencies, _motion(moving, **allowed)))
    return _compared(robot, tolerance, words, starts)


def _at_rest(robot: Robot) -> tuple[float, tuple[float, ...]]:
    """How far the tip is off the undeformed robot's at rest [m], and the first three frequencies [Hz]."""
    rest = robot_rest(robot)
    if not rest.model.nq:
        return 0.0, ()
    q = rest.q[None]
    bent, straight = tips(rest.model, [q, without_elasticity(rest.model, q)])
    found = sorted(one for mode in modes_about(rest) if (one := mode.undamped_frequency_Hz) is not None)
    return float(np.linalg.norm(bent - straight)), tuple(found[:3])


def _motion(robot: Robot, allowed: float) -> Motion | str:
    try:
        return moved(robot, allowed)
    except (InputError, SimulationError) as error:
        return str(error)


def _compared(robot: Robot, tolerance: float, words: str, starts: list[_Start]) -> Ladder:
    last = starts[-1]
    if isinstance(last.motion, str):
        raise SimulationError(f"{last.name}: {last.motion}")
    best, deflection = last.motion, float(last.motion.deflection.max())
    info = tuple(_rung(start, best, deflection, last) for start in starts)
    good = [rung for rung in info if rung.within(tolerance)]
    cheapest = min(good or info[-1:], key=lambda rung: (rung.coordinates, rung.cost_us))
    converged = len(info) > 1 and info[-2].within(tolerance)
    words = words or f"its sheet's own motion, {robot.integration.duration:.3g} s, {best.how}"
    return Ladder(robot.name, tolerance, words, deflection, info, cheapest.model, converged)


def _rung(start: _Start, best: Motion, deflection: float, last: _Start) -> Rung:
    known = None if isinstance(start.motion, str) else start.motion
    gap = None if known is None else float(np.linalg.norm(known.tip - best.tip, axis=1).max())
    off = None
    if start.frequencies and last.frequencies and last.frequencies[0] > 0:
        off = abs(start.frequencies[0] / last.frequencies[0] - 1)
    error = None if gap is None or deflection < _STILL else gap / deflection
    return Rung(start.name, start.whole.nq, start.frequencies, start.sag, _cost(start.whole),
                known and known.highest, gap, error, off, "" if known else str(start.motion))  # fmt: skip


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
