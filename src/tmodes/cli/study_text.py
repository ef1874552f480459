"""What a study found, as plain data and as text."""

from __future__ import annotations

from math import isfinite
from typing import TYPE_CHECKING, Any

from tmodes.cli.terminal import notice, print_table

if TYPE_CHECKING:
    from tmodes.study.result import StudyResult
    from tmodes.study.study import Study

__all__ = ["notice_slow", "print_study", "study_info"]

PERCENTILES = (1, 5, 25, 50, 75, 95, 99)
SHOWN = (5, 50, 95)
"""Percentiles of the plain data, and those that the table shows."""

MOST_REPORTED = 5
"""Cases that did not finish, reported one by one."""


def notice_slow(study: Study) -> None:
    """Say which quantities make a study slow."""
    slow = [name for name, one in study.sheet.quantities.items() if one.needs().result]
    if slow:
        names, verb = ", ".join(slow), "needs" if len(slow) == 1 else "need"
        notice(f"{names} {verb} the whole result of each case, which is run by itself: slow")


def study_info(result: StudyResult) -> dict[str, Any]:
    """Counts, percentiles of each quantity over the cases that have it, and the reasons of the others."""
    from tmodes.study.rows import GOOD

    rows, counts = result.rows, result.counts
    lost = [index for index, status in enumerate(rows.status) if status not in GOOD]
    failures = [
        {"case": int(rows.case[k]), "status": rows.status[k], "reason": rows.reason[k]} for k in lost[:MOST_REPORTED]
    ]
    more = len(lost) - len(failures)
    return {
        "study": result.study.sheet.name,
        "cases": len(rows),
        "status": counts,
        "good": sum(counts.get(status, 0) for status in GOOD),
        "quantities": {name: _spread(values, rows.units.get(name, "")) for name, values in rows.quantities.items()},
        "failures": failures,
        "warnings": [f"case {one['case']} {one['status']}: {one['reason']}" for one in failures]
        + ([f"and {more:,} more cases without a result; the table has their reasons"] if more else []),
    }


def _spread(values: Any, unit: str) -> dict[str, Any]:
    import numpy as np

    known = values[np.isfinite(values)]
    keys = "min", *(f"p{p}" for p in PERCENTILES), "max", "mean", "deviation"
    numbers: dict[str, float | None] = dict.fromkeys(keys)
    if len(known):
        spread = known.std(ddof=1) if len(known) > 1 else 0.0
        found = [known.min(), *np.percentile(known, PERCENTILES), known.max(), known.mean(), spread]
        numbers = dict(zip(numbers, map(float, found), strict=True))
    return {"unit": unit, "known": len(known), **numbers}


def print_study(info: dict[str, Any]) -> None:
    """The counts as a sentence, the quantities as a table, and where the files are."""
    counts = ", ".join(f"{count:,} {status.replace('_', ' ')}" for status, count in info["status"].items())
    head = ["quantity", "unit", "least", *(f"{p} %" for p in SHOWN), "largest", "mean"]
    rows = [
        [name, found["unit"], *(_number(found[key]) for key in ("min", *(f"p{p}" for p in SHOWN), "max", "mean"))]
        for name, found in info["quantities"].items()
    ]
    print_table(f"{info['study']}: {info['cases']:,} cases: {counts}", head, rows)
    for what, where in info["files"].items():
        print(f"{what.capitalize()}: {where}")


def _number(value: float | None) -> str:
    return "-" if value is None or not isfinite(value) else f"{value:.4g}"
