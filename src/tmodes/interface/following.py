"""References along paths: what ``tmodes follow`` computes and prints."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tmodes.errors import InputError, InputErrors
from tmodes.interface.files import write_files
from tmodes.io.arguments import checked_arguments
from tmodes.io.assignment import parse_assignment
from tmodes.io.printed import CommandResult, Table
from tmodes.io.words import meant, shown

if TYPE_CHECKING:
    from xarray import Dataset

    from tmodes.analysis.follow import Followed
    from tmodes.interface.references import Reference
    from tmodes.kinds.signals.registry import Signal
    from tmodes.kinds.timings.registry import Timing
    from tmodes.sheet import Robot

__all__ = ["Following", "follow"]

UNITS = {
    "duration_s": "s", "lead_s": "s", "tip_error_m": "m", "swing_m": "m, after it",
    "length": "m; rad of a turn, and of a path of the joints",
    "error_m": "m, the rigid robot's tip",
    "turned_rad": "rad, the rigid robot's tip; of a path of the joints these themselves", "speed": "rad/s, m/s",
    "acceleration": "rad/s^2, m/s^2",
}  # fmt: skip

PROFILE = "{type: s_curve, speed: 0.25, acceleration: 1.0, jerk: 10.0}"
"""The profile where none is given: what is gentle for a robot of a metre."""

_SAMPLES, _CHECKS = 400, ("checks", "swings")

_BY_TIME = {"duration": 1, "speed": -1, "acceleration": -2, "jerk": -3}
"""Numbers of profiles, and with which power of a factor on the time they grow."""

_TRIALS, _DOUBLINGS, _CLOSE = 14, 7, 0.01
"""Of the search for the least time: how many there usually are, doublings at most, within which share it is found."""

Group = str | Mapping[str, Any]


@checked_arguments
def follow(
    robot: Robot,
    path: Group | Sequence[Group],
    *,
    profile: Group | None = None,
    tolerance: float = 1e-7,
    reference: str = "rigid",
    least_time: bool = False,
    shaper: Group | None = None,
    out: str | os.PathLike[str] | None = None,
    figure: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
    progress: Callable[[str, float], None] = lambda stage, share: None,
) -> Following:
    """Joint references of a ``path`` of the tip, or of the joints, and the robot whose drives follow it.

    ``path``: a group such as ``{"type": "line", "to": [0.6, 0.0, 0.2]}`` [m], or text like it; several follow one
    another, each from rest to rest. Kinds: line, arc, via (points with rounded corners), turn, joints, or your own;
    with ``rpy`` the tip turns to there on the shortest way. ``profile``: speed profile along the path, a signal without
    start and end, which become 0 and the length, such as ``{"type": "s_curve", "speed": 0.5, "acceleration": 2.0,
    "jerk": 40.0}`` [m/s, ...]; gentle for a robot of a metre if left out; or a timing within the limits of the rigid
    robot's joints: ``{"type": "jerk_limited", "jerk": 100.0}``, an S-curve, or ``{"type": "toppra"}``, the least
    time (extra `planning`). It starts where the first commands put the rigid robot, whose inverse kinematics gives the
    joints; ``tolerance`` [m, rad] of its tip between the rows of the references.

    ``reference``: setpoints of the motors. ``rigid``: the joints of the rigid robot. ``motors``: these, and the
    efforts that keep the motors exactly on them, from a run of the whole robot as known. ``sag``: motors go where the
    tip of the robot as it bends is on the path at rest, under weight and loads (quasi-static), with their efforts.
    ``inverse``: motions and efforts with which the tip of the moving robot is on the path, in contact too
    (:mod:`tmodes.analysis.inversion`); they may begin before the path does. ``optimal``: in the time of the path,
    within the limits of speed and effort of the sheet, from rest at its start to rest at its end without swing, in
    between as near to it as that leaves open, by exact derivatives of runs (:mod:`tmodes.gradients.optimal`). Runs of
    the nominal robot say what that is worth (``checks``, ``swings``). ``least_time``: the profile made faster or
    slower, to 1 %, until a motor is at its limit of speed or effort (``limits`` of the sheet); of ``optimal`` the
    shortest motion that is found within them, to 2 %, where the path between the ends gives way. ``shaper``: of the way
    along the path, so that the tip stays on it and a mode does not ring after it, such as ``{"type": "zvd"}``; without
    ``frequencies`` [Hz] for the robot's first mode, in the middle between its lowest and its highest frequency on the
    path. ``out``: a file for the sheet; ``figure``: one for the references.

    Raises :class:`tmodes.errors.InputError` for a path that the rigid robot does not reach, or that passes a singular
    pose, and :class:`tmodes.errors.ResultFileError` where a file cannot be written. Source: B. Siciliano, L. Sciavicco,
    L. Villani, G. Oriolo, Robotics: Modelling, Planning and Control (2009), ch. 3 and 4.

    >>> found = tmodes.load("two_link_arm").follow({"type": "line", "to": [0.7, 0.0, 0.2]})
    >>> round(found.length, 4), found.error < 1e-7, found.robot.drives[0].signal.type
    (0.2065, True, 'trajectory')
    """
    from tmodes.interface.references import REFERENCES, SMOOTH, shortest
    from tmodes.kinds.paths.registry import Path

    groups = [path] if isinstance(path, str | Mapping) else [*path]
    if not groups or not tolerance > 0:
        raise InputError("--path", "no path" if not groups else f"tolerance {tolerance!r}",
                         "a path, and a tolerance > 0 m", "add --path '{type: line, to: [0.6, 0, 0.2]}'")  # fmt: skip
    paths = [_member(Path, _group("--path", one), "path") for one in groups]
    tell = (lambda stage, share: None) if least_time else progress
    smooth = _known(reference) in SMOOTH and profile is None
    pace = _Pace.of(profile, shaper, smooth=smooth, timed=not least_time)
    if pace.wants_mode:
        plain = replace(pace, shaper=None).followed(robot, paths, 1.0, tolerance, tell)
        pace = replace(pace, shaper={**(pace.shaper or {}), **_first_mode(robot, plain)})

    def timed(factor: float) -> Followed:
        return pace.followed(robot, paths, factor, tolerance, tell)

    def tried(factor: float) -> tuple[Followed, Reference]:
        found = timed(factor)
        return found, REFERENCES[reference](robot, found, tolerance, tell)

    if least_time and reference == "optimal":
        own = float(timed(1.0).times[-1])
        found, given = shortest(robot, lambda seconds: timed(seconds / own), own, progress)
    else:
        found, given = _least_time(robot, tried, progress) if least_time else tried(1.0)
    made = Following(robot, given.applied(robot, found), found, tuple(str(one.type) for one in paths), reference, given)
    if reference != "rigid":
        progress("check", 0.0)
        both = given.checks(robot, made.robot, found)
        made = replace(made, **{key: {name: row[k] for name, row in both.items()} for k, key in enumerate(_CHECKS)})
    write_files(out, made, figure, overwrite=overwrite)
    return made


@dataclass(frozen=True)
class _Pace:
    """How fast to go along paths: by a ``profile``, or a ``timing``; ``shaper``: of the way over time."""

    profile: dict[str, Any]
    timing: Timing | None
    shaper: dict[str, Any] | None
    smooth: bool

    @classmethod
    def of(cls, profile: Group | None, shaper: Group | None, *, smooth: bool, timed: bool) -> _Pace:
        """From plain data; ``smooth``: a profile of its own for each length. Raises as :func:`follow`."""
        from tmodes.kinds.shapers.registry import Shaper
        from tmodes.kinds.timings.registry import TIMINGS, Timing

        law = {key: value for key, value in _group("--profile", PROFILE if profile is None else profile).items()
               if key not in ("start", "end")}  # fmt: skip
        shape = None if shaper is None else _group("--shaper", shaper)
        if shape is not None:
            _refuse_kind(Shaper, shape, "--shaper")
        if law.get("type") not in TIMINGS:
            return cls(law, None, shape, smooth)
        if not timed:
            expected, hint = "a profile whose time changes", "leave `--least-time` out: the timing is found by it"
            raise InputError("--least-time", f"the timing `{law['type']}`", expected, hint)
        return cls(_group("--profile", PROFILE), _member(Timing, law, "profile"), shape, smooth)

    @property
    def wants_mode(self) -> bool:
        """Whether its shaper is for a mode of the robot."""
        return bool(self.shaper) and not self.shaper.get("frequencies")

    def followed(self, robot: Robot, paths: Sequence[Any], factor: float, tolerance: float, tell: Any) -> Followed:
        """The paths at a profile whose time is that of the sheet times a factor."""
        from tmodes.analysis.follow import followed
        from tmodes.analysis.timing import timed_ways

        found = followed(robot, paths, lambda length: self._signal(self._move(length, factor)), tolerance, tell)
        if self.timing is None:
            return found
        ways = iter(timed_ways(robot, found, self.timing))
        return followed(robot, paths, lambda length: self._signal(next(ways), shaped=True), tolerance, tell)

    def _move(self, length: float, factor: float) -> dict[str, Any]:
        own = _smooth(length) if self.smooth else {**self.profile, "start": 0.0, "end": length}
        known = {key: own[key] * factor**power for key, power in _BY_TIME.items() if key in own} if factor != 1 else {}
        return own | known

    def _signal(self, move: dict[str, Any], *, shaped: bool = False) -> Signal:
        from tmodes.kinds.signals.registry import Signal

        if self.shaper and (shaped or not self.timing):
            move = {"type": "shaped", "signal": move, "shaper": self.shaper}
        return _member(Signal, move, "profile")


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
            needed = REFERENCES["motors"](robot, given.positions, 0.0, lambda stage, share: None)
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
            raise InputError("--least-time", got, "limits that a time just keeps", "correct `limits` of the joints")
    if here:
        brentq(load, *sorted(logs[-2:]), xtol=_CLOSE / 2)
    _, found, given = done[min(log for log, (share, *_) in done.items() if share <= 1.0)]
    return found, given


def _first_mode(robot: Robot, found: Followed) -> dict[str, Any]:
    """Frequency [Hz] and damping of a shaper for the first mode along a path."""
    from tmodes.interface.references import REFERENCES
    from tmodes.interface.shaping import middle_modes

    rigid = REFERENCES["rigid"](robot, found, 0.0, lambda stage, share: None)
    return middle_modes(rigid.applied(robot, found), (1,), "path")[0]


def _smooth(length: float) -> dict[str, Any]:
    """A move about as fast as :data:`PROFILE` with four smooth derivatives, as the inverse needs them."""
    duration = max(10.0 * length, 3.1 * length**0.5, 0.1)  # speed and acceleration of the polynomial at most 0.25, 1
    return {"type": "polynomial", "start": 0.0, "end": length, "duration": duration}


def _known(reference: str) -> str:
    from tmodes.interface.references import REFERENCES

    if reference not in REFERENCES:
        hint = meant(reference, [*REFERENCES], "take one of these")
        raise InputError("--reference", shown(reference), f"one of {', '.join(REFERENCES)}", hint)
    return reference


def _group(which: str, given: Any) -> dict[str, Any]:
    """Plain data of a group, or of text like ``{type: line, to: [1, 0, 0]}``."""
    value = parse_assignment(f"{which}={given}")[1] if isinstance(given, str) else given
    if not isinstance(value, Mapping) or not all(isinstance(key, str) for key in value):
        raise InputError(
            which, shown(given), "a group with a `type`", "write it like '{type: line, to: [0.6, 0, 0.2]}'"
        )
    return dict(value)


def _refuse_kind(family: Any, data: dict[str, Any], which: str) -> None:
    """Raise :class:`tmodes.errors.InputError` where plain data name no kind of a family."""
    if family.kind_named(data) is None:
        known = ", ".join(family.registry.names)
        raise InputError(f"{which}.type", shown(data.get("type")), f"one of {known}", "name a kind")


def _member(family: Any, data: dict[str, Any], which: str) -> Any:
    """A member of a family from plain data; raises :class:`tmodes.errors.InputErrors` with all that is wrong."""
    from pydantic import ValidationError

    _refuse_kind(family, data, which)
    try:
        return family.of(data)
    except ValidationError as error:
        raise InputErrors([*_wrong(error, which)]) from None


_BOUNDS = {"ge": "at least", "gt": "above", "le": "at most", "lt": "below"}


def _wrong(error: Any, which: str) -> Iterator[InputError]:
    for one in error.errors()[:5]:
        place = ".".join([which, *map(str, one["loc"])])
        for issue in one.get("ctx", {}).get("issues", ()):
            yield InputError(f"{place}.{issue.field}", issue.got, issue.expected, issue.hint)
        if one["type"] != "issues":
            got = "nothing" if one["type"] == "missing" else shown(one["input"])
            size = one.get("ctx", {}).get("min_length", one.get("ctx", {}).get("max_length"))
            known: dict[str, str] = {
                "missing": "a value", "extra_forbidden": "a key that it has",
                "too_short": f"{size} values or more", "too_long": f"{size} values or fewer",
            }  # fmt: skip
            limits = [f"{_BOUNDS[key]} {limit:g}" for key, limit in one.get("ctx", {}).items() if key in _BOUNDS]
            expected = known.get(str(one["type"])) or " and ".join(limits) or str(one["msg"]).lower()
            yield InputError(place, got, expected, "correct it, or leave it out")


@dataclass(frozen=True, eq=False, repr=False)
class Following(CommandResult):
    """The ``robot`` whose drives follow a path; ``found``: the rows of their references.

    ``reference``: its kind, ``motors``: what that is. ``checks`` [m]: largest distance of the tip of the nominal robot
    from the path, under its controllers with the ``rigid`` reference, with ``this`` one, and in ``open loop`` by the
    efforts alone; empty for the rigid one; NaN where a run fails. ``swings`` [m]: the same after the motion, for half
    its time, from where the tip rests at the end of the path.
    """

    given: Robot = field(repr=False)
    robot: Any = field(repr=False)
    found: Followed
    kinds: tuple[str, ...]
    reference: str = "rigid"
    motors: Reference | None = None
    checks: Mapping[str, float] = field(default_factory=dict)
    swings: Mapping[str, float] = field(default_factory=dict)

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
        return self.motors.lead if self.motors else 0.0

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
        return [] if self.motors is None else [*self.motors.warnings]

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes follow --json`` prints it."""
        found = self.found
        return {
            "robot": self.given.name, "units": UNITS, "paths": list(self.kinds), "length": self.length,
            "reference": self.reference, "lead_s": self.lead, "duration_s": self.duration, "rows": len(found.times),
            "error_m": found.error, "turned_rad": found.turned,
            "joints": {name: {"start": float(found.values[0, k]), "end": float(found.values[-1, k]),
                              "speed": float(self._largest[0][k]), "acceleration": float(self._largest[1][k])}
                       for k, name in enumerate(found.joints)},
            "tip_error_m": dict(self.checks), "swing_m": dict(self.swings), "warnings": self.warnings,
        }  # fmt: skip

    @property
    def _largest(self) -> tuple[Any, Any]:
        """Largest speed and acceleration of each joint (joints,)."""
        data = self.data
        return tuple(np.abs(data[name].values).max(axis=0) for name in ("velocity", "acceleration"))  # type: ignore[return-value]

    @property
    def data(self) -> Dataset:
        """``position``, ``velocity``, ``acceleration`` (time, joint) [rad, m, s] at even times."""
        from xarray import Dataset

        end = self.motors.end if self.motors else self.duration
        times, drives = np.linspace(0.0, end, _SAMPLES), {drive.joint: drive for drive in self.robot.drives}
        pieces = [drives[joint].signal.schedule(end) for joint in self.found.joints]
        names = ("position", "rad, m"), ("velocity", "rad/s, m/s"), ("acceleration", "rad/s^2, m/s^2")
        return Dataset(
            {name: (("time", "joint"), np.stack([one.at(times, order) for one in pieces], axis=1), {"units": unit})
             for order, (name, unit) in enumerate(names)},
            {"time": ("time", times, {"units": "s"}), "joint": list(self.found.joints)},
        )  # fmt: skip

    def plot(self, ax: Any = None) -> list[Any]:
        """Positions of the motors over time."""
        from tmodes.plot.commands import points

        data = self.data
        shown_ = {name: (data.time.values, data.position.values[:, k]) for k, name in enumerate(self.found.joints)}
        return points(shown_, "time [s]", "reference [rad, m]", title=f"{self.given.name}: {', '.join(self.kinds)}",
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
        rows = [
            [
                name,
                *(
                    f"{value:.5g}"
                    for value in (found.values[0, k], found.values[-1, k], *(one[k] for one in self._largest))
                ),
            ]
            for k, name in enumerate(found.joints)
        ]
        yield Table("References [rad, m, s]", ["joint", "from", "to", "largest speed", "largest acceleration"], rows)
