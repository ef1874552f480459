"""Exact derivatives of the numbers of a run by quantities of its data sheet, by the noted program of its lowering.

The program (A. Griewank, A. Walther, Evaluating Derivatives, 2008, chapter 2) gives the derivatives of the parameters,
of the signals and of a given start; a start in equilibrium follows from its equations, J y' = -f'.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.rigid import nominal_of
from tmodes.analysis.statics.equilibrium import Equilibrium
from tmodes.equations.loop.outputs import Output
from tmodes.errors import InputError, InputErrors
from tmodes.gradients.lowering import Lowered, rows_of
from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_paths import entered, steps_of
from tmodes.io.sheet_words import at
from tmodes.kinds.controllers.registry import Block
from tmodes.kinds.noted.number import Noted
from tmodes.kinds.signals.schedule import SAME, on_knots, shifted
from tmodes.model.derivatives import differentiated
from tmodes.model.parameters import Structural
from tmodes.sheet import Robot
from tmodes.simulation.balance import Balance, command_places, frozen, resting, samplings
from tmodes.simulation.control import designs
from tmodes.simulation.initial_state import closed_balance, held_at_start
from tmodes.simulation.loop import Blocks, LoopModel
from tmodes.simulation.plan import Follow, planned
from tmodes.simulation.replay import Replay
from tmodes.simulation.vary.cases import run_blocks
from tmodes.simulation.vary.programs import CaseProgram, case_program

__all__ = ["Change", "changes_of", "number_at"]

Array = NDArray[np.float64]
Derivatives = Callable[[str], Array]


class Change(NamedTuple):
    """Derivatives by one quantity: of the parameters, of the state at the start, and of the rows of the signals.

    ``parameters``: of those of the loop, then of those of the outputs that have some of their own. ``jumps``: by which
    the derivative of the state jumps at the start of some steps, where an instant moves at which the rates jump.
    """

    parameters: Array
    start: Array
    rows: Array
    jumps: dict[int, Array]


def changes_of(
    sheet: Robot, here: Lowered, replay: Replay | None, paths: Collection[str], shown: Sequence[Output] = ()
) -> dict[str, Change]:
    """The derivatives by each path; ``shown``: outputs, of which those with numbers of their own count.

    ``replay``: the run, without which no jumps are found.

    Raises :class:`tmodes.errors.InputError` for a path at which no number stands, and for one that is structure, with
    the reason.
    """
    data, found = sheet_data(sheet), dict[str, Change]()
    steps = {path: tuple(steps_of(path, data)) for path in paths}
    values = {path: number_at(path, data) for path in steps}
    noted = _Noted(sheet, here, tuple(shown))
    for group in _apart(steps):
        own = {path: values[path] for path in group}
        program, edges = noted.at(own)
        made = _Changes(here, replay, program, own)
        for path in group:
            near = path in edges and _Changes(here, replay, noted.near(path, own[path]), {path: own[path]})
            found[path] = (near or made).along(path)
    return {path: found[path] for path in paths}


def _apart(steps: Mapping[str, tuple[Any, ...]]) -> Iterator[list[str]]:
    """Groups of paths of which none leads to another's number."""
    left = [*steps]
    while left:
        group: list[str] = []
        for path in left:
            own = steps[path]
            if not any(own[: len(steps[k])] == steps[k][: len(own)] for k in group):
                group.append(path)
        yield group
        left = [path for path in left if path not in group]


@dataclass(frozen=True, eq=False)
class _Noted:
    """Programs of the numbers of a run and of its outputs."""

    sheet: Robot
    here: Lowered
    shown: tuple[Output, ...]

    def at(self, values: Mapping[str, float]) -> tuple[CaseProgram, set[str]]:
        """That of some paths, which have these values, and those at an edge: it holds nowhere next to their value."""
        found = self._program(values)
        point, count = np.array([*values.values()]), len(values)
        ways = np.diag(_NEAR * np.where(point == 0, 1.0, np.abs(point)))
        cases = point + np.concatenate([ways, -ways])
        holds = found.holds(dict(zip(values, cases.T, strict=True))).reshape(2, count)
        return found, {path for path, kept in zip(values, holds.T, strict=True) if not kept.any()}

    def near(self, path: str, value: float) -> CaseProgram:
        """That of one path next to its value where it is at an edge: a limit at which nothing but numbers changes."""
        here, row = self._program({path: value}), {path: np.array([value])}
        names = [*here.places]
        for step in (_NEAR, -_NEAR):
            moved = {path: value + step * (abs(value) or 1.0)}
            try:
                found, robot = self._program(moved), self.here.variant.of(self.sheet.with_(moved).pair())
                key = LoopModel(planned(robot, self.here.variant.follow).plan).loop.rate.key
            except (InputError, InputErrors):
                continue
            if key == self.here.model.loop.rate.key and found.places == here.places and all(
                np.allclose(one, known, 1e-12, 1e-14, equal_nan=True)
                for one, known in zip(found.blocks(names, row), here.blocks(names, row), strict=True)
            ):  # fmt: skip
                return found
        raise _structural(path, f"at {value:g} it is at an edge: other values have another structure")

    def _program(self, values: Mapping[str, float]) -> CaseProgram:
        def designed(robot: Robot, inputs: Mapping[str, Noted]) -> None:
            vars(nominal_of(robot))["designs"] = self._designs(values, inputs)

        try:
            found = case_program(self.sheet, values, self.here.variant.of, self._blocks, designs=designed)
        except Structural as why:
            for path, value in values.items() if len(values) > 1 else ():
                self._program({path: value})
            raise _structural(next(iter(values)), str(why)) from why
        for path in found.fixed:
            raise _structural(path, "what is compiled depends on it")
        return found

    def _designs(self, values: Mapping[str, float], inputs: Mapping[str, Noted]) -> dict[str, Block]:
        """Laws that are designed from the robot, whose numbers follow those that are noted by their slopes.

        A program holds no eigenvalue problem: slopes are differences of fourth order of whole designs.
        """
        found = {name: (one, np.array(one.numbers(), dtype=float)) for name, one in self._designed(values).items()}
        changes: dict[str, Any] = {name: numbers for name, (_, numbers) in found.items()}
        for path in self._known(inputs) if found else ():
            step = _DESIGN * (abs(values[path]) or 0.1)
            near = [self._designed({**values, path: values[path] + k * step}) for k in (-2, -1, 1, 2)]
            for name in found:
                a, b, c, d = (np.array(one[name].numbers(), dtype=float) for one in near)
                slope = (8 * (c - b) - (d - a)) / (12 * step)
                changes[name] = changes[name] + slope * (inputs[path] - values[path])
        return {name: one.with_numbers(changes[name]) for name, (one, _) in found.items()}

    def _known(self, paths: Mapping[str, Any]) -> list[str]:
        """Those of the robot as known, from which laws are designed."""
        data = sheet_data(self.sheet)
        return [path for path in paths if steps_of(path, data)[0] != "real"]

    def _designed(self, values: Mapping[str, float]) -> dict[str, Block]:
        """Those laws of the sheet with other numbers."""
        if self.here.variant.follow is not Follow.SHEET or not any(one.block.is_designed for one in self.sheet.control):
            return {}
        return designs(self.sheet.with_({path: values[path] for path in self._known(values)}))

    def _blocks(self, robot: Robot) -> Blocks:
        return run_blocks(robot, self.here.variant.follow, [output.name for output in self.shown])


@dataclass(frozen=True, eq=False)
class _Changes:
    """Derivatives by paths, which have these ``values``, of the numbers of a program that is ``noted``."""

    here: Lowered
    replay: Replay | None
    noted: CaseProgram
    values: Mapping[str, float]

    @cached_property
    def _derivatives(self) -> Array:
        """Of all numbers by all paths."""
        return self.noted.program.derivative(np.array([*self.values.values()]))

    def _of(self, path: str) -> Derivatives:
        """Those of a block of numbers by a path."""
        column = self.noted.paths.index(path)

        def block(name: str) -> Array:
            place = self.noted.places[name]
            size = int(np.prod(place["shape"]))
            return self._derivatives[place["start"] : place["start"] + size, column].reshape(place["shape"])

        return block

    def _value(self, name: str) -> Array:
        """A block of numbers."""
        return self.noted.blocks([name], {path: np.array([value]) for path, value in self.values.items()})[0][0]

    def along(self, path: str) -> Change:
        """By one quantity."""
        of, plan = self._of(path), self.here.setup.planned.plan
        if any(of(f"{what} {place}").any() for pair in plan.clocks for place in pair if place >= 0
               for what in ("knots", "powers")):  # fmt: skip
            raise _structural(path, "the instants of samples depend on it")
        rows, moving = self._signals(of)
        parameters = of("parameters")
        start = self._start(of, parameters, rows)
        return Change(np.concatenate([parameters, of("further")]), start, rows, self._jumps(moving))

    def _signals(self, of: Derivatives) -> tuple[Array, dict[int, dict[int, float]]]:
        """Of the rows at fixed times; and by segment which signals have a knot there that moves, and how fast."""
        plan, duration = self.here.setup.planned, self.here.settings.duration
        rows = rows_of(plan.schedule, duration)
        knots, width, moving = np.append(rows[:, 0], duration), plan.plan.degree + 1, dict[int, dict[int, float]]()
        found = np.zeros_like(rows)
        for signal, piece in enumerate(plan.pieces):
            moved, powers = of(f"knots {signal}"), of(f"powers {signal}")
            if not (moved.any() or powers.any()):
                continue
            slope = on_knots(piece.slope(moved, powers, duration), knots, plan.plan.degree)
            found[:, 1 + signal * width : 1 + (signal + 1) * width] = slope
            for k in np.flatnonzero((moved != 0) & (piece.knots < duration * (1 - SAME))).tolist():
                segment = int(np.abs(knots[:-1] - piece.knots[k]).argmin())
                moving.setdefault(segment, {})[signal] = float(moved[k])
        return found, {segment: signals for segment, signals in moving.items() if segment}

    def _jumps(self, moving: Mapping[int, Mapping[int, float]]) -> dict[int, Array]:
        """By which slopes of the state jump: the rates before an instant less those after it, times how it moves.

        Signals that jump at one instant do so one after the other, those that move least first.
        """
        if self.replay is None:
            return {}
        here, done = self.here, self.replay.recording
        steps = {segment: int(np.searchsorted(done.segments, segment)) for segment in moving}
        states = self.replay.starts({step for step in steps.values() if step < len(done.t)})
        found: dict[int, Array] = {}
        for segment, signals in moving.items():
            if (step := steps[segment]) not in states:
                continue
            speeds = sorted({*signals.values()})
            rows = [_before(done.rows, segment, here.model.plan.degree)]
            for speed in speeds:
                row, width = rows[-1].copy(), here.model.plan.degree + 1
                for signal in (k for k, own in signals.items() if own == speed):
                    part = slice(1 + signal * width, 1 + (signal + 1) * width)
                    row[part] = done.rows[segment, part]
                rows.append(row)
            state, count = np.tile(states[step], (len(rows), 1)), len(rows)
            rates = here.model.rate(np.full(count, done.rows[segment, 0]), state, np.array(rows), here.parameters)
            jump = np.array(speeds) @ (rates[:-1] - rates[1:])
            if np.abs(jump).max(initial=0.0) > _ROUNDING * np.abs(speeds).max() * np.abs(rates).max(initial=0.0):
                found[step] = found.get(step, 0.0) + jump
        return found

    def _start(self, of: Derivatives, parameters: Array, rows: Array) -> Array:
        """Of the first state: as it is given, and else of the equilibrium in which the run starts."""
        setup = self.here.setup
        still = frozen(self.here.model, np.stack([setup.first_row, rows[0]]))
        start = self._resting(setup.rest, of, parameters, still) if setup.rest else of("start").copy()
        closed = setup.off is None and closed_balance(setup) is not None
        return self._begun(start, still, parameters, closed=closed)

    def _resting(self, rest: Equilibrium, of: Derivatives, parameters: Array, still: Array) -> Array:
        """Of a first state at ``rest``, but for the outputs that are held."""
        here, setup, start = self.here, self.here.setup, of("start").copy()
        q = here.model.layout.q
        free, closed = np.isnan(self._value("start")[q]), None if setup.off else closed_balance(setup)
        along = start.copy()
        along[q][self._driven] = np.where(free[self._driven], of("held"), start[q][self._driven])
        if closed:
            states = closed.at_rest(np.stack([here.start, along]))
            found = _moved_rest(closed, (here.parameters, parameters), still, states)
            (own, run), unknown = closed.places, closed.unknown
            start[run[np.isin(own, unknown)]] = found[own[np.isin(own, unknown)]]
        else:
            balance = Balance(self._standing)
            places = [setup.mechanics.coordinates.index(name) for name in self._standing.coordinates]
            own = [here.model.coordinates.index(name) for name in self._standing.coordinates]
            states = np.zeros((2, self._standing.layout.size))
            states[:, self._standing.layout.q] = rest.q[places], along[q][own]
            both = (self._value("rest_row"), of("rest_row"))
            numbers, found = (self._standing.numbers, of("rest")), np.zeros(len(free))
            found[own] = _moved_rest(balance, numbers, np.stack(both), states)[self._standing.layout.q]
        start[q] = np.where(free, found[: len(free)], start[q])
        return start

    def _begun(self, moved: Array, rows: Array, parameters: Array, *, closed: bool) -> Array:
        """Of the first state, with the outputs that are held: see :func:`tmodes.simulation.balance.begun`.

        ``closed``: it is an equilibrium of the closed loop.
        """
        here, model = self.here, self.here.model
        held = model.layout.controls.start + np.flatnonzero(model.plan.held_controls)
        for step, row in samplings(model, rows):
            blocks = {"time": np.zeros((1, 1)), "state": here.start[None], "row": row[:1], "step": np.zeros((1, 1))}
            along, moved = {"state": moved[None], "row": row[1:]}, moved.copy()
            after = differentiated(step, ["state"]).along(here.parameters, blocks, along, change=parameters)["state"][0]
            moved[held] = after[held]
        if closed or not model.loop.held_commands:
            return moved
        for _, places in model.loop.held_commands:
            moved[[*places]] = 0.0
        (where, which), begin = command_places(model), resting(model, here.start[None])
        blocks = {"time": np.zeros((1, 1)), "state": begin, "row": rows[:1], "step": np.zeros((1, 1))}
        along = {"state": resting(model, moved[None]), "row": rows[1:]}
        left = differentiated(model.loop.rate, ["rate"]).along(here.parameters, blocks, along, change=parameters)
        slopes = model.slopes(0.0, begin, rows[:1], here.parameters, which)[0][where]
        efforts = -(np.linalg.pinv(slopes) @ left["rate"][0][where])
        for value, (_, places) in zip(efforts, model.loop.held_commands, strict=True):
            moved[[*places]] = value
        return moved

    @cached_property
    def _standing(self) -> LoopModel:
        """The loop in which every drive stands."""
        return LoopModel(planned(self.here.setup.robot, Follow.HELD).plan)

    @property
    def _driven(self) -> list[int]:
        """The coordinates that drives hold at the start."""
        names = self.here.model.coordinates
        return [names.index(name) for name in held_at_start(self.here.setup.robot, self.here.model)]


def _moved_rest(balance: Balance, numbers: tuple[Array, Array], rows: Array, states: Array) -> Array:
    """Derivative (size,) of a state at rest, J y' = -f': each argument is what it is of and its derivative.

    That of the state gives the coordinates that are held.
    """
    along = states[1].copy()
    if not len(balance.unknown):
        return along
    along[balance.unknown] = 0.0
    blocks = {"time": np.zeros((1, 1)), "state": states[:1], "row": rows[:1], "step": np.zeros((1, 1))}
    slopes = differentiated(balance.loop.loop.rate, ["rate"]).along(
        numbers[0], blocks, {"state": along[None], "row": rows[1:]}, change=numbers[1]
    )["rate"][0]
    tangent = balance.tangent(states[:1], rows[:1], numbers[0])
    along[balance.unknown] = -(tangent.inverse @ slopes[balance.equations])
    return along


def _before(rows: Array, segment: int, degree: int) -> Array:
    """The row before a segment, about its start."""
    powers = rows[segment - 1, 1:].reshape(-1, degree + 1)
    length = rows[segment, 0] - rows[segment - 1, 0]
    return np.append(rows[segment, 0], shifted(powers, np.full(len(powers), length)))


_ROUNDING = 1e-12
"""Share of the rates by which they jump where they are continuous."""

_DESIGN = 3e-3
"""Relative step of the differences of a design."""

_NEAR = 1e-6
"""Relative step to a neighbour of a value, by which edges of the structure are seen."""


def _structural(path: str, why: str) -> InputError:
    expected = "a number that changes nothing but numbers, along which a run can be differentiated"
    return InputError(path, f"structure ({why})", expected, "name another quantity, or vary this one in a batch")


def number_at(path: str, data: Any) -> float:
    """The number at a path of a sheet's data.

    A list of equal numbers, gravity downwards and an inertia that is alike about every axis count as one number.

    Raises :class:`tmodes.errors.InputError` for anything else.
    """
    *groups, last = steps_of(path, data)
    known = at(entered(data, groups, path), last)
    several = _moments(known) if isinstance(known, dict) else known
    same = isinstance(several, list) and len(set(map(str, several))) == 1
    value: Any = several[0] if same and several else known
    if not groups and last == "gravity" and isinstance(known, list) and not any(known[:2]):
        value = -known[2]  # downwards
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not np.isfinite(value):
        expected, hint = "the path of a finite number", "name another quantity, or give this one a value"
        raise InputError(path, repr(known), expected, hint)
    return float(value)


def _moments(known: dict[str, Any]) -> list[Any] | None:
    """The moments of an inertia without products."""
    products = [known.get(name, 0.0) for name in ("xy", "xz", "yz")]
    return [known[name] for name in ("xx", "yy", "zz")] if "xx" in known and not any(products) else None
