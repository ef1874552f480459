"""The control system of a sheet: which blocks there are, what each reads and commands, in which order they follow."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from graphlib import CycleError, TopologicalSorter
from typing import Any, NamedTuple

from tmodes.kinds.controllers.registry import Block, Port
from tmodes.kinds.schema.quantity import Issue
from tmodes.sheet.parts import Command

__all__ = ["Node", "commander", "commands_effort", "control_issues", "network", "node_of"]


class Node(NamedTuple):
    """A block by name: its place in the sheet, its ports, and the joint that it sees as its own."""

    name: str
    path: str
    block: Block
    ports: tuple[Port, ...]
    joint: str = ""
    sheet: Any = None

    @property
    def place(self) -> str:
        """Its place in the sheet by its name, as messages say it."""
        head = self.path.partition(".")[0]
        return self.path if head == "drives" else f"{head}.{self.name}"

    @property
    def drives(self) -> tuple[str, ...]:
        """The joints whose drives it commands."""
        return self.sheet.drives if self.sheet else ()

    @property
    def signals(self) -> tuple[str, ...]:
        """Names of the signals that it gives."""
        return tuple(f"{self.name}.{port.name}" if port.name else self.name for port in self.ports)


def network(robot: Any) -> list[Node]:
    """Sensors and blocks, each after those that it reads; raises :class:`graphlib.CycleError` for a ring of them."""
    nodes = {node.name: node for node in _nodes(robot)}
    givers = {signal: name for name, node in nodes.items() for signal in node.signals}
    reads = {name: {givers[one] for one in node.block.reads if one in givers} for name, node in nodes.items()}
    return [nodes[name] for name in TopologicalSorter(reads).static_order()]


def _nodes(robot: Any) -> Iterator[Node]:
    for index, sensor in enumerate(robot.sensors):
        yield Node(sensor.name, f"sensors.{index}", sensor, sensor.ports)
    for index, sheet in enumerate(robot.control):
        yield node_of(sheet, f"control.{index}")


def node_of(sheet: Any, path: str = "") -> Node:
    """The block of an item of ``control``; without ports of its own it gives a signal for each of its drives."""
    several = len(sheet.drives) > 1
    ports = sheet.block.ports or tuple(Port(joint if several else "") for joint in sheet.drives) or (Port(),)
    return Node(sheet.name, path, sheet.block, ports, sheet.joint, sheet)


def commander(robot: Any, joint: str) -> Any:
    """The item of ``control`` that commands a joint's drive: of those in a row the last; None without one."""
    return next(iter(_commanders(robot, joint)), None)


def _commanders(robot: Any, joint: str) -> list[Any]:
    """Those that command a joint's drive, but for those whose command another one reads in their place."""
    there = [sheet for sheet in robot.control if joint in sheet.drives]
    read = {name for sheet in there for name in sheet.block.reads}
    return [one for one in there if dict(zip(one.drives, node_of(one).signals, strict=False)).get(joint) not in read]


def commands_effort(robot: Any, drive: Any) -> bool:
    """Whether the law of a drive, its own or a block with those that it reads, commands its effort."""
    blocks = {signal: node.block for node in _nodes(robot) for signal in node.signals}

    def of(block: Block) -> bool:
        return block.commands_effort or any(of(blocks[name]) for name in block.reads if name in blocks)

    sheet = commander(robot, drive.joint)
    law = drive.controller or (sheet and sheet.block)
    return law is not None and of(law)


def control_issues(robot: Any) -> Iterator[Issue]:
    """What does not fit: names given twice, drives commanded twice or not at all, rings of blocks."""
    seen: set[str] = {joint.name for joint in robot.joints} | {"tip", *(point.name for point in robot.points)}
    brought: dict[str, Any] = {}
    for node in _nodes(robot):
        if node.name in seen:
            got, expected = f"the name `{node.name}` again", "a name that no joint, point or other block has"
            yield Issue(f"{node.path}.name", got, expected, "rename it")
        seen.add(node.name)
        for name, signal in node.block.given.items():
            if brought.setdefault(name, signal) != signal:
                got, expected = "another signal on top of the same command", "one block that adds to each command"
                yield Issue(f"{node.path}.block.signals", got, expected, "let it add to the sum of the other block")
    try:
        network(robot)
    except CycleError as error:
        ring = " -> ".join(reversed(error.args[1]))
        expected = "blocks that do not read each other in a ring: at each instant, a sample too, each needs the other's"
        hint = "remove a wire, or write the blocks as one of your own that remembers what it gave (docs/adding.md)"
        yield Issue("control", f"the ring {ring}", expected, hint)
    yield from _commands(robot)
    yield from _links(robot)


def _links(robot: Any) -> Iterator[Issue]:
    """Sensors of strains and inner forces are on links that bend."""
    bend = {link.name: link.beam is not None for link in robot.links}
    known = f"a link with a beam: {', '.join(name for name, beam in bend.items() if beam) or 'none'}"
    for index, sensor in enumerate(robot.sensors):
        name = getattr(sensor, "link", None)
        if name is not None and not bend.get(name):
            got = f"`{name}`, which is rigid" if name in bend else f"the unknown link `{name}`"
            yield Issue(f"sensors.{index}.link", got, known, "give the link a `beam`, or name another one")


def _commands(robot: Any) -> Iterator[Issue]:
    """Each drive under position control has one law: its own, or a block's."""
    drives = {drive.joint: drive for drive in robot.drives}
    known = f"a joint with a drive: {', '.join(drives) or 'none'}"
    taken: set[str] = set()
    for index, sheet in enumerate(robot.control):
        path = f"control.{index}"
        if sheet.of and sheet.of not in drives:
            yield Issue(f"{path}.of", f"`{sheet.of}`", known, "correct the name, or add the drive")
        for k, joint in enumerate(sheet.drives):
            rivals = _commanders(robot, joint)
            other = rivals[0].name if rivals and (sheet in rivals[1:] or joint in sheet.drives[:k]) else None
            yield from _command(f"{path}.drives.{k}", joint, drives.get(joint), known, (sheet.name, other))
            taken.add(joint)
        yield from _outputs(path, sheet)
        yield from _gears(path, robot, sheet.block, drives)
    for index, drive in enumerate(robot.drives):
        if drive.controller and drive.controller.is_designed:
            hint = f"write `control: [{{name: law, drives: [{drive.joint}], block: {{...}}}}]`"
            expected = "such a law in the section `control`"
            yield Issue(f"drives.{index}.controller.type", "a law that is designed from the robot", expected, hint)
        if drive.command.is_controlled and drive.controller is None and drive.joint not in taken:
            hint = "add `controller: {type: pd, ...}`, or take the command `prescribed`"
            yield Issue(f"drives.{index}.controller", "nothing", "a controller for the command `position`", hint)


def _outputs(path: str, sheet: Any) -> Iterator[Issue]:
    """A block has as many outputs as it commands drives, and a joint where it works on one."""
    block, count = sheet.block, len(sheet.drives)
    if block.ports and count not in {0, len(block.ports)}:
        hint = "name as many joints as it has outputs"
        yield Issue(f"{path}.drives", f"{count} drives", f"{len(block.ports)}, one for each of its outputs", hint)
    elif block.needs_drives and not count:
        hint = "write `drives: [...]`, the joints that it commands"
        yield Issue(f"{path}.drives", "nothing", "at least one drive, for it has no other outputs", hint)
    elif block.needs_joint and (count > 1 or not sheet.joint):
        got, hint = f"{count} drives" if count else "nothing", "write one block for each joint, with `of` or one drive"
        yield Issue(f"{path}.{'drives' if count else 'of'}", got, "one joint, which it sees as its own", hint)


def _gears(path: str, robot: Any, block: Block, drives: Mapping[str, Any]) -> Iterator[Issue]:
    """A law of elastic joints divides by their stiffness."""
    each = [(name, joint) for joint in robot.joints for name in joint.coordinates or [joint.name]]
    rigid = [name for name, joint in each if name in drives and not joint.is_elastic]
    if block.needs_gears and rigid:
        got, hint = f"{', '.join(rigid)} with a rigid gear", "give them a `gear`, or take the law `computed_torque`"
        yield Issue(f"{path}.block.type", got, "drives with elastic gears alone, for this law winds them", hint)


def _command(path: str, joint: str, drive: Any, known: str, names: tuple[str, str | None]) -> Iterator[Issue]:
    """What keeps a block from commanding a drive; ``names``: of the block, and of one that commands it already."""
    name, other = names
    if drive is None:
        yield Issue(path, f"`{joint}`", known, "add an item with `command: position` under `drives`")
    elif drive.command is not Command.POSITION or drive.controller:
        got = "a controller of its own" if drive.controller else f"the command `{drive.command}`"
        expected = f"`command: position` without a controller, because `{name}` commands it"
        yield Issue(path, f"`{joint}` with {got}", expected, "remove one of the two")
    elif other:
        yield Issue(path, f"`{joint}`, which `{other}` commands", "a drive with one law", "remove one of the two")
