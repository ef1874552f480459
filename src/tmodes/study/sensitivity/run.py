"""Sensitivity of a study: its cases are planned, run and analysed."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmodes.errors import InputError
from tmodes.io.arguments import checked_arguments
from tmodes.io.words import meant
from tmodes.study.plans import Design
from tmodes.study.read import as_study
from tmodes.study.rows import Rows
from tmodes.study.sensitivity.indices import analysed
from tmodes.study.sensitivity.result import Sensitivity
from tmodes.study.study import Study

__all__ = ["sensitivity", "with_plan"]

Progress = Callable[[str, float], None]

SAMPLES = {"sobol": 1024, "morris": 64}
"""As many where none are asked for."""


@checked_arguments
def sensitivity(
    study: Study | str | os.PathLike[str],
    method: str = "sobol",
    *,
    samples: int | None = None,
    seed: int = 0,
    second_order: bool = False,
    out: str | os.PathLike[str] | None = None,
    progress: Progress = lambda stage, share: None,
    **where: Any,
) -> Sensitivity:
    """How much each parameter of a study, or of the file of one, makes its quantities vary.

    ``method`` ``sobol``: shares of the variance, from ``samples`` (a power of two) times the number of parameters and 2
    cases; ``second_order``: of pairs of parameters too, from nearly twice as many. ``morris``: mean size and spread of
    elementary effects, from ``samples`` times one more case than parameters: a quick screening. The plan of the sheet
    is not used. ``out``: the folder where finished cases are stored, so that the same call resumes; ``where``: as of
    :func:`tmodes.study.run_study`.

    Raises :class:`tmodes.errors.InputError` for an unknown method, samples that are none of it, and correlated
    parameters; :class:`tmodes.errors.SimulationError` where too many cases fail.

    >>> tmodes.sensitivity("study.yaml", samples=64).ranked("y")
    ('k',)
    """
    planned = _planned(as_study(study), method, samples, seed, second_order)
    design = planned.design()
    rows = _rows(planned, design, out, progress, where)
    return analysed(method, rows, design)


def _planned(study: Study, method: str, samples: int | None, seed: int, second_order: bool) -> Study:
    """The study with the plan of a method."""
    if method not in SAMPLES:
        hint = meant(method, SAMPLES, "sobol for shares of the variance")
        raise InputError("--method", repr(method), "sobol or morris", hint)
    _refuse_correlated(study)
    count = SAMPLES[method] if samples is None else samples
    if method == "morris":
        if second_order:
            raise InputError("--second-order", "given with morris", "left out", "take --method sobol")
        return with_plan(study, {"type": "morris", "trajectories": count, "seed": seed})
    return with_plan(study, {"type": "saltelli", "samples": count, "seed": seed, "second_order": second_order})


def _refuse_correlated(study: Study) -> None:
    """One parameter cannot change by itself where another follows it."""
    for one in study.sheet.correlations:
        if one.value:
            pair = " and ".join(one.between)
            hint = "indices need parameters that vary by themselves; remove it, or look at the correlation in a study"
            raise InputError("correlations", f"{one.value:g} between {pair}", "none for a sensitivity", hint)


def with_plan(study: Study, plan: dict[str, Any]) -> Study:
    """The same study by another plan. Raises :class:`tmodes.errors.InputError` for a plan that is none."""
    data = {**study.data, "study": {**study.data["study"], "plan": plan, "keep": {}}}
    return replace(Study.from_data(data, functions=study.functions), places=study.places, identified=study.identified)


def _rows(study: Study, design: Design, folder: Any, progress: Progress, where: dict[str, Any]) -> Rows:
    """All cases, computed at once, or through the folder."""
    if folder is None:
        return study.evaluate(0, design.values, progress)
    from tmodes.study.runner import run_study

    return run_study(study, folder, progress=progress, **where).rows
