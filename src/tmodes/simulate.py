"""RUN: the robot as it is known plans the motion, the robot as it really is runs under control.

pair -> reference regime (nominal robot, motor follows theta_o exactly) -> controlled run (real robot) -> Result
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from tmodes.analysis.modes import all_modes, closed_loop_eigenvalues
from tmodes.analysis.settling import settling
from tmodes.analysis.stability import step_size_verdict
from tmodes.mechanism import Drive
from tmodes.regime import run_regime
from tmodes.robot import NominalRealPair, Robot
from tmodes.trajectory import Journal

if TYPE_CHECKING:
    from tmodes.result import Result

__all__ = ["simulate"]

Progress = Callable[[str, float], None]


def simulate(
    robot: Robot | NominalRealPair,
    *,
    progress: Progress = lambda stage, share: None,
    journals: Callable[[str], Journal | None] = lambda stage: None,
) -> Result:
    """Plan with the known robot, run with the real one, and gather everything into a Result.

    Give a :class:`Robot` (its ``real`` factors make the real one) or a pair of your own. A run that cannot go on keeps
    what it had: look at ``result.status`` and ``result.message``. Raises :class:`tmodes.errors.SimulationError` when it
    cannot start (no gravity equilibrium, singular mass matrix).
    """
    from tmodes.assemble import assemble

    pair = robot if isinstance(robot, NominalRealPair) else robot.pair()
    reference = run_regime(pair.nominal, Drive.PRESCRIBED, lambda share: progress("reference", share), journals)
    no_reference = reference.trajectory.status != "finished"
    real = run_regime(
        pair.real, Drive.CONTROLLED, lambda share: progress("real robot", share), journals, begin_only=no_reference
    )
    verdict = step_size_verdict(pair.real.integration, closed_loop_eigenvalues(pair.real, drive=Drive.CONTROLLED))
    progress("gathering", 0.0)
    finished = not no_reference and real.trajectory.status == "finished"
    told = {
        "frequencies": all_modes(pair.real, contact=False),
        "settling": settling(reference, real) if finished else None,
    }
    result = assemble(pair, reference, real, told, verdict)
    progress("gathering", 1.0)
    return result
