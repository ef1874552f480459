"""Parts of a page that reports of all kinds of robots share: head, sections, status, warnings, figures, provenance."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from tmodes.report.markup import Markup, tag
from tmodes.report.picture import picture

if TYPE_CHECKING:
    from tmodes.plot import Figure
    from tmodes.plot.save import Drawing
    from tmodes.result.result import Result

__all__ = ["SECTIONS", "document", "figures_section", "rows_of", "section", "status", "title_of", "warnings"]

SECTIONS = {
    "viewer": "View", "numbers": "Numbers", "figures": "Figures for print", "robot": "Robot",
    "provenance": "Provenance",
}  # fmt: skip

_STYLES = ("page.css", "app.css")


def document(title: str, policy: str, sections: Mapping[str, str], *content: str | None) -> str:
    """The whole page as one HTML document; ``sections``: ids and names of what the navigation leads to."""
    styles = "".join(files("tmodes.report").joinpath(name).read_text(encoding="utf-8") for name in _STYLES)
    head = tag(
        "head",
        tag("meta", charset="utf-8"),
        tag("meta", http_equiv="Content-Security-Policy", content=policy),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("meta", name="color-scheme", content="light dark"),
        tag("title", f"{title} – tmodes"),
        tag("style", Markup(styles)),
    )
    main = tag("main", *content, id="main")
    skip = tag("a", "Skip to the content", href="#main", class_="skip")
    body = tag("body", skip, _navigation(sections) if sections else None, main)
    return f"<!doctype html>\n{tag('html', head, body, lang='en')}\n"


def title_of(result: Result, name: str) -> str:
    """The title of a run's page; a run that did not finish says so."""
    return name if result.success else f"{result.status.upper()}: {name}"


def section(name: str, *content: str | None) -> Markup:
    """One of SECTIONS, under its title."""
    title = f"{name}-title"
    return tag("section", tag("h2", SECTIONS[name], id=title), *content, id=name, aria_labelledby=title)


def _navigation(sections: Mapping[str, str]) -> Markup:
    links = (tag("li", tag("a", words, href=f"#{name}")) for name, words in sections.items())
    return tag("nav", tag("ul", *links), aria_label="Sections")


def status(result: Result) -> Markup:
    """How the run ended; a run that did not finish says so where no one can miss it."""
    message = result.message
    if result.success:
        ended = "Finished." if result.status == "finished" else "Ended by a stop condition."
        return tag("p", tag("strong", ended), f" {message}", class_="status good")
    data = result.data
    wanted = json.loads(data.attrs["robot"]).get("integration", {}).get("duration")
    of_wanted = f" of {wanted:g} s" if isinstance(wanted, (int, float)) else ""
    end = f"What follows ends at {float(data['time'][-1]):g} s{of_wanted} and is not a complete result."
    heading = tag("strong", f"This run did not finish: {result.status}.")
    return tag("div", heading, tag("p", message), tag("p", end), class_="status bad", role="alert")


def warnings(result: Result) -> Markup | None:
    """What the run has to say about itself; None where that is nothing."""
    if not result.warnings:
        return None
    sentences = tag("ul", *(tag("li", str(sentence)) for sentence in result.warnings))
    return tag("div", tag("strong", "Warnings"), sentences, class_="status warning", role="note")


def figures_section(figures: Mapping[str, Drawing], table: Mapping[str, Figure], left_out: Mapping[str, str]) -> Markup:
    """The figures of a table, numbered, folded until they are wanted, and why others are left out."""
    shown = [_figure(number, table[name], drawing) for number, (name, drawing) in enumerate(figures.items(), 1)]
    words = f"Show {len(shown)} figures as they stand in print"
    folded = tag("details", tag("summary", words), *shown) if shown else None
    return section("figures", folded, _left_out(table, left_out))


def _figure(number: int, entry: Figure, drawing: Drawing) -> Markup:
    shown = picture(drawing, entry.name, f"{entry.title}. {entry.caption}")
    place = tag("div", shown, class_="scroll plot", role="region", tabindex="0", aria_label=f"Figure {number}")
    caption = tag("figcaption", tag("strong", f"Figure {number}. {entry.title}."), f" {entry.caption}")
    return tag("figure", place, caption, id=entry.name)


def _left_out(table: Mapping[str, Figure], reasons: Mapping[str, str]) -> Markup | None:
    if not reasons:
        return None
    lines = (tag("li", tag("strong", f"{table[name].title}: "), reason, ".") for name, reason in reasons.items())
    return tag("div", tag("p", "Left out:"), tag("ul", *lines), class_="left-out")


def rows_of(info: Mapping[str, Any], group: str = "") -> Iterator[list[str]]:
    """Names and values; a group within the group has its name before the names in it."""
    for key, value in info.items():
        name = f"{group}{key}".replace("_", " ")
        if isinstance(value, Mapping):
            yield from rows_of(value, f"{name}: ")
        else:
            yield [name, f"{value:.6g}" if isinstance(value, float) else "–" if value is None else str(value)]
