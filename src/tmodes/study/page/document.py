"""The page of a study as one HTML document: its result in a sentence, tables without a program, and the charts."""

from __future__ import annotations

import base64
import gzip
import hashlib
from collections.abc import Mapping, Sequence
from functools import cache
from importlib.resources import files
from typing import Any

import numpy as np

from tmodes.report.markup import Markup, table, tag
from tmodes.report.pack import embedded, pack
from tmodes.report.parts import document, program
from tmodes.study.page.data import PERCENTS, ColumnInfo
from tmodes.study.rows import Rows

__all__ = ["packed_report", "study_document"]

_NEEDS = "The charts need JavaScript, which is switched off or failed to start. The numbers below need none."
_MOST_LOST = 20


@cache
def study_program() -> str:
    """The program of a study's page as ``tools/web.py`` built it."""
    return files("tmodes.report").joinpath("web/study.js").read_text(encoding="utf-8")


def _policy() -> str:
    """It may run its own program, and open a report, which runs the viewer's; it asks for nothing at all."""
    digests = [
        f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"
        for text in (study_program(), program())
    ]
    return (
        f"default-src 'none'; script-src {' '.join(digests)} 'wasm-unsafe-eval'; style-src 'unsafe-inline'; "
        "img-src data: blob:; worker-src blob:; connect-src 'none'; base-uri 'none'; form-action 'none'"
    )


def packed_report(html: str) -> str:
    """A report's document as text that a page can hold."""
    return base64.b64encode(gzip.compress(html.encode(), 6, mtime=0)).decode()


def study_document(
    title: str, lead: str, rows: Rows, info: Mapping[str, ColumnInfo], data: Mapping[str, Any],
    provenance: Sequence[Sequence[str]], sentence: str = "",
) -> str:  # fmt: skip
    """The whole page. ``data``: of :func:`tmodes.study.page.data.page_data`; ``provenance``: rows of words.

    ``sentence``: the result in words, where it is not the median and the range of the first quantity.
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
    numbers = tag("section", tag("h2", "Numbers"), _statistics(rows, info), _lost(rows), id="numbers")
    about = tag("section", tag("h2", "Provenance"), table("How it was made", ("What", "Value"), provenance),
                id="provenance")  # fmt: skip
    sections = {"charts": "Charts", "numbers": "Numbers", "provenance": "Provenance"}
    return document(
        title, _policy(), sections, Markup(tag("style", styles)), heading, *_status(rows, info, sentence), place,
        script, numbers, about,
    )  # fmt: skip


def _status(rows: Rows, info: Mapping[str, ColumnInfo], sentence: str) -> list[Markup]:
    """The study in a sentence: how many cases ended well, and the first quantity's median and 95 % range."""
    good = int(rows.good.sum())
    if sentence:
        return [tag("p", sentence, class_="status good" if good else "status bad")]
    name, values = next(iter(rows.quantities.items()))
    finite = values[rows.good & np.isfinite(values)]
    words = f"{good:,} of {len(rows):,} cases finished."
    if len(finite):
        shown = info.get(name)
        unit = "" if rows.units.get(name, "-") == "-" else f" {rows.units[name]}"
        middle, most = np.percentile(finite, [50, 95])
        title = (shown.title if shown else "") or name
        middle, most = f"{middle:.4g}{unit}", f"{most:.4g}{unit}"
        words += f" {title[:1].upper()}{title[1:]}: median {middle}, 95 % of all cases stay below {most}."
    found = [tag("p", words, class_="status good" if good == len(rows) else "status warning")]
    return found if good else [tag("p", words, class_="status bad", role="alert")]


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


def _lost(rows: Rows) -> Markup | None:
    lost = np.flatnonzero(~rows.good)
    if not len(lost):
        return None
    lines = [
        [
            str(rows.case[k]),
            *(f"{values[k]:.6g}" for values in rows.parameters.values()),
            rows.status[k],
            rows.reason[k],
        ]
        for k in lost[:_MOST_LOST].tolist()
    ]
    more = f", the first {_MOST_LOST} of {len(lost)}" if len(lost) > _MOST_LOST else ""
    return table(f"Cases that did not finish{more}", ("Case", *rows.parameters, "Ended", "Reason"), lines)
