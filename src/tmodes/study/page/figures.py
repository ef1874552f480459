"""The data of a study's figures: those of its page, and what follows from its plan."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from tmodes.errors import SimulationError
from tmodes.io.atomic import atomic_write
from tmodes.io.printed import changed_by
from tmodes.report.markup import Markup, table
from tmodes.study.answers import amount
from tmodes.study.optimize.result import Candidate, Optimum, chosen_values, design_name
from tmodes.study.page.data import ColumnInfo, page_data
from tmodes.study.page.document import shown_data, study_document
from tmodes.study.result import StudyResult
from tmodes.study.rows import GOOD, Rows
from tmodes.study.sensitivity.result import Sensitivity
from tmodes.study.study import Study

__all__ = ["designs_data", "effects_of", "figure_data", "indices_of", "write_designs"]

_NO_REPORT = "Designs have no live report; `tmodes run` with the values shown simulates one."


def indices_of(found: Sensitivity) -> list[dict[str, Any]]:
    """Sobol' indices with their intervals, by quantity; none of elementary effects, or where a quantity has none."""
    if found.method != "sobol":
        return []
    how = f"Sobol' indices, {found.samples:,} samples, {found.cases:,} cases"
    return [
        {"quantity": name, "how": how, "names": list(found.names), "first": _ends(found, "first", k),
         "total": _ends(found, "total", k)}
        for k, name in enumerate(found.quantities)
        if np.isfinite(found.indices["first"][k]).all()
    ]  # fmt: skip


def _ends(found: Sensitivity, index: str, k: int) -> list[list[float]]:
    """Value and both ends of the interval of each parameter."""
    return np.column_stack([found.indices[index][k], found.intervals[index][k]]).tolist()


def effects_of(found: Sensitivity) -> list[dict[str, Any]]:
    """Morris' effects by quantity: mean size mu* with its interval, and how much they vary, sigma; else none."""
    if found.method != "morris":
        return []
    return [
        {"quantity": name, "unit": found.units.get(name, "-"), "names": list(found.names),
         "size": _ends(found, "size", k), "spread": found.indices["spread"][k].tolist(), "trajectories": found.samples}
        for k, name in enumerate(found.quantities)
        if np.isfinite(found.indices["size"][k]).all()
    ]  # fmt: skip


def write_designs(found: Optimum, study: Study, path: Path | str) -> Path:
    """Write all designs of an optimization as one self-contained HTML file.

    Raises :class:`tmodes.errors.ResultFileError` when the file cannot be written.
    """
    rows, info, data = designs_data(found, study)
    lead = f"{found.designs:,} designs tried, {found.feasible:,} {_good(found)}; by {found.method}"
    aims = "; ".join(f"{one.partition(' ')[0]} {found.title(_aim(one))}" for one in found.objectives)
    provenance = [["robot", "none" if study.robot is None else study.robot.name], ["method", found.method],
                  ["objectives", aims], ["cases", f"{found.cases:,}"]]  # fmt: skip
    with atomic_write(path) as temporary:
        temporary.write_text(
            study_document(found.name, lead, rows, info, data, provenance, found.sentence, _against_start(found)),
            encoding="utf-8",
            newline="\n",
        )
    return Path(path)


def designs_data(found: Optimum, study: Study) -> tuple[Rows, dict[str, ColumnInfo], dict[str, Any]]:
    """All designs as rows, the words of their columns, and what a page or a figure shows of them."""
    rows, labels = _rows(found), {name: study.choice_names(name) for name in study.names}
    units = study.parameter_units
    info = {name: ColumnInfo(found.title(name), units[name], labels[name]) for name in rows.parameters if name in units
           } | {name: ColumnInfo(found.title(name), rows.units[name]) for name in rows.quantities}  # fmt: skip
    best = found.best or found.nearest
    x, y = _axes(found, best, [*rows.parameters])
    designs = {
        "x": x, "y": y, "front": [one.number for one in found.front], "best": best.number if best else -1,
        "start": _columns_of(found, found.start) if found.start else {},
        "limits": [{"text": _shown(found, one.text, one.term), "column": one.term, "bound": one.bound, "sign": one.sign}
                   for one in (best.limits if best else ())],
    }  # fmt: skip
    least = found.objectives[0].startswith("minimize")
    data = page_data(found.name, rows, info, no_report=_NO_REPORT, least_first=least, drawn=False, designs=designs)
    return rows, info, data | {"words": [_good(found) if word == GOOD[0] else word for word in data["words"]]}


def _good(found: Optimum) -> str:
    """How a design ended that none of the limits rules out, if there are any."""
    return "within all limits" if found.trials and found.trials.goals.limits else GOOD[0]


def _against_start(found: Optimum) -> Markup | None:
    """The best design, or the nearest one, against the start."""
    one, start = found.best or found.nearest, found.start
    if one is None:
        return None
    head, before = chosen_values(found, one), chosen_values(found, start) if start else {}
    rows = [[found.title(name), before.get(name, "–"), text, ""] for name, text in head.items()]
    own, other = _numbers(found, one), _numbers(found, start) if start else {}
    for name, value in own.items():
        both, unit = (other.get(name, np.nan), value), found.units.get(name, "-")
        shown = [amount(each, unit) if np.isfinite(each) else "–" for each in both]
        limits = ", ".join(_shown(found, limit.text, name).removeprefix(f"{found.title(name)} ")
                           for limit in one.limits if limit.term == name)  # fmt: skip
        rows.append([f"{found.title(name)}{f' ({limits})' if limits else ''}", *shown,
                     changed_by(value, both[0]) if np.isfinite(both).all() else ""])  # fmt: skip
    what = f"design by {found.title(_aim(found.objectives[0]))}" if found.front else "design"
    title = f"{'Best' if found.best else 'Nearest'} {what} against the start"
    return table(title, ("Number", "Start", design_name(one), "Change"), rows, numeric=(1, 2, 3))


def _shown(found: Optimum, limit: str, term: str) -> str:
    return limit.replace(term, found.title(term), 1).replace("<=", "≤").replace(">=", "≥")


def _numbers(found: Optimum, one: Candidate) -> dict[str, float]:
    """Objectives, then the terms of limits, then other quantities."""
    aims = dict(zip(map(_aim, found.objectives), one.objectives, strict=True))
    terms = {limit.term: limit.value for limit in one.limits}
    others = {name: high for name, (_, high) in one.quantities.items()}
    return {name: value for name, value in (aims | terms | others | terms | aims).items() if name not in one.values}


_BEYOND = "beyond a limit"


def _aim(text: str) -> str:
    """The name of an objective: ``minimize mass`` is of ``mass``."""
    return text.partition(" ")[2]


def _axes(found: Optimum, best: Candidate | None, parameters: list[str]) -> tuple[str, str]:
    """Both objectives; of one, that over the term of the limit that holds it most, or over what is chosen."""
    aims = [*map(_aim, found.objectives)]
    if len(aims) > 1:
        return aims[0], aims[1]
    limits = [one for one in (best.limits if best else ()) if one.term != aims[0]]
    return (min(limits, key=lambda one: one.margin).term if limits else parameters[0]), aims[0]


def _columns_of(found: Optimum, one: Candidate) -> dict[str, float]:
    """What a design has in each column; a choice that is no entry of the list in none."""
    own = {name: value for name, value in one.values.items() if name not in one.choices}
    return {name: value for name, value in (own | _numbers(found, one)).items() if np.isfinite(value)}


def _rows(found: Optimum) -> Rows:
    """A row for each design: what is chosen; objectives and terms of limits at the worst, of quantities the largest."""
    tried = found.trials
    assert tried is not None  # noqa: S101
    judged, limits, count = tried.judged(), tried.goals.limits, len(tried)
    parameters = dict(zip(tried.space.names, tried.designs.T, strict=True))
    terms = {one.term.text: judged.limits[:, k] for k, one in enumerate(limits)}
    aims = {one.term.text: judged.objectives[:, k] for k, one in enumerate(tried.goals.aims)}
    others = {name: tried.values[name].max(axis=1) for name in tried.study.sheet.quantities}
    more = {name: values for name, values in (others | terms).items() if name not in parameters}
    quantities = aims | more | aims
    known = np.logical_and.reduce([np.isfinite(one) for one in (*aims.values(), *terms.values())])
    status = np.where(judged.feasible, GOOD[0], np.where(known, _BEYOND, "failed")).tolist()
    kept = [one.kept(judged.limits[:, k]) for k, one in enumerate(limits)]
    texts = [[f"{_shown(found, one.text, one.term.text)}: {amount(value, one.unit)}" for value in values]
             for one, values in zip(limits, judged.limits.T.tolist(), strict=True)]  # fmt: skip
    broken = ["; ".join(text[row] for text, good in zip(texts, kept, strict=True) if not good[row])
              for row in range(count)]  # fmt: skip
    reason = [why or limit for why, limit in zip(tried.reasons, broken, strict=True)]
    units = {name: found.units.get(name, "-") for name in quantities}
    return Rows(np.arange(count), parameters, quantities, units, status, reason, [""] * count, np.zeros(count))


def figure_data(
    result: StudyResult, progress: Callable[[str, float], None] = lambda stage, share: None, *, bands: bool = True
) -> dict[str, Any]:
    """What :func:`tmodes.plot.studies.save_study_figures` draws of a study, a sensitivity or an optimization.

    ``bands``: also the motion of the tip, for which a hundred cases are run again.
    """
    study, plan = result.study, result.study.sheet.plan
    if study.sheet.optimize and plan.name_of_kind() == "list" and result.complete:
        from tmodes.study.optimize.summary import stored_designs

        return designs_data(stored_designs(study, result.rows), study)[2]
    indices, effects = _of_sensitivity(result)
    return shown_data(result, progress, bands=bands, indices=indices) | {"effects": effects}


def _of_sensitivity(result: StudyResult) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """Indices or effects of all quantities, where the plan is one for them and enough cases have values."""
    from tmodes.study.sensitivity.indices import analysed

    method = result.study.sheet.plan.analysis
    if not method or not result.complete:
        return [], []
    try:
        found = analysed(method, result.rows, result.design)
    except SimulationError:
        return [], []
    return indices_of(found), effects_of(found)
