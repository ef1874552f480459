"""How the numbers of a run change with the quantities of its data sheet."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.statics.held import free_coordinates
from tmodes.errors import InputError
from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_paths import entered, steps_of
from tmodes.io.sheet_units import at
from tmodes.model.model import Model
from tmodes.sensitivity.differences import Change, far_difference, near_difference, number_at, replaced
from tmodes.sensitivity.lowering import Lowered, replanned, rows_of, structure
from tmodes.sheet import Robot
from tmodes.simulation.plan import starts_at_rest
from tmodes.simulation.start import first_state, run_setup

__all__ = ["Changes"]

Array = NDArray[np.float64]


class Changes:
    """Differences of the plan, exact to about 1e-9 of a number that depends smoothly on the quantity.

    Those of the state at rest follow from the equations of rest, K q' = -f', where nothing but the arm's own numbers
    changes; elsewhere they are differences of equilibria.
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
            arm = self._changed(path, value + change)
            plan, model = replanned(arm)
            rows = rows_of(plan.schedule, self.here.settings.duration)
            self._check(path, model.loop, rows)
            start = plan.signals.at(0.0) if rests else first_state(arm, plan, model)
            return np.concatenate([model.loop.parts.numbers.vector, rows.ravel(), start])

        parts = [len(self.here.parameters), self.rows.size]
        parameters, rows, start = np.split(near_difference(numbers, value), np.cumsum(parts))
        change = Change(parameters, start, rows.reshape(self.rows.shape))
        return change._replace(start=self._rest_of(path, value, change)) if rests else change

    def _rest_of(self, path: str, value: float, change: Change) -> Array:
        """Derivative of the state at rest; ``change`` holds that of the signals at the start."""
        if change.start.any() or not self._arm_alone(change):
            return far_difference(lambda by: run_setup(self._changed(path, value + by)).start, value)
        start = np.zeros_like(self.here.start)
        start[: len(self.here.model.coordinates)] = self._rest_along(change.parameters)
        return start

    def _changed(self, path: str, value: float) -> Robot:
        """The arm as it really is with another number, which is only checked where it does not simply replace one."""
        # In an imported robot a number may stand for several, which only the importer knows.
        arm = None if self.sheet.imported else replaced(self.sheet, steps_of(path, self.data), value)
        return (arm or self.sheet.with_({path: value})).pair().real

    def _check(self, path: str, loop: Any, rows: Array) -> None:
        regime = self.here.regime
        if structure(loop) != structure(regime.model.loop) or rows.shape != self.rows.shape:
            what, hint = "a change of the structure", "name a quantity whose small changes only change numbers"
        elif not np.array_equal(rows[:, 0], self.rows[:, 0]):
            what, hint = "a change of the times at which signals jump", "name a quantity that leaves them as they are"
        else:
            return
        raise InputError(path, what, "a change of numbers alone, along which a run can be differentiated", hint)

    def _arm_alone(self, change: Change) -> bool:
        """Whether nothing acts on the arm at rest but its weight, which does not change, nor where its base stands."""
        regime = self.here.regime
        sheet, base = self.sheet, regime.model.loop.base
        moved = change.parameters[base.start : base.start + base.size].any()
        return not (sheet.loads or sheet.contact or sheet.initial.coordinates or sheet.initial.rates or moved)

    def _at_rest(self) -> tuple[Model, NDArray[np.intp], Array]:
        """The arm, its coordinates that are free at rest, and its stiffness there."""
        if self._rest is None:
            regime = self.here.regime
            model = regime.mechanics
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
