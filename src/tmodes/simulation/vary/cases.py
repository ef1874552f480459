"""Cases of one sheet as arrays: their numbers by a program from the varied ones, their starts all at once."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from tmodes.equations.loop.outputs import station_numbers
from tmodes.integrate.choice import STIFF, chosen_method
from tmodes.integrate.registry import AUTO, integrator
from tmodes.kinds.noted.functions import array
from tmodes.kinds.signals.schedule import SignalPieces, merge_cases
from tmodes.model.model import Model
from tmodes.model.parameters import Structural
from tmodes.sheet import Robot
from tmodes.simulation.balance import STANDS, Balance, BalanceSlope, begun, frozen
from tmodes.simulation.closed_start import closes, uncontrolled
from tmodes.simulation.initial_state import RunSetup, closed_balance, held_at_start, placed_state, slipping, undeformed
from tmodes.simulation.loop import Blocks, LoopModel, loop_numbers
from tmodes.simulation.plan import Follow, planned, refuse_jumps, starts_at_rest
from tmodes.simulation.vary.case_group import CaseGroup, CaseNumbers, Indices
from tmodes.simulation.vary.programs import CaseProgram, case_program
from tmodes.simulation.vary.rests import rests
from tmodes.simulation.vary.values import RobotVariant, changes_of

__all__ = ["Cases", "run_blocks"]

Array = NDArray[np.float64]


_BLOCK = 1024
"""Cases whose starts are found at once."""

_LONGEST = 20_000
"""Numbers of all signals."""

_SURELY = 2.0
"""Share of the limit up to which, or beyond which, the stiffness of a few cases decides the method of all."""


_COMMON = ("program", "held", "_standing", "_closed", "_moving")
"""What does not depend on the values themselves."""


def run_blocks(robot: Robot, follow: Follow, shown: Sequence[str] = ()) -> Blocks:
    """All numbers of a robot in a run, by what they are of; each signal on its own knots.

    ``shown``: outputs, of which those at stations along links have numbers of their own, ``further``.
    """
    plan, rest = planned(robot, follow), planned(robot, Follow.HELD)
    refuse_jumps(robot, plan)
    model, chain = LoopModel(plan.plan), Model(plan.chain, trials=True)
    at_start, at_rest = held_at_start(robot, model), starts_at_rest(robot)
    pose = np.full(chain.nq, np.nan) if at_rest else undeformed(model.coordinates, at_start)
    blocks = loop_numbers(model.loop, rest) | {
        "chain": chain.parameters, "base": chain.at_rest(gravity=0.0), "held": array([*at_start.values()]),
        "start": placed_state(robot, plan, model, pose), "further": station_numbers(model.loop, shown),
    }  # fmt: skip
    if at_rest:
        closes(robot, model)  # which is structure
    for k, piece in enumerate(plan.pieces):
        if piece.is_noted and piece.coefficients.size > _LONGEST:
            raise Structural("a signal has too many pieces")
        blocks |= {f"knots {k}": piece.knots, f"powers {k}": piece.coefficients}
    return blocks


@dataclass(frozen=True, eq=False)
class Cases:
    """k cases of a sheet: ``values`` (k,) of each path; ``like``: that of index ``at``; ``variant``: which robot runs.

    Those for which :meth:`holds` is false have other structures than ``like``: they are no cases of these.
    ``cases``: how many there are in all, where these are some; 0: these. ``shown``: outputs that
    are wanted of them.
    """

    sheet: Robot
    values: Mapping[str, Array]
    at: int
    like: RunSetup
    variant: RobotVariant = RobotVariant.ACTUAL
    cases: int = 0
    shown: tuple[str, ...] = ()

    def others(self, values: Mapping[str, Array]) -> Cases:
        """Other cases, by the same program."""
        made = replace(self, values={path: values[path] for path in self.values}, at=-1)
        made.__dict__.update({name: getattr(self, name) for name in _COMMON})
        return made

    def holding(self) -> tuple[Cases, Indices]:
        """The cases that have the structure of ``like``, and their indices."""
        which = np.flatnonzero(self.program.holds(self.values))
        return self.others({path: values[which] for path, values in self.values.items()}), which

    @cached_property
    def program(self) -> CaseProgram:
        """The program of their numbers. Raises :class:`tmodes.model.parameters.Structural` where there is none."""
        other = self.held.loop.modes or self.held.coordinates != self.like.model.coordinates
        if other and starts_at_rest(self.like.robot):
            raise Structural("its rest is found by other equations")
        if self._closed and (self.like.off or uncontrolled(self.like.model)):
            raise Structural("its start may be no equilibrium")
        case, follow = changes_of(self.values, self.at), self.variant.follow
        count = self.cases or len(next(iter(self.values.values())))
        blocks = partial(run_blocks, follow=follow, shown=self.shown)
        return case_program(self.sheet, case, self.variant.of, blocks, count)

    @cached_property
    def held(self) -> LoopModel:
        """The loop in which every drive stands."""
        return LoopModel(planned(self.like.robot, Follow.HELD).plan)

    @cached_property
    def _standing(self) -> tuple[Balance, BalanceSlope]:
        """The equations of rest with held motors, and their slope at the rest of ``like``, near those of all others."""
        rest, row = self.like.rest, planned(self.like.robot, Follow.HELD).schedule.rows_at(np.zeros(1))
        assert rest is not None  # noqa: S101
        balance = Balance(self.held)
        return balance, balance.tangent(self._at_rest(rest.q[None]), row, self.held.numbers)

    @cached_property
    def _closed(self) -> tuple[Balance, BalanceSlope] | None:
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

    def blocks(self, which: Indices, *names: str) -> list[Array]:
        """Blocks of numbers of some cases, (m, ...) each."""
        return self.program.blocks(names, {path: values[which] for path, values in self.values.items()})

    @cached_property
    def _moving(self) -> list[str]:
        """Blocks of signals that differ."""
        names = [f"{name} {k}" for k in range(len(self.like.planned.pieces)) for name in ("knots", "powers")]
        return [] if all(map(self.program.is_constant, names)) else names

    def _schedules(self, signals: Sequence[Array]) -> tuple[SignalPieces, ...]:
        """The signals of some cases, by their blocks, on common knots: one schedule where they are the same for all."""
        if not signals:
            return (self.like.planned.schedule,)
        return tuple(merge_cases([*zip(signals[::2], signals[1::2], strict=True)]))

    def numbers(self, which: Indices) -> CaseNumbers:
        """The numbers of some cases."""
        names = "parameters", "further", "chain", "base"
        parameters, further, chain, base, *signals = self.blocks(which, *names, *self._moving)
        numbers = np.hstack([parameters, further]) if further.size else parameters
        return CaseNumbers(numbers, chain, base, self._schedules(signals))

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

    def _rows(self, signals: Sequence[Array], count: int) -> Array:
        """The rows of the signals at time 0."""
        rows = [np.append(one.knots[0], one.coefficients[0]) for one in self._schedules(signals)]
        return np.broadcast_to(np.array(rows), (count, len(rows[0]))).copy()

    def _starts(self, which: Indices) -> Array:
        model, resting = self.like.model, self.like.rest is not None
        names = ("held", "rest", "rest_row") if resting else ()
        parameters, states, *more = self.blocks(which, "parameters", "start", *names, *self._moving)
        rows, states = self._rows(more[len(names) :], len(which)), states.copy()
        if resting:
            placed = states[:, model.layout.q]  # a view
            np.copyto(placed, self._rests(which, *more[: len(names)]), where=np.isnan(placed))
        states = begun(model, states, frozen(model, rows), parameters)
        if self._closed:
            states = self._balanced(*self._closed, states, rows, parameters)
        states = model.settled(states, rows, parameters)
        rates = model.rate(np.zeros(len(states)), states, rows, parameters)
        states[~np.isfinite(rates[:, model.layout.v]).all(axis=1)] = np.nan
        return states

    def _balanced(
        self, balance: Balance, tangent: BalanceSlope, states: Array, rows: Array, parameters: Array
    ) -> Array:
        """The equilibria of the closed loops, from the states with held motors; those that are in balance stay."""
        still, near = frozen(self.like.model, rows), balance.at_rest(states)
        found = rests(balance, parameters, still, near, tangent, STANDS)
        moved = (found != near).any(axis=1)
        states[moved] = balance.outside(found[moved], states[moved], still[moved], parameters[moved])
        return states

    def _rests(self, which: Indices, held: Array, numbers: Array, rows: Array) -> Array:
        """Poses at rest, of each case from that of ``like`` or, where that is too far, from its nearest neighbour's."""
        rest, names = self.like.rest, list(self.like.model.coordinates)
        assert rest is not None  # noqa: S101
        places = [names.index(name) for name in held_at_start(self.like.robot, self.like.model)]
        far = np.stack([values[which] / (np.abs(values).max() or 1.0) for values in self.values.values()])
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

    def groups(self, starts: Array, places: Indices, fastest: Array) -> Iterator[CaseGroup]:
        """The cases that have a start, by their method; ``fastest``: the largest eigenvalues of a few, as they go."""
        has_start = np.isfinite(starts).all(axis=1)
        methods = self._methods(starts, fastest)
        for method in sorted(set(methods[has_start].tolist())):
            chosen = np.flatnonzero(has_start & (methods == method))
            yield CaseGroup(
                self.like.by(method, None), places[chosen], starts[chosen],
                lambda which, chosen=chosen: self.numbers(chosen[which]),
            )  # fmt: skip

    def _methods(self, starts: Array, fastest: Array) -> NDArray[np.str_]:
        """The method of each case: that of a few where it is surely the same, else by the eigenvalues of each."""
        given = self.sheet.integration
        if given.method != AUTO:
            return np.full(len(starts), given.method)
        bounds = STIFF * (integrator("dormand_prince").reach or 1.0) / given.duration
        if not (fastest.max() * _SURELY <= bounds or fastest.min() >= bounds * _SURELY):
            fastest = np.concatenate([self.fastest(starts, which) for which in self._blocks])
        found = [chosen_method(given, highest, self.like.implicit)[0] for highest in fastest.tolist()]
        return np.array(found) if len(found) == len(starts) else np.full(len(starts), found[0])

    def fastest(self, starts: Array, which: Indices) -> Array:
        """The largest sizes of the eigenvalues of some cases at their starts; no joint or motor sticks."""
        states = slipping(self.like.model, np.nan_to_num(starts[which]))
        parameters, *signals = self.blocks(which, "parameters", *self._moving)
        slopes = self.like.model.jacobian(0.0, states, self._rows(signals, len(which)), parameters)
        return np.abs(np.linalg.eigvals(np.nan_to_num(slopes))).max(axis=1, initial=0.0)
