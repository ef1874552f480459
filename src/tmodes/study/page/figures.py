"""The data of a study's figures: those of its page, and what follows from its plan."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmodes.errors import SimulationError
from tmodes.study.page.analyses import designs_data, effects_of, indices_of
from tmodes.study.page.write import shown_data
from tmodes.study.result import StudyResult

__all__ = ["figure_data"]


def figure_data(
    result: StudyResult, progress: Callable[[str, float], None] = lambda stage, share: None, *, bands: bool = True
) -> dict[str, Any]:
    """What :func:`tmodes.plot.studies.save_study_figures` draws of a study, a sensitivity or an optimization.

    ``bands``: also the motion of the tip, for which a hundred cases are run again.
    """
    study, plan = result.study, result.study.sheet.plan
    if study.sheet.optimize and plan.name_of_kind() == "list" and result.complete:
        from tmodes.study.optimize.stored_optimum import stored_designs

        found, designs = stored_designs(study, result.rows)
        return designs_data(found, study, designs)[2]
    indices, effects = _of_sensitivity(result)
    return shown_data(result, progress, bands=bands, indices=indices) | {"effects": effects}


def _of_sensitivity(result: StudyResult) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """Indices or effects of all quantities, where the plan is one for them and enough cases have values."""
    from tmodes.study.sensitivity.analysis import analysed

    method = result.study.sheet.plan.analysis
    if not method or not result.complete:
        return [], []
    try:
        found = analysed(method, result.rows, result.design)
    except SimulationError:
        return [], []
    return indices_of(found), effects_of(found)
