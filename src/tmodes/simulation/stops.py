"""Stop conditions of a run, resolved: which output, beyond which value, and how far it is from there."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.equations.loop.outputs import COMMANDED, DEVIATION, Output, Outputs
from tmodes.errors import InputError, SimulationError
from tmodes.integrate.conditions import Condition
from tmodes.io.units import NotANumber, number
from tmodes.simulation.loop import LoopModel

__all__ = ["FROM", "STOPPED", "Instants", "Places", "SetIn", "Stop", "Stops", "resolved"]

Array = NDArray[np.float64]

Places = Callable[[Array], Array]

FROM = (DEVIATION, COMMANDED)
"""Distances of the tip on which a run may stop, in the order of the places that they are from."""

STOPPED = "stopped_by_condition"
"""Status of a run that a condition ended."""


@dataclass(frozen=True, eq=False)
class Instants:
    """Instants of a motion: ``times`` (n,) [s], ``states`` (n, size), and the rows (n, row) of the input there."""

    times: Array
    states: Array
    rows: Array


@dataclass(frozen=True)
class Stop:
    """A condition on an output: it holds where its value, or the ``size`` of it, is beyond ``limit``.

    ``text``: how it was asked for; ``name``: of the output in words.
    """

    text: str
    name: str
    output: Output
    limit: float
    above: bool
    size: bool = False

    def shown(self, value: float) -> str:
        """A value with its unit."""
        return f"{value:.9g} {self.output.unit}".removesuffix(" -")

    def info(self, time: float, before: float, value: float) -> str:
        """Sentence of a run that it ended at a time [s]: its value just before and there, where they differ."""
        info, was = self.shown(value), self.shown(before)
        side = f"reaches {info}" if info == was else f"jumps from {was} to {info}"
        return f"stopped at t = {time:.9g} s: stop condition `{self.text}`, {self.name} {side}"


@dataclass(frozen=True)
class Stops:
    """The stop conditions of a run of a ``model``; none of them is the usual case.

    ``places``: what distances of the tip are from, (n, 3) of each of :data:`FROM` at times (n,) [s].
    """

    stops: tuple[Stop, ...] = ()
    model: LoopModel | None = None
    places: Places | None = None

    def __bool__(self) -> bool:
        return bool(self.stops)

    @property
    def distances(self) -> set[str]:
        """The distances of the tip among them, for which places are needed."""
        return {stop.output.name.partition(".")[0] for stop in self.stops} & {*FROM}

    @cached_property
    def _outputs(self) -> tuple[Output, ...]:
        return tuple(stop.output for stop in self.stops)

    def values(self, instants: Instants) -> Array:
        """The values that are compared, (n, conditions)."""
        assert self.model is not None  # noqa: S101
        given = self.places(instants.times) if self.places else None
        found = self.model.seen(self._outputs, instants.times, instants.states, instants.rows, given)
        return np.where([stop.size for stop in self.stops], np.abs(found), found)

    def beyond(self, instants: Instants) -> Array:
        """How far each condition is from triggering, (n, conditions): above 0 where it holds."""
        return self._beyond(self.values(instants))

    def _beyond(self, values: Array) -> Array:
        signs = np.array([1.0 if stop.above else -1.0 for stop in self.stops])
        return signs * (values - [stop.limit for stop in self.stops])

    def refuse_at_start(self, start: Instants) -> None:
        """Raise :class:`tmodes.errors.SimulationError` where a condition holds before anything has moved.

        Those on distances are only asked once it is known from where.
        """
        if not self.stops or (self.distances and not self.places):
            return
        values = self.values(start)[0]
        for stop, value, beyond in zip(self.stops, values, self._beyond(values), strict=True):
            if beyond > 0:
                raise SimulationError(
                    f"stop condition `{stop.text}`: it holds at the start already, where {stop.name} is "
                    f"{stop.shown(value)}; change its value, or the start"
                )


def resolved(texts: Iterable[str], model: LoopModel, which: str = "integration.stop") -> tuple[Stop, ...]:
    """The conditions of some texts on the outputs of a robot in a run.

    Raises :class:`tmodes.errors.InputError` for what is no condition, names no output (with the nearest name), or
    has a value of another unit.
    """
    return tuple(_resolved(text, model, f"{which}.{place}") for place, text in enumerate(texts))


def _resolved(text: str, model: LoopModel, which: str) -> Stop:
    info = Condition.parsed(text, which)
    apart = info.name.partition(".")[0] in FROM
    output = (Outputs(model.loop, FROM) if apart else model.outputs).find(info.name, which)
    try:
        limit = number(info.value, output.unit)
    except NotANumber as error:
        unit = f"a number in {output.unit}" if output.unit != "-" else "a number without a unit"
        raise InputError(which, error.got, f"{unit}, that of {info.name}", error.hint) from None
    if not np.isfinite(limit):
        raise InputError(which, "an infinite value", "a finite one, which can be passed", "leave the condition out")
    return Stop(text, info.quantity, output, limit, info.above, info.size)


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
        which = int(self.stops.beyond(there)[0].argmax())
        value = float(self.stops.values(there)[0, which])
        return self.stops.stops[which].info(time, value, value)
