"""Numbers of robots at rest: no simulation."""

from __future__ import annotations

import time as clock
from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from tmodes.sheet import Robot
from tmodes.simulation.vary.static_numbers import static_numbers
from tmodes.study.quantities import Needs
from tmodes.study.ways.part import Part

__all__ = ["by_statics"]

Array = NDArray[np.float64]


def by_statics(
    robot: Robot, vary: Mapping[str, Array], needs: Needs, threads: int | None, progress: Callable[[str, float], None]
) -> Part:
    """Static numbers of the cases ``vary`` (m,) of one robot; their seconds are a share of those of all.

    Raises :class:`tmodes.errors.InputError` for a name that is unknown.
    """
    began = clock.process_time()
    found = static_numbers(robot, vary, needs.static, threads=threads, progress=progress, wrong="row")
    size = len(found.status)
    seconds = np.full(size, (clock.process_time() - began) / size)
    return Part([*found.status], [*found.message], [""] * size, seconds, {**found.values}, {**found.units})
