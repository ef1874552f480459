"""From the data sheet of a robot to what happens in a run: the plan of the closed loop, and its signals over time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from enum import StrEnum
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.rigid import driven_joints, rigid_model
from tmodes.chain.chain import Axis, Chain
from tmodes.equations.loop.contact_kernels import Touch
from tmodes.equations.loop.control_kernels import LIMITS, Servo, Winding
from tmodes.equations.loop.plan import BlockPlan, DrivePlan, LoadPlan, LoopPlan, TouchPlan, winding_of
from tmodes.errors import InputError
from tmodes.kinds.drives.contract import DriveKind
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.noted.functions import array, number
from tmodes.kinds.signals.registry import Jolts, MergedSchedule, constant_signal, merge
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.sheet.network import commander, commands_effort
from tmodes.sheet.parts import Command, DriveSheet, InitialState, LoadFrame
from tmodes.simulation.control import Sampling, control_plan, wired_name

if TYPE_CHECKING:
    from tmodes.sheet import Robot

__all__ = [
    "WAYS",
    "Follow",
    "Planned",
    "free_drive",
    "initial_value",
    "loose_drive",
    "planned",
    "refuse_jumps",
    "refuse_massless",
    "refuse_path",
]


class Follow(StrEnum):
    """Which drives follow their signals exactly."""

    SHEET = "sheet"  # those that the sheet says
    WANTED = "wanted"  # every position: the nominal run, in which all motors are where they should be
    HELD = "held"  # none: all stand where they are at first, and so does the base


@dataclass(frozen=True, eq=False)
class Planned:
    """A chain in a run, its plan, and its signals.

    Joints without a drive: ``undriven`` ones are held at their first value; those of ``loose`` have an initial rate and
    move freely with it, their motors without torque.

    ``signals``: all on common knots; ``each``: what the sheet says of them, one by one; ``pieces``: each on its own.
    Where numbers are noted, those of ``pieces`` are, and ``signals`` have none: common knots have no fixed structure.
    """

    chain: Chain
    plan: LoopPlan
    schedule: SignalPieces
    signals: MergedSchedule
    undriven: tuple[str, ...]
    each: tuple[Any, ...] = ()
    loose: tuple[str, ...] = ()
    pieces: tuple[SignalPieces, ...] = ()

    @property
    def noises(self) -> list[int]:
        """The signals that are noise: on setpoints, and of sensors."""
        found = [drive.noise for drive in self.plan.drives if drive.noise >= 0]
        return found + [k for k, one in enumerate(self.each) if getattr(one, "is_noise", False)]

    @property
    def clocks(self) -> list[tuple[int, Any]]:
        """The signals with the time since a sample."""
        return [(k, one) for k, one in enumerate(self.each) if getattr(one, "is_clock", False)]

    @property
    def first_row(self) -> NDArray[np.float64]:
        """The row of the signals at time 0."""
        if not any(piece.is_noted for piece in self.pieces):
            return self.schedule.rows_at(np.zeros(1))[0]
        rows = [np.pad(one.coefficients[0], (0, self.plan.degree - one.degree)) for one in self.pieces]
        return array(np.concatenate([[0.0], *rows]))

    def signals_at_start(self, derivative: int) -> NDArray[np.float64]:
        """Values (signals,) of all signals, or of a derivative, at time 0."""
        if not any(piece.is_noted for piece in self.pieces):
            return self.signals.at(0.0, derivative)
        return array([number(piece.at(0.0, derivative)) for piece in self.pieces])


@dataclass(eq=False)
class _Signals:
    """Schedules of signals up to ``until`` [s], of moves that end up to ``whole``, each with its number."""

    until: float
    whole: float
    schedules: list[SignalPieces] = field(default_factory=list)
    info: list[Any] = field(default_factory=list)

    def end(self, signal: Any) -> float:
        """Up to when a signal is planned [s]."""
        return self.until if signal.move_ends() is None else self.whole

    def add(self, signal: Any, path: str, until: float | None = None) -> int:
        self.info.append(signal)
        try:
            self.schedules.append(signal.schedule(self.end(signal) if until is None else until))
        except InputError as error:
            raise InputError(f"{path}.{error.which}", error.got, error.expected, error.hint, error.where) from error
        return len(self.schedules) - 1


def planned(
    robot: Robot, follow: Follow = Follow.SHEET, like: Chain | None = None, whole: float | None = None
) -> Planned:
    """The plan of a robot's run over ``integration.duration``; ``like``: the chain of another plan of the same arm.

    ``whole``: up to when the pieces of moves that end are planned [s], in place of the end of the run.

    Raises :class:`tmodes.errors.InputError` for a signal without a value, a contact that cannot be, and functions of a
    beam that no mass resists.
    """
    refuse_massless(robot)
    duration = robot.integration.duration
    signals = _Signals(duration, duration if whole is None else whole)
    sheets = {drive.joint: (index, drive) for index, drive in enumerate(robot.drives)}
    chain = like or robot.undriven.chain()
    drives, joints, undriven, loose = [], {}, [], []
    for node in chain.nodes:
        kinds = []
        for axis in node.joint.axes:
            kinds.append(axis.drive)
            if axis.drive.is_driven:
                index, sheet = sheets.get(axis.name, (-1, loose_drive(robot, axis)))
                if axis.name not in sheets:
                    (undriven if sheet is None else loose).append(axis.name)
                drives.append(_drive(robot, axis, index, sheet, signals, follow))
                kinds[-1] = _kind(axis, drives[-1])
        braked = any(drive.brake >= 0 and drive.joint == axis.name for drive in drives for axis in node.joint.axes)
        joints[node.joint.name] = (node.joint.braked() if braked else node.joint).driven_by(*kinds)
    nodes = tuple(replace(node, joint=joints.get(node.joint.name, node.joint)) for node in chain.nodes)
    chain = replace(chain, nodes=nodes)
    names = [point.name for point in chain.points]
    loads = tuple(_loads(robot, names, signals))
    base = () if follow is Follow.HELD else tuple(_base(robot, signals))
    touch = _touch(robot, chain, names, follow)
    jolts = () if follow is Follow.HELD else tuple(_jolts(robot, chain, drives, base, signals))
    blocks: tuple[BlockPlan, ...] = ()
    sources: dict[str, Any] = {}
    if follow is Follow.SHEET and (robot.sensors or robot.control or any(_reads(drive) for drive in drives)):
        bare = LoopPlan(chain, tuple(drives), len(signals.schedules), 1, loads, touch, base)
        blocks, sources = control_plan(robot, bare, signals)
    if jolts:  # a jump at the very end is after the run
        signals.schedules = [
            schedule.until(signals.until) if whole is None else schedule for schedule in signals.schedules
        ]
    merged = merge([each.plain() for each in signals.schedules]) if signals.schedules else _nothing(signals.until)
    if any(each.is_noted for each in signals.schedules):
        merged = MergedSchedule(merged.knots, np.full_like(merged.coefficients, np.nan))
    plan = LoopPlan(
        chain, tuple(drives), len(signals.schedules), merged.degree, loads, touch, base, jolts, blocks, sources
    )
    return Planned(chain, plan, merged.schedule, merged, tuple(undriven), tuple(signals.info), tuple(loose),
                   tuple(signals.schedules))  # fmt: skip


def refuse_massless(robot: Robot) -> None:
    """Raise :class:`tmodes.errors.InputError` for functions of a beam without mass: they have modes, but no runs."""
    for link in robot.links:
        for path, *issue in link.beam.massless_issues() if link.beam else ():
            raise InputError(f"links.{link.name}.beam.{path}", *issue)


def refuse_path(robot: Robot) -> None:
    """Raise :class:`tmodes.errors.InputError` for the path of a task that no drive follows yet."""
    if robot.task and robot.task.paths:
        hint = "take the pair of robot.commanded()"
        raise InputError("task.path", "a path that no drive follows", "left out where both robots are given", hint)


def free_drive(joint: str, *, has_motor: bool) -> DriveSheet:
    """No torque of the motor, no effort on a joint without one."""
    command = Command.TORQUE if has_motor else Command.EFFORT
    return DriveSheet(joint=joint, command=command, signal=constant_signal(0.0))


def loose_drive(robot: Robot, axis: Axis) -> DriveSheet | None:
    """The drive of a joint that has none but an initial rate; None where it stands and is held."""
    if any(robot.initial.rates.get(name) for name in (axis.name, f"{axis.name}.motor")):
        return free_drive(axis.name, has_motor=axis.joint.motor is not None)
    return None


def _nothing(until: float) -> MergedSchedule:
    return MergedSchedule(np.array([0.0, until]), np.zeros((1, 0, 1)))


def initial_value(robot: Robot, joint: str) -> float:
    """Where a joint's motor is at time 0: as `initial` says, else its first wanted position, else 0."""
    info = robot.initial.coordinates
    for name in (f"{joint}.motor", joint):
        if name in info:
            return info[name]
    sheet = next((drive for drive in robot.drives if drive.joint == joint), None)
    if sheet and sheet.command.is_motion:
        end = sheet.signal.move_ends(2.0)  # which does not depend on where the run ends
        return number(sheet.signal.schedule(robot.integration.duration if end is None else end).at(0.0))
    return 0.0


def _drive(
    robot: Robot, axis: Axis, index: int, sheet: DriveSheet | None, signals: _Signals, follow: Follow
) -> DrivePlan:
    winding, numbers = winding_of(axis.joint.motor)
    if sheet is None or follow is Follow.HELD:
        held = constant_signal(initial_value(robot, axis.name))
        return DrivePlan(axis.name, signals.add(held, "initial"), None, winding, numbers)
    command = sheet.command
    exact = command is Command.PRESCRIBED or (follow is Follow.WANTED and command.is_motion)
    signal = signals.add(sheet.signal, f"drives.{index}.signal")
    motion = signals.add(sheet.motion, f"drives.{index}.motion") if sheet.motion and command.is_motion else -1
    if exact:
        return DrivePlan(axis.name, signal, None, winding, numbers, motion=motion)
    noise, feed = (
        signals.add(one, f"drives.{index}.{name}") if one and command.is_controlled else -1
        for name, one in (("noise", sheet.disturbance), ("feed_forward", sheet.feed_forward))
    )
    brake = signals.add(sheet.brake, f"drives.{index}.brake") if sheet.brake else -1
    volts = command is Command.VOLTAGE or (command.is_controlled and not commands_effort(robot, sheet))
    driven = winding is not Winding.NONE and volts
    sampling = Sampling.of(sheet.controller, sheet.sample_time, sheet.delay) if sheet.controller else Sampling()
    limits = {
        name: getattr(sheet.saturation, name) for name in LIMITS if getattr(sheet.saturation, name, None) is not None
    }
    command_of = commander(robot, axis.name) if command.is_controlled else None  # a torque that is given is no block's
    wire = "" if command_of is None else wired_name(command_of, axis.name)
    needs = sheet.controller and sheet.controller.needs_model
    model = rigid_model(robot, driven_joints(robot)) if needs else None
    servo = Servo(
        sheet.controller, driven, winding, noisy=noise >= 0, timed=sampling.timed, delay=sampling.delay,
        limits=tuple(limits), wired=bool(wire), fed=feed >= 0, model=model,
    )  # fmt: skip
    own = servo.numbers(numbers, tuple(limits.values()), sampling.period or 0.0)
    clocks = sampling.clocks(signals, robot.integration.output_step, f"drives.{index}.controller")
    return DrivePlan(
        axis.name, signal, servo, winding, own, noise, *clocks, command=wire, motion=motion, feed=feed, brake=brake
    )  # fmt: skip


def _reads(drive: DrivePlan) -> bool:
    return bool(drive.servo and drive.servo.controller and drive.servo.controller.reads)


def _kind(axis: Axis, plan: DrivePlan) -> DriveKind:
    """An elastic gear keeps its motor's coordinate, moved as given or by a servo; a rigid one has none."""
    return drive_kind("prescribed") if plan.servo is None and not axis.drive.has_motor else axis.drive


def _loads(robot: Robot, names: list[str], signals: _Signals) -> Iterator[LoadPlan]:
    for index, load in enumerate(robot.loads):
        signal = signals.add(load.signal, f"loads.{index}.signal") if load.signal else -1
        wrench = (*load.force, *load.moment)
        yield LoadPlan(names.index(load.point), load.frame is LoadFrame.SECTION, wrench, signal)


WAYS = ("x", "y", "z", "roll", "pitch", "yaw")
"""The motions of the base by name."""


def _base(robot: Robot, signals: _Signals) -> Iterator[int]:
    if robot.base_motion is None:
        return
    still = constant_signal(0.0)
    for name in WAYS:
        yield signals.add(getattr(robot.base_motion, name) or still, f"base_motion.{name}")


def _jolts(
    robot: Robot, chain: Chain, drives: list[DrivePlan], base: tuple[int, ...], signals: _Signals
) -> Iterator[tuple[int, int]]:
    """Signals of given motions whose rates jump, and the signals of these jumps.

    A joint whose motion is given stands still before time 0, where no other initial rate is given than those of such
    joints, and its signal is no motion at constant speed; the robot moves with its base then. A motor behind an elastic
    gear moves nothing but its rotor at once.
    """
    prescribed = {drive.joint for drive in robot.drives if drive.command is Command.PRESCRIBED}
    from_rest = set(robot.initial.rates) <= {name for joint in prescribed for name in (joint, f"{joint}.motor")}
    given = dict.fromkeys(base, False)
    places = {drive.joint: drive.signal for drive in drives}
    for axis in chain.axes:
        if axis.name in prescribed and (axis.drive.is_given or (axis.joint.motor and axis.joint.motor.inertia)):
            given[places[axis.name]] = axis.drive.is_given and from_rest
    for signal, rests in given.items():
        jumps = Jolts(signals.info[signal], rests and not signals.info[signal].is_steady)
        end = signals.end(signals.info[signal])
        if jumps.jump(end):
            yield signal, signals.add(jumps, "jolts", end)


def refuse_jumps(robot: Robot, plan: Planned) -> None:
    """Raises :class:`tmodes.errors.InputError` where a joint or the base would have to jump in position."""
    rigid = {axis.name for axis in plan.chain.axes if axis.drive.is_given}
    places = {drive.joint: drive.signal for drive in plan.plan.drives}
    given = {
        places[drive.joint]: f"drives.{index}.signal"
        for index, drive in enumerate(robot.drives)
        if drive.command is Command.PRESCRIBED and drive.joint in rigid
    }
    given |= {k: f"base_motion.{name}" for k, name in zip(plan.plan.base, WAYS, strict=False)}
    for place, path in given.items():
        if len(jumps := plan.pieces[place].jumps()):
            got = f"a jump in position at t = {jumps[0]:.6g} s"
            hint = "move there in a short time, or let a controller follow it (`command: position`)"
            raise InputError(path, got, "a motion without jumps in position, which no finite force gives", hint)


def _touch(robot: Robot, chain: Chain, names: list[str], follow: Follow) -> TouchPlan | None:
    sheet = robot.contact
    if sheet is None:
        return None
    point = names.index(sheet.point)
    info = chain.points[point]
    if sheet.moving_mass > 0 and info.s < 1 and chain.nodes[info.node].link.has_stations:
        hint = "remove `mass`, or take another point"
        raise InputError("contact.mass", "a mass at a point inside a beam", "a point at the tip of a link", hint)
    touch = Touch(sheet.resting() if follow is Follow.HELD else sheet)
    return TouchPlan(point, touch, touch.numbers(chain.gravity))


def starts_at_rest(robot: Robot) -> bool:
    """Whether a run begins in equilibrium, of the closed loop or with held motors."""
    return robot.initial.state is not InitialState.ZERO
