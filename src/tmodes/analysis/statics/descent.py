"""From a robot that hardly anything holds to where it hangs: downhill, slowly, in a thick fluid."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.statics.rank import NOTHING, beyond_rounding, is_positive, solved
from tmodes.analysis.statics.system import Root, StaticSystem, newton

__all__ = ["descend"]

Array = NDArray[np.float64]

MOST_DESCENT = 2000
MOST_SLOWER = 60

NEARLY = 1e-6
"""Step of the descent [rad, m] from which Newton's method takes over."""

SLOWEST = 1e-9
"""Damper of a coordinate in the descent, over the largest one, that is none."""

STEADY = 1e-9
"""Relative rise of the force in a step of the descent that is rounding."""

LONGEST = 0.5
"""Longest step of the descent [rad, m]."""


def descend(system: StaticSystem, q: Array, factor: float, *, thick: bool = False) -> tuple[Root | None, Array]:
    """The pose to which a robot sinks when it moves slowly in a thick fluid, downhill all the way.

    Linearly implicit Euler steps of D q' = -r(q), each longer as the force falls (Kelley & Keyes, "Convergence analysis
    of pseudo-transient continuation", SIAM J. Numer. Anal. 35, 1998). A surface, or the gear of a motor that turns
    freely (``thick``), is stiff in one direction and makes the fluid so thick that along the others the robot hardly
    moves: there each step is twice as long as the last unless the force rises. With the pose (nq,) that was reached
    last; None where it comes to no rest.
    """
    forces = system.forces(q, factor)
    pace, reach = 1.0, system.reach(q)
    for _ in range(MOST_DESCENT):
        stiffness = system.stiffness(q, factor)[system.block]
        rest = beyond_rounding(forces.rest, stiffness, reach)
        if not rest.any():
            return Root(q, 0.0, stiffness), q
        if not (np.isfinite(stiffness).all() and np.isfinite(rest).all()):
            return None, q
        damper = _damper(stiffness, rest)
        pace = _downhill(stiffness, damper, pace, reach)
        step = solved(stiffness + damper / pace, rest, reach)
        if step is None or not np.isfinite(step).all():
            return None, q
        size = float(np.abs(step).max())
        if not size or pace > 1 / NOTHING or (size <= NEARLY and pace > 1):
            return newton(system, q, factor), q
        q = q.copy()
        q[system.free] -= step * min(1.0, LONGEST / size)
        found = system.forces(q, factor)
        fall = float(np.linalg.norm(forces.rest) / max(np.linalg.norm(found.rest), 1e-300))
        pace *= 2.0 if (thick or system.is_touched) and fall >= 1 - STEADY else min(max(fall, 0.5), 2.0)
        forces = found
    return None, q


def _damper(stiffness: Array, force: Array) -> Array:
    """A fluid in which each coordinate moves by about its own spring's pace, or, without one, 1 rad or m in a step.

    One damper for each: a gear that springs back would drag along, by inertia, what hangs loose behind it.
    """
    own = np.maximum(np.abs(np.diagonal(stiffness)), np.abs(force))
    return np.diag(np.maximum(own, SLOWEST * own.max()))


def _downhill(stiffness: Array, damper: Array, pace: float, reach: Array) -> float:
    """The pace, or a slower one, with which a step leads downhill: stiffness and damper together hold the pose."""
    for _ in range(MOST_SLOWER):
        if is_positive((stiffness + stiffness.T) / 2 + damper / pace, reach):
            break
        pace /= 2
    return pace
