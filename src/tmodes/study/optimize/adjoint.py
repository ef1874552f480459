"""Slopes of simulated quantities by the adjoint: one run with one sweep in reverse for all parameters."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.sensitivity.gradient import adjoint_gradient
from tmodes.sensitivity.quantities import Functional
from tmodes.sheet import Robot
from tmodes.study.optimize.gradient import Terms
from tmodes.study.optimize.smooth import functional_of
from tmodes.study.optimize.trials import Trials
from tmodes.study.quantities.contract import Needs

__all__ = ["Adjoint"]

Array = NDArray[np.float64]

_STEP = 1e-6
"""Of a parameter's range, along which formulas are differentiated."""


class Adjoint:
    """Terms at points of the unit cube, each by one run and one sweep for each simulated quantity in them.

    ``runs``: how many runs with their sweep there were. Raises :class:`tmodes.errors.InputError` for a quantity whose
    slope no adjoint gives.
    """

    def __init__(self, trials: Trials, functionals: Mapping[str, Functional]) -> None:
        if len(trials.scenarios) > 1:
            hint = "leave worst_case out, or take --method tpe"
            raise InputError("--method gradient", "a worst case of simulated quantities", "one case a design", hint)
        self.trials, self.runs = trials, 0
        self._known: dict[bytes, Terms] = {}
        self._given = functionals
        self._functionals = {name: self._functional(name) for name in self._simulated()}

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
        values, slopes = self._values(design), {}
        robot, paths = self._numbers(design)
        for name, functional in self._functionals.items():
            found = adjoint_gradient(robot, functional, list(paths))
            self.runs += 1
            values[name] = found.value
            slopes[name] = sum(found.by[path] * slope for path, slope in paths.items())
        whole = self._whole(values)
        self.trials.add(design, whole)
        return self._terms(values, slopes)

    def _values(self, design: Array) -> dict[str, float]:
        """Values of all parameters."""
        row = self.trials.scenarios[0].copy()
        row[list(self.trials.space.columns)] = design
        return dict(zip(self.trials.study.names, row.tolist(), strict=True))

    def _numbers(self, design: Array) -> tuple[Robot, dict[str, Array]]:
        """The robot of a design, and by path the slopes (k,) of its numbers along the unit cube."""
        study, space = self.trials.study, self.trials.space
        middle = self.trials.cases_of(design[None])
        steps = np.diag(space.high - space.low)
        around = self.trials.cases_of(np.concatenate([design + steps, design - steps]))
        robot, vary = study.numbers(np.concatenate([middle, around]))
        here = {path: float(numbers[0]) for path, numbers in vary.items()}
        k = len(space.names)
        slopes = {path: (numbers[1 : k + 1] - numbers[k + 1 :]) / 2 for path, numbers in vary.items()}
        return robot.with_(here), {path: slope for path, slope in slopes.items() if slope.any()}

    def _terms(self, values: Mapping[str, float], slopes: Mapping[str, Array]) -> Terms:
        """Objective and limits with their slopes: formulas by differences along each direction."""
        goals, space = self.trials.goals, self.trials.space
        unit = dict(zip(space.names, np.diag(space.high - space.low), strict=True)) | dict(slopes)
        none = np.zeros(len(space.names))
        ways = np.concatenate([none[None], _STEP * np.eye(len(none)), -_STEP * np.eye(len(none))])
        moved = {name: value + ways @ unit.get(name, none) for name, value in values.items()}
        whole = {name: one[:, None] for name, one in self._whole(moved).items()}
        judged = goals.judged(whole)
        terms = np.column_stack([judged.objectives[:, 0] * goals.signs[0], judged.excess])
        k = len(none)
        along = (terms[1 : k + 1] - terms[k + 1 :]).T / (2 * _STEP)
        return Terms(float(terms[0, 0]), along[0], terms[0, 1:], along[1:])

    def _whole(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """With the quantities that are formulas of these; those that are not asked for are not-a-number."""
        flat = {name: np.atleast_1d(np.asarray(one, dtype=float)) for name, one in values.items()}
        found = self.trials.study.formulas(flat)
        return {name: one if np.ndim(next(iter(values.values()))) else float(one[0]) for name, one in found.items()}

    def _simulated(self) -> list[str]:
        """Names of the quantities in objectives and limits that are no formulas."""
        quantities = self.trials.study.sheet.quantities
        goals = self.trials.goals
        left = [name for term in (*(aim.term for aim in goals.aims), *(one.term for one in goals.limits)) for name in term.names]
        found: dict[str, None] = {}
        while left:
            name = left.pop()
            needs = quantities[name].needs() if name in quantities else Needs()
            left += needs.names
            if name in self._given or needs.reductions or needs.static or needs.result:
                found[name] = None
        return list(found)

    def _functional(self, name: str) -> Functional:
        if name in self._given:
            return self._given[name]
        needs = self.trials.study.sheet.quantities[name].needs()
        if len(needs.reductions) != 1 or needs.static or needs.result:
            hint = "take --method tpe, or a series reduced by rms, mean or end"
            raise InputError(f"quantities.{name}", "no series", "a series of the run, for gradients", hint)
        (series, reduce), = needs.reductions
        return functional_of(series, reduce, lambda: self._nominal_tip, f"quantities.{name}")

    @cached_property
    def _nominal_tip(self) -> Array:
        """The nominal tip at the samples, (n, 3), which the design must not change."""
        raise NotImplementedError
