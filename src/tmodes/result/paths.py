"""The three paths of a tip, commanded, nominal and actual; and the error of the actual one against both, in parts.

Commanded: the nominal robot without elasticity, its drives at their setpoints. Nominal: elastic as known, its
motors at their setpoints. Where there is none, the robot that ran stands for the nominal one.
"""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.error_parts import PARTS, along, element_steps, substitutions, tips
from tmodes.simulation.motion_run import RunData

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = ["ErrorParts", "error_parts", "largest_elements", "part_names", "shapes_of", "tip_errors"]

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
    if not _setpoints(run):
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


def _setpoints(run: RunData) -> dict[int, int]:
    """The signal of each coordinate that a drive keeps, or moves, where it should be."""
    motion = {drive.joint for drive in run.robot.drives if drive.command.is_motion}
    return {
        driver.coordinate: driver.plan.signal
        for driver in run.setup.model.loop.drivers
        if driver.plan.servo is None or driver.plan.joint in motion
    } if motion else {}  # fmt: skip


def _steps(mover: RunData, run: RunData, part: slice) -> Array:
    """The tip of ``mover`` (the actual robot or the nominal one) in its four shapes, (4, n, 3) [m]."""
    return tips(mover.model, shapes_of(mover, run, part), mover.base[part])


def shapes_of(mover: RunData, run: RunData, part: slice) -> list[Array]:
    """The four shapes (n, nq) of the actual robot, or of the nominal one."""
    order = [(run.reference or run).coordinates.index(name) for name in mover.coordinates]
    commanded = (run.reference or run).q[part][:, order].copy()
    drivers = {run.coordinates[k]: signal for k, signal in _setpoints(run).items()}
    signals = run.planned.signals.at(run.times[part])
    for name, signal in drivers.items():
        commanded[:, mover.coordinates.index(name)] = signals[:, signal]
    driven = [driver.coordinate for driver in mover.setup.model.loop.drivers]
    return substitutions(mover.model, mover.q[part], commanded, driven)


def tip_errors(data: Dataset) -> dict[str, dict[str, Any]]:
    """Of the error against the ``commanded`` and the ``nominal`` path: the largest, when, at the end, and its parts.

    ``parts_m``: components along the largest error, which add up to it and may be negative; ``vectors_m`` [m].
    ``elements_m``: the same of each gear and link; ``environment_m``: what of gears and links is by the contact force,
    see :func:`tmodes.result.elements.element_errors`; both are not known of files of earlier versions.
    """
    found, details = {}, json.loads(data.attrs.get("tip_error_elements", "{}"))
    for which, series in (("commanded", "tip_error"), ("nominal", "tip_error_nominal")):
        if series not in data:
            continue
        parts = data[series].transpose("time", "error_part", "axis").values
        size = np.linalg.norm(parts.sum(axis=1), axis=1)
        worst, names = int(size.argmax()), [str(name) for name in data["error_part"].values]
        found[which] = {
            "max_m": float(size[worst]),
            "time_of_max_s": float(data["time"].values[worst]),
            "end_m": float(size[-1]),
            "parts_m": dict(zip(names, along(parts[worst]).tolist(), strict=True)),
            "vectors_m": dict(zip(names, parts[worst].tolist(), strict=True)),
            **{f"{key}_m": value for key, value in details.get(which, {}).items()},
        }
    return found


def largest_elements(one: dict[str, Any]) -> list[tuple[str, float]]:
    """Names and components [m] of the gears and links that have most of one of the :func:`tip_errors`, at most four."""
    named = [
        (f"{part.removesuffix('s')} {name}", value)
        for part, parts in one.get("elements_m", {}).items()
        for name, value in parts.items()
    ]
    return sorted((item for item in named if item[1]), key=lambda item: -abs(item[1]))[:_MOST_ELEMENTS]


_MOST_ELEMENTS = 4
