"""The data of a study's figures: those of its page, and what follows from its plan."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from tmodes.errors import SimulationError
from tmodes.io.atomic import atomic_write
from tmodes.study.optimize.result import Candidate, Optimum
from tmodes.study.page.data import ColumnInfo, page_data
from tmodes.study.page.document import shown_data, study_document
from tmodes.study.result import StudyResult
from tmodes.study.rows import Rows
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
    """Write the designs of an optimization as one self-contained HTML file: the feasible ones, and the front.

    Raises :class:`tmodes.errors.ResultFileError` when the file cannot be written.
    """
    designs = [*found.ranked, *(one for one in found.front if one not in found.ranked)]
    designs = designs or ([found.nearest] if found.nearest else [])
    rows, info, data = designs_data(found, study, designs)
    lead = f"{found.designs:,} designs tried, {found.feasible:,} within all limits; by {found.method}"
    provenance = [["robot", "none" if study.robot is None else study.robot.name], ["method", found.method],
                  ["objectives", "; ".join(found.objectives)], ["cases", f"{found.cases:,}"]]  # fmt: skip
    with atomic_write(path) as temporary:
        temporary.write_text(
            study_document(found.name, lead, rows, info, data, provenance, _sentence(found)),
            encoding="utf-8",
            newline="\n",
        )
    return Path(path)


def designs_data(
    found: Optimum, study: Study, designs: list[Candidate]
) -> tuple[Rows, dict[str, ColumnInfo], dict[str, Any]]:
    """Designs as rows, the words of their columns, and what a page or a figure shows of them."""
    rows, labels = _rows(found, designs), {name: study.choice_names(name) for name in study.names}
    units, titles = study.parameter_units, {name: one.title for name, one in study.sheet.parameters.items()}
    info = {name: ColumnInfo(titles[name], units[name], labels[name]) for name in rows.parameters if name in titles} | {
        name: ColumnInfo("", rows.units[name]) for name in rows.quantities
    }
    aims, best = [*map(_aim, found.objectives)], {one.number for one in found.front}
    front = [k for k, one in enumerate(designs) if one.number in best]
    pareto = {"objectives": (aims[0], aims[1]), "front": front} if len(aims) > 1 else {}
    least = found.objectives[0].startswith("minimize")
    return rows, info, page_data(
        found.name, rows, info, no_report=_NO_REPORT, least_first=least, drawn=False, **pareto
    )  # fmt: skip


def _sentence(found: Optimum) -> str:
    """The best design in words; where there is none the one that exceeds its limits least."""
    one = found.best or found.nearest
    if one is None:
        return "No design could be computed."
    chosen = ", ".join(f"{name} = {one.choices.get(name, f'{value:.5g}')}" for name, value in one.values.items())
    if found.best is None:
        return f"No design keeps all limits; the one that exceeds them least: {chosen}."
    if found.front:
        return f"{len(found.front)} designs of which none is better in all: {' and '.join(found.objectives)}."
    unit = found.units.get(_aim(found.objectives[0]), "-")
    reached = f"{one.objectives[0]:.5g}{'' if unit == '-' else f' {unit}'}"
    limits = "; ".join(f"{limit.text}: {limit.value:.4g}" for limit in one.limits)
    return f"Best design: {chosen}, {_aim(found.objectives[0])} {reached}{f' ({limits})' if limits else ''}."


def _aim(text: str) -> str:
    """The name of an objective: ``minimize mass`` is of ``mass``."""
    return text.partition(" ")[2]


def _rows(found: Optimum, designs: list[Candidate]) -> Rows:
    """A row for each design: what is chosen; objectives, the worst value of quantities, and terms of limits."""
    count = len(designs)
    parameters = {name: np.array([one.values[name] for one in designs]) for name in designs[0].values}
    quantities = {
        _aim(text): np.array([one.objectives[k] for one in designs]) for k, text in enumerate(found.objectives)
    }
    units = {name: found.units.get(name, "-") for name in quantities}
    for name in designs[0].quantities:
        if name not in quantities:
            quantities[name] = np.array([one.quantities[name][1] for one in designs])
            units[name] = found.units.get(name, "-")
    status = ["finished" if one.feasible else "stopped" for one in designs]
    reason = [one.reason or ("" if one.feasible else "it exceeds a limit") for one in designs]
    return Rows(np.array([one.number for one in designs]), parameters, quantities, units, status, reason, [""] * count,
                np.zeros(count))  # fmt: skip


def figure_data(
    result: StudyResult, progress: Callable[[str, float], None] = lambda stage, share: None, *, bands: bool = True
) -> dict[str, Any]:
    """What :func:`tmodes.plot.studies.save_study_figures` draws of a study, a sensitivity or an optimization.

    ``bands``: also the motion of the tip, for which a hundred cases are run again.
    """
    study, plan = result.study, result.study.sheet.plan
    if study.sheet.optimize and plan.name_of_kind() == "list" and result.complete:
        from tmodes.study.optimize.summary import stored_designs

        found, designs = stored_designs(study, result.rows)
        return designs_data(found, study, designs)[2]
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
