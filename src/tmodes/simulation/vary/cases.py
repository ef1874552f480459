"""Cases of one sheet as arrays: their numbers by a form of those of the varied paths, their starts all at once."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.integrate.choice import STIFF, chosen_method
from tmodes.integrate.registry import AUTO, integrator
from tmodes.kinds.signals.schedule import Schedule
from tmodes.model.accuracy import rounding
from tmodes.model.forms import Form, Range, Unfit
from tmodes.model.model import Model
from tmodes.sheet import Robot
from tmodes.simulation.balance import STANDS, Balance, Tangent, frozen
from tmodes.simulation.closed_start import closes, uncontrolled
from tmodes.simulation.loop import LoopModel, loop_numbers, whole
from tmodes.simulation.plan import Follow, planned, starts_at_rest
from tmodes.simulation.start import RunSetup, closed_balance, held_at_start, placed_state, slipping, undeformed
from tmodes.simulation.vary.block_forms import block_forms, pair_at
from tmodes.simulation.vary.lanes import Side
from tmodes.simulation.vary.lots import Indices, LaneNumbers, Lot
from tmodes.simulation.vary.rests import rests

__all__ = ["Cases"]

Array = NDArray[np.float64]


_BLOCK = 1024
"""Cases whose starts are found at once."""

_LONGEST = 20_000
"""Numbers of all signals."""

_EXACT = 1e-11
"""Relative error of a number that is rounding."""

_SURELY = 2.0
"""Share of the limit up to which, or beyond which, the stiffness of a few cases decides the method of all."""


_MOST = 400
"""Vectors that surfaces may take where these cases are part of more: it must not depend on which part they are."""


_COMMON = ("ranges", "held", "_standing", "_closed", "_structure", "forms", "_moves")
"""What does not depend on the values themselves."""


@dataclass(frozen=True, eq=False)
class Cases:
    """k cases of a sheet: ``values`` (k,) of each path; ``like``: one of them; ``side``: which of its robots runs.

    ``spans``: the least and the largest value of each path for which forms are found; None: those of the values.
    """

    sheet: Robot
    values: Mapping[str, Array]
    like: RunSetup
    side: Side = Side.ACTUAL
    spans: Mapping[str, tuple[float, float]] | None = None

    def others(self, values: Mapping[str, Array]) -> Cases:
        """Other cases within the same spans, by the same forms."""
        made = replace(self, values={path: values[path] for path in self.values})
        made.__dict__.update({name: self.__dict__[name] for name in _COMMON if name in self.__dict__})
        return made

    @cached_property
    def ranges(self) -> tuple[Range, ...]:
        """From the least to the largest value of each path."""
        own = {path: (float(values.min()), float(values.max())) for path, values in self.values.items()}
        ends = (own if self.spans is None else {path: self.spans[path] for path in own}).values()
        return tuple(Range(low, low, high) for low, high in ends)

    @cached_property
    def held(self) -> LoopModel:
        """The loop in which every drive stands."""
        return LoopModel(planned(self.like.robot, Follow.HELD).plan)

    @cached_property
    def _standing(self) -> tuple[Balance, Tangent]:
        """The equations of rest with held motors, and their slope at the rest of ``like``, near those of all others."""
        rest, row = self.like.rest, planned(self.like.robot, Follow.HELD).schedule.rows_at(np.zeros(1))
        assert rest is not None  # noqa: S101
        balance = Balance(self.held)
        return balance, balance.tangent(self._at_rest(rest.q[None]), row, self.held.numbers)

    @cached_property
    def _closed(self) -> tuple[Balance, Tangent] | None:
        """The same of the closed loop, where a run starts from its equilibrium."""
        like, balance = self.like, closed_balance(self.like)
        if balance is None:
            return None
        first, row = balance.at_rest(like.start[None]), frozen(like.model, like.first_row[None])
        return balance, balance.tangent(first, row, balance.loop.numbers)

    def _at_rest(self, q: Array) -> Array:
        states = np.zeros((len(q), self.held.layout.size))
        states[:, self.held.layout.q] = q
        return states

    @cached_property
    def _structure(self) -> Any:
        return self._at({})[1]

    @cached_property
    def forms(self) -> dict[str, Form]:
        """The form of each block of numbers. Raises :class:`tmodes.model.forms.Unfit` where there is none."""
        other = self.held.loop.modes or self.held.coordinates != self.like.model.coordinates
        if other and starts_at_rest(self.like.robot):
            raise Unfit({0: "its rest is found by other equations"})
        if self._closed and (self.like.off or uncontrolled(self.like.model)):
            raise Unfit({0: "its start may be no equilibrium"})
        most = _MOST if self.spans is not None else len(next(iter(self.values.values())))
        return block_forms(self._at, self.ranges, self._structure, most)

    def _at(self, point: Mapping[int, float]) -> tuple[Array, Any]:
        """All numbers where some paths have other values than their least."""
        return self._of(self.side.of(pair_at(self.sheet, self.values, self.ranges, point)))

    def _of(self, robot: Robot) -> tuple[Array, Any]:
        """The numbers of a robot, and all that must be the same for all cases."""
        plan, rest = planned(robot, self.side.follow), planned(robot, Follow.HELD)
        model, chain, held = LoopModel(plan.plan), Model(plan.chain, trials=True), LoopModel(rest.plan)
        at_start, at_rest = held_at_start(robot, model), starts_at_rest(robot)
        pose = np.full(chain.nq, np.nan) if at_rest else undeformed(model.coordinates, at_start)
        blocks = loop_numbers(model.loop, rest) | {
            "chain": chain.parameters, "base": chain.at_rest(gravity=0.0), "held": np.array([*at_start.values()]),
            "start": placed_state(robot, plan, model, pose),
            "knots": plan.schedule.knots, "coefficients": plan.schedule.coefficients,
        }  # fmt: skip
        vector, places = whole(blocks)
        if plan.schedule.coefficients.size > _LONGEST:
            raise Unfit({0: "its signals have too many pieces"})
        keys = model.loop.rate.key, held.loop.rate.key, chain.passes.schedule("inertia").key
        closed = at_rest and closes(robot, model)
        return vector, (keys, model.coordinates, tuple(at_start), at_rest, closed, robot.integration, places)

    def block(self, name: str, which: Indices) -> Array:
        """A block of numbers of some cases, (m, ...)."""
        found = self.forms[name].at({k: values[which] for k, values in enumerate(self.values.values())})
        return found.reshape(len(which), *self._structure[-1][name]["shape"])

    @cached_property
    def _moves(self) -> bool:
        """Whether the signals differ."""
        return any(form.products or form.sums for form in (self.forms["knots"], self.forms["coefficients"]))

    def numbers(self, which: Indices) -> LaneNumbers:
        """The numbers of some cases."""
        parameters, chain, base = (self.block(name, which) for name in ("parameters", "chain", "base"))
        if not self._moves:
            return LaneNumbers(parameters, chain, base, (self.like.planned.schedule,))
        pieces = zip(self.block("knots", which), self.block("coefficients", which), strict=True)
        return LaneNumbers(parameters, chain, base, tuple(Schedule(knots, powers) for knots, powers in pieces))

    def has_numbers(self, index: int, setup: RunSetup) -> bool:
        """Whether the numbers of a case are those of its sheet but for rounding, however far its values are apart."""
        found, true = self.numbers(np.array([index])), (setup.model.numbers, setup.mechanics.parameters)
        return all(
            bool((np.abs(given[0] - right) <= _EXACT * np.abs(right) + rounding(right))[np.isfinite(right)].all())
            for given, right in zip((found.parameters, found.chain), true, strict=True)
        )

    def starts(self, progress: Callable[[float], None], threads: int = 1) -> Array:
        """The first states (k, nx); not-a-number where none is found."""
        found = [self._starts(self._blocks[0])]  # by which all code is made
        with ThreadPoolExecutor(threads, "tmodes-starts") as pool:
            for states in pool.map(self._starts, self._blocks[1:]):
                found.append(states)
                progress(len(found) / len(self._blocks))
        return np.concatenate(found)

    @cached_property
    def _blocks(self) -> list[Indices]:
        every = np.arange(len(next(iter(self.values.values()))))
        return [every[k : k + _BLOCK] for k in range(0, len(every), _BLOCK)]

    def _rows(self, which: Indices) -> Array:
        """The rows of the signals at time 0."""
        if not self._moves:
            return np.tile(self.like.first_row, (len(which), 1))
        pieces = self.block("coefficients", which)[:, 0].reshape(len(which), -1)
        return np.column_stack([self.block("knots", which)[:, 0], pieces])

    def _starts(self, which: Indices) -> Array:
        model, parameters, rows = self.like.model, self.block("parameters", which), self._rows(which)
        states = self.block("start", which).copy()
        if self.like.rest is not None:
            placed = states[:, model.layout.q]  # a view
            np.copyto(placed, self._rests(which), where=np.isnan(placed))
        if self._closed:
            states = self._balanced(*self._closed, states, rows, parameters)
        states = model.settled(states, rows, parameters)
        rates = model.rate(np.zeros(len(states)), states, rows, parameters)
        states[~np.isfinite(rates[:, model.layout.v]).all(axis=1)] = np.nan
        return states

    def _balanced(self, balance: Balance, tangent: Tangent, states: Array, rows: Array, parameters: Array) -> Array:
        """The equilibria of the closed loops, from the states with held motors; those that are in balance stay."""
        still, near = frozen(self.like.model, rows), balance.at_rest(states)
        found = rests(balance, parameters, still, near, tangent, STANDS)
        moved = (found != near).any(axis=1)
        states[moved] = balance.outside(found[moved], states[moved], still[moved], parameters[moved])
        return states

    def _rests(self, which: Indices) -> Array:
        """Poses at rest, of each case from that of ``like`` or, where that is too far, from its nearest neighbour's."""
        rest, names = self.like.rest, list(self.like.model.coordinates)
        assert rest is not None  # noqa: S101
        places = [names.index(name) for name in held_at_start(self.like.robot, self.like.model)]
        held, numbers, rows = (self.block(name, which) for name in ("held", "rest", "rest_row"))
        far = np.stack(
            [one.shares(values[which]) for one, values in zip(self.ranges, self.values.values(), strict=True)]
        )
        found, lost, near = np.full((len(which), len(names)), np.nan), np.arange(len(which)), rest.q[None]
        while len(lost):
            begin = np.broadcast_to(near, (len(lost), len(names))).copy()
            begin[:, places] = held[lost]
            balance, tangent = self._standing
            there = rests(balance, numbers[lost], rows[lost], self._at_rest(begin), tangent)
            found[lost] = there[:, self.held.layout.q]
            known, before = np.flatnonzero(np.isfinite(found).all(axis=1)), len(lost)
            lost = np.flatnonzero(~np.isfinite(found).all(axis=1))
            if len(lost) == before or not len(known):
                break
            near = found[known[[np.abs(far[:, known] - far[:, [k]]).sum(axis=0).argmin() for k in lost]]]
        return found

    def lots(self, starts: Array, places: Indices, tried: list[RunSetup]) -> Iterator[Lot]:
        """The cases that have a start, by their method; ``tried``: some, as setups of their own."""
        has_start = np.isfinite(starts).all(axis=1)
        methods = self._methods(starts, tried)
        for method in sorted(set(methods[has_start].tolist())):
            chosen = np.flatnonzero(has_start & (methods == method))
            yield Lot(
                self.like.by(method, None), places[chosen], starts[chosen],
                lambda which, chosen=chosen: self.numbers(chosen[which]),
            )  # fmt: skip

    def _methods(self, starts: Array, tried: list[RunSetup]) -> NDArray[np.str_]:
        """The method of each case: that of a few where it is surely the same, else by the eigenvalues of each."""
        given, few = self.sheet.integration, sorted({setup.robot.integration.method for setup in tried})
        bounds = STIFF * (integrator("dormand_prince").reach or 1.0) / given.duration
        fastest = [setup.spectrum.highest for setup in tried]
        sure = max(fastest) * _SURELY <= bounds or min(fastest) >= bounds * _SURELY
        if given.method != AUTO or (len(few) == 1 and sure):
            return np.full(len(starts), few[0])
        model, found = self.like.model, []
        for which in self._blocks:
            states = slipping(model, np.nan_to_num(starts[which]))
            slopes = model.jacobian(0.0, states, self._rows(which), self.block("parameters", which))
            found += np.abs(np.linalg.eigvals(np.nan_to_num(slopes))).max(axis=1, initial=0.0).tolist()
        return np.array([chosen_method(given, highest, self.like.implicit)[0] for highest in found])
