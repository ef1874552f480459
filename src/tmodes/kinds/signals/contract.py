"""What a signal is: a value over time, given as pieces of polynomials.

A signal of a user's own is a class with the field ``type`` and one method; it has a ``delay`` by itself::

    @SIGNALS.register
    class Cosine(Signal):
        type: Literal["cosine"] = Field(description="kind of signal")
        frequency: float = positive("Hz", "f", "frequency")

        def pieces(self, until: float) -> SignalPieces:
            return fitted(lambda t: np.cos(2 * np.pi * self.frequency * t), until, "frequency")

Every signal is defined for all times from 0: before its first time and after its last it holds its value there.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from pydantic import Field

from tmodes.errors import InputError
from tmodes.kinds.noted.functions import zeros
from tmodes.kinds.schema.kind import Kind
from tmodes.kinds.schema.quantity import any_sign, not_negative
from tmodes.kinds.signals.schedule import SignalPieces

__all__ = ["SIGNALS", "Signal", "delayed", "signal_time", "signal_value"]


def signal_value(symbol: str, meaning: str, **more: Any) -> float:
    """A field of the signal's own unit."""
    return any_sign("signal", symbol, meaning, **more)


def signal_time(symbol: str, meaning: str, **more: Any) -> float:
    """A time from 0 on."""
    return not_negative("s", symbol, meaning, at_most=1e6, **more)


def delayed(move: SignalPieces, delay: float, until: float, first: float | None = None) -> SignalPieces:
    """The move from ``delay`` on, its first value before; cut or held at ``until`` [s]."""
    knots, pieces = move.knots + delay, move.coefficients
    if delay > 0:
        held = zeros((1, pieces.shape[1]), pieces, first)
        held[0, 0] = pieces[0, 0] if first is None else first
        knots, pieces = np.append(0.0, knots), np.vstack([held, pieces])
    return SignalPieces(knots, pieces).until(until)


class Signal(Kind, family="signal", key="type"):
    """A value over time [the unit of what it drives]; a kind says its ``pieces``, its delay is added to them."""

    type: Any = Field(description="kind of signal")
    delay: float = signal_time("t_0", "time at which it starts; it has its first value before", default=0.0)

    def __init_subclass__(cls, **more: Any) -> None:
        super().__init_subclass__(**more)
        if "schedule" in vars(cls):
            hint = "rename it; `schedule` adds the delay to the pieces"
            raise InputError(f"signal {cls.__qualname__}", "a method `schedule`", "a method `pieces`", hint)

    @property
    def keeps_rate(self) -> bool:
        """Whether its rate is the same at all times, without a delay, as it follows from the signal alone."""
        return False

    def pieces(self, until: float) -> SignalPieces:
        """The pieces without the delay, from time 0 up to ``until`` [s], or to where it moves no more.

        With a knot on every jump. Raises :class:`tmodes.errors.InputError` where it has no value.
        """
        raise NotImplementedError

    def length(self, reach: float = 1.0) -> float | None:
        """How long its motion takes [s], with ``reach`` times its duration; None for what does not end."""
        del reach
        return None

    @property
    def is_steady(self) -> bool:
        """Whether its rate is the same at all times from 0 on, as it follows from the signal alone; False if unknown.

        What a motion that is given so carries moves with it before time 0; any other motion begins from rest.
        """
        return self.keeps_rate and not self.delay > 0

    def schedule(self, until: float) -> SignalPieces:
        """The pieces from time 0 up to ``until`` [s], with a knot on every jump.

        Raises :class:`tmodes.errors.InputError` where it has no value.
        """
        return delayed(self.pieces(until), self.delay, until)

    def move_ends(self, reach: float = 1.0) -> float | None:
        """When its motion is at its end [s] with ``reach`` times its duration; None for what does not end."""
        length = self.length(reach)
        return None if length is None else self.delay + length


SIGNALS = Signal.registry
"""Those of tmodes, and what a user registers: ``@SIGNALS.register``."""
