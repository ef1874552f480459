"""Cases of an optimization in a study folder, as a study that lists them."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.study.plans.list_of_cases import ListOfCases
from tmodes.study.rows import Rows
from tmodes.study.study import Study

__all__ = ["stored_rows"]

Array = NDArray[np.float64]


def stored_rows(
    study: Study, cases: Array, first: int, folder: str | os.PathLike[str],
    progress: Callable[[str, float], None], where: dict[str, Any],
) -> Rows:  # fmt: skip
    """Rows of the ``cases`` (m, d) from ``first`` on, of which those that the folder has are not computed again.

    The folder is that of a study whose plan lists all of them: it can be read, and shown, as any other.
    """
    from tmodes.study.runner import run_study

    return _from(run_study(_listed(study, cases), folder, progress=progress, **where).rows, first)


def _listed(study: Study, cases: Array) -> Study:
    rows = [dict(zip(study.names, row, strict=True)) for row in cases.tolist()]
    plan = ListOfCases.model_validate({"type": "list", "rows": rows})
    data = {**study.data, "study": {**study.data["study"], "plan": {"type": "list", "rows": rows}}}
    return replace(study, sheet=study.sheet.model_copy(update={"plan": plan}), data=data)


def _from(rows: Rows, first: int) -> Rows:
    """The rows from a case on."""

    def cut(columns: Any) -> dict[str, Array]:
        return {name: one[first:] for name, one in columns.items()}

    return Rows(
        rows.case[first:], cut(rows.parameters), cut(rows.quantities), rows.units, rows.status[first:],
        rows.reason[first:], rows.method[first:], rows.seconds[first:], errors=rows.errors[first:],
    )  # fmt: skip
