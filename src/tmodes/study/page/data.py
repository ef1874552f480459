"""The data of a study's page: what ``web/src/study/contract.ts`` calls a StudyPage."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, TmodesError
from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_groups import is_grouped
from tmodes.io.sheet_paths import steps_of
from tmodes.live.knobs import REAL
from tmodes.live.sheet_numbers import sheet_numbers
from tmodes.sheet.robot import Robot
from tmodes.simulation.vary.simulate import prepared, run_prepared
from tmodes.simulation.vary.values import Whole
from tmodes.study.mapping import Group, groups_of
from tmodes.study.rows import GOOD, Rows
from tmodes.study.study import Study

__all__ = [
    "MOST_ROWS",
    "PERCENTS",
    "SHARES",
    "ColumnInfo",
    "Labels",
    "Setting",
    "ahead_of",
    "page_data",
    "setting_of",
    "shown_rows",
    "swings",
    "tip_bands",
]

Array = NDArray[np.float64]
Labels = Mapping[int, str]
"""How a case came about, by its index: ``nominal``, ``gear low``, ``gear high``."""

_FEWEST = 20
"""Good cases without which no tenth has two of them."""

_TENTHS = "Median over the cases in the lowest (blue) and the highest (orange) tenth of each parameter"
_CHOICES = "; of what is chosen from a list: the choice with the least and that with the largest median"
_ENDS = "Each parameter alone at its lowest (blue) and its highest (orange) value, all others nominal"


def swings(rows: Rows, labels: Labels, chosen: Mapping[str, bool]) -> list[dict[str, Any]]:
    """One tornado for each quantity that has one; ``chosen``: parameters that are chosen from a list."""
    found = []
    for quantity, values in rows.quantities.items():
        info = _of_ends(rows, labels, values) or _of_tenths(rows, values, chosen)
        if info:
            found.append({"quantity": quantity, "unit": rows.units.get(quantity, "-"), **info})
    return found


def _of_ends(rows: Rows, labels: Labels, values: Array) -> dict[str, Any] | None:
    """From cases that say so: the nominal one, and each parameter at both ends by itself."""
    place = {label: index for index, label in labels.items()}
    pairs = {name: [place.get(f"{name} {end}") for end in ("low", "high")] for name in rows.parameters}
    bars = [
        {"name": name, "low": float(values[low]), "high": float(values[high])}
        for name, (low, high) in pairs.items()
        if low is not None and high is not None and np.isfinite(values[[low, high]]).all()
    ]
    nominal = place.get("nominal")
    if not bars or nominal is None or not np.isfinite(values[nominal]):
        return None
    return {"how": _ENDS, "base": float(values[nominal]), "bars": bars}


def _of_tenths(rows: Rows, values: Array, chosen: Mapping[str, bool]) -> dict[str, Any] | None:
    good = rows.good & np.isfinite(values)
    if good.sum() < _FEWEST:
        return None
    bars = []
    for name, given in rows.parameters.items():
        own = given[good]
        if own.min() == own.max():
            continue
        if chosen.get(name):
            middles = [float(np.median(values[good][own == one])) for one in np.unique(own)]
            low, high = min(middles), max(middles)
        else:
            ends = np.percentile(own, [10, 90])
            low, high = (float(np.median(values[good][part])) for part in (own <= ends[0], own >= ends[1]))
        bars.append({"name": name, "low": low, "high": high})
    how = _TENTHS + (_CHOICES if any(chosen.get(bar["name"]) for bar in bars) else "")
    return {"how": how, "base": float(np.median(values[good])), "bars": bars} if bars else None


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


def shown_rows(rows: Rows, most: int = MOST_ROWS, always: Sequence[int] = ()) -> NDArray[np.int64]:
    """Indices of the rows that a page holds: of too many the extremes of each quantity, lost ones, and an even part.

    ``always``: indices that are among them.
    """
    if len(rows) <= most:
        return np.arange(len(rows))
    ends = [f(values) for values in rows.quantities.values() if np.isfinite(values).any()
            for f in (np.nanargmin, np.nanargmax)]  # fmt: skip
    lost = np.flatnonzero(~rows.good)[:_MOST_LOST]
    kept = np.unique(np.concatenate([np.array([*ends, *always], dtype=np.int64), lost]))
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
    answers: Mapping[str, str] | None = None,
    designs: Mapping[str, Any] | None = None,
    least_first: bool = False,
    drawn: bool = True,
    report: str = "",
    no_report: str = "",
) -> dict[str, Any]:
    """All that the page shows.

    ``labels``: how cases came about, by their index; ``answers``: sentences by quantity; ``drawn``: whether cases
    come as often as their distributions say; ``least_first``: whether the least values of the first quantity are the
    best. ``designs``: of an optimization, whose cases are designs: what ``web/src/study/contract.ts`` calls Designs,
    with indices of rows. ``indices``: Sobol' indices of quantities; ``report``: a packed report whose sliders are set
    to a case's numbers.
    """
    kept = shown_rows(rows, always=[*designs["front"], designs["best"]] if designs else ())
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
        "answers": dict(answers or {}),
        "designs": designs and {
            **designs, "front": [place[k] for k in designs["front"] if k in place], "best": place.get(designs["best"]),
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


SHARES = (5, 25, 50, 75, 95)
"""Percentiles that are drawn."""

_CASES, _MOST_TIMES, _MOST_NUMBERS = 240, 400, 25_000_000
"""Cases that are run again, instants that are drawn, numbers of their samples at most."""

_SECONDS, _PART, _ROUGH = 20.0, 0.1, 60
"""Processor time [s] that they may take, or this part of that of the study; cases that are run anyway."""

_FEWEST, _LITTLE = 20, 0.2
"""Cases without which there are no percentiles; spread over the largest below which an axis is left out."""


def tip_bands(study: Study, rows: Rows, progress: Callable[[str, float], None]) -> list[dict[str, Any]]:
    """The coordinates of the tip less those of the sheet's own run [mm], where they differ most.

    None of a study that simulates nothing, or whose cases cannot be run side by side.
    """
    needs = study.needs
    if study.robot is None or not (needs.reductions or needs.result) or rows.good.sum() < _FEWEST:
        return []
    try:
        group = _largest(study, rows)
        return [] if group is None else _bands(group, study.wholes.get(group.kind), progress)
    except TmodesError:  # a batch takes no stop conditions, and all of it must fit into memory
        return []


def _largest(study: Study, rows: Rows) -> Group | None:
    """Some good cases, evenly taken, of the robot that most of them share."""
    good = np.flatnonzero(rows.good)
    spent = rows.seconds[good]
    affordable = max(_ROUGH, int(max(_SECONDS, _PART * spent.sum()) / max(float(spent.mean()), 1e-9)))
    chosen = good[np.linspace(0, len(good) - 1, min(_CASES, affordable, len(good))).astype(int)]
    values = np.column_stack([given[chosen] for given in rows.parameters.values()])
    assert study.robot is not None  # noqa: S101
    groups = [one for one in groups_of(study.robot, study.names, study.targets, study.choices, values) if one.vary]
    found = max(groups, key=lambda one: len(one.places), default=None)
    return found if found is not None and len(found.places) >= _FEWEST else None


def _bands(group: Group, whole: Whole | None, progress: Callable[[str, float], None]) -> list[dict[str, Any]]:
    robot = group.robot
    assert robot is not None  # noqa: S101
    samples = robot.integration.duration / robot.integration.output_step
    count = max(_FEWEST, min(len(group.places), int(_MOST_NUMBERS / (samples * 40))))
    own = run_prepared(prepared(robot, None), tips=True, threads=1)

    def tell(stage: str, share: float) -> None:
        progress("motions", share if stage == "running" else 1.0)

    vary = {path: values[:count] for path, values in group.vary.items()}
    some = run_prepared(prepared(robot, vary, whole=whole), tips=True, progress=tell)
    if some.tips is None or own.tips is None or some.finished.sum() < _FEWEST or not own.finished.all():
        return []
    kept = np.unique(np.linspace(0, len(some.times) - 1, _MOST_TIMES).astype(int))
    apart = 1e3 * (some.tips[some.finished][:, kept] - own.tips[:, kept])
    percentiles = np.percentile(apart, SHARES, axis=0)
    spread = np.ptp(percentiles, axis=0).max(axis=0)
    return [
        {
            "title": f"Tip {'xyz'[axis]} less that of the sheet's own run",
            "label": f"Δ{'xyz'[axis]} of the tip",
            "unit": "mm",
            "times": some.times[kept],
            "shares": list(SHARES),
            "values": np.ascontiguousarray(percentiles[..., axis]).astype(np.float32),
            "nominal": None,
            "cases": int(some.finished.sum()),
        }
        for axis in np.argsort(-spread).tolist()
        if spread[axis] > _LITTLE * spread.max()
    ]


@dataclass(frozen=True)
class Setting:
    """The path of a slider, what a parameter's value is multiplied by there, and the ends that it must reach."""

    path: str
    factor: float
    low: float
    high: float


def setting_of(robot: Robot, path: str, ends: tuple[float, float], *, relative: bool) -> Setting | None:
    """The setting that does what a study's path does; None where a report can have none.

    ``ends``: least and largest value of the parameter; ``relative``: they are factors on the sheet's own number.
    """
    if is_grouped(path) and not path.startswith(REAL):
        return Setting(path, 1.0, *ends)
    real = path.startswith((REAL, "real."))
    number = _number(robot, path.removeprefix(REAL).removeprefix("real."))
    if number is None:
        return None
    own, value = number
    factor = 1.0
    if relative:
        factor = robot.real.get(path.removeprefix("real."), 1.0) if real else value
    low, high = sorted(factor * end for end in ends)
    return Setting(f"{REAL}{own}" if real else own, factor, low, high)


def _number(robot: Robot, path: str) -> tuple[str, float] | None:
    """The one number that stands at a path, or in the list there."""
    data = sheet_data(robot)
    try:
        steps = steps_of(path, data)
    except InputError:
        return None
    found = []
    for number in sheet_numbers(robot):
        own = steps_of(number.path, data)
        if own[: len(steps)] == steps:
            found.append((number.path, number.value))
    return found[0] if len(found) == 1 else None


def ahead_of(settings: Mapping[str, Setting]) -> dict[str, tuple[float, float]]:
    """What the live report must offer for these settings, of single numbers."""
    return {one.path: (one.low, one.high) for one in settings.values() if "*" not in one.path.split(".")}
