"""From the trials to the optimum that is reported; the same of a stored optimization."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tmodes.study.optimize.goals import Judged, goals_of
from tmodes.study.optimize.result import Candidate, Held, Optimum
from tmodes.study.optimize.space import DesignSpace, design_space
from tmodes.study.optimize.trials import Trials
from tmodes.study.rows import Rows
from tmodes.study.sheet import Choice
from tmodes.study.study import Study

__all__ = ["candidate", "found", "own_design", "pareto_front", "stored_designs", "with_start"]


def pareto_front(values: NDArray[np.float64]) -> NDArray[np.intp]:
    """Indices of the rows (m, o), all objectives to be small, that no other row dominates, by the first objective.

    A row dominates another where it is nowhere larger and somewhere smaller; of equal rows all are on the front.
    """
    order = np.lexsort(values.T[::-1])
    front: list[int] = []
    for k in order:  # what dominates a row comes before it
        known = values[front]
        if not ((known <= values[k]).all(axis=1) & (known < values[k]).any(axis=1)).any():
            front.append(int(k))
    return np.array(front, dtype=np.intp)


MOST_RANKED = 100

_SAME = 1e-3
"""Of a parameter's range: what differs by less is one design."""


def found(
    trials: Trials, method: str, units: dict[str, str], *, exact: bool = False, gradients: int = 0,
    prices: dict[str, float] | None = None,
) -> Optimum:  # fmt: skip
    """The optimum of what was tried."""
    judged = trials.judged()
    signed = judged.objectives * trials.goals.signs
    feasible = np.flatnonzero(judged.feasible)
    order = feasible[np.argsort(signed[feasible, 0], kind="stable")]
    front = feasible[pareto_front(signed[feasible])] if signed.shape[1] > 1 else order[:0]
    ranked = front if len(front) else order
    limits = trials.goals.limits
    return Optimum(
        trials.study.sheet.name, method, exact, tuple(aim.text for aim in trials.goals.aims), units,
        best=candidate(trials, judged, ranked[0]) if len(ranked) else None,
        nearest=None if len(ranked) or _failed(judged).all() else candidate(trials, judged, _nearest(judged)),
        ranked=tuple(candidate(trials, judged, k) for k in _apart(trials, order)),
        front=tuple(candidate(trials, judged, k) for k in front),
        designs=len(trials), feasible=len(feasible), failed=int(_failed(judged).sum()), cases=trials.cases,
        gradients=gradients, prices=prices or {},
        lost_to={limit.text: int((judged.excess[:, k] > 0).sum()) for k, limit in enumerate(limits)},
        history=_history(signed[:, 0], judged.feasible, trials.goals.signs[0]), trials=trials,
    )  # fmt: skip


def _apart(trials: Trials, order: NDArray[np.intp]) -> list[int]:
    """The first of these designs, without those that hardly differ from a better one."""
    shares = trials.space.shares(trials.designs)
    kept: list[int] = []
    for k in order.tolist():
        if not kept or (np.abs(shares[kept] - shares[k]).max(axis=1) > _SAME).all():
            kept.append(k)
        if len(kept) == MOST_RANKED:
            break
    return kept


def _failed(judged: Judged) -> NDArray[np.bool_]:
    """Designs of which an objective or a limit has no value."""
    return np.logical_or.reduce(np.isnan(np.hstack([judged.objectives, judged.limits])), axis=1)


def _nearest(judged: Judged) -> int:
    """The design that exceeds its limits least, of those that did not fail."""
    return int(np.argmin(np.where(_failed(judged), np.inf, judged.violation)))


def _history(signed: NDArray[np.float64], feasible: NDArray[np.bool_], sign: float) -> tuple[tuple[int, float], ...]:
    """Number and value of each design that was the best of those before it."""
    best, rows = np.inf, []
    for k, value in enumerate(np.where(feasible, signed, np.inf).tolist()):
        if value < best:
            best = value
            rows.append((k, float(sign) * value))
    return tuple(rows)


def candidate(trials: Trials, judged: Judged, number: int) -> Candidate:
    """One of the trials in all its numbers."""
    number = int(number)
    limits = tuple(
        Held(
            limit.text,
            limit.term.text,
            limit.sign,
            float(judged.limits[number, k]),
            limit.bound,
            limit.unit,
            float(-judged.excess[number, k]),
        )
        for k, limit in enumerate(trials.goals.limits)
    )
    parameters = trials.study.sheet.parameters
    values = dict(zip(trials.space.names, trials.designs[number].tolist(), strict=True))
    choices = {
        name: parameters[name].choices[int(values[name])].name
        for name, levels in zip(trials.space.names, trials.space.levels, strict=True)
        if levels
    }
    quantities = {name: _ends(trials.values[name][number]) for name in trials.study.sheet.quantities}
    return Candidate(
        number, values, choices, quantities, tuple(judged.objectives[number].tolist()), limits,
        bool(judged.feasible[number]), float(judged.violation[number]), trials.reasons[number],
    )  # fmt: skip


def _ends(values: NDArray[np.float64]) -> tuple[float, float]:
    """Least and largest of those that are numbers."""
    known = values[np.isfinite(values)]
    return (float(known.min()), float(known.max())) if len(known) else (float("nan"), float("nan"))


def stored_designs(study: Study, rows: Rows) -> Optimum:
    """The optimum among the designs of ``rows``, all cases in the order in which they were tried.

    Raises :class:`tmodes.errors.InputError` where objectives name what the study does not have.
    """
    asked = study.sheet.optimize
    assert asked is not None  # noqa: S101
    space, units = design_space(study, asked.design), dict(study.parameter_units) | dict(rows.units)
    values, each = study.design().values, max(1, asked.worst_case)
    trials = Trials(study, space, goals_of(asked, units), values[:each], None, lambda *_: None, {})
    trials.take(values[::each][:, list(space.columns)], rows)
    return found(trials, "", units)


_AS_IT_IS = "as in the sheet"


def own_design(study: Study, space: DesignSpace) -> tuple[Study, NDArray[np.float64]]:
    """The design (k,) of the sheet itself, and a study that has it: with an entry in each list that changes nothing."""
    parameters, levels = dict(study.sheet.parameters), np.array(space.levels)
    for name, count in zip(space.names, space.levels, strict=True):
        if count:
            entries = (*parameters[name].choices, Choice(name=_AS_IT_IS, set={}))
            parameters[name] = parameters[name].model_copy(update={"choices": entries})
    own = replace(study, sheet=study.sheet.model_copy(update={"parameters": parameters}))
    return own, np.where(levels > 0, levels, study.space.nominal[list(space.columns)])


def with_start(optimum: Optimum, own: Study, design: NDArray[np.float64], rows: Rows) -> Optimum:
    """With that design as its start, judged by the ``rows`` of its cases; the first trial, where they lack a term."""
    tried = optimum.trials
    assert tried is not None  # noqa: S101
    alone = Trials(own, tried.space, tried.goals, tried.scenarios, None, lambda *_: None, {})
    alone.take(design[None], rows)
    if not set(tried.goals.names) <= alone.values.keys():
        alone = tried
    return replace(optimum, start=candidate(alone, alone.judged(), 0))
