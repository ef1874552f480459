"""Motion at constant speed: joints that turn steadily, about which a robot may be at rest as seen by what turns.

Centrifugal and gyroscopic forces are then part of its equilibrium and of its small vibrations, as those of a blade.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.quasistatic import gross_motion
from tmodes.analysis.statics.system import StaticSystem
from tmodes.kinds.signals.contract import Signal
from tmodes.model.model import Model
from tmodes.sheet import Robot

__all__ = ["base_spin", "is_unsteady", "steady_rates", "whole_rates"]

Array = NDArray[np.float64]

_CHANGE = 1e-6
"""Change of forces in motion at constant speed, over their parts, beyond which it is more than rounding."""

_END = 0.9
"""Share of the run from which a speed must stay the same to be the steady one."""

_SAME = 1e-6
"""Change of a speed, over its largest, that is rounding of a fitted signal."""

_STILL = 1e-9
"""Way in the run, over the largest position (at least 1 rad or m), that is rounding."""


def steady_rates(robot: Robot, model: Model) -> dict[str, float]:
    """Coordinates whose position a drive moves at constant speed to the end of the run, and how fast [rad/s, m/s]."""
    found = {}
    for drive in robot.drives:
        names = [name for name in (f"{drive.joint}.motor", drive.joint) if name in model.coordinates]
        rate = _last_rate(drive.signal, robot.integration.duration) if drive.command.is_motion and names else 0.0
        if rate:
            found[names[0]] = rate
    return found


def base_spin(robot: Robot) -> Array | None:
    """Rate (3,) at which the base turns to the end of the run, at constant speed about one of its axes [rad/s]."""
    if robot.base_motion is None:
        return None
    rates = [_last_rate(turn, robot.integration.duration) if turn else 0.0 for turn in robot.base_motion.turns]
    return np.array(rates) if np.count_nonzero(rates) == 1 else None


def _last_rate(signal: Signal, duration: float) -> float:
    """The constant rate at the end of a signal; 0 where it stands, or its rate changes.

    Of a move that comes to its own end: at that end, also where the run is over before.
    """
    until = max(duration, 1.25 * (signal.move_ends() or 0.0))
    schedule = signal.schedule(until)
    times = np.linspace(0.0, until, 201)
    positions, rates = schedule.at(times), schedule.at(times, 1)
    last = rates[times >= _END * until]
    changes = np.ptp(last) > _SAME * np.abs(rates).max()
    stands = abs(last[-1]) * until <= _STILL * max(float(np.abs(positions).max()), 1.0)
    return 0.0 if changes or stands else float(last.mean())


def whole_rates(model: Model, named: Mapping[str, float] | None, *, base: bool) -> Array | None:
    """Rates (nq,): those given by name, and those of the joints whose gears they turn; None: nothing moves."""
    if not (named or base):
        return None
    rates = np.zeros(model.nq)
    for name, value in (named or {}).items():
        rates[model.coordinates.index(name)] = value
    turned = gross_motion(model, rates[None])[0]
    return np.where(rates, rates, turned)


def is_unsteady(system: StaticSystem, stiffness: Array) -> bool:
    """Whether forces along the free coordinates change as a robot (``stiffness`` (nq, nq)) moves on at its rates."""
    if system.rates is None:
        return False
    change, parts = stiffness[system.free] @ system.rates, np.abs(stiffness[system.free]) @ np.abs(system.rates)
    largest = float(np.abs(stiffness).max(initial=0.0) * np.abs(system.rates).max(initial=0.0))
    joints = np.abs(change) / np.maximum(parts, 1e-9 * max(largest, 1e-300))
    return float(joints.max(initial=0.0)) > _CHANGE or not (system.spin is None or _turns_with(system, system.spin))


def _turns_with(system: StaticSystem, spin: Array) -> bool:
    """Whether weight and loads stay the same as seen by a base that turns."""
    row, axis = system.base(1.0), spin / np.linalg.norm(spin)
    along = np.linalg.norm(np.cross(row[3:6], axis)) <= _CHANGE * np.linalg.norm(row[3:6])
    return bool(along) and all(act.turns_with(row[9:18].reshape(3, 3) @ axis) for act in system.acts)
