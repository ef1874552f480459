"""Laws designed from a robot as known: its linear form for them, and each design kept for all robots known alike."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

from tmodes.equations.lagrange.registry import SYSTEMS
from tmodes.kinds.controllers.registry import LinearPlant
from tmodes.kinds.noted.functions import kept, number
from tmodes.kinds.noted.number import follow_no
from tmodes.model.model import Model
from tmodes.simulation.linear import open_loop, opened

if TYPE_CHECKING:
    from tmodes.kinds.controllers.registry import Block
    from tmodes.sheet import Robot
    from tmodes.sheet.parts import DriveSheet

__all__ = ["designed_block", "linear_plant"]


def linear_plant(
    robot: Robot, reads: tuple[str, ...], drives: tuple[str, ...], *, start: bool = False, delay: float = 0.0
) -> LinearPlant:
    """The robot about its rest at the last setpoints, or the first (``start``), under the commands of ``drives``.

    ``reads``: outputs and sensors by name; sensors without samples and noise. The commands act ``delay`` [s] late.
    """
    held = {drive.joint: _setpoint(robot, drive, start=start) for drive in robot.drives if drive.command.is_motion}
    return copy.deepcopy(_plant(_read(robot), _Aside(robot), reads, drives, held, delay))


def designed_block(robot: Robot, block: Block, drives: tuple[str, ...], delay: float) -> Block:
    """A block designed for a robot as known; once for all whose numbers that count are the same.

    Raises :class:`tmodes.errors.InputError` where there is no design.
    """
    ends = [[_setpoint(robot, one, start=start) for one in robot.drives if one.command.is_motion]
            for start in (True, False)]  # fmt: skip
    return _block(_read(robot), _Aside(robot), block, drives, ends, delay)


@kept
def _block(read: Any, aside: _Aside, block: Block, drives: tuple[str, ...], ends: Any, delay: float) -> Block:
    del read, ends
    return block.designed(partial(linear_plant, aside.robot, delay=delay), drives)


def _read(robot: Robot) -> tuple[Any, ...]:
    """What a linear form reads of a robot, besides setpoints."""
    fields = tuple((name, value) for name, value in opened(robot) if name not in ("real", "task", "integration"))
    return *fields, SYSTEMS.get(robot.equations)


class _Aside:
    """An argument that changes nothing in the answer."""

    def __init__(self, robot: Robot) -> None:
        self.robot = robot

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Aside)

    def __hash__(self) -> int:
        return 0


@kept
def _plant(
    read: Any, aside: _Aside, reads: tuple[str, ...], drives: tuple[str, ...], held: Mapping[str, Any], delay: float
) -> LinearPlant:
    del read
    robot = aside.robot
    chain = robot.undriven.chain()
    follow_no("gains that are designed from the robot", held, delay, chain.gravity, Model(chain).parameters)
    names = chain.coordinates
    motors = {f"{joint}.motor" if f"{joint}.motor" in names else joint: value for joint, value in held.items()}
    commands = {drive.joint: drive.command for drive in opened(robot).drives}
    found = open_loop(robot, [f"{joint}.{commands[joint]}" for joint in drives], reads, held=motors)
    size = 2 * len(names) + sum(name.endswith(".current") for name in found.states)
    part = slice(0, size)
    return LinearPlant(
        found.states[part], drives, reads, found.A[part, part], found.B[part], found.C[:, part], found.D,
        found.x0[part], found.u0, found.y0, delay,
    )  # fmt: skip


def _setpoint(robot: Robot, drive: DriveSheet, *, start: bool) -> float:
    duration = robot.integration.duration
    return number(drive.signal.schedule(duration).at(0.0 if start else duration))
