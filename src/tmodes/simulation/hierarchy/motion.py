"""The motion on which link models are judged: the sheet's own, whatever its drives command, under all its loads."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.error_parts import tips, without_elasticity
from tmodes.errors import SimulationError
from tmodes.integrate.choice import chosen_method, otherwise
from tmodes.integrate.registry import AUTO
from tmodes.kinds.signals.registry import quintic_move
from tmodes.sheet import Robot
from tmodes.sheet.parts import Command, DriveSheet
from tmodes.simulation.hierarchy.variants import driven, whole_chain
from tmodes.simulation.initial_state import RunSetup, run_setup, run_trajectory
from tmodes.simulation.motion_run import tip_motion
from tmodes.simulation.parts import Trajectory, sample_times
from tmodes.simulation.plan import Follow, starts_at_rest
from tmodes.simulation.warnings import jumps

__all__ = ["Motion", "moved", "with_motion"]

Array = NDArray[np.float64]

AMPLITUDE = 0.2
"""Travel [rad, m] of each joint of a robot that nothing in its sheet moves."""

_SHORTEST, _LONGEST = 0.5, 5.0
"""Duration of that move [s]: at least, at most."""

_SAMPLES = 100
"""Least number of samples of a motion."""

_TIGHTEST, _LOOSEST = 1e-10, 1e-6
"""Tolerances between which motions are integrated: below it implicit steps are rounding."""


class Motion(NamedTuple):
    """``tip`` (n, 3) [m] at the samples; ``deflection`` (n,) [m]: its distance from where it is without elasticity.

    ``highest`` [1/s]: largest eigenvalue at the start, which bounds explicit steps; ``how``: who moves it, in words.
    """

    tip: Array
    deflection: Array
    highest: float
    how: str


def with_motion(robot: Robot, lowest_frequency: float) -> tuple[Robot, str]:
    """The nominal robot with something that moves it, and that in words, empty where that is its sheet's own.

    A robot that begins at rest, and has neither drives nor loads that change, makes 0.2 rad in each joint that could
    have a drive, in max(0.5 s, three periods).
    """
    robot = robot.model_copy(update={"real": {}})
    joints = [axis.name for axis in driven(whole_chain(robot))]
    changing = robot.drives or robot.base_motion or any(load.signal for load in robot.loads)
    if changing or robot.initial.rates or not starts_at_rest(robot) or not joints:
        return robot, ""
    until = float(np.clip(3 / max(lowest_frequency, 1e-9), _SHORTEST, _LONGEST))
    known = robot.initial.coordinates
    starts = [known.get(f"{name}.motor", known.get(name, 0.0)) for name in joints]
    drives = tuple(
        DriveSheet(joint=name, command=Command.PRESCRIBED, signal=quintic_move(start, start + AMPLITUDE, until))
        for name, start in zip(joints, starts, strict=True)
    )
    settings = robot.integration.model_copy(update={"duration": 1.3 * until})
    words = f"{AMPLITUDE:g} rad (m) in each joint in {until:.3g} s, quintic, as nothing in the sheet moves the robot"
    return robot.model_copy(update={"drives": drives, "integration": settings}), words


def moved(robot: Robot, allowed: float = _LOOSEST) -> Motion:
    """The motion of a robot: its nominal run where motors can follow their setpoints exactly, else by its drives.

    ``allowed``: error of a step [rad, m]. The method is chosen by the stiffness, as one model of the links may be far
    stiffer than that of the sheet. Raises :class:`tmodes.errors.SimulationError` where the run does not reach its end,
    and :class:`tmodes.errors.InputError` where a controller needs coordinates that are not there.
    """
    given = robot.integration
    tolerance = float(np.clip(allowed, _TIGHTEST, _LOOSEST))
    settings = given.model_copy(update={
        "method": AUTO, "output_step": min(given.output_step, given.duration / _SAMPLES), "check_error": False,
        "relative_tolerance": tolerance, "absolute_tolerance": 1e-2 * tolerance,
    })  # fmt: skip
    setup, how = _setup(robot.model_copy(update={"integration": settings}))
    if not setup.model.coordinates:
        still = tips(setup.mechanics, [np.zeros((1, 0))])[0].repeat(len(sample_times(settings)), axis=0)
        return Motion(still, np.zeros(len(still)), 0.0, how)
    highest = setup.spectrum.highest
    method, _ = chosen_method(settings, highest)
    setup = setup.by(method, otherwise(settings, method))
    done = run_trajectory(setup)
    if done.status != "finished":
        raise SimulationError(done.message)
    return Motion(*_tips(setup, done), highest, how)


def _setup(robot: Robot) -> tuple[RunSetup, str]:
    if any(drive.command is Command.POSITION for drive in robot.drives):
        nominal = run_setup(robot, Follow.WANTED)
        if not jumps(nominal):
            return nominal, "motors at their setpoints"
    return run_setup(robot), "drives and loads as in the sheet"


def _tips(setup: RunSetup, done: Trajectory) -> tuple[Array, Array]:
    times, q = done.times, done.states[:, setup.model.layout.q]
    tip, _ = tip_motion(setup, times, done.states)
    straight = done.states.copy()
    straight[:, setup.model.layout.q] = without_elasticity(setup.mechanics, q)
    return tip, np.linalg.norm(tip - tip_motion(setup, times, straight)[0], axis=1)
