"""The three paths of a tip, commanded, nominal and actual; and the error of the actual one against both, in parts.

Commanded: the nominal robot without elasticity, its drives at their setpoints. Nominal: elastic as known, its
motors at their setpoints. Where there is none, the robot that ran stands for the nominal one.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.error_parts import PARTS, element_steps, substitutions, tips
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.vary.tables import commanded_signals

__all__ = ["ErrorParts", "error_parts", "part_names", "shapes_of"]

Array = NDArray[np.float64]

GEOMETRY = "geometry"
"""The part of an actual robot whose dimensions are not the nominal ones."""

_SAME = 1e-12
"""Distance of two commanded tips [m] up to which nominal and actual robot have the same dimensions."""


class ErrorParts(NamedTuple):
    """``commanded`` tip (n, 3); parts (n, k, 3) of the actual tip less it, and less the nominal tip [m]."""

    commanded: Array
    to_commanded: Array
    to_nominal: Array | None


def part_names(run: RunData) -> list[str]:
    """The names of the parts of a run's error; none where no drive has a setpoint."""
    if not commanded_signals(run.setup):
        return []
    first = slice(1)
    gears = {part for part, _ in element_steps(run.model, run.q[:1], run.q[:1])[0]} - {"links"}
    names = [PARTS[0], ", ".join(sorted(gears, reverse=True)) or PARTS[1], PARTS[2]]
    apart = np.abs(_steps(run, run, first)[0] - _steps(run.reference or run, run, first)[0]).max()
    return [*names, *([GEOMETRY] if apart > _SAME else [])]


def error_parts(run: RunData, count: int) -> ErrorParts | None:
    """The error of the actual tip at the first ``count`` samples; None where no drive has a setpoint."""
    names = part_names(run)
    if not names:
        return None
    part = slice(count)
    own, planned = _steps(run, run, part), _steps(run.reference or run, run, part)
    commanded, geometry = planned[0], own[0] - planned[0]
    actual, nominal = (np.diff(found, axis=0).transpose(1, 0, 2) for found in (own, planned))
    if GEOMETRY in names:
        actual = np.concatenate([actual, geometry[:, None]], axis=1)
        nominal = np.concatenate([nominal, np.zeros_like(geometry)[:, None]], axis=1)
    return ErrorParts(commanded, actual, actual - nominal if run.reference else None)


def _steps(mover: RunData, run: RunData, part: slice) -> Array:
    """The tip of ``mover`` (the actual robot or the nominal one) in its four shapes, (4, n, 3) [m]."""
    return tips(mover.model, shapes_of(mover, run, part), mover.base[part])


def shapes_of(mover: RunData, run: RunData, part: slice) -> list[Array]:
    """The four shapes (n, nq) of the actual robot, or of the nominal one."""
    order = [(run.reference or run).coordinates.index(name) for name in mover.coordinates]
    commanded = (run.reference or run).q[part][:, order].copy()
    drivers = {run.coordinates[k]: signal for k, signal in commanded_signals(run.setup).items()}
    signals = run.planned.signals.at(run.times[part])
    for name, signal in drivers.items():
        commanded[:, mover.coordinates.index(name)] = signals[:, signal]
    driven = [driver.coordinate for driver in mover.setup.model.loop.drivers]
    return substitutions(mover.model, mover.q[part], commanded, driven)
