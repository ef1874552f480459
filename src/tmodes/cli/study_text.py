"""What a study found, as plain data and as text."""

from __future__ import annotations

from math import isfinite
from typing import TYPE_CHECKING, Any

from tmodes.cli.terminal import notice, print_table

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from tmodes.study.result import StudyResult
    from tmodes.study.study import Study

__all__ = ["notice_slow", "print_study", "study_info", "unfinished"]

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


def unfinished(result: StudyResult) -> list[str]:
    """What is said of a study that was interrupted."""
    if result.complete:
        return []
    done, cases = result.cover.done, len(result.design.values)
    return [f"these are {done:,} of {cases:,} cases; the same `tmodes study` computes the others"]


def study_info(result: StudyResult) -> dict[str, Any]:
    """Counts, percentiles of each quantity over the cases that have it, and the reasons of the others.

    Of the table one column at a time is in memory. Intervals of percentiles only where cases are drawn.
    """
    from tmodes.study.rows import GOOD
    from tmodes.study.statistics import CONFIDENCE
    from tmodes.study.table import Columns

    columns, plan = Columns(result.parquet), type(result.study.sheet.plan)
    counts, failures = columns.counts(), columns.lost(MOST_REPORTED)
    good = sum(counts.get(status, 0) for status in GOOD)
    cases = columns.cases
    more, certain = cases - good - len(failures), plan.draws and not plan.repeats
    return {
        "study": result.study.sheet.name,
        "cases": cases,
        "status": counts,
        "good": good,
        "drawn": plan.draws,
        "confidence": CONFIDENCE if certain else None,
        "quantities": {
            name: _spread(columns.numbers(name), columns.unit(name), certain=certain)
            for name in result.study.sheet.quantities
        },
        "failures": failures,
        "warnings": [f"case {one['case']} {one['status']}: {one['reason']}" for one in failures]
        + ([f"and {more:,} more cases without a result; the table has their reasons"] if more else []),
    }


def _spread(values: NDArray[np.float64], unit: str, *, certain: bool) -> dict[str, Any]:
    """Numbers of a column; ``certain``: with intervals of the percentiles, null where too few cases give an end."""
    from tmodes.study.statistics import statistics

    found = statistics(values, PERCENTILES)
    percents = {f"p{percent}": found.percentiles[percent] for percent in PERCENTILES}
    spread = {
        "min": found.least, **{key: one.value for key, one in percents.items()}, "max": found.largest,
        "mean": found.mean, "deviation": found.deviation if found.count != 1 else 0.0,
    }  # fmt: skip
    intervals = {key: [_known(one.low), _known(one.high)] for key, one in percents.items()}
    return {
        "unit": unit, "known": found.count, **{key: _known(value) for key, value in spread.items()},
        **({"intervals": intervals} if certain else {}),
    }  # fmt: skip


def _known(value: float) -> float | None:
    return value if isfinite(value) else None


def print_study(info: dict[str, Any]) -> None:
    """The counts as a sentence, the quantities as a table, and where the files are.

    Percentiles only where cases come as often as their distributions say.
    """
    counts = ", ".join(f"{count:,} {status.replace('_', ' ')}" for status, count in info["status"].items())
    percents = SHOWN if info["drawn"] else ()
    head = ["quantity", "unit", "least", *(f"{p} %" for p in percents), "largest", "mean"]
    rows = [
        [
            name, found["unit"], _number(found["min"]), *(_percentile(found, f"p{p}") for p in percents),
            _number(found["max"]), _number(found["mean"]),
        ]
        for name, found in info["quantities"].items()
    ]  # fmt: skip
    print_table(f"{info['study']}: {info['cases']:,} cases: {counts}", head, rows)
    if info["confidence"]:
        sure = f"{100 * info['confidence']:.0f} % confidence"
        print(f"In brackets: intervals of the percentiles at {sure}; - where there are too few cases for an end.")
    for what, where in info["files"].items():
        print(f"{what.capitalize()}: {where}")


def _percentile(found: dict[str, Any], key: str) -> str:
    """A percentile and its interval."""
    value = _number(found[key])
    if value == "-" or "intervals" not in found:
        return value
    low, high = map(_number, found["intervals"][key])
    return f"{value} [{low}, {high}]"


def _number(value: float | None) -> str:
    return "-" if value is None else f"{value:.4g}"
