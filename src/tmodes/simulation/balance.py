"""Equilibrium of a closed loop at its first setpoints: a pose and states of controllers and motors that all stay.

With the signals held at their first values the rates of all coordinates, currents and own states of controllers vanish:
a motor under a PD stands off its setpoint by what its torque takes, the integral of a PID carries the load. Newton's
method on the compiled right-hand side, from the pose in which the motors are held; where that is too far, what holds
them is let go in steps, so that the equilibrium is the one on the same branch.
"""

from __future__ import annotations

from collections.abc import Container, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.modes.closed_loop import settled
from tmodes.analysis.statics.path import STRAY
from tmodes.analysis.statics.system import ROUNDING, SETTLED
from tmodes.model.passes import evaluate
from tmodes.simulation.loop import LoopModel

__all__ = ["LITTLE", "STANDS", "Balance", "BalanceSlope", "Search", "begun", "frozen", "rounding", "samplings"]

Array = NDArray[np.float64]
Places = NDArray[np.intp]

_STEPS = 25
_SHORTEST = 1e-4
"""Shortest step on the way from held motors to free ones, as a share of it."""

LITTLE = 1e-3
"""First step [rad, m] too short to leave a branch."""

_LONGEST = 0.5
"""Longest step [rad, m]."""

STANDS = 1e-11
"""First step over 1 + |q| up to which the pose with held motors is the equilibrium already, and stays as it is."""

_ROUNDING, _SLOW = 1e-12, 1e-9
"""Of an acceleration that is none: a share of what a turn by 1 rad brings about, and a size [rad/s^2, m/s^2]."""

_EXACT = 1e-6
"""Largest entry of A A^-1 - 1 of a matrix in which nothing is held by nothing."""

_SINGULAR = 1e-13
"""Singular value over the largest one of a direction that nothing holds."""


def frozen(model: LoopModel, rows: Array, but: Container[int] = ()) -> Array:
    """Rows (..., row) of signals that stay at their first values, ``but`` for some; without the noise on setpoints."""
    count, still = model.plan.degree + 1, rows.copy()
    signals = still[..., 1:].reshape(*rows.shape[:-1], -1, count)  # a view
    signals[..., [k for k in range(model.plan.signals) if k not in but], 1:] = 0.0
    signals[..., [drive.noise for drive in model.plan.drives if drive.noise >= 0], :] = 0.0
    return still


def samplings(model: LoopModel, rows: Array) -> Iterator[tuple[Any, Array]]:
    """The samples, and their rows (k, row), after which all outputs that are held are those of these rows."""
    plan, rows = model.plan, rows.copy()
    width = plan.degree + 1
    for late in (late for _, late in plan.clocks if late >= 0):
        rows[:, 1 + late * width : 1 + (late + 1) * width] = 0.0  # an output is given with its sample
    for _ in range(plan.first_samples):
        yield model.loop.sampled, rows


def begun(model: LoopModel, states: Array, rows: Array, numbers: Array, *, holds: bool = True) -> Array:
    """States (k, size) with the outputs that are held before the first sample, delayed ones among them.

    Those of the start: as if robot and signals, ``rows`` (k, row) of :func:`frozen`, had always stood so. A command is
    that which holds the robot where it starts (``holds``), or that of the law. Own states of controllers stay.
    """
    outputs, count = model.layout.controls.start + np.flatnonzero(model.plan.held_controls), len(states)
    for sampled, row in samplings(model, rows):
        blocks = {"time": np.zeros((count, 1)), "state": states, "row": row, "step": np.zeros((count, 1))}
        states = states.copy()
        states[:, outputs] = evaluate(numbers, sampled, blocks, count)["state"][:, outputs]
    commands = model.loop.held_commands
    if not (holds and commands):
        return states
    for _, places in commands:
        states[:, places] = 0.0
    still, (where, which) = resting(model, states), command_places(model)
    slopes = model.slopes(0.0, still, rows, numbers, which)[:, where]
    left = model.rate(np.zeros(count), still, rows, numbers)[:, where]
    known = np.isfinite(slopes).all(axis=(1, 2)) & np.isfinite(left).all(axis=1)
    efforts = np.zeros(left.shape)
    efforts[known] = -(np.linalg.pinv(slopes[known]) @ left[known][..., None])[..., 0]
    for k, (_, places) in enumerate(commands):
        states[:, places] = efforts[:, [k]]
    return states


def resting(model: LoopModel, states: Array) -> Array:
    """The same states (k, size) without rates."""
    still = states.copy()
    still[:, model.layout.v] = 0.0
    return still


def command_places(model: LoopModel) -> tuple[Places, Places]:
    """Where the rate has the accelerations of what sampled commands move, and the state those in force."""
    first = model.layout.v.start
    found = [(first + moved, places[0]) for moved, places in model.loop.held_commands]
    return np.array([one for one, _ in found], dtype=np.intp), np.array([one for _, one in found], dtype=np.intp)


def _reach(q: Array) -> float:
    """Over which changes of coordinates ``q`` are small."""
    return 1.0 + float(np.abs(q).max(initial=0.0))


def rounding(slopes: Array, q: Array, share: float = _ROUNDING) -> Array:
    """Up to which the rates of which these are the ``slopes`` (n, m) are none, (n,), in the pose ``q``."""
    return share * np.abs(slopes).max(axis=1, initial=0.0) * _reach(q) + _SLOW


@dataclass(frozen=True, eq=False)
class Balance:
    """The equations of rest of the closed loop ``model``; ``kept``: coordinates that stay where they are put.

    They are those of :attr:`LoopModel.settles`, in whose states (..., size) equilibria are found.
    """

    model: LoopModel
    kept: frozenset[int] = frozenset()

    @property
    def loop(self) -> LoopModel:
        """Where nothing sticks, and samples are rates."""
        return self.model.settles

    @cached_property
    def coordinates(self) -> Places:
        """The coordinates to be found: those that neither a signal nor a joint keeps."""
        loop = self.loop.loop
        given = {driver.coordinate for driver in loop.drivers if driver.plan.servo is None}
        kept = given | self.kept | {*loop.parts.held}
        return np.array([k for k in range(loop.parts.size) if k not in kept], dtype=np.intp)

    @cached_property
    def unknown(self) -> Places:
        """Where the state holds what is to be found: coordinates, then currents and own states of controllers."""
        layout = self.loop.layout
        return np.append(self.coordinates, np.arange(layout.currents.start, layout.controls.stop))

    @cached_property
    def equations(self) -> Places:
        """Where the rate holds what must vanish, each next to its unknown."""
        return np.where(self.unknown < self.loop.layout.v.start, self.unknown + self.loop.layout.v.start, self.unknown)

    def rates(self, states: Array, rows: Array, numbers: Array) -> Array:
        """What must vanish, (k, unknown), of states (k, size)."""
        return self.loop.rate(np.zeros(len(states)), states, rows, numbers)[:, self.equations]

    def slopes(self, states: Array, rows: Array, numbers: Array) -> Array:
        """Its derivatives by the unknown, (k, unknown, unknown)."""
        return self.loop.slopes(0.0, states, rows, numbers, self.unknown)[:, self.equations]

    def tangent(self, states: Array, rows: Array, numbers: Array) -> BalanceSlope:
        """Of one state (1, size)."""
        return BalanceSlope.of(self.slopes(states, rows, numbers)[0], len(self.coordinates))

    def at_rest(self, states: Array) -> Array:
        """States (k, size) of the run, at rest, as states of the equations."""
        own, run = self.places
        found = np.zeros((len(states), self.loop.layout.size))
        found[:, own] = states[:, run]
        return found

    @property
    def places(self) -> tuple[Places, Places]:
        """Where a state of the equations holds what a run's holds too, and where that does."""
        own, layout = self.loop.layout, self.model.layout
        blocks = [np.arange(part.start, part.stop) for part in (own.q, own.currents, own.controls)]
        run = [np.arange(part.start, part.stop) for part in (layout.q, layout.currents, layout.controls)]
        run[2] = run[2][self._own]
        return np.concatenate(blocks), np.concatenate(run)

    def outside(self, found: Array, states: Array, rows: Array, numbers: Array) -> Array:
        """States of the run with what was found, (k, size): outputs that are held between samples included."""
        own, run = self.places
        states = states.copy()
        states[:, run] = found[:, own]
        return begun(self.model, states, rows, numbers, holds=False)

    @cached_property
    def _own(self) -> Places:
        """Where the controllers' own states stand among those of the run, which hold commands too."""
        return np.flatnonzero(~np.array(self.model.plan.held_controls, dtype=bool))


@dataclass(frozen=True, eq=False)
class BalanceSlope:
    """The slope of the equations of rest at one state: its ``inverse`` (unknown, unknown), what an unknown ``weighs``.

    ``counts``: unknowns that influence anything; a state of a controller that does not may drift. ``weighs``: 1 of a
    coordinate, of other unknowns the turn or travel [rad, m] that is in balance with one unit, in the equation in which
    that is least.
    """

    slopes: Array
    inverse: Array
    weighs: Array
    counts: NDArray[np.bool_]

    @classmethod
    def of(cls, slopes: Array, coordinates: int) -> BalanceSlope:
        """Of a matrix (unknown, unknown) whose first unknowns are ``coordinates``."""
        counts = np.ones(len(slopes), dtype=bool)
        while True:
            left = slopes[np.ix_(counts, counts)]
            blind = ~left.any(axis=0)
            if not blind.any():
                break
            counts[np.flatnonzero(counts)[blind]] = False
        inverse = np.zeros_like(slopes)
        inverse[np.ix_(counts, counts)] = pseudo_inverse(left)
        sizes = np.abs(slopes)
        springs = sizes[:, :coordinates].max(axis=1, initial=0.0)
        known = (springs > 0)[:, None] & (sizes[:, coordinates:] > 0)
        moves = np.divide(sizes[:, coordinates:], springs[:, None], out=np.full(known.shape, np.inf), where=known)
        least = moves.min(axis=0, initial=np.inf)
        return cls(slopes, inverse, np.append(np.ones(coordinates), np.where(np.isfinite(least), least, 0.0)), counts)


def pseudo_inverse(matrix: Array) -> Array:
    """Of a square matrix, whose rows and columns are made alike first; zero along what nothing holds."""
    if not matrix.size:
        return matrix.T.copy()
    across = np.abs(matrix).max(axis=1)
    across[across == 0] = 1.0
    alike = matrix / across[:, None]
    along = np.abs(alike).max(axis=0)
    along[along == 0] = 1.0
    alike /= along
    if not np.isfinite(alike).all():
        return np.full_like(alike, np.nan)
    try:
        inverse = np.linalg.inv(alike)  # thirty times as fast as by singular values
        exact = np.abs(alike @ inverse - np.eye(len(alike))).max() < _EXACT
    except np.linalg.LinAlgError:
        inverse, exact = alike, False
    if not exact:
        inverse = np.linalg.pinv(alike, rcond=_SINGULAR)
    return inverse / along[:, None] / across


@dataclass(eq=False)
class Search:
    """The equilibrium of one robot near the state ``first`` (size,) of the equations, at the signals of ``row``.

    ``end``: the last state on the way; ``failed``: it is no equilibrium; ``moved``: it is not the first one.
    """

    balance: Balance
    first: Array
    row: Array
    numbers: Array
    end: Array = field(init=False)
    failed: bool = False
    moved: bool = False
    _known: dict[bytes, BalanceSlope] = field(init=False, default_factory=dict)

    def __post_init__(self) -> None:
        self.end = self.first
        if len(self.balance.unknown):
            self._seek()

    def _seek(self) -> None:
        """At once, or by letting go in steps of what holds the motors."""
        first, tangent = self._rates(self.first), self._tangent(self.first)
        step = tangent.inverse @ first
        self.failed = not np.isfinite(step).all()
        if self.failed:
            return
        self.moved = self._size(step, tangent) > STANDS * self._reach(self.first)
        share, length = 0.0 if self.moved else 1.0, 1.0
        while share < 1.0:
            length = min(length, 1.0 - share)
            there = self._newton(self.end, (1.0 - share - length) * first, tangent.counts)
            if there is not None:
                self.end, share, length = there, share + length, 2 * length
            elif length == 1.0 and (near := self._settled()) is not None:
                self.end, length = near, float(np.nextafter(1.0, 0.0))  # once
                first, tangent = self._rates(near), self._tangent(near)
            elif (length := length / 2) < _SHORTEST:
                self.failed = True
                return
        after = self._tangent(self.end) if self.moved else tangent
        self.failed = self._left(self._rates(self.end), after)

    def _settled(self) -> Array | None:
        """The first state with controllers that have settled to it.

        An estimator that begins far off gives commands beyond their limits, from which no slope leads back.
        """
        own = slice(len(self.balance.coordinates), None)
        state = settled(
            self.first, self.balance.unknown[own], lambda one: self._rates(one)[own],
            lambda one: self._tangent(one).slopes[own, own],
        )  # fmt: skip
        return state if np.isfinite(state).all() else None

    def _rates(self, state: Array) -> Array:
        return self.balance.rates(state[None], self.row[None], self.numbers)[0]

    def _tangent(self, state: Array) -> BalanceSlope:
        key = state.tobytes()
        if key not in self._known:
            self._known[key] = self.balance.tangent(state[None], self.row[None], self.numbers)
        return self._known[key]

    @staticmethod
    def _size(step: Array, tangent: BalanceSlope) -> float:
        return float(np.abs(step * tangent.weighs).max(initial=0.0))

    def _reach(self, state: Array) -> float:
        return _reach(state[self.balance.loop.layout.q])

    def _newton(self, state: Array, left: Array, counts: NDArray[np.bool_]) -> Array | None:
        """The state near by at which so much is ``left``, on the same branch; None where there is none.

        Where others than ``counts`` influence anything, a controller is at its limit.
        """
        before = first = np.inf
        corrected = 0.0
        for k in range(_STEPS):
            tangent = self._tangent(state)
            step = tangent.inverse @ (self._rates(state) - left)
            size = self._size(step, tangent)
            if not np.isfinite(size):
                return None
            length = float(np.abs(step[: len(self.balance.coordinates)]).max(initial=0.0))
            first, corrected = (first, corrected + length) if k else (length, 0.0)
            if first > LITTLE and (corrected > STRAY * first or first > _LONGEST):
                return None
            state = state.copy()
            state[self.balance.unknown] -= step
            if size <= SETTLED * self._reach(state) or before <= size <= ROUNDING:
                return state if (self._tangent(state).counts == counts).all() else None
            before = size
        return None

    def _left(self, rates: Array, tangent: BalanceSlope) -> bool:
        """Whether more than rounding is left over along what nothing holds."""
        seen = tangent.counts.copy()
        seen[: len(self.balance.coordinates)] = True
        left = np.abs(rates - tangent.slopes @ (tangent.inverse @ rates))
        return bool((left > rounding(tangent.slopes, self.end[self.balance.loop.layout.q]))[seen].any())
