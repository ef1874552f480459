"""What a shaper is: impulses, so that a motion and its delayed copies together leave no vibration of a mode.

A shaper of a user's own is a class with the field ``type`` and one method::

    @SHAPERS.register
    class Thirds(Shaper):
        type: Literal["thirds"] = Field(description="kind of shaper")

        def of_mode(self, damping: Any) -> Impulses:
            return Impulses(np.array([0.0, 1 / 3, 2 / 3]), np.full(3, 1 / 3))

Source: N. C. Singer, W. P. Seering, Preshaping command inputs to reduce system vibration, ASME J. Dynamic Systems,
Measurement, and Control 112 (1990), 76-82.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Annotated, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from pydantic import Field

from tmodes.kinds.noted.functions import array, exp, sqrt
from tmodes.kinds.schema.kind import Kind
from tmodes.kinds.schema.quantity import LARGEST, Issue

__all__ = ["SHAPERS", "Impulses", "Shaper", "decay", "residual"]

Array = NDArray[np.float64]

MOST_MODES = 4
MOST_DAMPING = 0.9
_Frequency = Annotated[float, Field(ge=1e-3, le=LARGEST)]  # below it a motion becomes longer by minutes
_Damping = Annotated[float, Field(ge=0.0, le=MOST_DAMPING)]


class Impulses(NamedTuple):
    """``times`` (n,) [s], rising from 0, and ``amplitudes`` (n,) [-], whose sum is 1."""

    times: Array
    amplitudes: Array

    def after(self, other: Impulses) -> Impulses:
        """Both, one after the other: every impulse of one at each of the other."""
        times, amplitudes = np.add.outer(other.times, self.times), np.multiply.outer(other.amplitudes, self.amplitudes)
        return Impulses(array(times.ravel()), array(amplitudes.ravel()))


def _numbers(unit: str, symbol: str, meaning: str, **more: Any) -> Any:
    extra: Any = {"unit": unit, "symbol": symbol, "smallest": 0.0, "plausible": None}
    return Field(
        strict=False, max_length=MOST_MODES, description=f"{meaning} [{unit}]", json_schema_extra=extra, **more
    )


class Shaper(Kind, family="shaper", key="type"):
    """Impulses for one mode or several, of given undamped frequencies and damping ratios."""

    type: Any = Field(description="kind of shaper")
    frequencies: tuple[_Frequency, ...] = _numbers(
        "Hz", "f", "undamped frequency of each mode; none: in a task that of the first mode along the path", default=()
    )
    damping: tuple[_Damping, ...] = _numbers("-", "zeta", "damping ratio of each mode; none: undamped", default=())

    def _issues(self) -> Iterator[Issue]:
        if self.damping and len(self.damping) != len(self.frequencies):
            expected = f"{len(self.frequencies)} damping ratios, one for each frequency, or none"
            yield Issue("damping", f"a list of {len(self.damping)}", expected, "write one ratio for each frequency")

    def of_mode(self, damping: Any) -> Impulses:
        """The impulses for one mode, times in its damped periods."""
        raise NotImplementedError

    def impulses(self) -> Impulses:
        """The impulses for all modes: those of each, one after the other."""
        found = Impulses(np.zeros(1), np.ones(1))
        for frequency, damping in zip(self.frequencies, self.damping or [0.0] * len(self.frequencies), strict=True):
            one = self.of_mode(damping)
            period = 1 / (frequency * sqrt(1 - damping * damping))
            found = found.after(Impulses(array(one.times * period), one.amplitudes))
        return found

    @property
    def delay(self) -> Any:
        """By how much it lengthens a motion [s]: the time of its last impulse."""
        return self.impulses().times[-1]


def decay(damping: Any) -> Any:
    """By which factor a vibration of one mode becomes smaller in half a damped period."""
    return exp(-np.pi * damping / sqrt(1 - damping * damping)) if damping > 0 else 1.0


def residual(impulses: Impulses | Sequence[Any], frequency: ArrayLike, damping: ArrayLike = 0.0) -> Array:
    """Vibration after the last impulse over that right after a single one, of modes of ``frequency`` [Hz] and ratio.

    Shape of both, broadcast. Source: Singer and Seering (1990), eq. 6.
    """
    times, amplitudes = (np.asarray(part, dtype=np.float64) for part in impulses)
    omega, ratio = np.broadcast_arrays(2 * np.pi * np.asarray(frequency, dtype=np.float64), damping)
    since = times - times.max()
    waves = amplitudes * np.exp((ratio * omega)[..., None] * since)
    phase = (omega * np.sqrt(1 - ratio * ratio))[..., None] * times
    return np.hypot((waves * np.cos(phase)).sum(axis=-1), (waves * np.sin(phase)).sum(axis=-1))


SHAPERS = Shaper.registry
"""Those of tmodes, and what a user registers: ``@SHAPERS.register``."""
