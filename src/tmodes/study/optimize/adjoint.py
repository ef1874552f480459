"""Exact slopes of a study's terms: of numbers at rest, and of a run by one sweep in reverse for all parameters."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
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
Found = dict[str, tuple[Array, Array]]
"""By name values (s,) in the scenarios, and their slopes (s, k) along the unit cube."""

_STEP = 1e-5
"""Of a parameter's range, along which formulas are differentiated."""


class _Point(NamedTuple):
    """Scenarios (s,) of a point of the unit cube with one sheet: by path their numbers (s,), and slopes (s, k)."""

    scenarios: NDArray[np.intp]
    sheet: Robot
    vary: Mapping[str, Array]
    along: Mapping[str, Array]


class Adjoint:
    """Terms at points of the unit cube: numbers at rest with their slopes, simulated ones by a run and a sweep each.

    Numbers at rest that have no exact slopes (:class:`tmodes.simulation.vary.static_numbers.StaticSlopes`) are
    differentiated along neighbours. ``functionals``: quantities by name that the study does not have. ``runs``: how
    many runs with their sweep there were. Raises :class:`tmodes.errors.InputError` for a quantity that has no slope.
    """

    def __init__(self, trials: Trials, functionals: Mapping[str, Functional]) -> None:
        self.trials, self.study, self.runs = trials, trials.study, 0
        self._given = functionals
        self._known: dict[bytes, Terms] = {}
        names = trials.goals.names
        self._functionals = [name for name in names if name in functionals]
        needs = {name: self.study.sheet.quantities[name].needs() for name in leaves(self.study, names)}
        self._leaves = [*functionals, *needs]
        self._at_rest = {name: one.static for name, one in needs.items() if one.static}
        self._series = [name for name in needs if name not in self._at_rest]
        self._simulated = bool(self._functionals or self._series)
        self._statics = StaticSlopes([one for static in self._at_rest.values() for one in static])
        if len(trials.scenarios) > 1 and self._simulated:
            hint = "leave worst_case out, or take --method tpe"
            raise InputError("--method gradient", "a worst case of simulated quantities", "one case a design", hint)

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
        trials, space = self.trials, self.trials.space
        design = space.at(shares[None])
        cases = trials.cases_of(design)
        values: dict[str, Array] = dict(zip(self.study.names, cases.T, strict=True))
        try:
            if not self._simulated:
                number = trials.at(design)[0]
                found = self._resting(shares, {name: trials.values[name][number] for name in self._at_rest})
            else:
                rows = restricted(self.study, self._at_rest).evaluate(0, cases)
                found = self._resting(shares, rows.quantities) | self._run(shares)
                whole = formulas(self.study, values | {name: value for name, (value, _) in found.items()})
                trials.add(design[0], {name: float(one[0]) for name, one in whole.items()})
        except SimulationError as error:
            trials.add(design[0], {}, str(error))
            found = dict.fromkeys(self._leaves, (np.array([np.nan]), np.zeros((1, len(shares)))))
        values |= {name: value for name, (value, _) in found.items()}
        along = dict(zip(space.names, np.diag(space.high - space.low), strict=True))
        return self._terms(values, along | {name: slope for name, (_, slope) in found.items()}, shares)

    def _points(self, shares: Array) -> Iterator[_Point]:
        """A point in its scenarios. What parameters set follows them linearly: its slopes are of the whole range."""
        robot, k = self.study.robot, len(shares)
        assert robot is not None  # noqa: S101
        ends = [np.where(np.eye(k, dtype=bool), end, shares) for end in (0.0, 1.0)]
        cases = self.trials.cases_of(self.trials.space.at(np.concatenate([shares[None], *ends])))
        places = np.arange(len(cases)).reshape(2 * k + 1, -1)
        for group in groups_of(robot, self.study.names, self.study.targets, self.study.choices, cases):
            scenarios = group.places[group.places < places.shape[1]]
            if group.robot is None or not np.array_equal(group.places, places[:, scenarios].ravel()):
                got = group.wrong or "parameters that change more than numbers of the robot"
                raise InputError(
                    "--method gradient", got, "parameters that are numbers of the robot", "take --method tpe"
                )
            vary = {path: numbers.reshape(2 * k + 1, -1) for path, numbers in group.vary.items()}
            along = {path: (numbers[k + 1 :] - numbers[1 : k + 1]).T for path, numbers in vary.items()}
            yield _Point(scenarios, group.robot, {path: numbers[0] for path, numbers in vary.items()}, along)

    def _resting(self, shares: Array, values: Mapping[str, Array]) -> Found:
        """Numbers at rest, which have these ``values`` (s,), with slopes."""
        found = {name: np.full((len(self.trials.scenarios), len(shares)), np.nan) for name in self._at_rest}
        for point in self._points(shares) if found else ():
            for k, scenario in enumerate(point.scenarios):
                exact = self._statics.at(
                    point.sheet, *({path: own[k] for path, own in each.items()} for each in point[2:])
                )
                for name, (static, *others) in self._at_rest.items():
                    value, slope = exact.get(static, (np.nan, np.nan))
                    share = factor(static_unit(static), self.study.sheet.quantities[name].unit)
                    if not others and np.isclose(value * share, values[name][scenario]):  # of the same rest
                        found[name][scenario] = slope * share
        if lost := [name for name, slope in found.items() if np.isnan(slope).any()]:
            cases = self.trials.cases_of(self.trials.space.at(neighbours(shares)))
            rows = restricted(self.study, lost).evaluate(0, cases).quantities
            found |= {name: slopes(one.reshape(-1, len(values[name])), shares) for name, one in rows.items()}
        return {name: (values[name], slope) for name, slope in found.items()}

    def _run(self, shares: Array) -> Found:
        """Simulated quantities with slopes."""
        (point,) = self._points(shares)
        robot = point.sheet.with_({path: float(numbers[0]) for path, numbers in point.vary.items()})
        along = {path: slopes[0] for path, slopes in point.along.items() if slopes.any()}
        found = {name: self._measured(robot, along, self._given[name]) for name in self._functionals}
        found |= {name: self._of_series(robot, along, name) for name in self._series}
        return {name: (np.array([value]), slope[None]) for name, (value, slope) in found.items()}

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

    def _terms(self, values: Mapping[str, Array], slopes_of: Mapping[str, Array], shares: Array) -> Terms:
        """Objective and limits with their slopes: formulas by differences along each direction."""
        goals, none = self.trials.goals, np.zeros(len(shares))
        steps = neighbours(shares, _STEP) - shares
        moved = {name: value + steps @ slopes_of.get(name, none).T.reshape(len(shares), -1)
                 for name, value in values.items()}  # fmt: skip
        shape = next(iter(moved.values())).shape
        whole = formulas(self.study, {name: one.ravel() for name, one in moved.items()})
        judged = goals.judged({name: one.reshape(shape) for name, one in whole.items()})
        excess = np.where(np.isfinite(judged.excess), judged.excess, np.nan)
        terms = np.column_stack([judged.objectives[:, 0] * goals.signs[0], excess])
        along = slopes(terms, shares, _STEP)
        return Terms(float(terms[0, 0]), along[0], terms[0, 1:], along[1:])
