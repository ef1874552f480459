"""Linear models of a robot: what ``tmodes linear`` computes and prints."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from tmodes.analysis.margins import Margins
from tmodes.errors import InputError
from tmodes.interface.linear_model import LinearModel
from tmodes.interface.poses import Pose, pose_of, pose_words
from tmodes.interface.statics import circumstances
from tmodes.interface.variants import uncertain_of, uncertain_robots
from tmodes.io.arguments import checked_arguments
from tmodes.io.files import FilePath
from tmodes.kinds.schema.quantity import too_late

if TYPE_CHECKING:
    from tmodes.sheet import Robot
    from tmodes.simulation.linear import StateSpace

__all__ = ["LinearModel", "Margins", "linearize"]

Progress = Callable[[str, float], None]


@checked_arguments
def linearize(
    robot: Robot,
    *,
    at: Pose | None = None,
    time: float | None = None,
    inputs: str | Sequence[str] | None = None,
    outputs: str | Sequence[str] | None = None,
    closed: bool = False,
    loop: str | None = None,
    period: float | None = None,
    delay: float = 0.0,
    contact: bool = True,
    uncertain: Mapping[str, Any] | FilePath | None = None,
    cases: int = 50,
    seed: int = 0,
    progress: Progress = lambda stage, share: None,
) -> LinearModel:
    """The robot in small motions about its rest: M, D, K, and x' = A x + B u, y = C x + D u with named signals.

    At the pose ``at`` [rad, m], or the ``time`` [s] of its run (where ``system.rate`` is how the states change, and
    M, D, K are of its start), else where the first commands of its drives hold it, under weight and loads;
    ``contact`` with the surface that it touches. ``inputs``: commands of drives (``shoulder.torque``, ``.voltage``,
    ``.effort``) and loads on points (``tip.force.z``, ``tip.moment.x``); ``outputs``: any names of ``tmodes outputs``,
    and sensors. Without names: all drives, and the angles of their joints; without drives, of all joints. A joint
    without a drive that is named gets one, all others stay where they are and are no states.

    Open loop, or under the controllers of the sheet about the start of its run (``closed``), with ``JOINT.setpoint``
    and, apart, ``JOINT.setpoint_rate`` as inputs: a law that uses the rate needs both for smooth motions. A closed one
    has ``loops``, which its controllers close; ``loop`` names a drive: that loop, opened at its command. With a
    ``period`` [s] sampled, with a zero-order hold and a ``delay`` [s] of any length; sampled controllers sample by
    themselves. Where drives or the base turn at constant speed M, D, K are about that motion, and A, B, C, D
    about rest. Dry friction that sticks is left out. The derivatives are exact, of the compiled equations.

    ``uncertain``: as of :func:`tmodes.compare`, or its file: then ``family`` has the models of so many ``cases``.

    Errors: :class:`tmodes.errors.InputError` for an unknown name, :class:`tmodes.errors.SimulationError` where it finds
    no rest. Source: K. J. Astrom, B. Wittenmark, Computer-Controlled Systems, 3rd ed., chapters 2 and 3.

    >>> linear = tmodes.load("spong1987").linearize(inputs="joint.torque", outputs="joint.position")
    >>> linear.mass.shape, linear.A.shape, linear.B.shape
    ((2, 2), (4, 4), (4, 1))
    >>> round(float(abs(linear.poles[0])), 3)
    2.738
    """
    from tmodes.analysis.statics.at_rest import robot_rest
    from tmodes.simulation.control import designs
    from tmodes.simulation.drive_loops import drive_loops
    from tmodes.simulation.linear import closed_loop, delayed, open_loop, without_held
    from tmodes.simulation.linear_inputs import all_inputs, driven

    closed, chosen = closed or loop is not None, (_names(inputs, "inputs"), _names(outputs, "outputs"))
    _refuse(robot, closed=closed, at=at, time=time, period=period, delay=delay)
    robot = robot.pathless if time is None and not closed else robot.commanded(progress)
    robot = robot if closed else driven(robot, chosen[0])
    outs = [f"{drive.joint}.position" for drive in robot.drives] or ["tip.x", "tip.y", "tip.z"]
    held = pose_of(at, robot)
    if loop is not None and (inputs or outputs or period is not None):
        hint = "leave these out: its input and output are the command of the drive"
        raise InputError("loop", f"`{loop}` with inputs, outputs or a period", "a drive alone", hint)

    def made() -> StateSpace:
        own = chosen[0] or all_inputs(robot, closed=closed), chosen[1] or outs
        if closed:
            found = closed_loop(robot, *own, time)
        else:
            pose = dict(rest.named) if held is None else held
            found = open_loop(robot, *own, held=_drives(robot, pose), time=time, contact=contact, progress=progress)
        found = without_held(found)
        if period is not None and found.period is not None:
            got, expected = f"{period:g} s", f"left out: the controllers sample by themselves, every {found.period:g} s"
            raise InputError("period", got, expected, "remove it; delays stand in the sheet")
        return found if period is None else delayed(found, period, delay)

    if closed and time is None:  # where gains leave the robot
        system = made()
        n = next(k for k, name in enumerate(system.states) if name.endswith("'"))
        held = _drives(robot, dict(zip(system.states[:n], system.x0[:n].tolist(), strict=True)))
        made = partial(replace, system)
    rest = robot_rest(robot, held=held, contact=contact, moving=True, progress=progress)

    def loops() -> Mapping[str, StateSpace]:
        return drive_loops(robot, time)

    where = circumstances(robot, contact=contact, at=pose_words(at))
    where = where if time is None else f"at {time:g} s of its run"
    matrices = rest.matrices
    family = []
    for k, one in enumerate(uncertain_robots(robot, uncertain_of(uncertain), cases, seed)):
        progress("uncertain robots", k / cases)
        same = {"at": at, "time": time, "inputs": inputs, "outputs": outputs, "closed": closed, "loop": loop}
        family.append(linearize(one, **same, period=period, delay=delay, contact=contact).system)
    found = LinearModel(
        robot.name, where, rest.model.coordinates, rest.q, *matrices, made, closed, tuple(family), opened=loops,
        e_max={name: block.robustness for name, block in designs(robot).items() if block.robustness} if closed else {},
    )  # fmt: skip
    if loop is not None:
        return replace(found.loop(loop), family=tuple(family))
    if inputs is not None or outputs is not None or closed or period is not None or time is not None:
        _ = found.system  # wrong names are said at once
    return found


def _refuse(
    robot: Robot, *, closed: bool, at: Pose | None, time: float | None, period: float | None, delay: float
) -> None:
    if closed and at is not None:
        hint = "leave out `at`: it is the start of the run, see `initial` in the sheet"
        raise InputError("at", str(pose_words(at)), "left out with `closed`", hint)
    if time is not None and (at is not None or not 0 <= time <= robot.integration.duration):
        expected = f"a time within the run of {robot.integration.duration:g} s, without `at`"
        raise InputError("time", f"{time:g} s", expected, "write time=0.5, or at={'shoulder': 0.4}")
    if (period is None and delay) or (period is not None and not period > 0) or delay < 0:
        expected = "a period above 0 s, and a delay of 0 s or more"
        raise InputError("period", f"{period!r} s with a delay of {delay:g} s", expected, "write period=1e-3 for 1 kHz")
    for issue in too_late(delay, period):
        raise InputError(*issue)
    if closed and not robot.control and not any(drive.command.is_controlled for drive in robot.drives):
        hint = "leave out `closed`, or give a drive `command: position` and a `controller`"
        raise InputError("closed", "a robot without controllers", "one whose controllers close a loop", hint)


def _names(given: str | Sequence[str] | None, which: str) -> tuple[str, ...]:
    names = tuple(name.strip() for name in given.split(",")) if isinstance(given, str) else tuple(given or ())
    if again := [name for k, name in enumerate(names) if name in names[:k]]:
        raise InputError(which, f"`{again[0]}` twice", "each name once", "leave one out")
    return names


def _drives(robot: Robot, pose: Mapping[str, Any]) -> dict[str, Any]:
    """Of a pose the coordinates that drives hold."""
    names = robot.undriven.chain().coordinates
    motors = [f"{one.joint}.motor" if f"{one.joint}.motor" in names else one.joint for one in robot.drives]
    return {name: value for name, value in pose.items() if name in motors or name.removesuffix(".motor") in pose}
