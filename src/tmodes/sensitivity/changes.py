"""How the numbers of a run change with the quantities of its data sheet."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.equilibrium_held import free_coordinates
from tmodes.arm import Arm
from tmodes.arm_model import ArmModel
from tmodes.errors import InputError
from tmodes.io.arm_paths import entered, steps_of
from tmodes.io.arm_units import at
from tmodes.mechanism import Parameters
from tmodes.model import Model
from tmodes.motion.plan import starts_at_rest
from tmodes.motion.regime import arm_regime
from tmodes.robot import Robot
from tmodes.sensitivity.lowering import Lowered, replanned, rows_of, structure

__all__ = ["Change", "Changes"]

Array = NDArray[np.float64]

_NEAR, _FAR = 3e-5, 1e-3
"""Relative steps of the differences: of smooth arithmetic, whose error is of second order in the step and below 1e-8;
and of equilibria, found to a tolerance, by differences of fourth order."""


class Change(NamedTuple):
    """Derivatives by one quantity: of the parameters, of the state at the start, and of the rows of the signals."""

    parameters: Array
    start: Array
    rows: Array


class Changes:
    """Derivatives of a run's numbers by quantities of its sheet, by central differences.

    Those of the state at rest follow from the equations of rest, K q' = -f', where nothing but the arm's own numbers
    changes; elsewhere they are differences of equilibria.
    """

    def __init__(self, sheet: Arm | Robot, here: Lowered) -> None:
        self.sheet, self.here = sheet, here
        self.rows = rows_of(here.schedule, here.settings.duration)
        self._rest: tuple[ArmModel, NDArray[np.intp], Array] | None = None

    def along(self, path: str) -> Change:
        """By one quantity.

        Raises :class:`tmodes.errors.InputError` for a path at which no number other than 0 stands, and for one that
        changes more than numbers: the structure, or the times of the signals.
        """
        if isinstance(self.sheet, Robot):
            return self._of_robot(self.sheet, path)
        return self._of_arm(self.sheet, path)

    def _of_robot(self, sheet: Robot, path: str) -> Change:
        """The numbers are the parameters themselves."""
        parameters, model = self.here.parameters, self.here.model
        assert isinstance(parameters, Parameters)  # noqa: S101
        assert isinstance(model, Model)  # noqa: S101
        value, unit = _number(path, dict(parameters).get(path)), np.zeros_like(parameters.vector)
        unit[parameters.names.index(path)] = 1.0

        def start(change: float) -> Array:
            return model.rest(sheet.reference.start, replace(parameters, vector=parameters.vector + change * unit))

        return Change(unit, _far(start, value), np.zeros_like(self.rows))

    def _of_arm(self, sheet: Arm, path: str) -> Change:
        data = sheet.model_dump(mode="json", exclude_none=True)
        *groups, last = steps_of(path, data)
        value = _number(path, at(entered(data, groups, path), last))

        def numbers(change: float) -> Array:
            plan, loop = replanned(sheet.with_({path: value + change}))
            rows = rows_of(plan.schedule, self.here.settings.duration)
            self._check(path, loop, rows)
            return np.concatenate([loop.parts.numbers.vector, rows.ravel(), plan.signals.at(0.0)])

        parts = [len(self.here.parameters.vector), self.rows.size]
        parameters, rows, begin = np.split(_near(numbers, value), np.cumsum(parts))
        change = Change(parameters, np.zeros_like(self.here.start), rows.reshape(self.rows.shape))
        if starts_at_rest(sheet) and not begin.any() and self._arm_alone(sheet, change):
            change.start[: len(self.here.model.coordinates)] = self._rest_along(change.parameters)
            return change
        return change._replace(start=_far(lambda by: arm_regime(sheet.with_({path: value + by})).start, value))

    def _check(self, path: str, loop: Any, rows: Array) -> None:
        regime = self.here.regime
        assert regime is not None  # noqa: S101
        if structure(loop) != structure(regime.model.loop) or rows.shape != self.rows.shape:
            what, mend = "a change of the structure", "name a quantity whose small changes only change numbers"
        elif not np.array_equal(rows[:, 0], self.rows[:, 0]):
            what, mend = "a change of the times at which signals jump", "name a quantity that leaves them as they are"
        else:
            return
        raise InputError(path, what, "a change of numbers alone, along which a run can be differentiated", mend)

    def _arm_alone(self, sheet: Arm, change: Change) -> bool:
        """Whether nothing acts on the arm at rest but its weight, which does not change, nor where its base stands."""
        regime = self.here.regime
        assert regime is not None  # noqa: S101
        initial, base = sheet.initial, regime.model.loop.base
        moved = change.parameters[base.start : base.start + base.size].any()
        return not (sheet.loads or sheet.contact or initial.coordinates or initial.rates or moved)

    def _at_rest(self) -> tuple[ArmModel, NDArray[np.intp], Array]:
        """The arm, its coordinates that are free at rest, and its stiffness there."""
        if self._rest is None:
            regime = self.here.regime
            assert regime is not None  # noqa: S101
            model = ArmModel(regime.planned.chain)
            held = {model.coordinates[driver.coordinate]: 0.0 for driver in regime.model.loop.drivers}
            free = free_coordinates(model, held, ())
            self._rest = model, free, model.stiffness(regime.start[: model.nq])
        return self._rest

    def _rest_along(self, parameters: Array) -> Array:
        """K q' = -f' along the free coordinates."""
        model, free, stiffness = self._at_rest()
        q, found = self.here.start[: model.nq], np.zeros(model.nq)
        if len(free):
            forces = model.static_forces_along(q, parameters[: len(model.parameters)])
            found[free] = -np.linalg.solve(stiffness[np.ix_(free, free)], forces[free])
        return found


def _near(value_at: Callable[[float], Array], value: float) -> Array:
    step = _NEAR * abs(value)
    return (value_at(step) - value_at(-step)) / (2 * step)


def _far(value_at: Callable[[float], Array], value: float) -> Array:
    step = _FAR * abs(value)
    near = np.stack([value_at(k * step) for k in (-2, -1, 1, 2)])
    return np.array([1.0, -8.0, 8.0, -1.0]) @ near / (12 * step)


def _number(path: str, known: Any) -> float:
    """The number at a path; one that stands for several equal ones is told once."""
    same = isinstance(known, list) and len(set(map(str, known))) == 1
    value = known[0] if same else known
    if isinstance(value, bool) or not isinstance(value, (int, float)) or value == 0 or not np.isfinite(value):
        expected = "the path of a finite number other than 0: its change is told relative to it"
        raise InputError(path, repr(known), expected, "name another quantity, or give this one a value")
    return float(value)
