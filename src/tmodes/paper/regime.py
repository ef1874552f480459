"""One robot in motion: planned as it is known, or under control as it really is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.integrate.settings import Integration
from tmodes.paper.mechanism import Drive, Parameters
from tmodes.paper.model import PaperModel
from tmodes.paper.sheet import PaperRobot
from tmodes.simulation.error_estimate import with_error
from tmodes.simulation.stops import Stops
from tmodes.simulation.trajectory import Journal, Trajectory, integrate

__all__ = ["PaperRun", "run_paper"]


@dataclass(frozen=True)
class PaperRun:
    """One robot in motion: its model, its numbers, and the trajectory that it took."""

    robot: PaperRobot
    model: PaperModel
    parameters: Parameters
    rows: NDArray[np.float64]
    trajectory: Trajectory

    def observed(self, count: int) -> dict[str, NDArray[np.float64]]:
        """What the model gives at the first ``count`` samples, by the names of ``OBSERVED``."""
        run = self.trajectory
        return self.model.observe(run.times[:count], run.states[:count], self.rows[:count], self.parameters)


def run_paper(
    robot: PaperRobot,
    drive: Drive,
    progress: Callable[[float], None] = lambda share: None,
    journals: Callable[[str], Journal | None] = lambda stage: None,
    until: float | None = None,
    stops: Stops | None = None,
    otherwise: Integration | None = None,
) -> PaperRun:
    """Run one robot from rest in its own equilibrium, its motor controlled or following theta_o exactly.

    ``until`` [s] ends the run before its duration (it is then kept in no journal); 0 gives the first sample alone.
    ``stops``: conditions (:func:`tmodes.paper.quantities.robot_stops`) of which the first that triggers ends the run.
    ``otherwise``: the settings to go on with where the motion turns out stiff; None: those of the robot to the end.
    Raises :class:`tmodes.errors.SimulationError` where there is no equilibrium, the mass matrix is singular, or a
    condition holds at the start.
    """
    mechanism, parameters = robot.split(drive)
    model, schedule, settings = PaperModel(mechanism), robot.wanted(drive), robot.integration
    start = model.rest(robot.reference.start, parameters)
    model.check_mass_matrix(start, parameters)
    motion = (model, parameters, schedule, start)
    rows = schedule.until(settings.duration)
    if until is not None and until <= 0:
        trajectory = Trajectory(np.zeros(1), start[None, :], "stopped", "not begun")
    else:
        journal = journals(drive.value) if until is None else None
        settings = settings if until is None else settings.model_copy(update={"duration": until})
        trajectory = integrate(*motion, settings, progress, journal, otherwise, stops)
        later = otherwise and otherwise.finer()
        trajectory = with_error(trajectory, settings, lambda changed: integrate(*motion, changed, otherwise=later))
    return PaperRun(robot, model, parameters, rows.rows_at(trajectory.times), trajectory)
