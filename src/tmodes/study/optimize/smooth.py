"""Series of a run, reduced to one number, as functionals that the adjoint differentiates."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.equations.loop.outputs import COMMANDED, DEVIATION
from tmodes.errors import InputError
from tmodes.gradients.quantities import Functional
from tmodes.sheet import Robot
from tmodes.simulation.start import run_setup

__all__ = ["REFERENCED", "has_slope", "reduced_series"]

Array = NDArray[np.float64]

REFERENCED = (COMMANDED, DEVIATION)
"""Series that are distances of the tip from a reference."""

_AXES = "xyz"

Seen = Callable[[Array], tuple[Array, Array]]
"""From what is observed (n, size) to the series (n,), and its slopes (n, size)."""


def reduced_series(
    robot: Robot, series: str, reduce: str, reference: Array | None, weights: list[Array], which: str
) -> Functional:
    """A series reduced by ``rms``, ``mean`` or ``end`` over the samples, by the trapezoidal rule.

    ``reference`` (n, 3): what the tip's distance is from. ``weights``: gets the derivatives by the tip, (n, 3), each
    time it is measured. Raises :class:`tmodes.errors.InputError` for what has no slope.
    """
    if reduce not in _REDUCED:
        hint = "a largest or least value has no slope everywhere; take rms, or --method tpe"
        raise InputError(f"{which}.reduce", reduce, f"one of {', '.join(_REDUCED)} for gradients", hint)
    name, seen = _seen(robot, series, reference, which)

    def measure(times: Array, info: Mapping[str, Array]) -> tuple[float, Mapping[str, ArrayLike]]:
        values, slopes = seen(np.asarray(info[name]))
        value, shares = _REDUCED[reduce](_time_shares(times), values)
        weights[:] = [shares[:, None] * slopes]
        return value, {name: weights[0]}

    return Functional((name,), measure)


def has_slope(reductions: Sequence[tuple[str, str]]) -> bool:
    """Whether a quantity that needs these reductions may have a slope by the adjoint."""
    return len(reductions) == 1 and reductions[0][1] in _REDUCED


def _seen(robot: Robot, series: str, reference: Array | None, which: str) -> tuple[str, Seen]:
    """What is observed for a series, and how it follows."""
    if reference is not None:
        return "tip", lambda tip: _distance(tip - reference)
    head, _, tail = series.rpartition(".")
    if head == "tip" and tail in _AXES:
        return "tip", _column(_AXES.index(tail))
    model = run_setup(robot.pair().real).model
    if head in model.coordinates and tail in ("position", "velocity"):
        start = model.layout.q.start if tail == "position" else model.layout.v.start
        return "state", _column(start + model.coordinates.index(head))
    expected = (
        f"one of {', '.join(REFERENCED)}, tip.x, tip.y, tip.z, a coordinate's position or velocity, for gradients"
    )
    raise InputError(f"{which}.series", series, expected, "take one of these, or --method tpe")


def _column(k: int) -> Seen:
    def seen(values: Array) -> tuple[Array, Array]:
        slopes = np.zeros_like(values)
        slopes[:, k] = 1.0
        return values[:, k], slopes

    return seen


def _distance(apart: Array) -> tuple[Array, Array]:
    size = np.linalg.norm(apart, axis=1)
    return size, apart / np.where(size > 0, size, np.inf)[:, None]


def _time_shares(times: Array) -> Array:
    """Weights of samples in a mean over time, (n,)."""
    steps = np.diff(times)
    return (np.append(steps, 0.0) + np.append(0.0, steps)) / (2 * (times[-1] - times[0]))


def _rms(shares: Array, series: Array) -> tuple[float, Array]:
    value = float(np.sqrt(shares @ series**2))
    return value, shares * series / (value or np.inf)


def _mean(shares: Array, series: Array) -> tuple[float, Array]:
    return float(shares @ series), shares


def _end(shares: Array, series: Array) -> tuple[float, Array]:
    last = np.zeros_like(shares)
    last[-1] = 1.0
    return float(series[-1]), last


_REDUCED: dict[str, Any] = {"rms": _rms, "mean": _mean, "end": _end}
