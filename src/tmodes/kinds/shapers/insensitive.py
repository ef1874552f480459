"""The extra-insensitive shaper: a tolerated vibration at its frequency, none at one below and one above."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from tmodes.errors import InputError
from tmodes.kinds.noted.functions import array, cos, exp, sin, sqrt
from tmodes.kinds.noted.number import Lost, is_noted, plain_value
from tmodes.kinds.schema.quantity import quantity
from tmodes.kinds.shapers.contract import SHAPERS, Impulses, Shaper

__all__ = ["EI"]

Array = NDArray[Any]

_STEP = 0.02
"""Step of the damping ratio in which the solution is followed from the undamped one."""

_NEWTON = 12
"""Newton steps at each."""

_ROUNDS, _SOLVED = 16, 1e-11
"""Steps of the chord method from the plain solution to that of noted numbers, and the last one that is rounding."""


@SHAPERS.register
class EI(Shaper):
    """Three impulses over a period, wide about the frequency: there a ``tolerated`` vibration remains.

    The exact solution, damped too, not the fit of its curves: sum 1, residual ``tolerated`` at the frequency, zero at
    a lower and a higher one. Source: W. Singhose, W. Seering, N. Singer, Residual vibration reduction using vector
    diagrams to generate shaped inputs, ASME J. Mechanical Design 116 (1994), 654-659.
    """

    type: Literal["ei"] = Field(description="kind of shaper")
    tolerated: float = quantity(
        "-", "V", "vibration that is tolerated, over that without shaper", above=0.0, at_most=0.5, default=0.05
    )

    def of_mode(self, damping: Any) -> Impulses:
        """By Newton's method from the undamped one; raises :class:`tmodes.errors.InputError` where there is none."""
        ratio, tolerated = plain_value(damping), plain_value(self.tolerated)
        found = _solved(ratio, tolerated)
        if found is None:
            got, hint = f"a damping ratio of {ratio:g}", "take `zvd`, or a lower damping ratio"
            raise InputError("damping", got, "a mode for which there are such impulses", hint)
        unknown = array(found)
        if is_noted((damping, self.tolerated)):
            inverse = np.linalg.inv(_slopes(unknown, ratio, tolerated))
            step: Any = unknown
            for _ in range(_ROUNDS):
                step = inverse @ _missing(unknown, damping, self.tolerated)
                unknown = unknown - step
            if not sum(part * part for part in step) <= _SOLVED**2:
                raise Lost("impulses that move too far", damping)
        first, last, second = unknown[:3]
        return Impulses(array([0.0, second, 1.0]), array([first, 1 - first - last, last]))


def _missing(unknown: Array, damping: Any, tolerated: Any) -> Array:
    """What five equations lack (5,): cosine and sine parts at both frequencies, squared residual at 1.

    ``unknown``: first and last amplitude, second time over the damped period, both frequencies over the own one.
    """
    first, last, time, low, high = unknown
    impulses = (first, 0.0), (1 - first - last, time), (last, 1.0)
    slope = 2 * np.pi * damping / sqrt(1 - damping * damping)
    found = []
    for ratio in (low, high, 1.0):
        waves = [(size * exp(slope * ratio * (t - 1.0)), 2 * np.pi * ratio * t) for size, t in impulses]
        found.append((sum(a * cos(p) for a, p in waves), sum(a * sin(p) for a, p in waves)))
    (c1, s1), (c2, s2), (c, s) = found
    return array([c1, s1, c2, s2, c * c + s * s - tolerated * tolerated])


def _slopes(unknown: Array, damping: float, tolerated: float) -> Array:
    """Derivatives (5, 5) of what is missing, by differences of 1e-6."""
    steps = 1e-6 * np.eye(5)
    return np.stack([
        (_missing(unknown + step, damping, tolerated) - _missing(unknown - step, damping, tolerated)) / 2e-6
        for step in steps
    ], axis=1)  # fmt: skip


@lru_cache(maxsize=256)
def _solved(damping: float, tolerated: float) -> tuple[float, ...] | None:
    """The solution for plain numbers, followed from no damping; None where it ends before."""
    low = np.arccos(-(1 - tolerated) / (1 + tolerated)) / np.pi
    found = np.array([(1 + tolerated) / 4, (1 + tolerated) / 4, 0.5, low, 2 - low])
    for ratio in np.linspace(0.0, damping, 1 + int(np.ceil(damping / _STEP))):
        step = found
        for _ in range(_NEWTON):
            step = np.linalg.solve(_slopes(found, ratio, tolerated), _missing(found, ratio, tolerated))
            found = found - step
            if not np.isfinite(found).all() or np.abs(found).max() > 10:
                return None
        if np.abs(step).max() > 1e-9 or not 0 < found[2] < 1 or not found[3] < 1 < found[4]:
            return None
    return tuple(found.tolist())
