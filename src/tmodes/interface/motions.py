"""Motions after which a robot stands still: what ``tmodes motion`` finds and prints."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, cast

from tmodes.errors import InputError
from tmodes.interface.poses import Pose, held_of
from tmodes.io.arguments import checked_arguments
from tmodes.io.printed import CommandResult, Table, written
from tmodes.io.words import meant, shown

if TYPE_CHECKING:
    from xarray import Dataset

    from tmodes import Robot as UsersRobot
    from tmodes.gradients.optimal import Found, RestToRest
    from tmodes.result.result import Result
    from tmodes.sheet import Robot

__all__ = ["Motion", "freed", "limits_of", "missed", "motion", "steady"]

Progress = Callable[[str, float], None]
Limits = Mapping[str, Mapping[str, float]]

_METHODS, _MOST_MODES = ("gradients", "collocation"), 20

_SAMPLES, _LONGEST, _FAR = 400, 5.0, 10.0
"""Samples of a check; longest time after a motion that is looked at, over its own; a large swing over the accepted."""

UNITS = {
    "duration": "s", "from": "rad, m: of the motor", "to": "rad, m: of the motor", "torque": "N*m, N, largest",
    "torque_limit": "N*m, N", "speed": "rad/s, m/s, largest, of the motor", "speed_limit": "rad/s, m/s",
    "swing_m": "m, largest distance of the tip from its rest at the goal, after the motion",
    "accepted_m": "m", "way_m": "m, of the tip from rest to rest",
}  # fmt: skip


@checked_arguments
def motion(
    robot: Robot,
    *,
    goal: Pose | None = None,
    start: Pose | None = None,
    duration: float | None = None,
    least_time: bool = False,
    method: str = "gradients",
    torque: Pose | None = None,
    speed: Pose | None = None,
    modes: int = 5,
    tolerance: float | None = None,
    out: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
    progress: Progress = lambda stage, share: None,
) -> Motion:
    """From rest to rest without swing: torques of the drives after which the whole robot, as it bends, stands still.

    ``start`` and ``goal``: joints by name [rad, m], ``shoulder=0.4,elbow=-60deg``, of a joint behind an elastic gear
    its motor; by default from where the drives of the sheet begin to where they end. ``duration`` [s]: by default of
    the sheet's own move. ``least_time``: the shortest one, to 2 %, searched from there. ``method``: ``gradients``, or
    ``collocation``: torques of least mean square, or of the least time, linear between even rows, by Hermite-Simpson
    and IPOPT (:mod:`tmodes.equations.loop.collocation`), of robots with few coordinates. ``torque`` [N*m, N] and
    ``speed`` [rad/s, m/s]: limits of the drives by joint, by default those of the sheet (``limits``). ``modes``: how
    many modes at the goal have harmonics of their own among the torques. ``tolerance``: swing of the tip that is
    accepted [m], by default 5e-7 of its distance from the base. ``out``: a file for the robot with these torques, as a
    data sheet; ``overwrite`` what is there.

    Loads act as at time 0 all along: how they change later is a disturbance, which no torque plans for.

    Of the nominal robot, with all its elasticity, by exact derivatives of its runs (:mod:`tmodes.gradients.optimal`);
    checked by a run in open loop, and by one with more functions of the links. Where nothing is within the tolerance
    and the limits, what comes nearest is returned with a warning. The problem: A. De Luca, G. Di Giovanni, Rest-to-rest
    motion of a one-link flexible arm, IEEE/ASME Int. Conf. on Advanced Intelligent Mechatronics, 2001.

    Raises :class:`tmodes.errors.InputError` for what is no such motion, and :class:`tmodes.errors.SimulationError`
    where there is no rest at an end, or no least time, and :class:`tmodes.errors.ResultFileError` where the file cannot
    be written.

    >>> found = tmodes.load("spong1987").motion(start={"joint": 0}, goal={"joint": 1.0}, duration=1.0)
    >>> found.swing < 1e-6
    True
    """
    from tmodes.gradients.collocation import collocated
    from tmodes.gradients.least_time import least_time as shortest
    from tmodes.gradients.optimal import RestToRest

    robot = robot.pathless
    freed(robot)
    if method not in _METHODS:
        hint = meant(method, _METHODS, "take one of these")
        raise InputError("--method", shown(method), f"one of {', '.join(_METHODS)}", hint)
    if not 1 <= modes <= _MOST_MODES:
        raise InputError("--modes", str(modes), f"1 to {_MOST_MODES} modes", "5 is the usual")
    first, last, time = _ends(robot, start, goal, duration)
    limits = {
        "torque": limits_of(robot, torque, "--torque", "effort", [*last]),
        "speed": limits_of(robot, speed, "--speed", "speed", [*last]),
    }

    calm = steady(robot)

    def move(seconds: float) -> RestToRest:
        return RestToRest(calm, first, last, seconds, modes=modes, torque=limits["torque"], speed=limits["speed"])

    def tell(share: float) -> None:
        progress("motion", share)

    trial = move(time)
    allowed = trial.accepted if tolerance is None else tolerance
    if not allowed > 0:
        raise InputError("--tolerance", f"{allowed:g}", "a swing above 0 m", "leave it out for 5e-7 of the reach")
    if method == "collocation":
        trial, found = collocated(calm, move, time, allowed, least_time=least_time, progress=tell)
    elif least_time:
        trial, found = shortest(move, time, allowed, tell)
    else:
        found = trial.solve(allowed, progress=tell)
    progress("check", 0.0)
    made = _checked(calm, robot, trial, found, allowed, limits)
    if out is not None:
        from tmodes.io.atomic import atomic_write
        from tmodes.io.sheet_write import robot_to_yaml

        with atomic_write(out, overwrite=overwrite) as path:
            path.write_text(robot_to_yaml(made.robot), encoding="utf-8")
    return made


def freed(robot: Robot) -> None:
    """Raise :class:`tmodes.errors.InputError` for a robot in contact."""
    if robot.contact:
        raise InputError("contact", "a robot in contact", "one in free space", "set `contact: false`")


def missed(found: Found, swing: float, accepted: float) -> list[str]:
    """What is not as asked for: a swing [m], linear or of a run, that is not accepted; limits that are passed."""
    more, warnings = "give more time, higher limits or more modes", list[str]()
    if max(found.swing, swing / _FAR) > accepted:
        swings = f"the tip swings by {written(swing, 'm')}, {written(accepted, 'm')} is accepted"
        warnings.append(f"{swings}: no motion was found that does better; {more}")
    if found.excess:
        warnings.append(f"a limit is passed by {found.excess:.2g} of it: no motion was found that keeps it; {more}")
    return warnings


def _ends(
    robot: Robot, start: Pose | None, goal: Pose | None, duration: float | None
) -> tuple[dict[str, float], dict[str, float], float]:
    """Start and goal of each joint that is moved or held, and the time [s]; by default those of the sheet's drives."""
    moves = {drive.joint: drive.signal for drive in robot.drives if drive.command.is_motion}
    given = [_of_joints(robot, pose, which) for pose, which in ((start, "--start"), (goal, "--goal"))]
    ends = [end for signal in moves.values() if (end := signal.move_ends()) is not None]
    time = duration or max(ends, default=0.0)
    if not 0 < time < math.inf:
        hint = "give it: --duration 1.5"
        raise InputError("--duration", shown(duration), "a time above 0 s; no drive of the sheet has a move", hint)
    joints = [*dict.fromkeys([*moves, *given[0], *given[1]])]
    if not joints:
        raise InputError("--goal", "nothing", "a goal of a joint, as no drive has a move", "write --goal JOINT=VALUE")
    own = {joint: signal.schedule(max(time, *ends, 0.0)) for joint, signal in moves.items()}
    known = robot.initial.coordinates
    first, last = (
        {joint: float(own[joint].at(at)) if joint in own else known.get(f"{joint}.motor", known.get(joint, 0.0))
         for joint in joints} | some
        for at, some in zip((0.0, max(time, *ends, 0.0)), given, strict=True)
    )  # fmt: skip
    last = {joint: first[joint] if joint not in own and joint not in given[1] else last[joint] for joint in joints}
    if first == last:
        raise InputError("--goal", "where it starts", "a goal that differs from the start", "write --goal JOINT=VALUE")
    return first, last, time


def _of_joints(robot: Robot, pose: Pose | None, which: str) -> dict[str, float]:
    """Values by joint, of joints that a motor or an effort can move."""
    driven = [axis.name for axis in robot.undriven.chain().axes if axis.drive.takes_effort]
    found = held_of(pose, robot, which)
    for name in found:
        if name not in driven:
            hint = meant(name, driven, "name a joint that a motor moves")
            raise InputError(which, shown(name), f"joints with a drive: {', '.join(driven)}", hint)
    return found


def limits_of(robot: Robot, given: Pose | None, which: str, name: str, joints: Sequence[str]) -> dict[str, float]:
    """Limits by joint: those of the sheet, and those that are given in their place."""
    own = {joint.name: getattr(joint.limits, name) for joint in robot.joints if joint.limits}
    found = {joint: value for joint, value in own.items() if value is not None and joint in joints}
    units = {"effort": ("N*m", "N"), "speed": ("rad/s", "m/s")}[name]
    for joint, value in held_of(given, robot, which, units).items():
        if joint not in joints:
            raise InputError(which, shown(joint), f"joints that are moved: {', '.join(joints)}", "correct the name")
        if value <= 0:
            raise InputError(f"{which} {joint}", f"{value:g}", "a limit above 0", "correct the value")
        found[joint] = value
    return found


def steady(robot: Robot) -> Robot:
    """The robot whose loads stay as they are at time 0."""
    from tmodes.kinds.signals.registry import constant_signal

    end, loads = robot.integration.duration, list(robot.loads)
    for k, load in enumerate(loads):
        if load.signal is not None:
            first = constant_signal(float(load.signal.schedule(end).at(0.0)))
            loads[k] = load.model_copy(update={"signal": first})
    return robot.model_copy(update={"loads": tuple(loads)})


def _checked(robot: Robot, sheet: Robot, move: RestToRest, found: Found, accepted: float, limits: Limits) -> Motion:
    """Runs in open loop of what was found: as it is, with more functions of the links; and with motors on a quintic."""
    from tmodes.analysis.modes.of_sheet import finer
    from tmodes.gradients.optimal import under_torques
    from tmodes.kinds.signals.registry import quintic_move
    from tmodes.result.run import run
    from tmodes.sheet.parts import Command, DriveSheet

    torques = found.signals(move.joints)
    slowest = min((one for one in move.goal.frequencies if one * move.duration > 1), default=math.inf)
    until = move.duration + min(2 * math.pi / slowest + move.duration / 2, _LONGEST * move.duration)

    def ran(one: Robot, drives: tuple[DriveSheet, ...] = ()) -> tuple[Robot, Result, float]:
        """Robot, run and swing."""
        driven, _ = under_torques(one, move.start, torques, until)
        rest = under_torques(one, move.end, torques, until)[1]
        settings = {"output_step": until / _SAMPLES, "error_estimate": False, "model_error": False}
        update = {"integration": driven.integration.model_copy(update=settings)} | (
            {"drives": drives} if drives else {}
        )
        result = run(driven.model_copy(update=update))
        after = result.data["tip"].values[result.data["time"].values >= move.duration]
        return driven, result, float(((after - rest.model.pose(rest.q)[0][0]) ** 2).sum(axis=1).max() ** 0.5)

    given = tuple(
        DriveSheet(joint=joint, command=Command.PRESCRIBED, signal=quintic_move(move.start[joint], end, move.duration))
        for joint, end in move.end.items()
    )
    driven, result, swing = ran(robot)
    swings = {"planned": swing}
    if more := finer(robot):
        swings["finer"] = ran(more)[2]
    swings["quintic"] = ran(robot, given)[2]
    made = cast("UsersRobot", driven.model_copy(update={"real": sheet.real, "loads": sheet.loads}))
    return Motion(made, sheet, move, found, result, swings, accepted, limits)


@dataclass(frozen=True, eq=False, repr=False)
class Motion(CommandResult):
    """A motion from rest to rest; ``robot``: driven by the torques that were found, in open loop.

    ``move``: what was asked; ``found``: the torques and how well they do; ``result``: the run of the nominal robot by
    them; ``swings`` [m]: how far the tip then is from where it should stand: of the robot as ``planned``, with more
    functions of its links (``finer``), and where motors follow a ``quintic`` exactly in the same time.
    """

    robot: UsersRobot = field(repr=False)
    sheet: Robot = field(repr=False)
    move: RestToRest
    found: Found
    result: Result
    swings: Mapping[str, float]
    accepted: float
    limits: Limits

    @property
    def swing(self) -> float:
        """Largest distance of the tip from its rest at the goal after the motion [m], of the robot as planned."""
        return self.swings["planned"]

    @property
    def duration(self) -> float:
        """Time of the motion [s]."""
        return self.move.duration

    @property
    def followed(self) -> UsersRobot:
        """The robot of the sheet, whose controllers follow the motors of this motion; without feed-forward.

        Raises :class:`tmodes.errors.InputError` where a joint that moves has no controller.
        """
        from tmodes.gradients.optimal import table

        motors, drives = self.data["motor"], {drive.joint: drive for drive in self.sheet.drives}
        for joint in self.move.joints:
            if joint not in drives or not drives[joint].command.is_controlled:
                hint = "give its drive a controller and `command: position`"
                raise InputError("drives", f"no controller of {joint}", "a controller of each joint that moves", hint)
            course = table(motors["time"].values, motors.sel(joint=joint).values)
            drives[joint] = drives[joint].model_copy(update={"signal": course})
        settings = self.robot.integration
        changes = {"drives": tuple(drives.values()), "integration": settings}
        return cast("UsersRobot", self.sheet.model_copy(update=changes))

    @property
    def warnings(self) -> list[str]:
        """What is to be known about this motion."""
        found = list[str]()
        if any(load.signal is not None and load.signal.type != "constant" for load in self.sheet.loads):
            found.append("loads of the sheet that change over time are planned for as at time 0")
        found += missed(self.found, self.swing, self.accepted)
        if (fine := self.swings.get("finer", 0.0)) > _FAR * max(self.accepted, self.swing):
            found.append(
                f"with more functions of its links the tip swings by {written(fine, 'm')}: plan with more functions"
            )
        return found

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes motion --json`` prints it; ``signals``: of the drives, as a sheet has them."""
        signals = {drive.joint: drive.signal.model_dump(mode="json") for drive in self.robot.drives}
        return {
            "robot": self.robot.name, "units": UNITS, "duration": self.duration, "way_m": self._way,
            "joints": self._joints(), "swing_m": dict(self.swings), "accepted_m": self.accepted,
            "runs": self.found.runs, "runs_with_slopes": self.found.slopes, "warnings": self.warnings,
            "signals": {joint: signals[joint] for joint in self.move.joints},
        }  # fmt: skip

    @property
    def _way(self) -> float:
        first, last = self.move.tips
        return float(((last - first) ** 2).sum() ** 0.5)

    def _joints(self) -> list[dict[str, Any]]:
        data = self.data
        return [
            {"joint": joint, "from": self.move.start[joint], "to": self.move.end[joint]}
            | {
                key: value
                for name, series in (("torque", "torque"), ("speed", "motor_speed"))
                for key, value in (
                    (name, float(abs(data[series].sel(joint=joint)).max())),
                    (f"{name}_limit", self.limits[name].get(joint)),
                )
            }
            for joint in self.move.joints
        ]

    @property
    def data(self) -> Dataset:
        """Over ``time`` [s]: ``torque`` [N*m, N], ``motor`` [rad, m] and ``motor_speed`` of each ``joint``.

        The reference: coordinates and rates, ``q`` and ``v`` by ``coordinate``, and the ``tip`` (time, axis) [m].
        """
        from xarray import Dataset

        known, joints = self.result.data, self.move.joints
        times, names = known["time"].values, [known["coordinate"].values[place] for place in self.move.places]
        drives = {drive.joint: drive.signal.schedule(self.duration).until(times[-1]) for drive in self.robot.drives}
        motors = {name: known[name].sel(coordinate=names).values for name in ("q", "v")}
        return Dataset(
            {
                "torque": (("time", "joint"), [[float(drives[joint].at(t)) for joint in joints] for t in times]),
                "motor": (("time", "joint"), motors["q"]), "motor_speed": (("time", "joint"), motors["v"]),
                **{name: known[name] for name in ("q", "v", "tip")},
            },
            {"joint": joints},
        )  # fmt: skip

    def plot(self, ax: Any = None) -> list[Any]:
        """The torques over time."""
        from tmodes.plot.commands import points

        data, joints = self.data, self.move.joints
        lines = {joint: (data["time"], data["torque"].sel(joint=joint)) for joint in joints}
        return points(lines, "time [s]", "torque [N·m, N]", title=self._sentence(), ax=ax, line="-", marks=False)

    def _sentence(self) -> str:
        return f"{self.robot.name}: rest to rest in {self.duration:.4g} s, tip {written(self._way, 'm')} on"

    def tables(self) -> Iterator[str | Table]:
        """Joints with their limits, and how far the tip swings afterwards."""
        rows = [[one["joint"], *("-" if one[key] is None else f"{one[key]:.4g}" for key in list(one)[1:])]
                for one in self._joints()]  # fmt: skip
        columns = ["joint", "from", "to", "torque", "limit", "speed", "limit"]
        yield Table(self._sentence(), columns, rows)
        words = {"planned": "as planned", "finer": "with more functions of its links",
                 "quintic": "its motors on a quintic, exactly"}  # fmt: skip
        swings = [[words[name], written(value, "m")] for name, value in self.swings.items()]
        yield Table("Largest distance of the tip from its rest at the goal afterwards", ["robot", "swing"], swings)
