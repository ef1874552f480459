"""The settings that runs at equal error are tried with, from loose to tight, and SciPy's run of a rate function."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.bench.clock import now
from tmodes.errors import CompileError
from tmodes.integrate.registry import integrator, integrators

Array = NDArray[np.float64]

__all__ = ["STEPS", "TOLERANCES", "adaptive_methods", "solved", "tolerances_of"]

TOLERANCES = tuple(10.0**-power for power in np.arange(3.0, 12.1, 0.5))
"""Relative tolerances of adaptive methods."""

STEPS = tuple(round(25 * 2.0 ** (k / 2)) for k in range(29))
"""Numbers of equal steps."""


def tolerances_of(method: str) -> tuple[float, ...]:
    """Those that a method takes."""
    least = integrator(method).least_tolerance
    return tuple(max(info, least) for info in TOLERANCES if info > 0.9 * least)


def adaptive_methods(loops: Any) -> list[str]:
    """The methods with a tolerance for which there is a native loop."""

    def there(method: str) -> bool:
        try:
            return loops[method] is not None
        except (KeyError, CompileError):  # none for this kind of robot, or none for one so large
            return False

    return [method for method, one in integrators().items() if one.adaptive and there(method)]


def solved(
    rate: Callable[[float, Array, Array], Any],
    start: Array,
    knots: Sequence[float],
    rows: Sequence[Array],
    method: Any,
    tolerance: float,
    samples: Array,
) -> tuple[float, Array]:
    """Time [s] of ``solve_ivp`` and its states at ``samples`` [s], the last of which is the end.

    It restarts at every knot, so that no step crosses a jump. ``rate(t, state, row)``; the absolute tolerance is a
    thousandth of the relative one.
    """
    from scipy.integrate import solve_ivp

    state, found, began = start, [], now()
    for left, right, row in zip(knots[:-1], knots[1:], rows, strict=True):
        wanted = samples[(samples > left) & (samples <= right)]
        options = {"rtol": tolerance, "atol": tolerance * 1e-3, "args": (row,)}
        states = solve_ivp(rate, (left, right), state, method, np.union1d(wanted, [right]), **options).y.T
        found.append(states[: len(wanted)])
        state = states[-1]
    return now() - began, np.concatenate(found)
