"""From the control system of a sheet to its blocks in a run: what they read, when they sample, what is designed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import floor
from typing import TYPE_CHECKING, Any, NamedTuple

from tmodes.analysis.rigid import nominal_of, rigid_model
from tmodes.equations.loop.laws import Delay, Law
from tmodes.equations.loop.outputs import Outputs
from tmodes.equations.loop.plan import BlockPlan, LoopParts, LoopPlan
from tmodes.errors import InputError
from tmodes.kinds.noted.functions import isfinite, number
from tmodes.kinds.noted.number import follow_no
from tmodes.kinds.signals.registry import Clock, constant_signal, sampled_noise
from tmodes.sheet.network import Node, network, node_of

if TYPE_CHECKING:
    from tmodes.kinds.controllers.registry import Block
    from tmodes.sheet import Robot

__all__ = ["Sampling", "control_plan", "designs", "wired_name"]

_WHOLE = 1e-9
"""A delay nearer to whole periods than this share of one is taken as whole periods."""


class Sampling(NamedTuple):
    """When a law samples: its ``period`` [s], whether that is its drive's, and by how much its output is late."""

    period: float | None = None
    timed: bool = False
    delay: Delay = Delay()
    part: float = 0.0

    @classmethod
    def of(cls, block: Block, sample_time: float | None, delay: float) -> Sampling:
        """Of a block; ``sample_time`` and ``delay`` [s] are those of its drive or its item in the sheet."""
        period, late = block.period if sample_time is None else sample_time, delay + block.lag
        if period is None:
            return cls()
        if block.period is not None and not (isfinite(period) and period > 0):
            hint = "correct the class, or leave its period out for continuous time"
            raise InputError(f"{type(block).__name__}.period", f"{period}", "a time above 0 [s]", hint)
        whole = floor(number(late) / number(period) + _WHOLE)
        part = late - whole * period
        is_late = number(part) > _WHOLE * number(period)
        return cls(period, block.period is None, Delay(whole, is_late), part if is_late else 0.0)

    def clocks(self, signals: Any, output_step: float, path: str) -> tuple[int, int]:
        """The signals with the time since the last sample, and since the last late output; -1 for none."""
        if self.period is None:
            return -1, -1
        first = signals.add(Clock(self.period, output_step), path)
        late = signals.add(Clock(self.period, output_step, self.part), path) if self.delay.late else -1
        return first, late


def wired_name(sheet: Any, joint: str) -> str:
    """The signal of a block that commands a joint's drive."""
    return node_of(sheet).signals[sheet.drives.index(joint)]


class _Rate(int):
    """The number of a signal of which the rate is read."""

    order = 1


@dataclass
class _Sources:
    """What blocks read but for the signals of each other: outputs, setpoints, gravity, noise."""

    robot: Robot
    plan: LoopPlan
    signals: Any
    outputs: Outputs
    blocks: frozenset[str]
    found: dict[str, Any]
    given: dict[str, Any]

    def add(self, name: str, node: Node) -> None:
        """Make a signal known by its name; raises :class:`tmodes.errors.InputError` for an unknown one."""
        if name in self.found:
            return
        path = f"{node.place}{'.block' if node.sheet else ''}"
        head, _, last = name.rpartition(".")
        drive = next((one for one in self.plan.drives if one.joint == head), None)
        if name in node.block.noises:
            seed, deviation = node.block.noise_of(name)
            noise = sampled_noise(node.block.period or 0.0, self.robot.integration.output_step, deviation, seed)
            self.found[name] = self.signals.add(noise, path)
        elif name in self.given:
            self.found[name] = self.signals.add(self.given[name], f"{path}.signals")
        elif last in ("reference'", "feed_forward'", "setpoint'"):
            self.add(name[:-1], node)
            self.found[name] = _Rate(self.found[name[:-1]])
        elif last == "feed_forward" and drive and drive.feed >= 0:
            self.found[name] = drive.feed
        elif head == "gravity" and last in "xyz":
            value = self.robot.gravity["xyz".index(last)]
            self.found[name] = self.signals.add(constant_signal(value), path)
        elif last == "setpoint" and drive:
            self.found[name] = drive.signal
        else:
            self.found[name] = self._output(name, path)

    def _output(self, name: str, path: str) -> Any:
        plain = name.replace(".motor.", ".")
        if name not in self.outputs and ".motor." in name and plain in self.outputs:
            name = plain  # behind a rigid gear the motor is where the joint is
        return self.outputs.find(name, path, self.blocks)


def control_plan(robot: Robot, plan: LoopPlan, signals: Any) -> tuple[tuple[BlockPlan, ...], dict[str, Any]]:
    """The blocks of a sheet in their order, and what they read; ``plan``: the rest of the run.

    ``signals`` takes the clocks and noises. Raises :class:`tmodes.errors.InputError` for an unknown name, and for an
    output that a block of continuous time cannot read because it follows from the commands of its instant.
    """
    nodes = [_designed(robot, node) for node in network(robot)]
    given = frozenset(name for node in nodes for name in node.signals)
    own = {drive.joint: drive.servo.law for drive in plan.drives if drive.servo and drive.servo.law}
    sheets = enumerate(robot.drives)
    at_drives = {f"drives.{k}.controller": own[one.joint] for k, one in sheets if one.controller and one.joint in own}
    everywhere = [*nodes, *(Node("", path, law.block, ()) for path, law in at_drives.items())]
    brought = {name: signal for node in everywhere for name, signal in node.block.given.items()}
    sources = _Sources(robot, plan, signals, Outputs(LoopParts(plan)), given, {}, brought)
    for node in everywhere:
        for name in node.block.reads:
            if name not in given:
                sources.add(name, node)
    blocks = [_block(robot, plan, node, signals, brought) for node in nodes]
    _refuse_late(everywhere, [*(block.law for block in blocks), *at_drives.values()], sources.found)
    return tuple(blocks), sources.found


def _block(robot: Robot, plan: LoopPlan, node: Node, signals: Any, given: Mapping[str, Any]) -> BlockPlan:
    """A block of the plan; ``given``: signals over time that blocks bring, by name."""
    sheet, block = node.sheet, node.block
    sampling = Sampling.of(block, *((sheet.sample_time, sheet.delay) if sheet else (None, 0.0)))
    own = next((drive for drive in plan.drives if drive.joint == node.joint), None)
    limited = bool(own and own.servo and own.servo.limit)
    fed = bool(own and own.servo and own.servo.fed) or any(f"{name}.feed_forward" in given for name in node.signals)
    model = rigid_model(robot, tuple(drive.joint for drive in plan.drives)) if block.needs_model else None
    law = Law(
        block, bool(own), outputs=len(node.ports), limited=limited, timed=sampling.timed, delay=sampling.delay,
        model=model, fed=fed,
    )  # fmt: skip
    clocks = sampling.clocks(signals, robot.integration.output_step, node.path)
    return BlockPlan(node.name, law, node.ports, law.numbers(sampling.period), node.joint, *clocks, node.drives)


def designs(known: Robot) -> dict[str, Block]:
    """The blocks that are designed for a robot as known, by their names."""
    return {node.name: _designed(known, node).block for node in network(known) if node.block.is_designed}


def _designed(robot: Robot, node: Node) -> Node:
    """The node with its block designed for the robot as known, once for each robot."""
    if not node.block.is_designed:
        return node
    from tmodes import designed_block

    known = nominal_of(robot)
    found = vars(known).setdefault("designs", {})
    if node.name not in found:
        follow_no(f"gains of `{node.name}` that are designed before the run", vars(node.block), node.sheet.delay)
        try:
            late = node.sheet.delay + node.block.lag
            found[node.name] = designed_block(known, node, late)
        except InputError as error:
            if error.which.startswith("sensors."):
                raise
            path = f"{node.place}.block.{'measured' if error.which == 'outputs' else error.which}"
            raise InputError(path, error.got, error.expected, error.hint, error.where) from error
    return node._replace(block=found[node.name].following(node.block))


def _refuse_late(nodes: list[Node], laws: list[Law], sources: dict[str, Any]) -> None:
    """Outputs that follow from the commands of their instant are read at samples alone."""
    late = {name for name, source in sources.items() if getattr(source, "late", False)}
    for node, law in zip(nodes, laws, strict=True):
        read = [name for name in law.block.reads if name in late]
        if not read or law.is_sampled:
            continue
        late |= {*node.signals}
        if not node.path.startswith("sensors.") or law.states:
            got = f"`{read[0]}` in continuous time"
            expected = "a sampled block: it follows from the commands of the same instant"
            raise InputError(f"{node.place}.sample_time", got, expected, "add `sample_time: 0.001`")
