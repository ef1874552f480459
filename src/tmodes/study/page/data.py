"""The data of a study's page: what ``web/src/study/contract.ts`` calls a StudyPage."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.study.page.swings import Labels, swings
from tmodes.study.rows import GOOD, Rows

__all__ = ["MOST_ROWS", "PERCENTS", "ColumnInfo", "page_data", "shown_rows"]

Array = NDArray[np.float64]

MOST_ROWS = 20_000
"""Cases that a page holds."""

_MOST_LOST, _MOST_BINS = 2_000, 60

PERCENTS = (1, 5, 25, 50, 75, 95, 99)


@dataclass(frozen=True)
class ColumnInfo:
    """What a page shows of a column: its words, its unit, names of what is chosen, and where its number stands.

    ``path`` and ``factor``: of the slider of a report that sets it, and what the value is multiplied by there.
    """

    title: str = ""
    unit: str = "-"
    labels: tuple[str, ...] = ()
    nominal: float | None = None
    path: str | None = None
    factor: float = 1.0


def shown_rows(rows: Rows, most: int = MOST_ROWS) -> NDArray[np.int64]:
    """Indices of the rows that a page holds: of too many the extremes of each quantity, lost ones, and an even part."""
    if len(rows) <= most:
        return np.arange(len(rows))
    ends = [f(values) for values in rows.quantities.values() if np.isfinite(values).any()
            for f in (np.nanargmin, np.nanargmax)]  # fmt: skip
    lost = np.flatnonzero(~rows.good)[:_MOST_LOST]
    kept = np.unique(np.concatenate([np.array(ends, dtype=np.int64), lost]))
    even = np.linspace(0, len(rows) - 1, most - len(kept)).astype(np.int64)
    return np.unique(np.concatenate([kept, even]))


def page_data(
    name: str,
    rows: Rows,
    info: Mapping[str, ColumnInfo],
    *,
    labels: Labels | None = None,
    indices: Sequence[Mapping[str, Any]] = (),
    bands: Sequence[Mapping[str, Any]] = (),
    objectives: tuple[str, str] | None = None,
    front: Sequence[int] = (),
    least_first: bool = False,
    drawn: bool = True,
    report: str = "",
    no_report: str = "",
) -> dict[str, Any]:
    """All that the page shows.

    ``labels``: how cases came about, by their index; ``front``: cases that no other beats; ``drawn``: whether cases
    come as often as their distributions say; ``least_first``: whether the least values of the first quantity are the
    best. ``indices``: Sobol' indices of quantities; ``report``: a packed report whose sliders are set to a case's
    numbers.
    """
    kept = shown_rows(rows)
    words = sorted({str(status) for status in rows.status})
    place = {int(row): k for k, row in enumerate(kept)}
    return {
        "name": name,
        "cases": len(rows),
        "case": rows.case[kept].astype(np.int32),
        "parameters": [_column(key, values, kept, info.get(key)) for key, values in rows.parameters.items()],
        "quantities": [
            _column(key, values, kept, info.get(key) or ColumnInfo(unit=rows.units.get(key, "-")))
            for key, values in rows.quantities.items()
        ],
        "status": np.array([words.index(str(rows.status[k])) for k in kept], dtype=np.uint8),
        "words": words,
        "good": [word in GOOD for word in words],
        "reasons": {str(place[int(k)]): rows.reason[k][:300] for k in kept if rows.reason[k] and not rows.good[k]},
        "tornados": swings(rows, labels or {}, {key: len(one.labels) > 0 for key, one in info.items()}),
        "indices": [*indices],
        "bands": [*bands],
        "pareto": None if objectives is None else {
            "x": objectives[0], "y": objectives[1], "front": [place[k] for k in front if k in place],
        },
        "leastFirst": least_first,
        "drawn": drawn,
        "report": report,
        "noReport": no_report,
    }  # fmt: skip


def _column(name: str, values: Array, kept: NDArray[np.int64], info: ColumnInfo | None) -> dict[str, Any]:
    info = info or ColumnInfo()
    finite = values[np.isfinite(values)]
    counts, edges = np.histogram(finite, _bins(finite)) if len(finite) else (np.zeros(0), np.zeros(0))
    percents = [[share, float(np.percentile(finite, share))] for share in PERCENTS] if len(finite) else []
    return {
        "name": name, "title": info.title, "unit": info.unit, "values": values[kept].astype(np.float64),
        "labels": list(info.labels) or None, "nominal": info.nominal, "path": info.path, "factor": info.factor,
        "edges": edges.astype(np.float64), "counts": counts.astype(np.int32), "percentiles": percents,
    }  # fmt: skip


def _bins(values: Array) -> Array:
    """Edges by Freedman and Diaconis (1981), few where there are few values; of one value about it."""
    low, high = float(values.min()), float(values.max())
    if low == high:
        return np.array([low - 0.5 * (abs(low) or 1.0) * 1e-3, high + 0.5 * (abs(high) or 1.0) * 1e-3])
    width = 2 * float(np.subtract(*np.percentile(values, [75, 25]))) / len(values) ** (1 / 3)
    count = int(np.ceil((high - low) / width)) if width > 0 else 10
    return np.linspace(low, high, min(max(count, 5), _MOST_BINS) + 1)
