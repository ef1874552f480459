"""Slopes of simulated quantities by the adjoint: one run with one sweep in reverse for all parameters."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, SimulationError
from tmodes.gradients.gradient import adjoint_gradient
from tmodes.gradients.quantities import Functional, reduced_output
from tmodes.sheet import Robot
from tmodes.simulation.outputs import robot_outputs
from tmodes.simulation.reductions import SMOOTH
from tmodes.study.optimize.gradient import Terms, neighbours, slopes
from tmodes.study.optimize.leaves import factor, formulas, leaves, numbers_of, restricted
from tmodes.study.optimize.trials import Trials

__all__ = ["Adjoint"]

Array = NDArray[np.float64]

_STEP = 1e-6
"""Of a parameter's range, along which formulas are differentiated."""


@dataclass(frozen=True, eq=False)
class _Point:
    """A point (k,) of the unit cube with its robot: by path its numbers there and at two neighbours along each way."""

    shares: Array
    sheet: Robot
    vary: Mapping[str, Array]

    @property
    def robot(self) -> Robot:
        """The robot of the design."""
        return self.sheet.with_({path: float(numbers[0]) for path, numbers in self.vary.items()})

    def slopes(self) -> dict[str, Array]:
        """Of the numbers by path, (k,) along the unit cube, but of those that stay."""
        found = {path: slopes(numbers, self.shares) for path, numbers in self.vary.items()}
        return {path: slope for path, slope in found.items() if slope.any()}


class Adjoint:
    """Terms at points of the unit cube, each by one run and one sweep for each simulated quantity in them.

    ``functionals``: quantities by name that the study does not have. ``runs``: how many runs with their sweep there
    were. Raises :class:`tmodes.errors.InputError` for a quantity whose slope no adjoint gives.
    """

    def __init__(self, trials: Trials, functionals: Mapping[str, Functional]) -> None:
        if len(trials.scenarios) > 1:
            hint = "leave worst_case out, or take --method tpe"
            raise InputError("--method gradient", "a worst case of simulated quantities", "one case a design", hint)
        self.trials, self.study, self.runs = trials, trials.study, 0
        self._given = functionals
        self._known: dict[bytes, Terms] = {}
        names = trials.goals.names
        self._functionals = [name for name in names if name in functionals]
        found = leaves(self.study, names)
        self._at_rest = [name for name in found if self.study.sheet.quantities[name].needs().static]
        self._series = [name for name in found if name not in self._at_rest]

    @property
    def start(self) -> Array:
        """The sheet's own design, within the ranges, (k,) of the unit cube."""
        space = self.trials.space
        return np.clip(space.shares(self.trials.scenarios[0][list(space.columns)]), 0.0, 1.0)

    def at(self, shares: Array) -> Terms:
        """The terms at shares (k,)."""
        key = shares.tobytes()
        if key not in self._known:
            self._known[key] = self._computed(shares)
        return self._known[key]

    def _computed(self, shares: Array) -> Terms:
        design = self.trials.space.at(shares[None])[0]
        cases = self.trials.cases_of(self.trials.space.at(neighbours(shares)))
        sheet, vary = numbers_of(self.study, cases)
        point = _Point(shares, sheet, vary)
        try:
            found = self._resting(cases, shares)
            found |= {name: self._measured(point, self._given[name]) for name in self._functionals}
            found |= {name: self._of_series(point, name) for name in self._series}
        except SimulationError as error:
            self.trials.add(design, {}, str(error))
            return self._lost(len(shares))
        own = dict(zip(self.study.names, cases[0].tolist(), strict=True))
        ways = self.trials.space.high - self.trials.space.low
        along = dict(zip(self.trials.space.names, np.diag(ways), strict=True))
        values = own | {name: value for name, (value, _) in found.items()}
        along |= {name: slope for name, (_, slope) in found.items()}
        whole = formulas(self.study, {name: np.array([value]) for name, value in values.items()})
        self.trials.add(design, {name: float(one[0]) for name, one in whole.items()})
        return self._terms(values, along)

    def _lost(self, count: int) -> Terms:
        """Terms of a design that cannot run."""
        limits = len(self.trials.goals.limits)
        return Terms(np.nan, np.zeros(count), np.full(limits, np.nan), np.zeros((limits, count)))

    def _resting(self, cases: Array, shares: Array) -> dict[str, tuple[float, Array]]:
        """Numbers at rest, with slopes."""
        if not self._at_rest:
            return {}
        rows = restricted(self.study, self._at_rest).evaluate(0, cases)
        return {name: (float(one[0]), slopes(one, shares)) for name, one in rows.quantities.items()}

    def _measured(self, point: _Point, functional: Functional) -> tuple[float, Array]:
        """A functional of the run, with slopes."""
        paths = point.slopes()
        found = adjoint_gradient(point.robot, functional, list(paths))
        self.runs += 1
        slope = sum((found.by[path] * along for path, along in paths.items()), np.zeros(len(point.shares)))
        return found.value, slope

    def _of_series(self, point: _Point, name: str) -> tuple[float, Array]:
        """A reduced series of the run, with slopes, in the unit of the quantity."""
        quantity, which = self.study.sheet.quantities[name], f"quantities.{name}"
        needs = quantity.needs()
        if len(needs.reductions) != 1 or needs.result:
            hint = "take --method tpe, or a series reduced by rms, mean or end"
            raise InputError(which, "a number of the whole result", "a series of the run, for gradients", hint)
        ((series, reduce),) = needs.reductions
        if reduce not in SMOOTH:
            hint = "a largest or least value has no slope everywhere; take rms, or --method tpe"
            raise InputError(f"{which}.reduce", reduce, f"one of {', '.join(SMOOTH)} for gradients", hint)
        own = robot_outputs(point.robot).find(series, f"{which}.series").unit
        value, slope = self._measured(point, reduced_output(series, reduce))
        return value * factor(own, quantity.unit), slope * factor(own, quantity.unit)

    def _terms(self, values: Mapping[str, float], slopes_of: Mapping[str, Array]) -> Terms:
        """Objective and limits with their slopes: formulas by differences along each direction."""
        goals, count = self.trials.goals, len(self.trials.space.names)
        ways = np.concatenate([np.zeros((1, count)), _STEP * np.eye(count), -_STEP * np.eye(count)])
        none = np.zeros(count)
        moved = {name: value + ways @ slopes_of.get(name, none) for name, value in values.items()}
        whole = formulas(self.study, moved)
        judged = goals.judged({name: one[:, None] for name, one in whole.items()})
        terms = np.column_stack([judged.objectives[:, 0] * goals.signs[0], judged.excess])
        along = ((terms[1 : count + 1] - terms[count + 1 :]) / (2 * _STEP)).T
        return Terms(float(terms[0, 0]), along[0], terms[0, 1:], along[1:])
