"""Optimize the design of a study's robot."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from tmodes.equations.loop.outputs import OWN
from tmodes.errors import InputError
from tmodes.gradients.quantities import Functional
from tmodes.io.arguments import checked_arguments, whole_number
from tmodes.io.words import meant
from tmodes.simulation.reductions import SMOOTH
from tmodes.study.optimize.compromise import compromises
from tmodes.study.optimize.goals import Goals, goals_of, refuse_contradictions
from tmodes.study.optimize.leaves import cheap, leaves
from tmodes.study.optimize.local import by_gradient, without_gradient
from tmodes.study.optimize.result import Optimum
from tmodes.study.optimize.sampled import search
from tmodes.study.optimize.space import DesignSpace, design_space, scenarios_of
from tmodes.study.optimize.summary import found, own_design, with_start
from tmodes.study.optimize.trials import Trials
from tmodes.study.read import as_study
from tmodes.study.sheet import Optimize
from tmodes.study.study import Study

__all__ = ["METHODS", "optimize"]

Progress = Callable[[str, float], None]

METHODS = "auto", "grid", "gradient", "compromise", "cobyqa", "tpe", "nsga2"
MOST_DESIGNS = 20_000
"""Designs of a finite space that are all tried."""

MOST_TRIALS, MOST_SEED = 1_000_000, 2**53 - 1

_TOGETHER = 100_000
"""Cases that are computed together when all designs are tried."""

TRIALS = {"tpe": 200, "nsga2": 1000, "gradient": 64, "compromise": 8, "cobyqa": 200}


@checked_arguments
def optimize(
    study: Study | str | os.PathLike[str],
    method: str = "auto",
    *,
    trials: int | None = None,
    seed: int = 0,
    out: str | os.PathLike[str] | None = None,
    functionals: Mapping[str, Functional] | None = None,
    progress: Progress = lambda stage, share: None,
    **where: Any,
) -> Optimum:
    """The best design of a study, or of the file of one, by the objectives and limits of its sheet's ``optimize``.

    ``method``: ``grid`` tries every design of a finite space, whose optimum is exact; ``gradient`` descends, from the
    sheet's own design where something is simulated (slopes by the adjoint), else from the best of ``trials`` evenly
    spread designs, with exact slopes of numbers at rest (by differences those of frequencies under loads, in contact
    and in steady motion); ``cobyqa`` descends from the sheet's own design
    without slopes, in at most ``trials`` designs; ``compromise`` descends along gradients to ``trials``
    compromises between two objectives; ``tpe`` and ``nsga2`` try ``trials`` designs; ``auto``: the first of
    these that fits, ``compromise`` and ``cobyqa`` never. ``out``: a folder for finished cases, so that the same call
    resumes.
    ``functionals``: further quantities by name, measured on the run, for ``gradient``. ``where``: as of
    :func:`tmodes.study.run_study`.

    Raises :class:`tmodes.errors.InputError` for what is wrong in the sheet, before anything runs.

    >>> tmodes.optimize("study.yaml", "tpe", trials=2).designs
    2
    """
    whole_number("seed", seed, 0, MOST_SEED)
    if trials is not None:
        whole_number("trials", trials, 1, MOST_TRIALS)
    study = as_study(study).fixed()
    asked = _asked(study)
    space = design_space(study, asked.design)
    _refuse_stuck(space)
    names = (*study.names, *study.sheet.quantities, *(functionals or {}))
    named = goals_of(asked, dict.fromkeys(names))
    refuse_contradictions(asked.limits)
    chosen = _chosen(study, space, named, method, functionals or {})
    scenarios = scenarios_of(study, space, asked.worst_case, seed)
    units = dict(study.parameter_units) | dict.fromkeys(functionals or {}, "-")
    own, start = own_design(study, space)
    cases = scenarios.copy()
    cases[:, space.columns] = start
    rows = own.evaluate(0, cases, progress)
    units |= rows.units
    tried = Trials(study, space, goals_of(asked, units), scenarios, out, progress, where)
    count = trials or TRIALS.get(chosen, 0)
    if chosen == "gradient":
        return with_start(by_gradient(tried, functionals or {}, count, seed, units, progress), own, start, rows)
    if chosen == "compromise":
        return with_start(compromises(tried, count, units, progress), own, start, rows)
    if chosen == "cobyqa":
        return with_start(without_gradient(tried, count, units, progress), own, start, rows)
    if chosen == "grid":
        designs = space.all()
        for part in np.array_split(designs, -(-len(designs) * len(scenarios) // _TOGETHER)):
            tried.at(part)
    else:
        search(tried, chosen, count, seed, progress)
    return with_start(found(tried, chosen, units, exact=chosen == "grid"), own, start, rows)


def _asked(study: Study) -> Optimize:
    if study.sheet.optimize is None:
        hint = "write `optimize: {objectives: [{minimize: mass}], limits: [sag <= 1.5 mm], design: [tube]}`"
        raise InputError("optimize", "nothing", "objectives, and limits where there are any", hint)
    return study.sheet.optimize


def _refuse_stuck(space: DesignSpace) -> None:
    if space.count == 1:
        name = space.names[0]
        raise InputError(
            "optimize.design", f"`{name}` alone, which has one choice", "something to choose", "add another"
        )


def _chosen(study: Study, space: DesignSpace, goals: Goals, method: str, functionals: Mapping[str, Functional]) -> str:
    """The method; raises :class:`tmodes.errors.InputError` for one that does not fit."""
    several = len(goals.aims) > 1
    finite = space.count is not None and space.count <= MOST_DESIGNS
    smooth = space.continuous and not several
    if method == "auto":
        local = smooth and _differentiable(study, goals, functionals)
        return "grid" if finite else "nsga2" if several else "gradient" if local else "tpe"
    refusals = {
        "grid": (not finite, _too_many(space), f"a list of at most {MOST_DESIGNS:,} designs", "take tpe or nsga2"),
        "gradient": (not smooth, _not_smooth(space, several=several), "one objective of ranges", "take tpe or nsga2"),
        "compromise": (not (space.continuous and len(goals.aims) == 2 and _differentiable(study, goals, functionals)),
                    f"{len(goals.aims)} objectives, or one without slopes", "two objectives with slopes, of ranges",
                    "take nsga2"),
        "cobyqa": (not smooth, _not_smooth(space, several=several), "one objective of ranges", "take tpe or nsga2"),
        "tpe": (several, f"{len(goals.aims)} objectives", "one objective", "take nsga2, or limits"),
        "nsga2": (False, "", "", ""),
    }  # fmt: skip
    if method not in refusals:
        hint = meant(method, METHODS, "auto chooses by the study")
        raise InputError("--method", repr(method), f"one of {', '.join(METHODS)}", hint)
    wrong, got, expected, hint = refusals[method]
    if wrong:
        raise InputError(f"--method {method}", got, f"used for {expected}", hint)
    return method


def _differentiable(study: Study, goals: Goals, functionals: Mapping[str, Functional]) -> bool:
    """Whether all terms have slopes, without a simulation or by the adjoint."""
    if cheap(study) and not functionals:
        return True
    needs = [study.sheet.quantities[name].needs() for name in leaves(study, goals.names)]
    return all(one.static or _has_slope(one.reductions) for one in needs)


def _has_slope(reductions: Sequence[tuple[str, str]]) -> bool:
    """Whether the adjoint may give a slope of what needs these reductions."""
    return len(reductions) == 1 and reductions[0][1] in SMOOTH and reductions[0][0].partition(".")[0] != OWN


def _too_many(space: DesignSpace) -> str:
    return "a continuous range" if space.count is None else f"{space.count:,} designs"


def _not_smooth(space: DesignSpace, *, several: bool) -> str:
    return "several objectives" if several else f"a choice among {max(space.levels)} entries"
