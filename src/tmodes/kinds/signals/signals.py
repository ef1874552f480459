"""Signals: values over time as a data sheet tells them, each as a schedule of polynomials.

Every signal is defined for all times from 0: before its first time and after its last it holds its value there.
"""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum
from typing import Annotated, Any, Literal, Self

import numpy as np
from pydantic import Field, model_validator

from tmodes.kinds.schema.quantity import LARGEST, DataSheet, Issue, any_sign, not_negative, positive, refuse
from tmodes.kinds.signals.schedule import Schedule
from tmodes.kinds.signals.signals_expression import FormulaError, parse_formula
from tmodes.kinds.signals.signals_fit import fitted, fitted_sine
from tmodes.kinds.signals.signals_merge import MergedSchedule, merge
from tmodes.kinds.signals.signals_noise import Noise
from tmodes.kinds.signals.trapezoid import TrapezoidalMove

__all__ = [
    "Constant",
    "Expression",
    "Interpolation",
    "MergedSchedule",
    "Noise",
    "Quintic",
    "Signal",
    "Sine",
    "Step",
    "Table",
    "Trapezoid",
    "merge",
]

MOST_ROWS = 10_000
"""Largest number of rows of a table."""

_Number = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]


def _value(symbol: str, meaning: str, **more: Any) -> float:
    return any_sign("signal", symbol, meaning, **more)


def _time(symbol: str, meaning: str, **more: Any) -> float:
    return not_negative("s", symbol, meaning, at_most=1e6, **more)


class Constant(DataSheet):
    """One value at all times."""

    type: Literal["constant"] = Field(description="kind of signal")
    value: float = _value("u", "value")

    def schedule(self, until: float) -> Schedule:
        """One piece up to ``until`` [s]."""
        return Schedule(np.array([0.0, until]), np.array([[self.value]]))


class Step(DataSheet):
    """A jump from one value to another."""

    type: Literal["step"] = Field(description="kind of signal")
    start: float = _value("u_0", "value before the jump")
    end: float = _value("u_1", "value from the jump on")
    time: float = _time("t_1", "time of the jump")

    def schedule(self, until: float) -> Schedule:
        """Two pieces with the jump on their knot; one where it comes first or after ``until`` [s]."""
        if not 0 < self.time < until:
            return Schedule(np.array([0.0, until]), np.array([[self.start if self.time >= until else self.end]]))
        return Schedule(np.array([0.0, self.time, until]), np.array([[self.start], [self.end]]))


class Trapezoid(DataSheet):
    """From rest to rest with constant acceleration, constant speed and constant deceleration."""

    type: Literal["trapezoid"] = Field(description="kind of signal")
    start: float = _value("u_0", "value at the start", at_least=-1e3, at_most=1e3)
    end: float = _value("u_1", "value at the end", at_least=-1e3, at_most=1e3)
    duration: float = positive("s", "T", "duration of the move", at_most=1e5, smallest=1e-6)
    ramp_fraction: float = positive(
        "-", "ramp", "share of the duration that each ramp takes", at_most=0.5, smallest=1e-6
    )
    delay: float = _time("t_0", "time at which it starts", default=0.0)

    def schedule(self, until: float) -> Schedule:
        """The delay, the three pieces of the move, and the last value, up to ``until`` [s]."""
        given = {name: getattr(self, name) for name in ("start", "end", "duration", "ramp_fraction")}
        return _delayed(TrapezoidalMove(**given).schedule(), self.delay, until)


class Quintic(DataSheet):
    """From rest to rest, smooth up to the acceleration: 10 x^3 - 15 x^4 + 6 x^5."""

    type: Literal["quintic"] = Field(description="kind of signal")
    start: float = _value("u_0", "value at the start")
    end: float = _value("u_1", "value at the end")
    duration: float = positive("s", "T", "duration of the move", at_most=1e6, smallest=1e-6)
    delay: float = _time("t_0", "time at which it starts", default=0.0)

    def schedule(self, until: float) -> Schedule:
        """The delay, the move, and the last value, up to ``until`` [s]."""
        shape = (self.end - self.start) * np.array([0.0, 0.0, 0.0, 10.0, -15.0, 6.0])
        move = shape / self.duration ** np.arange(6)
        move[0] = self.start
        return _delayed(Schedule(np.array([0.0, self.duration]), move[None, :]), self.delay, until)


class Sine(DataSheet):
    """offset + amplitude sin(2 pi frequency t + phase)."""

    type: Literal["sine"] = Field(description="kind of signal")
    amplitude: float = _value("A", "amplitude")
    frequency: float = positive("Hz", "f", "frequency", plausible=(1e-3, 1e4))
    phase: float = any_sign("rad", "phi", "phase at time 0", default=0.0, at_least=-1e3, at_most=1e3)
    offset: float = _value("u_0", "value that it swings about", default=0.0)

    def schedule(self, until: float) -> Schedule:
        """Pieces of degree 7, exact to 1e-12 of the amplitude, up to ``until`` [s]."""
        return fitted_sine(self.amplitude, self.frequency, self.phase, self.offset, until)


class Interpolation(StrEnum):
    """How a table is joined between its rows; ``cubic`` starts and ends at rest."""

    LINEAR = "linear"
    CUBIC = "cubic"


class Table(DataSheet):
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

    @model_validator(mode="after")
    def _rows(self) -> Self:
        refuse(list(self._issues()))
        return self

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

    def schedule(self, until: float) -> Schedule:
        """A piece between each two rows, and the first and last value held, up to ``until`` [s]."""
        times, values = np.array(self.times), np.array(self.values)
        pieces = self._cubic(times, values) if self.interpolation is Interpolation.CUBIC else _straight(times, values)
        rising = np.diff(times) > 0
        move = Schedule(np.append(times[:-1][rising], times[-1]) - times[0], pieces[rising])
        return _ending(_delayed(move, float(times[0]), until, first=self.values[0]), float(times[-1]), self.values[-1])

    @staticmethod
    def _cubic(times: Any, values: Any) -> Any:
        from scipy.interpolate import CubicSpline

        return CubicSpline(times, values, bc_type="clamped").c[::-1].T


class Expression(DataSheet):
    """A formula of the time t [s], such as ``0.2*sin(2*pi*t)*exp(-t)``."""

    type: Literal["expression"] = Field(description="kind of signal")
    formula: str = Field(min_length=1, max_length=500, description="formula of t")

    @model_validator(mode="after")
    def _readable(self) -> Self:
        try:
            parse_formula(self.formula)
        except FormulaError as error:
            refuse([Issue("formula", error.got, error.expected, error.hint)])
        return self

    def schedule(self, until: float) -> Schedule:
        """Pieces of degree 7, exact to 1e-12 of the largest value, up to ``until`` [s].

        Raises :class:`tmodes.errors.InputError` where the formula has no value or jumps.
        """
        return fitted(parse_formula(self.formula), until, "formula")


Signal = Annotated[
    Constant | Step | Trapezoid | Quintic | Sine | Table | Expression | Noise,
    Field(discriminator="type"),
]
"""A field of this type takes any signal; its ``type`` says which."""


def _straight(times: Any, values: Any) -> Any:
    rise = np.diff(times)
    slope = np.divide(np.diff(values), rise, out=np.zeros_like(rise), where=rise > 0)
    return np.column_stack([values[:-1], slope])


def _delayed(move: Schedule, delay: float, until: float, first: float | None = None) -> Schedule:
    """The move from ``delay`` on, its first value before; cut or held at ``until`` [s]."""
    knots, pieces = move.knots + delay, move.coefficients
    if delay > 0:
        held = np.zeros((1, pieces.shape[1]))
        held[0, 0] = pieces[0, 0] if first is None else first
        knots, pieces = np.append(0.0, knots), np.vstack([held, pieces])
    return Schedule(knots, pieces).until(until)


def _ending(schedule: Schedule, last: float, value: float) -> Schedule:
    """The schedule with exactly ``value`` from the time ``last`` [s] on (a jump may stand in the last row)."""
    coefficients = schedule.coefficients.copy()
    coefficients[schedule.knots[:-1] >= last] = np.eye(1, coefficients.shape[1])[0] * value
    return Schedule(schedule.knots, coefficients)
