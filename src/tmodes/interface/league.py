"""The files of a comparison: its page, its table, its figure, and a report of each nominal run."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote

import numpy as np

from tmodes.interface.contenders import Contender
from tmodes.interface.files import write_files
from tmodes.io.atomic import atomic_write, check_writable
from tmodes.report.plots import Axis, Curve, Page, Plot, write_plots

__all__ = ["write_league", "write_page"]

Progress = Callable[[str, float], None]

_ERROR = "largest error of the tip [mm]"
_DECADES, _SPREAD, _GOLDEN = 30.0, 0.5, 0.6180339887498949
"""Largest over smallest error beyond which an axis is logarithmic; height of the dots of a row; how these are laid."""

_MOST_TIMES = 600
_MARKS = ("circle", "square", "triangle", "ring", "cross")


def write_league(found: Any, folder: Path, *, reports: bool, progress: Progress) -> None:
    """compare.html, compare.csv and compare.svg into a folder, replacing those of the same comparison."""
    write_page(found, folder / "compare.html", reports=reports, progress=progress)
    write_files(None, found, folder / "compare.svg", overwrite=True)
    rows = [_flat(one) for one in found.info()["variants"]]
    text = io.StringIO()
    table = csv.DictWriter(text, list(dict.fromkeys(key for row in rows for key in row)), lineterminator="\n")
    table.writeheader()
    table.writerows(rows)
    with atomic_write(folder / "compare.csv") as temporary:
        temporary.write_text(text.getvalue(), encoding="utf-8", newline="\n")


def _flat(info: dict[str, Any], group: str = "") -> dict[str, Any]:
    """Numbers of groups within groups by names such as ``cases.fails.share``, lists by their place."""
    flat: dict[str, Any] = {}
    for key, given in info.items():
        value = {str(k): each for k, each in enumerate(given)} if isinstance(given, list) else given
        flat |= _flat(value, f"{group}{key}.") if isinstance(value, dict) else {f"{group}{key}": value}
    return flat


def write_page(found: Any, path: Path, *, reports: bool, progress: Progress = lambda stage, share: None) -> Path:
    """The page, with links to what reports are there."""
    from tmodes.report.page import write_report

    check_writable(path.parent, 0)
    links = {}
    for k, one in enumerate(found.contenders):
        own = path.parent / one.folder / "report.html"
        if reports and one.result is not None:
            progress(f"report of {one.name}", k / len(found.contenders))
            check_writable(own.parent, 0)
            write_report(one.result, own)
            links[one.name] = quote(f"{one.folder}/report.html")
    return write_plots(_page(found, links), path)


def _page(found: Any, links: dict[str, str]) -> Page:
    cases = f"{found.cases} cases, the same for all" if found.cases > 1 else "the robot as known"
    lead = f"{len(found.contenders)} variants on one task, {cases}"
    info = found.info()
    about = [["robot", found.name], ["uncertain", ", ".join(found.uncertain) or "nothing"], ["cases", str(found.cases)]]
    about += [["tolerance", "none" if found.tolerance is None else f"{1e3 * found.tolerance:g} mm"]]
    best = found.ranked[0]
    level = "warning" if best.failed(found.tolerance) or not best.nominal.good else "neutral"
    sentence, *parts = found.tables()
    return Page(
        f"{found.name}: comparison", lead, str(sentence), [*_plots(found)], parts, level, found.warnings, found.notices,
        links, {"compare.json": json.dumps(info)}, about,
    )  # fmt: skip


def _plots(found: Any) -> Iterator[Plot]:
    """The errors of all; that of each as known over time; the share of the cases within an error."""
    from tmodes.plot.style import CYCLE, SERIES

    every = found.ranked
    looks = {one.name: {"colour": CYCLE[k % len(CYCLE)], "dash": SERIES[k % len(SERIES)]}
             for k, one in enumerate(every)}  # fmt: skip
    names = [one.name for one in every]
    nominal = np.array([_mm(one.nominal.largest_m) for one in every])
    errors = np.array([1e3 * one.errors for one in every]).reshape(len(every), -1)
    known = np.concatenate([nominal, errors.ravel()])
    known = known[np.isfinite(known) & (known > 0)]
    scale = "log" if len(known) and known.max() > _DECADES * known.min() else "linear"
    limit = None if found.tolerance is None else 1e3 * found.tolerance
    reach = None if scale == "log" or not len(known) else (0.0, 1.05 * max(known.max(), limit or 0.0))
    rows = np.arange(len(every), dtype=float)
    several = errors.shape[1] > 1
    curves = [Curve("nominal", nominal, rows, "circle", "blue")]
    if several:
        shift = _SPREAD * ((np.arange(errors.shape[1]) * _GOLDEN) % 1.0 - 0.5)
        place = np.repeat(rows, errors.shape[1]) + np.tile(shift, len(every))
        curves.insert(0, Curve("one of the cases", errors.ravel(), place, "dots", "sky"))
    if errors.shape[1]:
        word = f"worst of {found.cases}" if several else "actual robot"
        curves.append(Curve(word, [_mm(one.worst) for one in every], rows, "square", "red"))
    if limit is not None:
        curves.append(Curve("tolerance", [limit, limit], [-0.5, len(every) - 0.5], "line", "quiet", (6, 3)))
    lost = int((~np.isfinite(errors)).sum())
    yield Plot("Errors of all variants", Axis(_ERROR, scale, range=reach), Axis("", names=names), curves,
               "The best one first." + (f" {lost} cases that did not end have no mark." if lost else ""),
               90 + 44 * len(every))  # fmt: skip
    if several:
        steps = [Curve(one.name, *_within(1e3 * one.errors), **looks[one.name]) for one in every]
        if limit is not None:
            steps.append(Curve("tolerance", [limit, limit], [0.0, 100.0], "line", "quiet", (6, 3)))
        yield Plot("Share of the cases within an error", Axis(_ERROR, scale), Axis("share of the cases [%]"), steps,
                   "A curve that ends below 100 %: the other cases did not end.")  # fmt: skip
    if split := [(one, one.attribution) for one in every if one.stack]:
        own = np.arange(len(split), dtype=float)
        marks = [
            Curve(part, [_mm(shares[part]) for _, shares in split], own, _MARKS[k % len(_MARKS)], CYCLE[k % len(CYCLE)])
            for k, part in enumerate(split[0][1])
        ]
        yield Plot("Added by each uncertain number", Axis("adds to the largest error [mm]"),
                   Axis("", names=[one.name for one, _ in split]), marks,
                   "Each alone at its worse end; the remainder: only all together.", 90 + 44 * len(split))  # fmt: skip
    courses = [(one, course) for one in every if (course := _course(one)) is not None]
    if courses:
        lines = [Curve(one.name, *course, **looks[one.name]) for one, course in courses]
        if limit is not None:
            end = max(course[0][-1] for _, course in courses)
            lines.append(Curve("tolerance", [0.0, end], [limit, limit], "line", "quiet", (6, 3)))
        yield Plot("Tip error over time, as known", Axis("time [s]"), Axis("error of the tip [mm]"), lines)


def _mm(length: float | None) -> float:
    return np.nan if length is None else 1e3 * length


def _within(errors: np.ndarray[Any, Any]) -> tuple[Any, Any]:
    """The steps of the share [%] of all cases whose error is not larger."""
    known = np.sort(errors[np.isfinite(errors)])
    shares = 100 * np.arange(len(known) + 1) / len(errors)
    return np.repeat(known, 2), np.repeat(shares, 2)[1:-1]


def _course(one: Contender) -> tuple[Any, Any] | None:
    """Times [s] and errors [mm] of the tip of the nominal run; None where it has none."""
    if one.result is None or one.nominal.largest_m is None:
        return None
    error = one.result.output("tip_error")
    kept = np.unique(np.linspace(0, error.sizes["time"] - 1, _MOST_TIMES).astype(int))
    return error["time"].values[kept], 1e3 * error.values[kept]
