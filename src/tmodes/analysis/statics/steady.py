"""Motion at constant speed: joints that turn steadily, about which a robot may be at rest as seen by what turns.

Centrifugal and gyroscopic forces are then part of its equilibrium and of its small vibrations, as those of a blade.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.quasistatic import gross_motion
from tmodes.kinds.signals.contract import Signal
from tmodes.model.model import Model
from tmodes.sheet import Robot

__all__ = ["steady_rates", "unsteadiness", "whole_rates"]

Array = NDArray[np.float64]

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


def whole_rates(model: Model, named: Mapping[str, float] | None) -> Array | None:
    """Rates (nq,): those given by name, and those of the joints whose gears they turn; None where none is given."""
    if not named:
        return None
    rates = np.zeros(model.nq)
    for name, value in named.items():
        rates[model.coordinates.index(name)] = value
    turned = gross_motion(model, rates[None])[0]
    return np.where(rates, rates, turned)


def unsteadiness(stiffness: Array, rates: Array, free: NDArray[np.intp]) -> float:
    """By how much the forces along the ``free`` coordinates change as the robot moves on, over their parts [-]."""
    change, parts = stiffness[free] @ rates, np.abs(stiffness[free]) @ np.abs(rates)
    largest = float(np.abs(stiffness).max(initial=0.0) * np.abs(rates).max(initial=0.0))
    return float((np.abs(change) / np.maximum(parts, 1e-9 * max(largest, 1e-300))).max(initial=0.0))
