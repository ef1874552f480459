"""Outputs of a run, reduced to one number, as functionals that the adjoint differentiates."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.equations.loop.outputs import COMMANDED, DEVIATION, DISTANCES
from tmodes.errors import InputError
from tmodes.gradients.quantities import Functional, reduced_output
from tmodes.sheet import Robot
from tmodes.simulation.outputs import robot_outputs
from tmodes.simulation.reductions import SMOOTH, Reduction, with_slope

__all__ = ["REFERENCED", "has_slope", "reduced_series"]

Array = NDArray[np.float64]

REFERENCED = (COMMANDED, DEVIATION)
"""Outputs that are distances of the tip from a reference."""


def reduced_series(
    robot: Robot, series: str, reduce: str, reference: Array | None, weights: list[Array], which: str
) -> Functional:
    """An output reduced by a rule that has a slope, over the samples.

    ``reference`` (n, 3): what the tip's distance is from. ``weights``: gets the derivatives by the tip, (n, 3), each
    time it is measured. Raises :class:`tmodes.errors.InputError` for what has no slope.
    """
    if reduce not in SMOOTH:
        hint = "a largest or least value has no slope everywhere; take rms, or --method tpe"
        raise InputError(f"{which}.reduce", reduce, f"one of {', '.join(SMOOTH)} for gradients", hint)
    if reference is None and robot_outputs(robot).find(series, f"{which}.series").name.startswith(tuple(DISTANCES)):
        expected = f"one of {', '.join(REFERENCED)}, or another output, for gradients"
        raise InputError(f"{which}.series", series, expected, "take one of these, or --method tpe")
    if reference is None:
        return reduced_output(series, reduce)

    def measure(times: Array, info: Mapping[str, Array]) -> tuple[float, Mapping[str, ArrayLike]]:
        values, slopes = _distance(info["tip"] - reference)
        value, shares = with_slope(Reduction(series, reduce), values, times)
        weights[:] = [shares[:, None] * slopes]
        return value, {"tip": weights[0]}

    return Functional(("tip",), measure)


def has_slope(reductions: Sequence[tuple[str, str]]) -> bool:
    """Whether a quantity that needs these reductions may have a slope by the adjoint."""
    return len(reductions) == 1 and reductions[0][1] in SMOOTH


def _distance(apart: Array) -> tuple[Array, Array]:
    size = np.linalg.norm(apart, axis=1)
    return size, apart / np.where(size > 0, size, np.inf)[:, None]
