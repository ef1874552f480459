"""From the unloaded robot to the loaded one in steps of the load factor, each short enough to stay on its branch."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.statics.descent import descend
from tmodes.analysis.statics.rank import leading, scale_of, solved, unheld
from tmodes.analysis.statics.stability import Stability, stability_of
from tmodes.analysis.statics.system import Root, StaticSystem, newton
from tmodes.errors import SimulationError

__all__ = ["LoadPath", "Progress", "Station", "follow"]

Array = NDArray[np.float64]

Progress = Callable[[str, float], None]
"""Gets the name of the stage and the share of it that is done."""

LONGEST = 0.4
"""Largest change of a coordinate in one step [rad, m], by the tangent."""

STRAY = 0.5
"""Largest correction after a step, as a share of the step: beyond it another branch may have been caught."""

ROUNDING = 1e-10
"""Correction [rad, m] that is rounding."""

NEAR = 1e-5
"""Step of the load factor within which stability may be lost: a longer one may have missed a branch that keeps it."""

SMALLEST = 1e-9
"""Smallest step of the load factor."""

LITTLE = 1e-3
"""Load factor with which the path begins where springs hold the unloaded robot nowhere."""

SOFT = 1e-9
"""Stiffness over the largest one below which a coordinate counts as one without a spring."""

LOOSE = 1e7
"""Change [rad, m] per load factor of a robot that its springs hold nowhere."""

ABSURD = 1e9
"""The same of a robot that springs hold, which no mass and no load brings about that is meant."""

MOST_STEPS = 1000


@dataclass(frozen=True, eq=False)
class Station:
    """An equilibrium on the way: load factor, pose (nq,), residual, and its stability."""

    factor: float
    q: Array
    residual: float
    stability: Stability
    tangent: Array
    """Change of the free coordinates per load factor."""


@dataclass(eq=False)
class LoadPath:
    """The stations from load factor 0 to 1; ``lost_at``: the factor at which stability was first lost, or None."""

    stations: list[Station] = field(default_factory=list)
    lost_at: float | None = None

    @property
    def end(self) -> Station:
        """The robot under its full load."""
        return self.stations[-1]


def follow(system: StaticSystem, q: Array, progress: Progress = lambda stage, share: None) -> LoadPath:
    """The equilibria from the unloaded robot, near pose q (nq,), to the full load.

    A robot that hardly anything holds when it is unloaded sinks from q to where a little of its load puts it. Tangent
    predictor, Newton corrector, steps that adapt. Raises :class:`SimulationError` with the last factor that
    was reached where the branch turns back (the robot snaps) or cannot be followed.
    """
    path = LoadPath([_first(system, q)])
    step = 1.0
    while path.end.factor < 1.0:
        here = path.end
        step = _held_short(here, min(step, 1.0 - here.factor))
        found = _next(system, here, step)
        if found is None:
            step /= 2
            if step < SMALLEST:
                path, step = LoadPath([_sunk(system, here)]), 1.0
            continue
        path.stations.append(found)
        if path.lost_at is None and here.stability.stable and not found.stability.stable:
            path.lost_at = _crossing(system, here, found)
        _check_length(path)
        progress("statics", found.factor)
        step *= 2
    return path


def _sunk(system: StaticSystem, here: Station) -> Station:
    """The robot under a little load, where its path stopped before that: in a dead zone hardly anything holds it.

    Raises :class:`SimulationError` where the path had come farther, and where it comes to no rest.
    """
    root = descend(system, here.q, LITTLE)[0] if here.factor < LITTLE else None
    if root is None:
        raise SimulationError(_stopped(system, here))
    return _at(system, root, LITTLE)


def _held_short(here: Station, step: float) -> float:
    """The step, so that no coordinate changes too much; what is left is taken whole, so that 1 is met exactly."""
    pace = float(np.abs(here.tangent).max(initial=0.0))
    step = min(step, LONGEST / pace) if pace else step
    left = 1.0 - here.factor
    return left if step > left * (1 - 1e-9) else step


def _next(system: StaticSystem, here: Station, step: float) -> Station | None:
    predicted = here.q.copy()
    predicted[system.free] += step * here.tangent
    factor = 1.0 if step == 1.0 - here.factor else here.factor + step
    root = newton(system, predicted, factor)
    if root is None:
        return None
    stray, moved = np.abs(root.q - predicted).max(initial=0.0), np.abs(predicted - here.q).max(initial=0.0)
    if stray > STRAY * moved + ROUNDING:
        return None
    found = _at(system, root, factor)
    lost = here.stability.stable and not found.stability.stable
    return None if lost and step > NEAR else found


def _first(system: StaticSystem, q: Array) -> Station:
    """The unloaded robot, or one with a little load where its springs hold it (almost) nowhere: loose joints, play."""
    mass, springs = system.reduced(q, 0.0)
    own = np.abs(np.diagonal(springs))
    sprung = bool(own.min(initial=np.inf) > SOFT * own.max(initial=0.0))
    held = stability_of(mass, springs, system.reach(q)).margin != 0.0
    root = newton(system, q, 0.0) if held or sprung else None
    start = _at(system, root, 0.0) if root else None
    pace = np.abs(start.tangent).max(initial=0.0) if start else np.inf
    if start and held and pace <= LOOSE:
        return start
    absurd = sprung and ABSURD < pace < np.inf
    root, last = (None, q) if absurd else descend(system, q, LITTLE, thick=sprung and not held)
    if root is None:
        loose = int(own.argmin()) if sprung else _loosest(system, last, int(own.argmin()))
        raise SimulationError(_restless(system.model.coordinates[system.free[loose]], own[loose], sprung=sprung))
    return _at(system, root, LITTLE)


def _loosest(system: StaticSystem, q: Array, softest: int) -> int:
    """The coordinate that the load accelerates most along what nothing holds, by its kinetic energy, or ``softest``."""
    mass, stiffness = system.reduced(q, 1.0)
    reach = system.reach(q)
    loose = unheld(stiffness, reach) / scale_of(stiffness, reach)[:, None]
    pushed = loose @ np.linalg.solve(loose.T @ mass @ loose, loose.T @ system.forces(q, 1.0).rest)
    moved = np.abs(pushed) * np.sqrt(np.diagonal(mass))
    return leading(moved[:, None])[0] if moved.any() else softest


def _restless(loose: str, stiffness: float, *, sprung: bool) -> str:
    """Why there is no rest: what the springs hold cannot be carried, or the softest coordinate has none."""
    if sprung:
        return (
            f"static equilibrium: none was found near the start, where springs hold every coordinate (the softest "
            f"is {loose}, {stiffness:.3g} N*m/rad or N/m); check masses, loads and the contact's preload"
        )
    return (
        f"static equilibrium: coordinate {loose} has no spring and does not come to rest; hold it, or give it a spring"
    )


def _at(system: StaticSystem, root: Root, factor: float) -> Station:
    mass, reach = system.mass(root.q)[system.block], system.reach(root.q)
    by_factor = system.forces(root.q, factor).by_factor
    if unheld(root.stiffness, reach).size:
        slope = solved(root.stiffness, by_factor, reach)
    else:
        slope = np.asarray(np.linalg.solve(root.stiffness, by_factor), dtype=float)
    tangent = np.zeros_like(by_factor) if slope is None else -slope
    return Station(factor, root.q, root.residual, stability_of(mass, root.stiffness, reach), tangent)


def _crossing(system: StaticSystem, stable: Station, unstable: Station) -> float:
    """The load factor between two stations at which the lowest squared frequency is zero, or two modes join."""
    from scipy.optimize import brentq

    def margin(factor: float) -> float:
        share = (factor - stable.factor) / (unstable.factor - stable.factor)
        root = newton(system, stable.q + share * (unstable.q - stable.q), factor)
        if root is None:
            return -1.0
        return stability_of(system.mass(root.q)[system.block], root.stiffness, system.reach(root.q)).margin

    if not margin(stable.factor) > 0 > margin(unstable.factor):  # it jumps, as where a surface lets go
        return unstable.factor
    return float(brentq(margin, stable.factor, unstable.factor, xtol=1e-10))  # pyright: ignore[reportArgumentType]


def _check_length(path: LoadPath) -> None:
    if len(path.stations) > MOST_STEPS:
        raise SimulationError(
            f"static equilibrium: only load factor {path.end.factor:.6g} of the full load was reached in {MOST_STEPS} "
            "steps; lower the load"
        )


def _stopped(system: StaticSystem, here: Station) -> str:
    names = system.model.coordinates
    fastest = names[int(system.free[int(np.abs(here.tangent).argmax())])] if len(here.tangent) else "none"
    return (
        f"static equilibrium: the robot snaps through at load factor {here.factor:.6g} of the full load, in "
        f"coordinate {fastest}; keep the load below "
        f"{here.factor:.4g} of the given one, raise the stiffness there, or start in the pose beyond the snap (start)"
    )
