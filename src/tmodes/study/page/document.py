"""The page of a study as one HTML document: its result in a sentence, tables without a program, and the charts."""

from __future__ import annotations

import base64
import gzip
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np

from tmodes.errors import TmodesError
from tmodes.io.atomic import atomic_write
from tmodes.report.markup import Markup, table, tag
from tmodes.report.pack import embedded, pack
from tmodes.report.page import page
from tmodes.report.parts import document, policy
from tmodes.result.run import run
from tmodes.study.page.data import PERCENTS, ColumnInfo, Setting, ahead_of, page_data, setting_of, tip_bands
from tmodes.study.result import StudyResult
from tmodes.study.rows import Rows
from tmodes.study.study import Study

__all__ = ["packed_report", "shown_data", "study_document", "write_page"]

_NEEDS = "The charts need JavaScript, which is switched off or failed to start. The numbers below need none."
_MOST_LOST = 20


@cache
def study_program() -> str:
    """The program of a study's page as ``tools/web.py`` built it."""
    return files("tmodes.report").joinpath("web/study.js").read_text(encoding="utf-8")


def packed_report(html: str) -> str:
    """A report's document as text that a page can hold."""
    return base64.b64encode(gzip.compress(html.encode(), 6, mtime=0)).decode()


def study_document(
    title: str, lead: str, rows: Rows, info: Mapping[str, ColumnInfo], data: Mapping[str, Any],
    provenance: Sequence[Sequence[str]], sentence: str, chosen: Markup | None = None,
) -> str:  # fmt: skip
    """The whole page. ``data``: of :func:`tmodes.study.page.data.page_data`; ``provenance``: rows of words.

    ``sentence``: the result in words; ``chosen``: of an optimization, the best design as a table.
    """
    styles = Markup(files("tmodes.report").joinpath("study.css").read_text(encoding="utf-8"))
    heading = tag("header", tag("h1", title), tag("p", lead, class_="lead"), class_="top")
    place = tag("section", tag("h2", "Charts", class_="offscreen"),
                tag("noscript", tag("p", _NEEDS, class_="status warning")), tag("div", id="tmodes-study"),
                id="charts", aria_label="Charts")  # fmt: skip
    script = Markup(
        tag("script", Markup(embedded(pack(data))), type="text/plain", id="tmodes-data")
        + tag("script", Markup(study_program()))
    )
    lost = "Designs beyond a limit" if data["designs"] else "Cases that did not finish"
    numbers = tag("section", tag("h2", "Numbers"), _statistics(rows, info), _lost(rows, info, lost), id="numbers")
    about = tag("section", tag("h2", "Provenance"), table("How it was made", ("What", "Value"), provenance),
                id="provenance")  # fmt: skip
    sections = {"charts": "Charts", "numbers": "Numbers", "provenance": "Provenance"}
    return document(
        title, policy(study_program()), sections, Markup(tag("style", styles)), heading,
        _status(rows, sentence, "good" if chosen else "warning"), chosen or Markup(),
        place, script, numbers, about,
    )  # fmt: skip


def _status(rows: Rows, sentence: str, lost: str) -> Markup:
    """What was found, in a sentence; where cases were lost of the class ``lost``."""
    good = int(rows.good.sum())
    if good:
        return tag("p", sentence, class_=f"status {'neutral' if good == len(rows) else lost}")
    return tag("p", sentence, class_="status bad", role="alert")


def _statistics(rows: Rows, info: Mapping[str, ColumnInfo]) -> Markup:
    head = ("Quantity", "Unit", "Cases", "Mean", "Deviation", *(f"{share} %" for share in PERCENTS), "Least", "Largest")
    lines = []
    for name, values in rows.quantities.items():
        finite = values[np.isfinite(values)]
        numbers = (
            [finite.mean(), finite.std(), *np.percentile(finite, PERCENTS), finite.min(), finite.max()]
            if len(finite)
            else []
        )
        shown = info.get(name)
        words = [(shown.title if shown else "") or name, rows.units.get(name, "-"), f"{len(finite)}"]
        lines.append([*words, *([f"{number:.5g}" for number in numbers] or ["–"] * (len(PERCENTS) + 4))])
    return table("Quantities over all cases", head, lines, numeric=range(2, len(head)))


def _lost(rows: Rows, info: Mapping[str, ColumnInfo], what: str) -> Markup | None:
    lost = np.flatnonzero(~rows.good)
    if not len(lost):
        return None
    labels = {name: info[name].labels if name in info else () for name in rows.parameters}
    lines = [
        [
            str(rows.case[k]),
            *(labels[name][int(own[k])] if labels[name] else f"{own[k]:.6g}" for name, own in rows.parameters.items()),
            rows.status[k],
            rows.reason[k],
        ]
        for k in lost[:_MOST_LOST].tolist()
    ]
    more = f", the first {_MOST_LOST} of {len(lost)}" if len(lost) > _MOST_LOST else ""
    return table(f"{what}{more}", ("Case", *rows.parameters, "Ended", "Reason"), lines)


Progress = Callable[[str, float], None]

_NO_MOTION = "Nothing is simulated in this study: its quantities are at rest, or formulas of its parameters."


def write_page(
    result: StudyResult,
    path: Path | str,
    *,
    progress: Progress = lambda stage, share: None,
    sentence: str = "",
    **found: Any,
) -> Path:
    """Write a study as one self-contained HTML file.

    ``sentence``, and ``found``: what an analysis says and adds, as :func:`tmodes.study.page.data.page_data` takes it:
    ``answers``, ``indices``. Raises :class:`tmodes.errors.ResultFileError` when the file cannot be written.
    """
    study, rows = result.study, result.shown_rows
    settings = _settings(study)
    info = _columns(study, rows, settings)
    report, reason = _report(study, settings, progress)
    data = _shown(result, rows, info, progress, report=report, no_report=reason, **found)
    said, about = sentence or result.sentence, _provenance(result, rows)
    text = study_document(study.sheet.name, study.sheet.title, rows, info, data, about, said)
    with atomic_write(path) as temporary:
        temporary.write_text(text, encoding="utf-8", newline="\n")
    return Path(path)


def shown_data(result: StudyResult, progress: Progress, *, bands: bool = True, **found: Any) -> dict[str, Any]:
    """The data of the page, without a report, ``bands``: with the motion of the tip; ``found`` as of `write_page`."""
    rows = result.shown_rows
    return _shown(result, rows, _columns(result.study, rows, {}), progress, motion=bands, **found)


def _shown(
    result: StudyResult,
    rows: Rows,
    info: Mapping[str, ColumnInfo],
    progress: Progress,
    *,
    motion: bool = True,
    **more: Any,
) -> dict[str, Any]:
    """The data of the page; the motion of the tip only where cases come as often as their distributions say."""
    study = result.study
    drawn = study.sheet.plan.draws
    bands = tip_bands(study, rows, progress) if drawn and motion else []
    more = {"answers": result.answers} | more
    return page_data(study.sheet.name, rows, info, labels=result.design.labels, bands=bands, drawn=drawn, **more)


def _settings(study: Study) -> dict[str, Setting]:
    """The settings of a live report by the names of parameters, of those that have one."""
    found = {}
    for name, one in study.sheet.parameters.items():
        if study.robot is not None and one.path and one.distribution:
            setting = setting_of(study.robot, one.path, one.distribution.ends, relative=one.relative)
            if setting is not None:
                found[name] = setting
    return found


def _columns(study: Study, rows: Rows, settings: Mapping[str, Setting]) -> dict[str, ColumnInfo]:
    nominal = dict(zip(study.names, study.space.nominal.tolist(), strict=True))
    found = {}
    for name, one in study.sheet.parameters.items():
        labels, setting = study.choice_names(name), settings.get(name)
        found[name] = ColumnInfo(
            one.title, study.parameter_units[name], labels, None if labels else nominal[name],
            setting.path if setting else None, setting.factor if setting else 1.0,
        )  # fmt: skip
    return found | {name: ColumnInfo(one.title, rows.units[name]) for name, one in study.sheet.quantities.items()}


def _report(study: Study, settings: Mapping[str, Setting], progress: Progress) -> tuple[str, str]:
    """The report of the sheet's own run, packed, with settings for what the study varies; or why there is none."""
    needs = study.needs
    if study.robot is None or not (needs.reductions or needs.result):
        return "", _NO_MOTION
    moved = [name for name, one in study.sheet.parameters.items() if one.path]
    lost = [name for name in study.names if name not in settings and (name not in moved or study.choices.get(name))]
    try:
        done = run(study.robot, progress=lambda stage, share: progress("report", share))
        text = page(done, ahead=ahead_of(settings))
    except TmodesError as error:
        return "", f"The sheet's own run has no report: {error}"
    if not done.success:
        return "", f"The sheet's own run has no report: {done.message}"
    note = f"The report cannot change {', '.join(lost)}: these stay as in the sheet." if lost else ""
    return packed_report(text), note


def _provenance(result: StudyResult, rows: Rows) -> list[list[str]]:
    study = result.study
    plan = study.sheet.plan.model_dump(mode="json", exclude_none=True)
    words = ", ".join(f"{key} {value}" for key, value in plan.items() if not isinstance(value, (list, dict)))
    methods = ", ".join(sorted({method for method in rows.method if method})) or "nothing simulated"
    return [
        ["robot", "none" if study.robot is None else study.robot.name],
        ["plan", words],
        ["cases", f"{len(rows):,}"],
        ["integrators", methods],
        ["seconds of computing, summed over cases", f"{float(rows.seconds.sum()):.3g} s"],
        ["engine", str(result.stored.engine)],
    ]
