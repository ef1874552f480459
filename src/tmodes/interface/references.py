"""References of a path: setpoints of motors, from the rigid robot's joints to the inverse of all that bends.

A reference gives each motor a position, and an effort that is added to what its controller commands. Each is checked on
the nominal robot, under its controllers and by the efforts alone.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.follow import Followed, Leg
from tmodes.analysis.inversion import inverted
from tmodes.analysis.sagging import Task, carried, sagged
from tmodes.equations.loop.control_kernels import Winding
from tmodes.equations.loop.plan import winding_of
from tmodes.errors import InputError, TmodesError
from tmodes.gradients.least_time import least_time
from tmodes.gradients.optimal import Course, Found, RestToRest, under_torques
from tmodes.interface.motions import freed, limits_of, missed, steady
from tmodes.kinds.signals.registry import Signal
from tmodes.result.run import ready_to_run
from tmodes.sheet import Robot
from tmodes.sheet.parts import Command, ControlSheet, DriveSheet, Initial, InitialState
from tmodes.sheet.task import ReferenceKind
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.simulate import simulate_motion

__all__ = ["REFERENCES", "Reference", "largest_load", "shortest"]

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]

_ROWS, _SAMPLES, _DEGREE, _AFTER = 800, 1000, 5, 1.5
"""Rows of efforts that a run gives; samples of a check; degree of the splines through efforts; until when a check
looks, over the time of the reference."""

_SMOOTH, _STILL, _CREEPS, _JUMP = 1e-2, 1e-4, 1e-3, 1e-6
"""Difference of efforts, and rate at the ends, over the largest ones, beyond which there is a warning; rates
[rad/s, m/s] below which a motion is none; jump of a derivative over its largest value that is rounding."""


@dataclass(frozen=True, eq=False)
class Reference:
    """Positions of the motors and efforts of their drives, as rows of references; None: no efforts.

    ``states``: of all coordinates, where they are known. The path begins ``lead`` [s] after them. ``warnings``: what is
    to be known about it.
    """

    positions: Followed
    efforts: Followed | None = None
    states: Followed | None = None
    lead: float = 0.0
    warnings: tuple[str, ...] = ()

    @property
    def end(self) -> float:
        """When the motors are at their ends [s]."""
        return float(self.positions.times[-1])

    def applied(self, robot: Robot, path: Followed) -> Robot:
        """The robot whose drives have this reference, and whose errors count from the path; its run is long enough."""
        drives, places = list(robot.drives), {drive.joint: k for k, drive in enumerate(robot.drives)}
        parts = [self.positions.signals(), path.signals(), self.efforts.signals() if self.efforts else []]
        for k, joint in enumerate(path.joints):
            drive = drives[places[joint]]
            update: dict[str, Any] = {"signal": parts[0][k], "motion": None, "feed_forward": None}
            if self.positions is not path:
                update["motion"] = parts[1][k] | {"delay": self.lead}
            if parts[2] and drive.command.is_controlled:
                update["feed_forward"] = parts[2][k]
            made = {name: one and _signal(one) for name, one in update.items()}
            drives[places[joint]] = drive.model_copy(update=made)
        end = max(robot.integration.duration, self.end)
        settings = robot.integration.model_copy(update={"duration": end})
        task = robot.task and robot.task.judged
        made = robot.model_copy(update={"drives": tuple(drives), "integration": settings, "task": task})
        return made.model_copy(update={"control": tuple(self._known(robot, one) for one in robot.control)})

    def _known(self, robot: Robot, sheet: ControlSheet) -> ControlSheet:
        """The same with what coordinates do that no setpoint moves, and currents, where its block follows these."""
        if "reference" not in type(sheet.block).model_fields:
            return sheet
        found = dict[str, Any]()
        if self.states and self.efforts:
            axes = {axis.name: axis.joint.motor for axis in robot.undriven.chain().axes}
            coordinates, moved = self.states.joints, set(self.positions.joints)
            moved = {motor if (motor := f"{joint}.motor") in coordinates else joint for joint in moved}
            found = {
                name: one for name, one in zip(coordinates, self.states.signals(), strict=True) if name not in moved
            }
            for joint in self.efforts.joints:
                kind, (_, _, torque, _) = winding_of(axes[joint])
                if kind is Winding.INDUCTANCE:
                    found[f"{joint}.current"] = self.efforts.signals(1 / torque)[self.efforts.joints.index(joint)]
        block = sheet.block.model_copy(update={"reference": {name: Signal.of(one) for name, one in found.items()}})
        return sheet.model_copy(update={"block": block})

    def checks(self, robot: Robot, made: Robot, path: Followed) -> dict[str, tuple[float, float]]:
        """Largest distance of the nominal robot's tip from the path, and afterwards from its rest [m], by reference.

        That is where the tip rests at the end of the path, as far as joints move it there.
        """
        plain, task, found = Reference(path).applied(robot, path), Task(robot, path), {}
        try:
            place = task.end()
        except InputError:
            place = task.along(np.array([task.duration])).places[0]
        tried: dict[str, Callable[[], Robot]] = {"rigid": lambda: plain, "this": lambda: made}
        if self.efforts is not None and all(d.feed_forward for d in made.drives if d.joint in path.joints):
            tried["open loop"] = lambda: _open_loop(made, path.joints, done)
        done: Any = None
        for name, one in tried.items():
            lead, end = (0.0, float(path.times[-1])) if name == "rigid" else (self.lead, self.end)
            try:
                done = _nominal(one(), _AFTER * end, _SAMPLES)
            except TmodesError:
                found[name] = float("nan"), float("nan")
                if name == "this":  # then it is not known from where the open loop begins
                    break
                continue
            tip = done.points.position[:, [point.name for point in done.chain.points].index("tip")]
            late = done.times >= end * (1 - 1e-9)
            off = np.where(late[:, None], tip - place, tip - task.along(done.times - lead).places)
            sizes = np.linalg.norm(off, axis=1)
            found[name] = float(sizes[~late].max()), float(sizes[late].max())
        return found


def _signal(data: dict[str, Any]) -> Signal:
    """A signal from plain data; raises :class:`tmodes.errors.InputError` for numbers that no sheet takes."""
    from pydantic import ValidationError

    try:
        return Signal.of(data)
    except ValidationError as error:
        wrong = error.errors()[0]
        got = f"a motion whose {wrong['loc'][0]} reach {wrong['input']:.3g}"
        raise InputError("task.profile", got, "one that a robot can make", "give it more time") from None


def largest_load(robot: Robot, reference: Reference) -> float:
    """The largest speed or effort of a motor on a reference over its limit.

    Raises :class:`tmodes.errors.InputError` where no joint of it has a limit.
    """
    bounds, own = {joint.name: joint.limits for joint in robot.joints}, reference.positions
    shares = []
    for k, joint in enumerate(own.joints):
        limits = bounds[joint]
        if limits and limits.speed:
            shares.append(float(np.abs(own.rates[:, k]).max()) / limits.speed)
        if limits and limits.effort and reference.efforts is not None:
            shares.append(float(np.abs(reference.efforts.values[:, k]).max()) / limits.effort)
    if not shares:
        raise _unlimited()
    return max(shares)


def _unlimited() -> InputError:
    hint = "add `limits: {speed: 3.0, effort: 100.0}` to its joints"
    return InputError("task.least_time", "no limit of speed or effort", "a limit of a joint that moves", hint)


def _replaced(robot: Robot, drives: Sequence[DriveSheet]) -> Robot:
    """The robot with other drives of the same joints."""
    own = {drive.joint: drive for drive in drives}
    return robot.model_copy(update={"drives": tuple(own.get(drive.joint, drive) for drive in robot.drives)})


def _open_loop(robot: Robot, joints: Sequence[str], done: RunData) -> Robot:
    """The robot whose drives of ``joints`` give their efforts and nothing else, from where a run began."""
    motors, drives = {joint.name for joint in robot.joints if joint.motor}, []
    for drive in robot.drives:
        if drive.joint in joints and drive.feed_forward is not None:
            command = Command.TORQUE if drive.joint in motors else Command.EFFORT
            drives.append(DriveSheet(joint=drive.joint, command=command, signal=drive.feed_forward))
    start = dict(zip(done.coordinates, done.q[0].tolist(), strict=True))
    initial = Initial(state=InitialState.ZERO, coordinates=start)
    return _replaced(robot, drives).model_copy(update={"initial": initial})


def _nominal(robot: Robot, end: float, samples: int) -> RunData:
    """The run of the robot as known up to ``end`` [s], without noise."""
    settings = {
        "duration": end,
        "output_step": end / samples,
        "error_estimate": False,
        "model_error": False,
        "stop": (),
    }
    drives = tuple(drive.model_copy(update={"noise": None}) for drive in robot.drives)
    update = {"real": {}, "task": None, "drives": drives, "integration": robot.integration.model_copy(update=settings)}
    return simulate_motion(ready_to_run(robot.model_copy(update=update)).pair())


def _needed(robot: Robot, positions: Followed) -> Reference:
    """Positions of the motors, with the efforts that keep the nominal robot's motors exactly on them."""
    moved = [DriveSheet(joint=joint, command=Command.PRESCRIBED, signal=Signal.of(signal))
             for joint, signal in zip(positions.joints, positions.signals(), strict=True)]  # fmt: skip
    exact = _replaced(robot, moved).model_copy(update={"control": (), "sensors": ()})
    done = _nominal(exact, float(positions.times[-1]), _ROWS)
    efforts = done.effort[:, [done.drives.index(joint) for joint in positions.joints]]
    return Reference(positions, _rows(positions, done.times, efforts), _states(positions, done))


def _states(like: Followed, done: Any) -> Followed:
    """The rows of all coordinates of a run."""
    return replace(like, joints=tuple(done.coordinates), times=done.times, values=done.q, rates=done.v,
                   accelerations=done.a)  # fmt: skip


def _rows(like: Followed, times: Array, values: Array) -> Followed:
    """Rows of ``values`` (n, joints) with their rates and accelerations, by a spline."""
    from scipy.interpolate import make_interp_spline

    spline = make_interp_spline(times, values, k=_DEGREE)
    rates, accelerations = (np.asarray(spline.derivative(order)(times)) for order in (1, 2))
    return replace(like, times=times, values=values, rates=rates, accelerations=accelerations)


def _rigid(robot: Robot, path: Followed, tolerance: float, progress: Progress) -> Reference:
    del robot, tolerance, progress
    return Reference(path)


def _motors(robot: Robot, path: Followed, tolerance: float, progress: Progress) -> Reference:
    del tolerance
    progress("motors", 0.0)
    return _needed(robot, path)


def _sag(robot: Robot, path: Followed, tolerance: float, progress: Progress) -> Reference:
    del tolerance
    progress("sag", 0.0)
    return _needed(robot, sagged(robot, path))


def _quasi_static(robot: Robot, path: Followed, tolerance: float, progress: Progress) -> Reference:
    del tolerance
    progress("quasi-static", 0.0)
    found = _needed(robot, carried(robot, path))
    if all(_is_smooth(leg, 2) for leg in path.legs):
        return found
    jump = "what the motion bends jumps, as accelerations of the profile do"
    return replace(found, warnings=(f"{jump}: take --profile '{{type: polynomial, duration: ...}}'",))


def _inverse(robot: Robot, path: Followed, tolerance: float, progress: Progress) -> Reference:
    known = vars(robot).get("nominal") or robot
    found = inverted(known, path, max(tolerance, 1e-9), lambda share: progress("inverse", share))
    own = replace(path, times=found.times, values=found.q[:, found.motors], rates=found.rates[:, found.motors],
                  accelerations=found.accelerations[:, found.motors])  # fmt: skip
    warnings = []
    if found.rough > _SMOOTH:
        jump = f"the efforts are not smooth ({found.rough:.0%} differ with half as many instants)"
        warnings.append(f"{jump}{_why_rough(known, path)}")
    if found.aside > tolerance:
        warnings.append(
            f"the tip leaves its place by up to {found.aside:.2g} m before and after the path, so that nothing swings "
            "in the end: what bends is hardly damped where the tip is held"
        )
    if found.left > _STILL * max(float(np.abs(found.rates).max()), _CREEPS):
        warnings.append(
            f"the robot still moves by {found.left:.2g} rad/s, m/s where the motion is cut: what bends is hardly "
            "damped where the tip is held"
        )
    states = replace(path, joints=tuple(known.undriven.chain().coordinates), times=found.times, values=found.q,
                     rates=found.rates, accelerations=found.accelerations)  # fmt: skip
    return Reference(own, _rows(path, found.times, found.efforts), states, found.lead, tuple(warnings))


def _why_rough(robot: Robot, path: Followed) -> str:
    """What makes efforts jump, and what helps: the profile, corners of the path, kinks of the gears."""
    if not all(_is_smooth(leg) for leg in path.legs):
        return ", as the profile is not: take --profile '{type: polynomial, duration: ...}'"
    if any(leg.course.knots for leg in path.legs):
        return ", as the path's corners are not: give it a larger `blend`"
    gears = {joint.name: joint.gear for joint in robot.joints if joint.name in path.joints and joint.gear}
    kinked = [name for name, gear in gears.items() if gear.torque_limits or gear.backlash]
    if kinked:
        return (f", as the gears of {', '.join(kinked)} have kinks (`torque_limits`, `backlash`): efforts jump where "
                "a gear passes one; give a single `stiffness` for smooth ones")  # fmt: skip
    return ", as what bends swings faster than instants can be near, where the tip is held: take a longer duration"


def _is_smooth(leg: Leg, orders: int = 4) -> bool:
    """Whether so many derivatives of the way over time have no jump, from rest to rest."""
    pieces, knots, ends = leg.pieces, leg.pieces.knots, np.linspace(0.0, leg.end, _SAMPLES)
    for order in range(1, orders + 1):
        late, early = pieces.at(knots, order), pieces.at(np.nextafter(knots, -np.inf), order)
        late[-1] = early[0] = 0.0
        if np.abs(late - early).max() > _JUMP * np.abs(pieces.at(ends, order)).max():
            return False
    return True


def _course(robot: Robot, path: Followed) -> RestToRest:
    """From rest at the start of a path to rest at its end, the tip near it, within the limits of the sheet.

    Raises :class:`tmodes.errors.InputError` for a robot in contact.
    """
    freed(robot)
    held, task = sagged(robot, path), Task(robot, path)
    given = _needed(robot, held).efforts
    assert given is not None  # noqa: S101

    def off(times: Array) -> Callable[[Array], tuple[Array, Array]]:
        wanted = task.along(times)
        stays = task.off(np.repeat(wanted.q[:1], len(times), axis=0), wanted)
        size = float(np.linalg.norm(stays, axis=1).max())
        return lambda q: (task.off(q, wanted) / size, task.off_slopes(q, wanted) / size)

    def efforts(times: Array) -> Array:
        return np.array([np.interp(times, given.times, column) for column in given.values.T])

    start, goal = (dict(zip(path.joints, row.tolist(), strict=True)) for row in held.values[[0, -1]])
    torque, speed = (limits_of(robot, None, "", name, path.joints) for name in ("effort", "speed"))
    course = Course(off, efforts, task.targets(path.values).q)
    return RestToRest(_bare(robot), start, goal, task.duration, torque=torque, speed=speed, near=course)


def _bare(robot: Robot) -> Robot:
    """The robot without blocks, its loads as at the start."""
    return steady(robot).model_copy(update={"control": (), "sensors": ()})


def _driven(robot: Robot, path: Followed, move: RestToRest, found: Found) -> Reference:
    """What the motors do under the torques that were found."""
    torques = found.signals(move.joints)
    done = _nominal(under_torques(_bare(robot), move.start, torques, move.duration)[0], move.duration, _ROWS)
    efforts = np.stack([torques[joint].schedule(move.duration).at(done.times) for joint in path.joints], axis=1)
    warnings = tuple(missed(found, found.swing, move.accepted))
    own = _rows(path, done.times, done.q[:, move.places])
    return Reference(own, _rows(path, done.times, efforts), _states(path, done), 0.0, warnings)


def _optimal(robot: Robot, path: Followed, tolerance: float, progress: Progress) -> Reference:
    del tolerance
    progress("optimal", 0.0)
    move = _course(robot, path)
    return _driven(robot, path, move, move.solve(move.accepted, progress=lambda share: progress("optimal", share)))


def shortest(
    robot: Robot, timed: Callable[[float], Followed], seconds: float, progress: Progress
) -> tuple[Followed, Reference]:
    """The reference ``optimal`` in the least time that limits allow, searched from ``seconds`` on; ``timed``: the path.

    Raises :class:`tmodes.errors.InputError` where no joint of it has a limit, and
    :class:`tmodes.errors.SimulationError` where no time is found.
    """
    made = list[tuple[Followed, RestToRest]]()

    def move(time: float) -> RestToRest:
        path = timed(time)
        made.append((path, _course(robot, path)))
        return made[-1][1]

    first = move(seconds)
    if not np.isfinite([*first.torque, *first.speed]).any():
        raise _unlimited()
    best, found = least_time(move, seconds, first.accepted, lambda share: progress("least time", share))
    path = next(path for path, one in made if one is best)
    return path, _driven(robot, path, best, found)


REFERENCES: Mapping[ReferenceKind, Callable[[Robot, Followed, float, Progress], Reference]] = {
    ReferenceKind.RIGID: _rigid, ReferenceKind.MOTORS: _motors, ReferenceKind.SAG: _sag,
    ReferenceKind.QUASI_STATIC: _quasi_static,
    ReferenceKind.INVERSE: _inverse, ReferenceKind.OPTIMAL: _optimal,
}  # fmt: skip
