"""A page of charts: what was found in a sentence, charts, tables that need no program, and files to download."""

from __future__ import annotations

import base64
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from tmodes.io.atomic import atomic_write
from tmodes.io.printed import Table
from tmodes.report.markup import Markup, table, tag
from tmodes.report.pack import embedded, pack
from tmodes.report.parts import document, policy

__all__ = ["Axis", "Curve", "Page", "Plot", "plots_document", "write_plots"]

_NEEDS = "The charts need JavaScript, which is switched off or failed to start. The numbers below need none."
_SECTIONS = {"charts": "Charts", "numbers": "Numbers", "provenance": "Provenance"}


@dataclass(frozen=True)
class Axis:
    """``scale``: ``linear``, ``log``, or ``asinh``, logarithmic beyond ``bend`` to both sides; ``names`` of rows."""

    label: str
    scale: str = "linear"
    bend: float = 1.0
    names: Sequence[str] | None = None
    range: tuple[float, float] | None = None


@dataclass(frozen=True)
class Curve:
    """Points ``x``, ``y`` (n,) as ``kind``: ``line``, ``band`` (its outline), ``dots``, or a mark.

    Marks: ``circle``, ``square``, ``triangle``, ``ring``, ``cross``; ``colour``: a name of the palette.
    """

    name: str
    x: ArrayLike
    y: ArrayLike
    kind: str = "line"
    colour: str = "blue"
    dash: Sequence[float] = ()

    @property
    def data(self) -> dict[str, Any]:
        """As ``web/src/plots/contract.ts`` has it."""
        values = {key: np.asarray(getattr(self, key), dtype=np.float64) for key in ("x", "y")}
        own = {"name": self.name, "kind": self.kind, "colour": self.colour, "dash": list(self.dash)}
        return own | values


@dataclass(frozen=True)
class Plot:
    """A chart of ``curves``; ``height`` in pixels; ``equal``: one unit is as long in both directions."""

    title: str
    x: Axis
    y: Axis
    curves: Sequence[Curve]
    note: str = ""
    height: int = 300
    equal: bool = False

    @property
    def data(self) -> dict[str, Any]:
        """As ``web/src/plots/contract.ts`` has it."""
        axes = {key: asdict(getattr(self, key)) for key in ("x", "y")}
        own = {key: getattr(self, key) for key in ("title", "note", "height", "equal")}
        return own | axes | {"curves": [one.data for one in self.curves]}


@dataclass(frozen=True)
class Page:
    """What a page of charts says and shows.

    ``sentence``: what was found, ``level`` its look (``good``, ``neutral``, ``warning``, ``bad``); ``parts``: sentences
    and tables as they are printed; ``links``: addresses of first cells, by their texts; ``downloads``: files by name.
    """

    title: str
    lead: str
    sentence: str
    plots: Sequence[Plot]
    parts: Iterable[str | Table]
    level: str = "neutral"
    warnings: Sequence[str] = ()
    notes: Sequence[str] = ()
    links: Mapping[str, str] | None = None
    downloads: Mapping[str, str] | None = None
    provenance: Sequence[Sequence[str]] = ()


@cache
def _program() -> str:
    return files("tmodes.report").joinpath("web/plots.js").read_text(encoding="utf-8")


def plots_document(page: Page) -> str:
    """The whole page as one HTML document."""
    style = Markup(files("tmodes.report").joinpath("study.css").read_text(encoding="utf-8"))
    heading = tag("header", tag("h1", page.title), tag("p", page.lead, class_="lead"), class_="top")
    said = tag("p", page.sentence, class_=f"status {page.level}")
    warned = tag("div", tag("ul", *(tag("li", one) for one in page.warnings)), class_="status warning", role="note")
    charts = tag("section", tag("h2", "Charts", class_="offscreen"),
                 tag("noscript", tag("p", _NEEDS, class_="status warning")), tag("div", id="tmodes-plots"),
                 id="charts", aria_label="Charts")  # fmt: skip
    data = tag("script", Markup(embedded(pack({"plots": [one.data for one in page.plots]}))), type="text/plain",
               id="tmodes-data")  # fmt: skip
    saved = [tag("a", name, href=_inside(content), download=name) for name, content in (page.downloads or {}).items()]
    numbers = tag("section", tag("h2", "Numbers"), *(_part(one, page.links or {}) for one in page.parts),
                  *(tag("p", one, class_="note") for one in page.notes),
                  tag("p", "Download: ", *saved) if saved else None, id="numbers")  # fmt: skip
    about = tag("section", tag("h2", "Provenance"), table("How it was made", ("What", "Value"), page.provenance),
                id="provenance")  # fmt: skip
    return document(
        page.title, policy(_program()), _SECTIONS, tag("style", style), heading, said,
        warned if page.warnings else None, charts, data, tag("script", Markup(_program())), numbers, about,
    )  # fmt: skip


def _inside(content: str) -> str:
    return f"data:application/json;base64,{base64.b64encode(content.encode()).decode()}"


def _part(part: str | Table, links: Mapping[str, str]) -> Markup:
    """A sentence, or a table whose first cells are links where there are addresses for them."""
    if isinstance(part, str):
        return tag("p", part)
    rows = [[tag("a", row[0], href=links[row[0]]) if row[0] in links else row[0], *row[1:]] for row in part.rows]
    numeric = [k for k in range(len(part.columns)) if all(_is_number(row[k]) for row in part.rows)]
    return table(part.title or ", ".join(part.columns), part.columns, rows, numeric)


def _is_number(text: str) -> bool:
    return (", " not in text and text.lstrip("-−+×÷.")[:1].isdigit()) or text == "-"


def write_plots(page: Page, path: Path | str) -> Path:
    """Write it as one self-contained file; raises :class:`tmodes.errors.ResultFileError` where that fails."""
    text = plots_document(page)
    with atomic_write(path) as temporary:
        temporary.write_text(text, encoding="utf-8", newline="\n")
    return Path(path)
