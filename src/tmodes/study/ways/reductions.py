"""Cases whose series are reduced to numbers in the native loop: the fast way."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, InputErrors, SimulationError
from tmodes.sheet import Robot
from tmodes.simulation.batch.runner import Runner
from tmodes.simulation.batch.simulate import thread_count
from tmodes.simulation.vary.kept import Kept as KeptCase
from tmodes.simulation.vary.kept import kept_cases
from tmodes.simulation.vary.programs import refused_cases
from tmodes.simulation.vary.reduce import Reduction, reduced
from tmodes.simulation.vary.values import Whole
from tmodes.study.quantities import Needs
from tmodes.study.rows import Kept
from tmodes.study.ways.part import Part

__all__ = ["by_reductions", "motions_of"]

Array = NDArray[np.float64]


def by_reductions(
    robot: Robot, vary: Mapping[str, Array], needs: Needs, kept: Collection[int],
    threads: int | None, progress: Callable[[str, float], None], whole: Whole | None, runner: Runner,
) -> Part:  # fmt: skip
    """Reductions of the cases ``vary`` (m,) of one robot, and the motions of those ``kept``, by index.

    Raises :class:`tmodes.errors.InputError` for a series or a rule that is unknown.
    """
    asked = {pair: Reduction(*pair) for pair in needs.reductions}
    size = len(next(iter(vary.values())))
    try:
        found = reduced(
            robot, vary, [*asked.values()], threads=threads, progress=progress, kept=kept, wrong="row", whole=whole,
            runner=runner,
        )  # fmt: skip
    except SimulationError as error:
        return Part.of_all(size, "failed", str(error))
    except (InputError, InputErrors):
        refused = refused_cases(robot, vary)
        if len(refused) < size:
            raise
        part = Part.of_all(size, "refused")
        part.reason = [refused[k] for k in range(size)]
        return part
    ended = zip(found.status, found.message, strict=True)
    words = ["" if status == "finished" else why for status, why in ended]
    return Part(
        [*found.status], words, [*found.method], np.asarray(found.seconds, dtype=float),
        {pair: found.values[one] for pair, one in asked.items()},
        {pair: found.units[one] for pair, one in asked.items()},
        kept={case: _motion(one) for case, one in found.kept.items()}, errors=found.errors,
    )  # fmt: skip


def _motion(one: KeptCase) -> Kept:
    return Kept(one.times, one.states, one.tips, tuple(one.coordinates))


def motions_of(
    robot: Robot, vary: Mapping[str, Array], kept: Collection[int], part: Part, threads: int | None,
    progress: Callable[[str, float], None],
) -> dict[int, Kept]:  # fmt: skip
    """Motions of the cases ``kept``, by index, of those that can be run; ``part``: how each of them ended."""
    found = kept_cases(robot, vary, kept, part.status, threads=thread_count(threads), progress=progress)
    return {case: _motion(one) for case, one in found.items()}
