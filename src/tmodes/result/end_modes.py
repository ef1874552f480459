"""The modes about the pose in which a run ends: what a tip that comes to rest there vibrates with."""

from __future__ import annotations

from typing import Any

from tmodes.analysis.modes.of_sheet import frequencies_about
from tmodes.analysis.rigid import nominal_of
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.analysis.statics.equilibrium import steady_rates
from tmodes.errors import SimulationError
from tmodes.kinds.signals.registry import constant_signal
from tmodes.sheet import Robot
from tmodes.simulation.motion_run import RunData

__all__ = ["end_modes", "held_at"]

Modes = list[dict[str, Any]]


def end_modes(run: RunData, *states: str) -> Modes:
    """Modes about the rest at the last setpoints and loads, of the first of ``states`` of the motors that there is.

    Joints without a setpoint are where the run ends. None where that is no rest, or the end a motion at constant speed.
    """
    if steady_rates(run.robot, run.model):
        return []
    robot = held_at(run.robot, float(run.times[-1]), dict(zip(run.coordinates, run.q[-1].tolist(), strict=True)))
    try:
        rest = robot_rest(robot, model=run.model)
        found = (frequencies_about(robot, rest, state).get(state) for state in states)
        return next(filter(None, found), [])
    except SimulationError:
        return []


def held_at(robot: Robot, end: float, place: dict[str, float]) -> Robot:
    """The robot whose signals stay as they are at ``end`` [s], without noise; it begins at coordinates ``place``."""

    def still(signal: Any) -> Any:
        return signal and constant_signal(float(signal.schedule(max(end, robot.integration.duration)).at(end)))

    drives = [
        one.model_copy(
            update={
                "signal": still(one.signal),
                "feed_forward": still(one.feed_forward),
                "brake": still(one.brake),
                "noise": None,
                "motion": None,
            }
        )
        for one in robot.drives
    ]
    loads = [one.model_copy(update={"signal": still(one.signal)}) for one in robot.loads]
    initial = robot.initial.model_copy(update={"coordinates": place})
    found = robot.model_copy(update={"drives": tuple(drives), "loads": tuple(loads), "initial": initial})
    vars(found)["nominal"] = nominal_of(robot)  # by which its laws are designed
    return found
