"""Series of a run, reduced to one number, as functionals that the adjoint differentiates."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.errors import InputError
from tmodes.sensitivity.quantities import Functional

__all__ = ["SMOOTH", "functional_of", "time_shares"]

Array = NDArray[np.float64]

SMOOTH = "rms, mean, end"
"""Reductions with a slope everywhere but at zero."""

_AXES = "xyz"


def functional_of(series: str, reduce: str, nominal: Callable[[], Array], which: str) -> Functional:
    """A series reduced by ``rms``, ``mean`` or ``end`` over the samples, by the trapezoidal rule.

    ``deviation`` (of the tip from ``nominal`` (n, 3)) and the parts of the tip's position, ``tip.x``. Raises
    :class:`tmodes.errors.InputError` for others.
    """
    if reduce not in _REDUCED:
        hint = "a largest value has no slope; take rms, or --method tpe"
        raise InputError(which, f"the reduction {reduce}", f"one of {SMOOTH}, for gradients", hint)
    seen = _seen(series, nominal, which)
    return Functional(("tip",), lambda times, info: _measured(times, np.asarray(info["tip"]), seen, _REDUCED[reduce]))


Seen = Callable[[Array], tuple[Array, Array]]
"""From the tip (n, 3) to the series (n,), and its slopes (n, 3)."""


def _seen(series: str, nominal: Callable[[], Array], which: str) -> Seen:
    head, _, axis = series.partition(".")
    if series == "deviation":
        reference = nominal()
        return lambda tip: _distance(tip - reference)
    if head == "tip" and axis in _AXES and axis:
        unit = np.eye(3)[_AXES.index(axis)]
        return lambda tip: (tip @ unit, np.broadcast_to(unit, tip.shape))
    expected = "deviation or tip.x, tip.y, tip.z, for gradients"
    raise InputError(which, f"the series {series}", expected, "take one of these, or --method tpe")


def _distance(apart: Array) -> tuple[Array, Array]:
    size = np.linalg.norm(apart, axis=1)
    return size, apart / np.where(size > 0, size, np.inf)[:, None]


def _measured(times: Array, tip: Array, seen: Seen, reduced: Any) -> tuple[float, Mapping[str, ArrayLike]]:
    series, slopes = seen(tip)
    value, weights = reduced(time_shares(times), series)
    return value, {"tip": weights[:, None] * slopes}


def time_shares(times: Array) -> Array:
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


_REDUCED = {"rms": _rms, "mean": _mean, "end": _end}
