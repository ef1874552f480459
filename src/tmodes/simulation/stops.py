"""Stop conditions of a run, resolved: which named quantity, beyond which value, and how far it is from there."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, SimulationError
from tmodes.integrate.condition import Condition
from tmodes.io.units import NotANumber, number
from tmodes.io.words import nearest

__all__ = ["STOPPED", "Instants", "Quantity", "SetIn", "Stop", "Stops", "resolved"]

Array = NDArray[np.float64]

STOPPED = "stopped_by_condition"
"""Status of a run that a condition ended."""

_SHOWN = 12
"""Names that a message lists."""


@dataclass(frozen=True, eq=False)
class Instants:
    """Instants of a motion: ``times`` (n,) [s], ``states`` (n, size), and the rows (n, row) of the input there."""

    times: Array
    states: Array
    rows: Array


@dataclass(frozen=True)
class Quantity:
    """A named number of a motion with its unit; ``of`` gives its values (n,) at instants."""

    unit: str
    of: Callable[[Instants], Array]


@dataclass(frozen=True)
class Stop:
    """A condition on a quantity: it holds where its value, or the ``size`` of it, is beyond ``limit``.

    ``text``: how it was asked for; ``name``: of the quantity in words.
    """

    text: str
    name: str
    quantity: Quantity
    limit: float
    above: bool
    size: bool = False

    def values(self, instants: Instants) -> Array:
        """The values that are compared, (n,)."""
        found = self.quantity.of(instants)
        return np.abs(found) if self.size else found

    def beyond(self, values: Array) -> Array:
        """How far values are beyond the limit, (n,): above 0 where the condition holds."""
        return values - self.limit if self.above else self.limit - values

    def shown(self, value: float) -> str:
        """A value with its unit."""
        return f"{value:.9g} {self.quantity.unit}".removesuffix(" -")

    def info(self, time: float, before: float, value: float) -> str:
        """Sentence of a run that it ended at a time [s]: its value just before and there, where they differ."""
        info, was = self.shown(value), self.shown(before)
        side = f"reaches {info}" if info == was else f"jumps from {was} to {info}"
        return f"stopped at t = {time:.9g} s: stop condition `{self.text}`, {self.name} {side}"


@dataclass(frozen=True)
class Stops:
    """The stop conditions of a run; none of them is the usual case."""

    stops: tuple[Stop, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.stops)

    def beyond(self, instants: Instants) -> Array:
        """How far each condition is from triggering, (n, conditions): above 0 where it holds."""
        return np.stack([stop.beyond(stop.values(instants)) for stop in self.stops], axis=1)

    def refuse_at_start(self, start: Instants) -> None:
        """Raise :class:`tmodes.errors.SimulationError` where a condition holds before anything has moved."""
        for stop in self.stops:
            value = stop.values(start)
            if stop.beyond(value)[0] > 0:
                raise SimulationError(
                    f"stop condition `{stop.text}`: it holds at the start already, where {stop.name} is "
                    f"{stop.shown(value[0])}; change its value, or the start"
                )


def resolved(texts: Iterable[str], known: Mapping[str, Quantity], which: str = "integration.stop") -> tuple[Stop, ...]:
    """The conditions of some texts on the quantities that a robot has.

    Raises :class:`tmodes.errors.InputError` for what is no condition, names no quantity (with the nearest name), or
    has a value of another unit.
    """
    return tuple(_resolved(text, known, f"{which}.{place}") for place, text in enumerate(texts))


def _resolved(text: str, known: Mapping[str, Quantity], which: str) -> Stop:
    info = Condition.parsed(text, which)
    quantity = known.get(info.name)
    if quantity is None:
        raise _unknown(info.name, known, which)
    try:
        limit = number(info.value, quantity.unit)
    except NotANumber as error:
        unit = f"a number in {quantity.unit}" if quantity.unit != "-" else "a number without a unit"
        raise InputError(which, error.got, f"{unit}, that of {info.name}", error.hint) from None
    if not np.isfinite(limit):
        raise InputError(which, "an infinite value", "a finite one, which can be passed", "leave the condition out")
    return Stop(text, info.quantity, quantity, limit, info.above, info.size)


def _unknown(name: str, known: Mapping[str, Quantity], which: str) -> InputError:
    last = name.rpartition(".")[2]
    close = nearest(name, known) or next((other for other in known if other.rpartition(".")[2] == last), None)
    names = sorted(known, key=lambda other: (not other.startswith(name.partition(".")[0]), other))
    more = ", ..." if len(names) > _SHOWN else ""
    hint = f"did you mean `{close}`?" if close else "write one of these names"
    return InputError(which, f"the unknown name {name!r}", f"one of {', '.join(names[:_SHOWN])}{more}", hint)


@dataclass(frozen=True)
class SetIn:
    """Finds where a condition triggers; ``row`` gives that of the input at a time and state, ``duration`` [s]."""

    stops: Stops
    row: Callable[[float, Array], Array]
    duration: float

    def within(
        self, ends: tuple[float, float], states: tuple[Array, Array], moved: Callable[[float], Array]
    ) -> tuple[float, Array, str] | None:
        """Time, state and words, or None where no condition holds at either end; ``moved`` gives a state between."""
        from scipy.optimize import brentq

        known = dict(zip(ends, states, strict=True))

        def beyond(time: float) -> float:
            if time not in known:
                known[time] = moved(time)
            return float(self.stops.beyond(self._instant(time, known[time])).max())

        if beyond(ends[0]) <= 0 and beyond(ends[1]) <= 0:
            return None
        close = 4 * float(np.spacing(self.duration))
        root: Any = ends[0] if beyond(ends[0]) > 0 else brentq(beyond, *ends, xtol=close)
        time = float(root)
        state = known[time] if time in known else moved(time)
        return time, state, self._info(time, state)

    def _instant(self, time: float, state: Array) -> Instants:
        return Instants(np.array([time]), state[None, :], self.row(time, state)[None, :])

    def _info(self, time: float, state: Array) -> str:
        there = self._instant(time, state)
        stop = self.stops.stops[int(self.stops.beyond(there)[0].argmax())]
        value = float(stop.values(there)[0])
        return stop.info(time, value, value)
