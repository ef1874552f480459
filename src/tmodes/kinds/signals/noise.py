"""Noise as a signal: random, smooth, of limited band, and the same for the same seed everywhere."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from tmodes.errors import InputError
from tmodes.kinds.noted.functions import ceil
from tmodes.kinds.schema.quantity import any_sign, not_negative, positive
from tmodes.kinds.signals.contract import SIGNALS, Signal
from tmodes.kinds.signals.fit import MOST_PIECES
from tmodes.kinds.signals.schedule import Clock, SignalPieces

__all__ = ["Noise", "SampledNoise", "hermite", "normal_numbers"]


@SIGNALS.register
class Noise(Signal):
    """Random values, normally distributed, two for each period of the highest frequency, joined by a cubic spline.

    It begins at its mean, so that a run still starts from rest. Above that frequency its power falls quickly; between
    the values its deviation is a little smaller than at them.
    """

    type: Literal["noise"] = Field(description="kind of signal")
    deviation: float = not_negative("signal", "sigma", "standard deviation of the values", at_most=1e12)
    frequency: float = positive("Hz", "f", "highest frequency", plausible=(1e-3, 1e4))
    seed: int = not_negative("-", "seed", "same seed, same noise", at_most=2**53)
    mean: float = any_sign("signal", "u_0", "value that it swings about", default=0.0)

    def pieces(self, until: float) -> SignalPieces:
        """A cubic piece between each two values, up to ``until`` [s]; a longer run has the same noise at its start.

        Raises :class:`tmodes.errors.InputError` where it needs too many pieces.
        """
        spacing = 0.5 / self.frequency
        if until / spacing > MOST_PIECES:
            got, most = f"{self.frequency:g} Hz over {until:g} s", f"at most {MOST_PIECES / 2 / until:.3g} Hz"
            raise InputError("frequency", got, most, "lower the frequency, or shorten the run")
        count = ceil(until / spacing) + 1
        values = self.mean + self.deviation * np.append(0.0, normal_numbers(self.seed, count + 1))
        # Slopes of neighbours (Catmull, Rom 1974) hang on nothing that comes later, as those of a whole spline would.
        slopes = np.append(0.0, (values[2:] - values[:-2]) / (2 * spacing))
        pieces = hermite(values[:count], values[1 : count + 1], slopes[:count], slopes[1 : count + 1], spacing)
        return SignalPieces(spacing * np.arange(count + 1, dtype=np.float64), pieces).until(until)


@dataclass(frozen=True)
class SampledNoise:
    """A random value at each sample of a sensor, held until the next: normally distributed about 0."""

    period: float
    output_step: float
    deviation: float
    seed: int
    is_noise: ClassVar[bool] = True

    def schedule(self, until: float) -> SignalPieces:
        """A constant piece for each sample, up to ``until`` [s]; a longer run has the same noise at its start."""
        starts = Clock(self.period, self.output_step).samples(until)
        values = self.deviation * normal_numbers(self.seed, len(starts))
        return SignalPieces(np.append(starts, until), values[:, None])

    def move_ends(self, reach: float = 1.0) -> float | None:
        """Never."""
        del reach


def hermite(
    start: NDArray[np.float64],
    end: NDArray[np.float64],
    slope: NDArray[np.float64],
    last_slope: NDArray[np.float64],
    length: Any,
) -> NDArray[np.float64]:
    """Cubics (pieces, 4) with given values and slopes at both ends, of a ``length`` [s], one for all or of each."""
    rise = (end - start) / length
    square = (3 * rise - 2 * slope - last_slope) / length
    return np.column_stack([start, slope, square, (slope + last_slope - 2 * rise) / length**2])


def normal_numbers(seed: int, count: int) -> NDArray[np.float64]:
    """Normally distributed numbers (count,), from the raw numbers of a generator whose stream never changes.

    PCG64 (O'Neill 2014) by the transformation of Box and Muller (1958); a longer list begins with the shorter one.
    """
    pairs = (count + 1) // 2
    raw = np.random.PCG64(seed).random_raw(2 * pairs).reshape(pairs, 2)
    uniform = ((raw >> np.uint64(11)) + 0.5) * 2.0**-53
    radius, angle = np.sqrt(-2 * np.log(uniform[:, 0])), 2 * np.pi * uniform[:, 1]
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle)]).ravel()[:count]
