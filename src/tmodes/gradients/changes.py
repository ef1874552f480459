"""How the numbers of a run change with the quantities of its data sheet."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel

from tmodes.analysis.statics.equilibrium import free_coordinates
from tmodes.errors import InputError
from tmodes.gradients.lowering import Lowered, rows_of, structure
from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_paths import entered, steps_of
from tmodes.io.sheet_words import at
from tmodes.model.model import Model
from tmodes.sheet import Robot
from tmodes.simulation.balance import Balance, frozen
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.plan import planned, starts_at_rest
from tmodes.simulation.start import closed_balance, first_state, run_setup

__all__ = ["Change", "Changes", "far_difference", "near_difference", "number_at", "replaced"]

Array = NDArray[np.float64]


class Changes:
    """Differences of the plan, exact to about 1e-9 of a number that depends smoothly on the quantity.

    Those of a start in equilibrium follow from its equations: of the closed loop where it is that of one, else of the
    robot with held motors, K q' = -f', where nothing but the robot's own numbers changes; elsewhere they are
    differences of equilibria.
    """

    def __init__(self, sheet: Robot, here: Lowered) -> None:
        self.sheet, self.here, self.data = sheet, here, sheet_data(sheet)
        self.rows = rows_of(here.schedule, here.settings.duration)
        self._rest: tuple[Model, NDArray[np.intp], Array] | None = None

    def along(self, path: str) -> Change:
        """By one quantity.

        Raises :class:`tmodes.errors.InputError` for a path at which no number other than 0 stands (in signals 0 will
        do), and for one that changes more than numbers: the structure, or the times of the signals.
        """
        *groups, last = steps_of(path, self.data)
        known = at(entered(sheet_data(self.sheet), groups, path), last)
        value = number_at(path, known, zero="signal" in groups)

        rests = starts_at_rest(self.sheet)

        def numbers(change: float) -> Array:
            robot = self._changed(path, value + change)
            plan = planned(robot)
            model = LoopModel(plan.plan)
            rows = rows_of(plan.schedule, self.here.settings.duration)
            self._check(path, model.loop, rows)
            start = plan.signals.at(0.0) if rests else first_state(robot, plan, model)
            return np.concatenate([model.loop.parts.numbers.vector, rows.ravel(), start])

        parts = [len(self.here.parameters), self.rows.size]
        parameters, rows, start = np.split(near_difference(numbers, value), np.cumsum(parts))
        change = Change(parameters, start, rows.reshape(self.rows.shape))
        return change._replace(start=self._rest_of(path, value, change)) if rests else change

    def _rest_of(self, path: str, value: float, change: Change) -> Array:
        """Derivative of the state at rest; ``change`` holds that of the signals at the start."""
        placed = self.sheet.initial.coordinates or self.sheet.initial.rates
        if (balance := closed_balance(self.here.setup)) and not (self.here.setup.off or placed):
            return self._closed_along(balance, change, value)
        if change.start.any() or not self._robot_alone(change):
            return far_difference(lambda by: run_setup(self._changed(path, value + by)).start, value)
        start = np.zeros_like(self.here.start)
        start[: len(self.here.model.coordinates)] = self._rest_along(change.parameters)
        return start

    def _closed_along(self, balance: Balance, change: Change, value: float) -> Array:
        """Of the equilibrium of the closed loop, J y' = -f' of its unknowns y, and of motions that are given."""
        here, layout = self.here, self.here.model.layout
        first, row = here.start[None].copy(), self.rows[0]
        signals, start = change.rows[0, 1:].reshape(here.model.plan.signals, -1), np.zeros_like(here.start)
        for driver in here.model.loop.drivers:
            if driver.plan.servo is None:
                for block, power in ((layout.q, 0), (layout.v, 1)):
                    start[block][driver.coordinate] = signals[driver.plan.signal, power : power + 1].sum()
        still, states = frozen(here.model, np.stack([row, change.rows[0]])), balance.at_rest(first)

        def rates(by: float) -> Array:
            rows = (still[0] + by * still[1])[None]
            return balance.rates(states, rows, here.parameters + by * change.parameters)[0]

        tangent = balance.tangent(states, still[:1], here.parameters)
        start[balance.unknown] = -(tangent.inverse @ near_difference(rates, value))
        return start

    def _changed(self, path: str, value: float) -> Robot:
        """The robot as it really is with another number, which is only checked where it does not simply replace one."""
        # In an imported robot a number may stand for several, which only the importer knows.
        robot = None if self.sheet.imported else replaced(self.sheet, steps_of(path, self.data), value)
        return (robot or self.sheet.with_({path: value})).pair().real

    def _check(self, path: str, loop: Any, rows: Array) -> None:
        setup = self.here.setup
        if structure(loop) != structure(setup.model.loop) or rows.shape != self.rows.shape:
            what, hint = "a change of the structure", "name a quantity whose small changes only change numbers"
        elif not np.array_equal(rows[:, 0], self.rows[:, 0]):
            what, hint = "a change of the times at which signals jump", "name a quantity that leaves them as they are"
        else:
            return
        raise InputError(path, what, "a change of numbers alone, along which a run can be differentiated", hint)

    def _robot_alone(self, change: Change) -> bool:
        """Whether nothing acts on the robot at rest but its weight, which stays, as its base stays where it is."""
        setup = self.here.setup
        sheet, base = self.sheet, setup.model.loop.base
        moved = change.parameters[base.start : base.start + base.size].any()
        return not (sheet.loads or sheet.contact or sheet.initial.coordinates or sheet.initial.rates or moved)

    def _at_rest(self) -> tuple[Model, NDArray[np.intp], Array]:
        """The robot, its coordinates that are free at rest, and its stiffness there."""
        if self._rest is None:
            setup = self.here.setup
            model = setup.mechanics
            held = {model.coordinates[driver.coordinate]: 0.0 for driver in setup.model.loop.drivers}
            free = free_coordinates(model, held, ())
            self._rest = model, free, model.stiffness(setup.start[: model.nq])
        return self._rest

    def _rest_along(self, parameters: Array) -> Array:
        """K q' = -f' along the free coordinates."""
        model, free, stiffness = self._at_rest()
        q, found = self.here.start[: model.nq], np.zeros(model.nq)
        if len(free):
            forces = model.static_forces_along(q, parameters[: len(model.parameters)])
            found[free] = -np.linalg.solve(stiffness[np.ix_(free, free)], forces[free])
        return found


_NEAR, _FAR = 3e-5, 1e-3
"""Relative steps of the differences: of smooth arithmetic, whose error is of second order in the step and below 1e-8;
and of equilibria, found to a tolerance, by differences of fourth order."""


class Change(NamedTuple):
    """Derivatives by one quantity: of the parameters, of the state at the start, and of the rows of the signals."""

    parameters: Array
    start: Array
    rows: Array


def near_difference(value_at: Callable[[float], Array], value: float) -> Array:
    """Derivative of smooth arithmetic at a value, from changes of it; at 0 the change counts in its own unit."""
    step = _NEAR * (abs(value) or 1.0)
    return (value_at(step) - value_at(-step)) / (2 * step)


def far_difference(value_at: Callable[[float], Array], value: float) -> Array:
    """The same of an equilibrium."""
    step = _FAR * (abs(value) or 1.0)
    near = np.stack([value_at(k * step) for k in (-2, -1, 1, 2)])
    return np.array([1.0, -8.0, 8.0, -1.0]) @ near / (12 * step)


def number_at(path: str, known: Any, *, zero: bool = False) -> float:
    """The number at a path; a list of equal numbers and an inertia that is alike about every axis count as one.

    Raises :class:`tmodes.errors.InputError` for anything else, and for a zero where none may be.
    """
    several = _moments(known) if isinstance(known, dict) else known
    same = isinstance(several, list) and len(set(map(str, several))) == 1
    value: Any = several[0] if same and several else known
    wrong = isinstance(value, bool) or not isinstance(value, (int, float)) or not np.isfinite(value)
    if wrong or (value == 0 and not zero):
        expected = "the path of a finite number other than 0: its change is given relative to it"
        raise InputError(path, repr(known), expected, "name another quantity, or give this one a value")
    return float(value)


def _moments(known: dict[str, Any]) -> list[Any] | None:
    """The moments of an inertia without products."""
    products = [known.get(name, 0.0) for name in ("xy", "xz", "yz")]
    return [known[name] for name in ("xx", "yy", "zz")] if "xx" in known and not any(products) else None


def replaced(sheet: Any, steps: Sequence[str | int], value: float) -> Any:
    """A sheet with another number where one stands, made again without checks; None where none stands by itself.

    A check of the whole takes longer than what differences need otherwise.
    """
    if not steps:
        alone = isinstance(sheet, tuple) and len(sheet) == 1 and isinstance(sheet[0], float)
        return (value,) if alone else value if isinstance(sheet, float) else None
    step, *rest = steps
    if isinstance(sheet, BaseModel):
        fields = {name: getattr(sheet, name) for name in type(sheet).model_fields}
        inner = replaced(fields.get(str(step)), rest, value)
        made = type(sheet).model_construct(sheet.model_fields_set, **(fields | {str(step): inner}))
        return None if inner is None else made
    if isinstance(sheet, tuple) and isinstance(step, int):
        inner = replaced(sheet[step], rest, value)
        return None if inner is None else (*sheet[:step], inner, *sheet[step + 1 :])
    return None
