"""The modes of a robot in the poses through which its drives command it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.modes.of_sheet import frequencies_about
from tmodes.analysis.statics.at_rest import first_commands, robot_rest
from tmodes.analysis.statics.path import Progress
from tmodes.analysis.vibration import RINGS
from tmodes.errors import InputError
from tmodes.model.model import Model
from tmodes.sheet import Robot

__all__ = ["INSTANTS", "ModeAlong", "commanded_poses", "modes_along"]

Array = NDArray[np.float64]

INSTANTS = 9
"""Poses of a motion at which its modes are taken."""


@dataclass(frozen=True, eq=False)
class ModeAlong:
    """The mode of a ``number`` by rising frequency: natural ``frequency`` [Hz] and ``damping`` ratio (n,) at n poses.

    ``element``: its dominant one at the first.
    """

    number: int
    element: str
    frequency: Array
    damping: Array


def commanded_poses(robot: Robot, count: int = INSTANTS) -> Iterator[tuple[float, dict[str, float]]]:
    """Times [s] from 0 to where all moves are at their ends, and the coordinates that are commanded then [rad, m]."""
    model = Model(robot.chain())
    names = first_commands(robot, model)
    drives = [drive for drive in robot.drives if drive.command.is_motion]
    ends = [end for drive in drives if (end := drive.signal.move_ends()) is not None]
    last = max(ends, default=robot.integration.duration)
    moves = {drive.joint: drive.signal.schedule(max(last, robot.integration.duration)) for drive in drives}
    for time in np.linspace(0.0, last, count).tolist() if count > 1 else [0.0]:
        yield time, {name: float(moves[name.removesuffix(".motor")].at(time)) for name in names}


def modes_along(
    robot: Robot, numbers: tuple[int, ...], poses: list[dict[str, float]], progress: Progress
) -> list[ModeAlong]:
    """Modes that ring, of ``numbers`` from 1 on, in ``poses``; motors under control, where any is, else locked.

    By rising frequency; those of a damping ratio of :data:`RINGS` and more, which hardly do, come after all others.
    Raises :class:`tmodes.errors.InputError` where a pose has not so many, and
    :class:`tmodes.errors.SimulationError` where it has no rest.
    """
    found = []
    for k, held in enumerate(poses):
        progress("modes", k / len(poses))
        states = frequencies_about(robot, robot_rest(robot, held=held, contact=False), "locked", "controlled")
        rows = states.get("controlled", states.get("locked", []))
        rows = sorted((row for row in rows if row["damped_frequency_Hz"]), key=_rings_first)
        if len(rows) < max(numbers):
            got, expected = f"mode {max(numbers)} of {len(rows)} that ring", "numbers of modes that the robot has"
            raise InputError("modes", got, expected, "`tmodes modes` lists them")
        found.append([rows[number - 1] for number in numbers])
    return [
        ModeAlong(number, rows[0]["element"], *(np.array([row[key] for row in rows])
                                                for key in ("frequency_Hz", "damping_ratio")))
        for number, rows in zip(numbers, zip(*found, strict=True), strict=True)
    ]  # fmt: skip


def _rings_first(row: dict[str, Any]) -> tuple[bool, float]:
    return row["damping_ratio"] >= RINGS, row["frequency_Hz"]
