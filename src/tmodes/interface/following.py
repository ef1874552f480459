"""References along paths: what ``tmodes follow`` computes and prints."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tmodes.errors import InputError
from tmodes.interface.files import write_files
from tmodes.io.arguments import checked_arguments
from tmodes.io.assignment import parse_assignment
from tmodes.io.printed import CommandResult, Table
from tmodes.kinds.signals.registry import Signal
from tmodes.sheet.task import ENDS, ReferenceKind

if TYPE_CHECKING:
    from xarray import Dataset

    from tmodes.analysis.follow import Followed
    from tmodes.interface.references import Reference
    from tmodes.sheet import Robot
    from tmodes.sheet.task import Task

__all__ = ["Following", "commanded_robot", "follow"]

UNITS = {
    "duration_s": "s", "lead_s": "s", "tip_error_m": "m", "swing_m": "m, after it",
    "length": "m; rad of a turn, and of a path of the joints",
    "error_m": "m, the rigid robot's tip",
    "turned_rad": "rad, the rigid robot's tip; of a path of the joints these themselves", "speed": "rad/s, m/s",
    "acceleration": "rad/s^2, m/s^2",
}  # fmt: skip

PROFILE = {"type": "s_curve", "speed": 0.25, "acceleration": 1.0, "jerk": 10.0}
"""The profile where none is given: what is gentle for a robot of a metre."""

_SAMPLES, _CHECKS = 400, ("checks", "swings")

_OF_MOVES = {"start": "from", "end": "to", "speed": "largest speed", "acceleration": "largest acceleration"}
"""Numbers of a move of a joint, and their heads."""

_BY_TIME = {"duration": 1, "speed": -1, "acceleration": -2, "jerk": -3}
"""Numbers of profiles, and with which power of a factor on the time they grow."""

_TRIALS, _DOUBLINGS, _CLOSE = 14, 7, 0.01
"""Of the search for the least time: how many there usually are, doublings at most, within which share it is found."""

SMOOTH = (ReferenceKind.INVERSE, ReferenceKind.OPTIMAL)
"""References that want a profile with smooth derivatives."""

Group = str | Mapping[str, Any]
Progress = Callable[[str, float], None]


@checked_arguments
def follow(
    robot: Robot,
    path: Group | Sequence[Group] | None = None,
    *,
    profile: Group | None = None,
    reference: str | None = None,
    least_time: bool | None = None,
    shaper: Group | None = None,
    fit: float | None = None,
    out: str | os.PathLike[str] | None = None,
    figure: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
    progress: Progress = lambda stage, share: None,
) -> Following:
    """References of a path of the tip, or of the joints, and the robot whose drives follow it.

    The arguments are keys of the sheet's ``task``, and go before what it says; what neither has is as below. A run of
    a sheet with such a task follows the same references.

    ``path``: a group such as ``{"type": "line", "to": [0.6, 0.0, 0.2]}`` [m], or text like it; several follow one
    another, each from rest to rest. Kinds: line, arc, via (points with rounded corners), turn, joints, or your own;
    with ``rpy`` the tip turns to there on the shortest way. ``profile``: speed profile along the path, a signal without
    start and end, which become 0 and the length, such as ``{"type": "s_curve", "speed": 0.5, "acceleration": 2.0,
    "jerk": 40.0}`` [m/s, ...]; gentle for a robot of a metre if left out; or a timing within the limits of the rigid
    robot's joints: ``{"type": "jerk_limited", "jerk": 100.0}``, an S-curve, or ``{"type": "toppra"}``, the least
    time (extra `planning`). It starts where the first commands put the rigid robot, whose inverse kinematics gives the
    joints; ``fit`` [m, rad; 1e-7]: of its tip between the rows of the references.

    ``reference``: setpoints of the motors. ``rigid``, the default: the joints of the rigid robot. ``motors``: these,
    and the efforts that keep the motors exactly on them, from a run of the whole robot as known. ``sag``: motors go
    where the tip of the robot as it bends is on the path at rest, under weight and loads, with their efforts.
    ``quasi_static``: under weight, loads and the inertia of the motion, as if what bends did not swing (the stationary
    part of the paper's solution). ``inverse``: motions and efforts with which the tip of the moving robot is on the
    path, in contact too (:mod:`tmodes.analysis.inversion`); they may begin before the path does. ``optimal``: in the
    time of the path, within the limits of speed and effort of the sheet, from rest at its start to rest at its end
    without swing, in between as near to it as that leaves open, by exact derivatives of runs
    (:mod:`tmodes.gradients.optimal`). Runs of the nominal robot say what that is worth (``checks``, ``swings``).
    ``least_time``: the profile made faster or
    slower, to 1 %, until a motor is at its limit of speed or effort (``limits`` of the sheet); of ``optimal`` the
    shortest motion that is found within them, to 2 %, where the path between the ends gives way. ``shaper``: of the way
    along the path, so that the tip stays on it and a mode does not ring after it, such as ``{"type": "zvd"}``; without
    ``frequencies`` [Hz] for the robot's first mode, in the middle between its lowest and its highest frequency on the
    path. ``out``: a file for the sheet; ``figure``: one for the references.

    Raises :class:`tmodes.errors.InputErrors` with all that is wrong in the task,
    :class:`tmodes.errors.InputError` for a path that the rigid robot does not reach, or that passes a singular
    pose, and :class:`tmodes.errors.ResultFileError` where a file cannot be written. Source: B. Siciliano, L. Sciavicco,
    L. Villani, G. Oriolo, Robotics: Modelling, Planning and Control (2009), ch. 3 and 4.

    >>> found = tmodes.load("two_link_arm").follow({"type": "line", "to": [0.7, 0.0, 0.2]})
    >>> round(found.length, 4), found.error < 1e-7, found.robot.drives[0].signal.type
    (0.2065, True, 'trajectory')
    """
    options = {"path": path, "profile": profile, "reference": reference, "least_time": least_time, "shaper": shaper,
               "fit": fit}  # fmt: skip
    task, own = _asked(robot, options), robot.pathless
    found, given = _planned(own, task, progress)
    made = Following(robot, given.applied(own, found), found, task, given)
    if task.reference != ReferenceKind.RIGID:
        progress("check", 0.0)
        both = given.checks(own, made.robot, found)
        made = replace(made, **{key: {name: row[k] for name, row in both.items()} for k, key in enumerate(_CHECKS)})
    write_files(out, made, figure, overwrite=overwrite)
    return made


def commanded_robot(robot: Robot, progress: Progress = lambda stage, share: None) -> Robot:
    """The robot whose drives follow the path of its task, as in the sheet that :func:`follow` writes.

    Raises :class:`tmodes.errors.InputError` as it does, and for drives that have a motion of their own.
    """
    task, own = robot.task, robot.pathless
    assert task  # noqa: S101
    for drive in robot.drives:
        which, hint = f"drives.{drive.joint}", "or remove `task.path`"
        rows = drive.signal.schedule(drive.signal.move_ends() or 1.0).coefficients
        if drive.command.is_motion and (rows[:, 1:].any() or np.ptp(rows[:, 0])):
            got, expected = f"`{drive.signal.type}`, which moves", "a value that stays, from which `task.path` starts"
            raise InputError(f"{which}.signal", got, expected,
                             f"write {{type: constant, value: {rows[0, 0]:.12g}}}, {hint}")  # fmt: skip
        for name in ("motion", "feed_forward"):
            if drive.command.is_motion and getattr(drive, name) is not None:
                raise InputError(f"{which}.{name}", "given", "left out: `task.path` gives it", f"remove it, {hint}")
    found, given = _planned(own, task, progress)
    return given.applied(own, found)


def _asked(robot: Robot, options: Mapping[str, Any]) -> Task:
    """The task of the sheet, its keys in place of which the options go; read as a sheet is."""
    known = robot.task.model_dump(mode="json") if robot.task else {}
    given = {name: _plain(name, value) for name, value in options.items() if value is not None}
    if "path" not in known | given:
        hint = "add --path '{type: line, to: [0.6, 0, 0.2]}', or `task: {path: ...}` to the sheet"
        raise InputError("task.path", "nothing", "a path of the tip, or of the joints", hint)
    task = robot.with_({"task": known | given}).task
    assert task  # noqa: S101
    return task


def _plain(name: str, value: Any) -> Any:
    """Plain data of an argument, of text like ``{type: line, to: [1, 0, 0]}`` too; one of several is itself."""
    if isinstance(value, list | tuple):
        each = [_plain(name, one) for one in value]
        return each[0] if len(each) == 1 else each
    return parse_assignment(f"task.{name}={value}")[1] if isinstance(value, str) else value


def _planned(robot: Robot, task: Task, progress: Progress) -> tuple[Followed, Reference]:
    """Rows of the joints along the path of a task, and what the motors of a robot without one do for it."""
    from tmodes.interface.references import REFERENCES, shortest

    tell = (lambda stage, share: None) if task.least_time else progress
    paced = task
    if task.shaper and not task.shaper.frequencies:
        mode = _first_mode(robot, _followed(robot, task.model_copy(update={"shaper": None}), 1.0, tell))
        paced = task.model_copy(update={"shaper": task.shaper.model_copy(update=mode)})

    def timed(factor: float) -> Followed:
        return _followed(robot, paced, factor, tell)

    def tried(factor: float) -> tuple[Followed, Reference]:
        found = timed(factor)
        return found, REFERENCES[task.reference](robot, found, task.fit, tell)

    if task.least_time and task.reference == ReferenceKind.OPTIMAL:
        own = float(timed(1.0).times[-1])
        return shortest(robot, lambda seconds: timed(seconds / own), own, progress)
    return _least_time(robot, tried, progress) if task.least_time else tried(1.0)


def _followed(robot: Robot, task: Task, factor: float, tell: Progress) -> Followed:
    """The paths of a task at its profile, whose time is its own times a factor."""
    from tmodes.analysis.follow import followed
    from tmodes.analysis.timing import timed_ways

    def along(signals: Callable[[float], Signal]) -> Followed:
        return followed(robot, task.paths, signals, task.fit, tell)

    if task.timing is None:
        return along(lambda length: _shaped(task, _move(task, length, factor)))
    ways = iter(timed_ways(robot, along(lambda length: _move(task, length, factor)), task.timing))
    return along(lambda length: _shaped(task, Signal.of(next(ways))))


def _move(task: Task, length: float, factor: float) -> Signal:
    """The profile of a task along a length; a gentle one where it has none, or a timing is still to be found."""
    law: Any = task.profile
    if law is None or task.timing:
        gentle = _smooth(length) if law is None and task.reference in SMOOTH else PROFILE
        law = Signal.of({**gentle, **ENDS})
    own = {name: getattr(law, name) for name in type(law).model_fields} | {"start": 0.0, "end": length}
    known = {key: own[key] * factor**power for key, power in _BY_TIME.items() if own.get(key)}
    return type(law).model_construct(None, **own | (known if factor != 1 else {}))


def _shaped(task: Task, move: Signal) -> Signal:
    return Signal.of({"type": "shaped", "signal": move, "shaper": task.shaper}) if task.shaper else move


def _least_time(
    robot: Robot, tried: Callable[[float], tuple[Followed, Reference]], progress: Callable[[str, float], None]
) -> tuple[Followed, Reference]:
    """What is ``tried`` with the time of the profile times a factor, with the least one that the limits allow."""
    from scipy.optimize import brentq

    from tmodes.interface.references import REFERENCES, largest_load

    done: dict[float, tuple[float, Followed, Reference]] = {}

    def load(log: float) -> float:
        """Logarithm of the largest share of a limit, with the logarithm of a factor."""
        if log in done:  # an end of the bracket
            return math.log(done[log][0])
        progress("least time", min(0.9, len(done) / _TRIALS))
        found, given = tried(math.exp(log))
        if given.efforts is None and any(joint.limits and joint.limits.effort for joint in robot.joints):
            needed = REFERENCES[ReferenceKind.MOTORS](robot, given.positions, 0.0, lambda stage, share: None)
        else:
            needed = given
        done[log] = largest_load(robot, needed), found, given
        return math.log(done[log][0])

    logs, here = [0.0], load(0.0)
    while here and math.log(done[logs[-1]][0]) * here > 0:
        logs.append(logs[-1] + math.copysign(math.log(2.0), here))
        if abs(load(logs[-1]) - math.log(done[logs[-2]][0])) < _CLOSE or len(logs) > _DOUBLINGS:
            share = done[logs[-1]][0]
            got = f"{share:.3g} of a limit however slow" if here > 0 else f"{share:.3g} of all limits however fast"
            raise InputError("task.least_time", got, "limits that a time just keeps", "correct `limits` of the joints")
    if here:
        brentq(load, *sorted(logs[-2:]), xtol=_CLOSE / 2)
    _, found, given = done[min(log for log, (share, *_) in done.items() if share <= 1.0)]
    return found, given


def _first_mode(robot: Robot, found: Followed) -> dict[str, Any]:
    """Frequency [Hz] and damping of a shaper for the first mode along a path."""
    from tmodes.interface.references import REFERENCES
    from tmodes.interface.shaping import middle_modes

    rigid = REFERENCES[ReferenceKind.RIGID](robot, found, 0.0, lambda stage, share: None)
    return middle_modes(rigid.applied(robot, found), (1,), "path")[0]


def _smooth(length: float) -> dict[str, Any]:
    """A move about as fast as :data:`PROFILE` with four smooth derivatives, as the inverse needs them."""
    duration = max(10.0 * length, 3.1 * length**0.5, 0.1)  # speed and acceleration of the polynomial at most 0.25, 1
    return {"type": "polynomial", "duration": duration}


@dataclass(frozen=True, eq=False, repr=False)
class Following(CommandResult):
    """The ``robot`` whose drives follow the path of a ``task``; ``found``: rows of the rigid robot's joints along it.

    ``motors``: the reference, setpoints of the motors and what else they are given. ``checks`` [m]: largest distance
    of the tip of the nominal robot from the path, under its controllers with the ``rigid`` reference, with ``this``
    one, and in ``open loop`` by the efforts alone; empty for the rigid one; NaN where a run fails. ``swings`` [m]: the
    same after the motion, for half its time, from where the tip rests at the end of the path.
    """

    given: Robot = field(repr=False)
    robot: Any = field(repr=False)
    found: Followed
    task: Task
    motors: Reference
    checks: Mapping[str, float] = field(default_factory=dict)
    swings: Mapping[str, float] = field(default_factory=dict)

    @property
    def kinds(self) -> tuple[str, ...]:
        """Of the paths."""
        return tuple(str(one.type) for one in self.task.paths)

    @property
    def reference(self) -> str:
        """Its kind."""
        return str(self.task.reference)

    @property
    def length(self) -> float:
        """Of all paths [m; rad of a turn, and of a path of the joints]."""
        return float(sum(leg.course.length for leg in self.found.legs))

    @property
    def duration(self) -> float:
        """Of the path [s]."""
        return float(self.found.times[-1])

    @property
    def lead(self) -> float:
        """How long the motors move before the path begins [s]."""
        return self.motors.lead

    @property
    def error(self) -> float:
        """The largest distance of the rigid robot's tip from the path [m]."""
        return self.found.error

    @property
    def sheet(self) -> str:
        """The data sheet of the robot that follows, as YAML."""
        from tmodes.io.sheet_write import robot_to_yaml

        return robot_to_yaml(self.robot)

    @property
    def warnings(self) -> list[str]:
        """What is to be known about it."""
        return [*self.motors.warnings]

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes follow --json`` prints it."""
        found = self.found
        return {
            "robot": self.given.name, "units": UNITS, "paths": list(self.kinds), "length": self.length,
            "reference": self.reference, "lead_s": self.lead, "duration_s": self.duration, "rows": len(found.times),
            "error_m": found.error, "turned_rad": found.turned,
            **{group: {name: dict(zip(_OF_MOVES, row, strict=True)) for name, row in rows.items()}
               for group, rows in self._moves.items()},
            "tip_error_m": dict(self.checks), "swing_m": dict(self.swings), "warnings": self.warnings,
        }  # fmt: skip

    @property
    def _moves(self) -> dict[str, dict[str, list[float]]]:
        """First and last position, largest speed and acceleration by joint: of the rigid robot, of the motors."""
        data, found = self.data, dict[str, dict[str, list[float]]]()
        for group, head, rows in (("joints", "joint_", self.found), ("setpoints", "", self.motors.positions)):
            largest = [np.abs(data[f"{head}{name}"].values).max(axis=0) for name in ("velocity", "acceleration")]
            columns = np.stack([*rows.values[[0, -1]], *largest], axis=1)
            found[group] = dict(zip(rows.joints, columns.tolist(), strict=True))
        return found

    @property
    def data(self) -> Dataset:
        """``position``, ``velocity``, ``acceleration`` (time, joint) of the setpoints at even times [rad, m, s].

        ``joint_position`` and so on: of the rigid robot's joints along the path.
        """
        from xarray import Dataset

        end, drives = self.motors.end, {drive.joint: drive for drive in self.robot.drives}
        times, own = np.linspace(0.0, end, _SAMPLES), [drives[joint] for joint in self.found.joints]
        names = ("position", "rad, m"), ("velocity", "rad/s, m/s"), ("acceleration", "rad/s^2, m/s^2")
        series = dict[str, Any]()
        for head, signals in (("", [one.signal for one in own]), ("joint_", [one.motion or one.signal for one in own])):
            pieces = [one.schedule(end) for one in signals]
            for order, (name, unit) in enumerate(names):
                values = np.stack([one.at(times, order) for one in pieces], axis=1)
                series[f"{head}{name}"] = ("time", "joint"), values, {"units": unit}
        return Dataset(series, {"time": ("time", times, {"units": "s"}), "joint": list(self.found.joints)})

    def plot(self, ax: Any = None) -> list[Any]:
        """Setpoints of the motors over time."""
        from tmodes.plot.commands import points

        data = self.data
        shown_ = {name: (data.time.values, data.position.values[:, k]) for k, name in enumerate(self.found.joints)}
        return points(shown_, "time [s]", "setpoint [rad, m]", title=f"{self.given.name}: {', '.join(self.kinds)}",
                      ax=ax, line="-", marks=False)  # fmt: skip

    def tables(self) -> Iterator[str | Table]:
        """What the path is, how closely the rigid robot's tip keeps to it, and what each joint does."""
        found = self.found
        off = f"its tip within {found.error:.2g} m of it" if found.error else f"within {found.turned:.2g} rad of it"
        turned = f" and {found.turned:.2g} rad" if found.error and found.turned else ""
        yield (f"{self.given.name}: {', '.join(self.kinds)} of {self.length:.4g} in {self.duration:.4g} s, "
               f"{len(found.times)} rows; as a rigid robot {off}{turned}")  # fmt: skip
        shapers = {f"{one.shaper.type} for {', '.join(f'{f:.4g}' for f in one.shaper.frequencies)} Hz"
                   for one in (leg.signal for leg in found.legs) if one.type == "shaped"}  # fmt: skip
        yield from (f"shaped by {one}" for one in sorted(shapers))
        if self.checks:
            lead = f"; it begins {self.lead:.3g} s before the path" if self.lead else ""
            yield f"reference {self.reference}{lead}"
            names = {"this": f"{self.reference}, under control", "open loop": f"{self.reference}, efforts alone"}
            rows = [[names.get(name, name), f"{value:.3g}", f"{self.swings[name]:.3g}"]
                    for name, value in self.checks.items()]  # fmt: skip
            yield Table("Nominal robot: largest distance of the tip [m]", ["reference", "from the path", "afterwards"],
                        rows)  # fmt: skip
        same = self.motors.positions is found
        titles = {"joints": "Joints of the rigid robot" + (", and setpoints" if same else ""),
                  "setpoints": "Setpoints of the motors"}  # fmt: skip
        for group, rows in self._moves.items():
            if group == "joints" or not same:
                yield Table(f"{titles[group]} [rad, m, s]", ["joint", *_OF_MOVES.values()],
                            [[name, *(f"{value:.5g}" for value in row)] for name, row in rows.items()])  # fmt: skip
