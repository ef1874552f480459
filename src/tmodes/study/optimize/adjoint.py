"""Exact slopes of a study's terms: of numbers at rest, and of a run by one sweep in reverse for all parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, SimulationError
from tmodes.gradients.gradient import adjoint_gradient
from tmodes.gradients.quantities import Functional, reduced_output
from tmodes.sheet import Robot
from tmodes.simulation.outputs import robot_outputs
from tmodes.simulation.reductions import SMOOTH
from tmodes.simulation.vary.static_numbers import StaticSlopes, static_unit
from tmodes.study.mapping import groups_of
from tmodes.study.optimize.gradient import Terms, neighbours, slopes
from tmodes.study.optimize.leaves import factor, formulas, leaves, restricted
from tmodes.study.optimize.trials import Trials

__all__ = ["Adjoint"]

Array = NDArray[np.float64]
Found = dict[str, tuple[float, Array]]
"""By name a value, and its slopes (k,) along the unit cube."""

_STEP = 1e-5
"""Of a parameter's range, along which formulas are differentiated."""


class _Point(NamedTuple):
    """A point of the unit cube in one scenario: the sheet, and by path its numbers there and their slopes (k,)."""

    sheet: Robot
    case: Mapping[str, float]
    along: Mapping[str, Array]


class Adjoint:
    """Terms at points of the unit cube: numbers at rest with their slopes, simulated ones by a run and a sweep each.

    Of several cases of a design all run side by side, and slopes are those of the cases that decide. Numbers at rest
    that have no exact slopes (:class:`tmodes.simulation.vary.static_numbers.StaticSlopes`) are differentiated along
    neighbours. ``functionals``: quantities by name that the study does not have.
    ``runs``: how many runs with their sweep there were. Raises :class:`tmodes.errors.InputError` for a quantity that
    has no slope.
    """

    def __init__(self, trials: Trials, functionals: Mapping[str, Functional]) -> None:
        self.trials, self.study, self.runs = trials, trials.study, 0
        self._given = functionals
        self._at: dict[bytes, Terms] = {}
        self._of_cases: dict[tuple[bytes, int], Terms] = {}
        names = trials.goals.names
        self._functionals = [name for name in names if name in functionals]
        needs = {name: self.study.sheet.quantities[name].needs() for name in leaves(self.study, names)}
        self._leaves = [*functionals, *needs]
        self._at_rest = {name: one.static for name, one in needs.items() if one.static}
        self._series = [name for name in needs if name not in self._at_rest]
        self.simulated = bool(self._functionals or self._series)
        self._statics = StaticSlopes([one for static in self._at_rest.values() for one in static])
        if self._functionals and len(trials.scenarios) > 1:
            hint = "make it a quantity of the study, a series reduced by rms, mean or end"
            raise InputError("--method gradient", "the worst case of a functional", "one run for it", hint)

    def at(self, shares: Array) -> Terms:
        """The terms at shares (k,)."""
        key = shares.tobytes()
        if key not in self._at:
            self._at[key] = self._computed(shares)
        return self._at[key]

    def _computed(self, shares: Array) -> Terms:
        trials = self.trials
        design = trials.space.at(shares[None])
        cases = trials.cases_of(design)
        if self.simulated and len(cases) == 1:
            return self._alone(shares, design[0], cases[0])
        known = self._known(shares)
        if self._lost_at(shares):
            return self._terms(shares, cases[0], self._lost(shares))
        which = trials.goals.deciding({name: one[None] for name, one in known.items()})
        each = {k: self.of_case(shares, k) for k in {*which}}
        own, limits = each[which[0]], [(each[k].excess[row], each[k].slopes[row]) for row, k in enumerate(which[1:])]
        excess, along = ([one[part] for one in limits] for part in range(2))
        return Terms(own.objective, own.slope, np.array(excess), np.reshape(along, (-1, len(shares))))

    def _number(self, shares: Array) -> int:
        """Of the trial at shares (k,)."""
        return int(self.trials.at(self.trials.space.at(shares[None]))[0])

    def _lost_at(self, shares: Array) -> str:
        """Why a case has failed there; empty where none has."""
        return self.trials.reasons[self._number(shares)]

    def _known(self, shares: Array) -> dict[str, Array]:
        """Values (s,) of all parameters and quantities at shares (k,) in all cases, not-a-number of one that failed."""
        number = self._number(shares)
        return {name: one[number] for name, one in self.trials.values.items()}

    def in_all_cases(self, shares: Array) -> Array:
        """The objective, signed, and the excess of each limit at shares (k,) in all cases, (1 + l, s)."""
        goals, known = self.trials.goals, self._known(shares)
        return np.array([one.sign * one.term.at(known) for one in goals.aims]
                        + [one.excess(one.term.at(known)) for one in goals.limits])  # fmt: skip

    def of_case(self, shares: Array, case: int) -> Terms:
        """The terms at shares (k,) in one case."""
        key = shares.tobytes(), case
        if key not in self._of_cases:
            own = self.trials.cases_of(self.trials.space.at(shares[None]))[case]
            self._of_cases[key] = self._terms(shares, own, self._found(shares, case, self._known(shares)))
        return self._of_cases[key]

    def _lost(self, shares: Array) -> Found:
        return dict.fromkeys(self._leaves, (np.nan, np.zeros(len(shares))))

    def _alone(self, shares: Array, design: Array, case: Array) -> Terms:
        """The one case of a design, whose run with its sweep gives its values too."""
        try:
            rows = restricted(self.study, self._at_rest).evaluate(0, case[None])
            found = self._found(shares, 0, rows.quantities)
            own = dict(zip(self.study.names, case, strict=True))
            values = own | {name: value for name, (value, _) in found.items()}
            whole = formulas(self.study, {name: np.array([value]) for name, value in values.items()})
            self.trials.add(design, {name: float(one[0]) for name, one in whole.items()})
        except SimulationError as error:
            self.trials.add(design, {}, str(error))
            found = self._lost(shares)
        return self._terms(shares, case, found)

    def _found(self, shares: Array, scenario: int, values: Mapping[str, Array]) -> Found:
        """All that terms are made of in a scenario, with slopes; ``values`` (s,) of numbers at rest in all."""
        found = self._resting(shares, scenario, values)
        return found | (self._run(self._point(shares, scenario)) if self.simulated else {})

    def _beside(self, shares: Array, scenario: int, names: Sequence[str]) -> Found:
        """Quantities in a scenario with slopes along neighbours."""
        if not names:
            return {}
        cases = self.trials.cases_of(self.trials.space.at(neighbours(shares)))
        rows = restricted(self.study, names).evaluate(0, cases[scenario :: len(self.trials.scenarios)]).quantities
        return {name: (one[0], slopes(one, shares)) for name, one in rows.items()}

    def _point(self, shares: Array, scenario: int) -> _Point:
        """What parameters set follows them linearly: its slopes are those of the whole range."""
        robot, k, study, space = self.study.robot, len(shares), self.study, self.trials.space
        assert robot is not None  # noqa: S101
        ends = [np.where(np.eye(k, dtype=bool), end, shares) for end in (0.0, 1.0)]
        cases = self.trials.cases_of(self.trials.space.at(np.concatenate([shares[None], *ends])))
        cases = cases[scenario :: len(self.trials.scenarios)]
        groups = list(groups_of(robot, study.names, study.targets, study.choices, cases))
        if len(groups) != 1 or groups[0].robot is None:
            got = "parameters that change more than numbers of the robot" if len(groups) > 1 else groups[0].wrong
            raise InputError("--method gradient", got, "parameters that are numbers of the robot", "take --method tpe")
        vary = groups[0].vary.items()
        share = space.slopes(shares) / (space.high - space.low)
        along = {path: (numbers[k + 1 :] - numbers[1 : k + 1]) * share for path, numbers in vary}
        return _Point(groups[0].robot, {path: float(numbers[0]) for path, numbers in vary}, along)

    def _resting(self, shares: Array, scenario: int, values: Mapping[str, Array]) -> Found:
        """Numbers at rest in a scenario, of those that have these ``values`` (s,) in all, with slopes."""
        if not self._at_rest:
            return {}
        exact, found = self._statics.at(*self._point(shares, scenario)), Found()
        for name, (static, *others) in self._at_rest.items():
            value, slope = exact.get(static, (np.nan, np.zeros(len(shares))))
            share = factor(static_unit(static), self.study.sheet.quantities[name].unit)
            if not others and np.isclose(value * share, values[name][scenario]):  # the same rest
                found[name] = values[name][scenario], slope * share
        return found | self._beside(shares, scenario, [name for name in self._at_rest if name not in found])

    def _run(self, point: _Point) -> Found:
        """Simulated quantities with slopes."""
        robot, along = point.sheet.with_(point.case), {path: one for path, one in point.along.items() if one.any()}
        found = {name: self._measured(robot, along, self._given[name]) for name in self._functionals}
        return found | {name: self._of_series(robot, along, name) for name in self._series}

    def _measured(self, robot: Robot, along: Mapping[str, Array], functional: Functional) -> tuple[float, Array]:
        """A functional of the run, with slopes."""
        found = adjoint_gradient(robot, functional, list(along))
        self.runs += 1
        nothing = np.zeros(len(self.trials.space.names))
        return found.value, sum((found.by[path] * slope for path, slope in along.items()), nothing)

    def _of_series(self, robot: Robot, along: Mapping[str, Array], name: str) -> tuple[float, Array]:
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
        own = robot_outputs(robot).find(series, f"{which}.series").unit
        value, slope = self._measured(robot, along, reduced_output(series, reduce))
        return value * factor(own, quantity.unit), slope * factor(own, quantity.unit)

    def _terms(self, shares: Array, case: Array, found: Found) -> Terms:
        """Objective and limits of a case (d,) with their slopes: formulas by differences along each direction."""
        goals, space = self.trials.goals, self.trials.space
        own = dict(zip(self.study.names, case, strict=True))
        along = dict(zip(space.names, np.diag(space.slopes(shares)), strict=True))
        along |= {name: slope for name, (_, slope) in found.items()}
        values = own | {name: value for name, (value, _) in found.items()}
        steps, none = neighbours(shares, _STEP) - shares, np.zeros(len(shares))
        whole = formulas(self.study, {name: one + steps @ along.get(name, none) for name, one in values.items()})
        judged = goals.judged({name: one[:, None] for name, one in whole.items()})
        excess = np.where(np.isfinite(judged.excess), judged.excess, np.nan)
        terms = np.column_stack([judged.objectives[:, 0] * goals.signs[0], excess])
        slope = slopes(terms, shares, _STEP)
        return Terms(float(terms[0, 0]), slope[0], terms[0, 1:], slope[1:])
