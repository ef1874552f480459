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

from tmodes.analysis.follow import Followed
from tmodes.analysis.inversion import inverted
from tmodes.analysis.sagging import Task, sagged
from tmodes.errors import InputError, TmodesError
from tmodes.kinds.signals.registry import Signal
from tmodes.result.run import ready_to_run
from tmodes.sheet import Robot
from tmodes.sheet.parts import Command, DriveSheet, Initial, InitialState
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.simulate import simulate_motion

__all__ = ["REFERENCES", "Reference", "largest_load"]

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]

_ROWS, _SAMPLES, _DEGREE = 800, 1000, 5
"""Rows of efforts that a run gives; samples of a check; degree of the splines through efforts."""

_SMOOTH, _STILL, _CREEPS = 1e-2, 1e-5, 1e-3
"""Difference of efforts, and rate at the ends, over the largest ones, beyond which there is a warning; rates
[rad/s, m/s] below which a motion is none."""


@dataclass(frozen=True, eq=False)
class Reference:
    """Positions of the motors and efforts of their drives, as rows of references; None: no efforts.

    The path begins ``lead`` [s] after them. ``warnings``: what is to be known about it.
    """

    positions: Followed
    efforts: Followed | None = None
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
            made = {name: one and Signal.of(one) for name, one in update.items()}
            drives[places[joint]] = drive.model_copy(update=made)
        end = max(robot.integration.duration, self.end)
        settings = robot.integration.model_copy(update={"duration": end})
        return robot.model_copy(update={"drives": tuple(drives), "integration": settings})

    def checks(self, robot: Robot, made: Robot, path: Followed) -> dict[str, float]:
        """Largest distance of the tip of the nominal robot from the path [m], by reference."""
        plain, task, found = Reference(path).applied(robot, path), Task(robot, path), {}
        tried: dict[str, Callable[[], Robot]] = {"rigid": lambda: plain, "this": lambda: made}
        if self.efforts is not None and all(d.feed_forward for d in made.drives if d.joint in path.joints):
            tried["open loop"] = lambda: _open_loop(made, path.joints, done)
        done: Any = None
        for name, one in tried.items():
            lead, end = (0.0, float(path.times[-1])) if name == "rigid" else (self.lead, self.end)
            try:
                done = _nominal(one(), end, _SAMPLES)
            except TmodesError:
                found[name] = float("nan")
                if name == "this":  # then it is not known from where the open loop begins
                    break
                continue
            tip = done.points.position[:, [point.name for point in done.chain.points].index("tip")]
            found[name] = float(np.linalg.norm(tip - task.along(done.times - lead).places, axis=1).max())
        return found


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
        hint = "add `limits: {speed: 3.0, effort: 100.0}` to its joints"
        raise InputError("--least-time", "no limit of speed or effort", "a limit of a joint that moves", hint)
    return max(shares)


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
    return Reference(positions, _rows(positions, done.times, efforts))


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


def _inverse(robot: Robot, path: Followed, tolerance: float, progress: Progress) -> Reference:
    known = vars(robot).get("nominal") or robot
    found = inverted(known, path, max(tolerance, 1e-9), lambda share: progress("inverse", share))
    own = replace(path, times=found.times, values=found.q[:, found.motors], rates=found.rates[:, found.motors],
                  accelerations=found.accelerations[:, found.motors])  # fmt: skip
    warnings = []
    if found.rough > _SMOOTH:
        warnings.append(
            f"the efforts are not smooth ({found.rough:.0%} differ with half as many instants), as the profile is not: "
            "take --profile '{type: polynomial, duration: ...}'"
        )
    if found.left > _STILL * max(float(np.abs(found.rates).max()), _CREEPS):
        warnings.append(
            f"the robot still moves by {found.left:.2g} rad/s, m/s where the motion is cut: what bends is hardly "
            "damped where the tip is held"
        )
    return Reference(own, _rows(path, found.times, found.efforts), found.lead, tuple(warnings))


REFERENCES: Mapping[str, Callable[[Robot, Followed, float, Progress], Reference]] = {
    "rigid": _rigid, "motors": _motors, "sag": _sag, "inverse": _inverse,
}  # fmt: skip
"""By name, from what is known least to most."""
