"""Values at given times."""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.noted.functions import cubic_slopes, number
from tmodes.kinds.noted.number import is_noted
from tmodes.kinds.schema.quantity import LARGEST, Issue
from tmodes.kinds.signals.contract import SIGNALS, Signal, delayed
from tmodes.kinds.signals.noise import hermite
from tmodes.kinds.signals.schedule import SignalPieces

__all__ = ["Interpolation", "Table"]

MOST_ROWS = 10_000
"""Largest number of rows of a table."""

_Number = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]


class Interpolation(StrEnum):
    """How a table is joined between its rows; ``cubic`` starts and ends at rest."""

    LINEAR = "linear"
    CUBIC = "cubic"


@SIGNALS.register
class Table(Signal):
    """Values at given times; in a linear table, the same time twice is a jump."""

    type: Literal["table"] = Field(description="kind of signal")
    times: tuple[_Number, ...] = Field(
        strict=False,
        min_length=2,
        max_length=MOST_ROWS,
        description="times [s]",
        json_schema_extra={"unit": "s", "symbol": "t", "smallest": 0.0, "plausible": None},
    )
    values: tuple[_Number, ...] = Field(
        strict=False,
        min_length=2,
        max_length=MOST_ROWS,
        description="values at these times [signal]",
        json_schema_extra={"unit": "signal", "symbol": "u", "smallest": 0.0, "plausible": None},
    )
    interpolation: Interpolation = Field(strict=False, description="linear or cubic")

    def _issues(self) -> Iterator[Issue]:
        if len(self.times) != len(self.values):
            expected = f"{len(self.times)} values, one for each time"
            yield Issue("values", f"a list of {len(self.values)}", expected, "write one value for each time")
        if self.times[0] < 0:
            yield Issue("times", repr(self.times[0]), "times from 0 on", "a run starts at time 0")
        jumps = self.interpolation is Interpolation.LINEAR
        for index, (earlier, later) in enumerate(zip(self.times, self.times[1:], strict=False)):
            twice = jumps and later == earlier and self.times[index - 1 : index] != (earlier,)
            if later <= earlier and not twice:
                got = f"{later!r} s after {earlier!r} s"
                hint = "order the rows by time" + ("" if jumps else "; a jump needs `interpolation: linear`")
                yield Issue(f"times.{index + 1}", got, "times that rise", hint)
                return
        if self.times[-1] == self.times[0]:
            hint = "give the last row a later time; a jump alone is the signal `step`"
            yield Issue("times", f"{self.times[0]!r} s in every row", "a last time after the first", hint)

    def pieces(self, until: float) -> SignalPieces:
        """A piece between each two rows, and the first and last value held, up to ``until`` [s]."""
        times, values = np.array(self.times), np.array(self.values)
        pieces = self._cubic(times, values) if self.interpolation is Interpolation.CUBIC else _straight(times, values)
        rising = np.diff(times) > 0
        move = SignalPieces(np.append(times[:-1][rising], times[-1]) - times[0], pieces[rising])
        return _ending(delayed(move, number(times[0]), until, first=self.values[0]), number(times[-1]), self.values[-1])

    @staticmethod
    def _cubic(times: Any, values: Any) -> Any:
        if is_noted(times) or is_noted(values):
            slopes, width = cubic_slopes(times, values), times[1:] - times[:-1]
            return hermite(values[:-1], values[1:], slopes[:-1], slopes[1:], width)
        from scipy.interpolate import CubicSpline

        return CubicSpline(times, values, bc_type="clamped").c[::-1].T


def _straight(times: Any, values: Any) -> Any:
    slope = np.array([b / a if a > 0 else 0.0 for a, b in zip(np.diff(times), np.diff(values), strict=True)])
    return np.column_stack([values[:-1], slope])


def _ending(schedule: SignalPieces, last: float, value: float) -> SignalPieces:
    """The schedule with exactly ``value`` from the time ``last`` [s] on (a jump may stand in the last row)."""
    coefficients = schedule.coefficients
    late, held = (schedule.knots[:-1] >= last)[:, None], np.eye(1, coefficients.shape[1])[0] * value
    return SignalPieces(schedule.knots, np.where(late, held, coefficients))
