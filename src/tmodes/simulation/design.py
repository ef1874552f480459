"""Laws designed from a robot as known: its linear form for them, and each design kept for all robots known alike."""

from __future__ import annotations

import copy
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

from tmodes.equations.lagrange.registry import SYSTEMS
from tmodes.equations.loop.control_kernels import Winding
from tmodes.equations.loop.plan import winding_of
from tmodes.kinds.controllers.registry import LinearPlant
from tmodes.kinds.noted.functions import kept, number
from tmodes.kinds.noted.number import follow_no
from tmodes.model.model import Model
from tmodes.sheet.network import commands_effort, node_of
from tmodes.simulation.linear import open_loop
from tmodes.simulation.linear_inputs import opened

if TYPE_CHECKING:
    from tmodes.kinds.controllers.registry import Block
    from tmodes.sheet import Robot
    from tmodes.sheet.network import Node
    from tmodes.sheet.parts import DriveSheet

__all__ = ["designed_block", "linear_plant"]


class _Added(NamedTuple):
    """What is fed forward on top of a command: pairs of a signal's name and a factor; its value at each rest."""

    pairs: tuple[tuple[str, Any], ...]
    start: Any
    end: Any


def linear_plant(
    robot: Robot, reads: tuple[str, ...], drives: tuple[str, ...], *, start: bool = False, delay: float = 0.0,
    added: tuple[_Added, ...] = (),
) -> LinearPlant:  # fmt: skip
    """The robot about its rest at the last setpoints, or the first (``start``), under the commands of ``drives``.

    ``reads``: outputs and sensors by name; sensors without samples and noise. The commands act ``delay`` [s] late.
    ``added``: what is fed forward on top of each.
    """
    held = {drive.joint: _setpoint(robot, drive, start=start) for drive in robot.drives if drive.command.is_motion}
    found = replace(
        copy.deepcopy(_plant(_read(robot), _Aside(robot), reads, drives, held, delay)),
        first=tuple(_setpoint(robot, one, start=True) for name in drives for one in robot.drives if one.joint == name),
    )
    if not any(one.pairs for one in added):
        return found
    rest = tuple(one.start if start else one.end for one in added)
    follow_no("what is fed forward to a law that is designed", rest, [one.pairs for one in added])
    return replace(found, effort=found.effort - rest, added=tuple(one.pairs for one in added), added_at_rest=rest)


def designed_block(robot: Robot, node: Node, delay: float) -> Block:
    """The block of a node designed for a robot as known; once for all whose numbers that count are the same.

    Raises :class:`tmodes.errors.InputError` where there is no design.
    """
    ends = [[_setpoint(robot, one, start=start) for one in robot.drives if one.command.is_motion]
            for start in (True, False)]  # fmt: skip
    added = tuple(_added(robot, *each) for each in zip(node.drives, node.signals, strict=True))
    return _block(_read(robot), _Aside(robot), node.block, node.drives, ends, delay, added)


@kept
def _block(
    read: Any, aside: _Aside, block: Block, drives: tuple[str, ...], ends: Any, delay: float, added: tuple[_Added, ...]
) -> Block:
    del read, ends
    return block.designed(partial(linear_plant, aside.robot, delay=delay, added=added), drives)


def _added(robot: Robot, joint: str, command: str) -> _Added:
    """What is fed forward to a drive on top of a command: by blocks, and by the drive itself."""
    found, duration = [*_fed(robot, joint, command)], robot.integration.duration
    start, end = (
        sum(factor * number(signal.schedule(duration).at(time)) for _, factor, signal in found if signal)
        for time in (0.0, duration)
    )
    return _Added(tuple((name, factor) for name, factor, _ in found), start, end)


def _fed(robot: Robot, joint: str, command: str) -> Iterator[tuple[str, Any, Any]]:
    """Names and factors of these signals; the signal itself where it is not 0 at rest."""
    nodes = [node_of(sheet) for sheet in robot.control]
    while node := next((one for one in nodes if f"{command}.feed_forward" in one.block.given), None):
        name = f"{command}.feed_forward"
        yield name, 1.0, node.block.given[name]
        command = node.signals[[*node.block.given].index(name)]
    drive = next(one for one in robot.drives if one.joint == joint)
    if drive.feed_forward is None:
        return
    axis = next(one for one in robot.undriven.chain().axes if one.name == joint)
    winding, (resistance, back, torque, inductance) = winding_of(axis.joint.motor)
    name, volts = f"{joint}.feed_forward", winding is not Winding.NONE and not commands_effort(robot, drive)
    yield name, resistance / torque if volts else 1.0, drive.feed_forward
    if volts:
        yield from ((f"{name}'", inductance / torque, None), (f"{joint}.setpoint'", back, None))


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
