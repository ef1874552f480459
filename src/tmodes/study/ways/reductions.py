"""Cases whose series are reduced to numbers in the native loop, and numbers of robots at rest: the fast ways."""

from __future__ import annotations

import time as clock
from collections.abc import Callable, Collection, Mapping

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, InputErrors, SimulationError
from tmodes.sheet import Robot
from tmodes.simulation.batch.executor import Executor
from tmodes.simulation.case_results import CaseResults
from tmodes.simulation.vary.programs import refused_cases
from tmodes.simulation.vary.reduce import Reduction, reduced
from tmodes.simulation.vary.static_numbers import static_numbers
from tmodes.simulation.vary.values import Whole
from tmodes.study.quantities import Needs

__all__ = ["by_reductions", "by_statics"]

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]


def by_reductions(
    robot: Robot, vary: Mapping[str, Array], needs: Needs, kept: Collection[int],
    threads: int | None, progress: Progress, whole: Whole | None, executor: Executor,
) -> CaseResults:  # fmt: skip
    """Reductions of the cases ``vary`` (m,) of one robot, and the motions of those ``kept``, by index.

    Raises :class:`tmodes.errors.InputError` for a series or a rule that is unknown.
    """
    asked = {Reduction(*pair): pair for pair in needs.reductions}
    size = len(next(iter(vary.values())))
    try:
        found = reduced(
            robot, vary, [*asked], threads=threads, progress=progress, kept=kept, wrong="row", whole=whole,
            executor=executor,
        )  # fmt: skip
    except SimulationError as error:
        return CaseResults.of_all(size, "failed", str(error))
    except (InputError, InputErrors):
        refused = refused_cases(robot, vary)
        if len(refused) < size:
            raise
        found = CaseResults.of_all(size)
        found.put(refused, "refused")
        return found
    found.message[found.status == "finished"] = ""
    found.values = {asked[one]: values for one, values in found.values.items()}
    found.units = {asked[one]: unit for one, unit in found.units.items()}
    return found


def by_statics(
    robot: Robot, vary: Mapping[str, Array], needs: Needs, threads: int | None, progress: Progress
) -> CaseResults:
    """Static numbers of the cases ``vary`` (m,) of one robot; their seconds are a share of those of all.

    Raises :class:`tmodes.errors.InputError` for a name that is unknown.
    """
    began = clock.process_time()
    found = static_numbers(robot, vary, needs.static, threads=threads, progress=progress, wrong="row")
    found.seconds[:] = (clock.process_time() - began) / len(found)
    return found
