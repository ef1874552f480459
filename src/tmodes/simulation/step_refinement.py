"""Step refinement: the same motion integrated with finer steps, whose difference is the error of a run."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from tmodes.integrate.settings import Integration
from tmodes.simulation.initial_state import RunSetup, run_trajectory
from tmodes.simulation.parts import Trajectory
from tmodes.simulation.stops import STOPPED

__all__ = ["refined_run"]


def refined_run(
    setup: RunSetup, first: Trajectory, progress: Callable[[float], None] = lambda share: None
) -> Trajectory | None:
    """A run from the same start to the same end, of the same samples, with finer steps.

    Every piece of the signals is halved too: where pieces, not tolerances, hold the steps short, these are refined all
    the same. None where there is no such run: the first one did not reach its end, a Python function controls it, or
    the second one is lost. ``progress`` is given the share that is done. Raises KeyboardInterrupt where it is
    interrupted.
    """
    if first.status not in {"finished", STOPPED} or setup.callback or len(first.times) < 2:
        return None

    def refined(settings: Integration) -> Integration:
        return settings.refined()[0].model_copy(update={"duration": float(first.times[-1])})

    signals = setup.planned.signals.halved()
    robot = setup.robot.model_copy(update={"integration": refined(setup.robot.integration)})
    planned = replace(setup.planned, signals=signals, schedule=signals.schedule)
    later = setup.otherwise and refined(setup.otherwise)
    second = run_trajectory(replace(setup, robot=robot, planned=planned, otherwise=later), progress)
    if second.status == "interrupted":
        raise KeyboardInterrupt
    return second if second.status == "finished" and len(second.times) == len(first.times) else None
