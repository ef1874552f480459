"""``tmodes.run``: simulate a robot and give the Result, of which everything else is asked."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from tmodes.result.ready import ready_to_run
from tmodes.result.result import Result, assemble_result
from tmodes.sheet import Robot, RobotPair
from tmodes.simulation.callback import Controller
from tmodes.simulation.parts import Journal
from tmodes.simulation.simulate import simulate_motion

__all__ = ["run"]


def run(
    robot: Robot | RobotPair,
    *,
    progress: Callable[[str, float], None] = lambda stage, share: None,
    journals: Callable[[str], Journal | None] = lambda stage: None,
    controller: Controller | None = None,
    stop: Sequence[str] = (),
) -> Result:
    """Plan with the robot as known, run the actual one under control, and return the :class:`tmodes.Result`.

    ``robot``: its ``real`` factors make the actual one; or a pair of your own. A robot without drives moves freely from
    its ``initial`` state. ``progress`` receives the stage and its share; ``journals`` gives where the stages
    ``reference`` and ``real`` keep their progress, so that an interrupted run resumes. ``controller``: a Python
    function in place of the sheet's controllers. ``stop``: conditions in addition to those of ``integration.stop``.

    A run that cannot continue keeps what it had: look at ``result.status`` and ``result.message``. Raises
    :class:`tmodes.errors.InputError` for what cannot be run, and :class:`tmodes.errors.SimulationError` where it cannot
    start.
    """
    pair = robot if isinstance(robot, RobotPair) else ready_to_run(robot).pair()
    done = simulate_motion(pair, progress=progress, journals=journals, controller=controller, stop=stop)
    return assemble_result(done, pair.nominal)
