"""What the folder of an optimization shows: its designs judged again, and nothing computed."""

from __future__ import annotations

from tmodes.study.optimize.goals import goals_of
from tmodes.study.optimize.result import Candidate, Optimum
from tmodes.study.optimize.space import design_space
from tmodes.study.optimize.summary import candidate, found
from tmodes.study.optimize.trials import Trials
from tmodes.study.rows import Rows
from tmodes.study.study import Study

__all__ = ["stored_designs"]


def stored_designs(study: Study, rows: Rows) -> tuple[Optimum, list[Candidate]]:
    """The optimum among the designs of ``rows``, all cases in the order in which they were tried, and every design.

    Raises :class:`tmodes.errors.InputError` where objectives name what the study does not have.
    """
    asked = study.sheet.optimize
    assert asked is not None  # noqa: S101
    space, units = design_space(study, asked.design), dict(study.parameter_units) | dict(rows.units)
    values, each = study.design().values, max(1, asked.worst_case)
    trials = Trials(study, space, goals_of(asked, units), values[:each], None, lambda *_: None, {})
    trials.take(values[::each][:, list(space.columns)], rows)
    judged = trials.judged()
    return found(trials, "", units), [candidate(trials, judged, k) for k in range(len(trials))]
