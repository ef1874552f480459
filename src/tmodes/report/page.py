"""The page: how the run ended, the first numbers, the figures, the robot, and where it all came from."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from tmodes.plot.figures import FIGURES, left_out
from tmodes.report.markup import Markup, tag
from tmodes.report.numbers import cards, deformation_table, frequency_tables
from tmodes.report.picture import picture
from tmodes.report.sheet import data_sheet
from tmodes.report.tables import table

if TYPE_CHECKING:
    from tmodes.plot.save import Drawing
    from tmodes.result import Result

__all__ = ["page"]

POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'"
"""The page may ask for nothing at all, and run nothing."""

SECTIONS = {"numbers": "Numbers", "figures": "Figures", "robot": "Robot", "provenance": "Provenance"}


def page(result: Result, figures: Mapping[str, Drawing]) -> str:
    """The whole page as one HTML document; ``figures`` by name, in the order of the page."""
    sheet = json.loads(result.data.attrs["robot"])
    name = str(sheet.get("name") or "robot")
    ended = "" if result.success else f"{result.status.upper()}: "
    head = tag(
        "head",
        tag("meta", charset="utf-8"),
        tag("meta", http_equiv="Content-Security-Policy", content=POLICY),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("meta", name="color-scheme", content="light dark"),
        tag("title", f"{ended}{name} – tmodes"),
        tag("style", Markup(files("tmodes.report").joinpath("page.css").read_text(encoding="utf-8"))),
    )
    main = tag(
        "main",
        _header(result, sheet, name),
        _status(result),
        _warnings(result),
        _numbers(result),
        _figures(result, figures),
        _section("robot", data_sheet(sheet, json.loads(result.data.attrs["parameters"]))),
        _provenance(result, sheet),
        id="main",
    )
    body = tag("body", tag("a", "Skip to the content", href="#main", class_="skip"), _navigation(), main)
    return f"<!doctype html>\n{tag('html', head, body, lang='en')}\n"


def _section(name: str, *content: str | None) -> Markup:
    return tag(
        "section", tag("h2", SECTIONS[name], id=f"{name}-title"), *content, id=name, aria_labelledby=f"{name}-title"
    )


def _navigation() -> Markup:
    links = (tag("li", tag("a", words, href=f"#{name}")) for name, words in SECTIONS.items())
    return tag("nav", tag("ul", *links), aria_label="Sections")


def _header(result: Result, sheet: Mapping[str, Any], name: str) -> Markup:
    space = "in contact with the environment" if "contact_force" in result.data else "in free space"
    span = f"{float(result.data['time'][-1]):g} s simulated"
    told = f"Reading “{result.data.attrs['reading']}”, {space}, {span}"
    return tag("header", tag("h1", name), tag("p", str(sheet.get("title", "")), class_="lead"), tag("p", told))


def _status(result: Result) -> Markup:
    """How the run ended; a run that did not finish says so where no one can miss it."""
    message = result.message
    if result.success:
        return tag("p", tag("strong", "Finished."), f" {message}", class_="status good")
    data = result.data
    wanted = json.loads(data.attrs["robot"]).get("integration", {}).get("duration")
    of_wanted = f" of {wanted:g} s" if isinstance(wanted, (int, float)) else ""
    end = f"What follows ends at {float(data['time'][-1]):g} s{of_wanted} and is not a complete result."
    heading = tag("strong", f"This run did not finish: {result.status}.")
    return tag("div", heading, tag("p", message), tag("p", end), class_="status bad", role="alert")


def _warnings(result: Result) -> Markup | None:
    if not result.warnings:
        return None
    sentences = tag("ul", *(tag("li", str(sentence)) for sentence in result.warnings))
    return tag("div", tag("strong", "Warnings"), sentences, class_="status warning", role="note")


def _numbers(result: Result) -> Markup:
    told = result.summary()
    note = "Frequencies in free space, about the rest under gravity: under control as in this run, with the motor "
    note += "held still, and with the motor free to turn."
    return _section(
        "numbers",
        cards(told),
        tag("h3", "Frequencies"),
        tag("p", note, class_="note"),
        frequency_tables(result.frequencies),
        tag("h3", "Elastic angles"),
        deformation_table(told["deformations"]),
    )


def _figures(result: Result, figures: Mapping[str, Drawing]) -> Markup:
    shown = (_figure(number, name, drawing) for number, (name, drawing) in enumerate(figures.items(), 1))
    return _section("figures", *shown, _left_out(result))


def _figure(number: int, name: str, drawing: Drawing) -> Markup:
    entry = FIGURES[name]
    place = tag(
        "div",
        picture(drawing, name, f"{entry.title}. {entry.caption}"),
        class_="scroll plot",
        role="region",
        tabindex="0",
        aria_label=f"Figure {number}",
    )
    caption = tag("figcaption", tag("strong", f"Figure {number}. {entry.title}."), f" {entry.caption}")
    return tag("figure", place, caption, id=name)


def _left_out(result: Result) -> Markup | None:
    reasons = left_out(result)
    if not reasons:
        return None
    lines = (tag("li", tag("strong", f"{FIGURES[name].title}: "), reason, ".") for name, reason in reasons.items())
    return tag("div", tag("p", "Left out:"), tag("ul", *lines), class_="left-out")


def _provenance(result: Result, sheet: Mapping[str, Any]) -> Markup:
    attributes = result.data.attrs
    versions = json.loads(attributes["versions"])
    equations = {key: attributes[key] for key in ("reading", "mechanism")}
    return _section(
        "provenance",
        tag("p", str(sheet.get("citation", ""))),
        tag(
            "div",
            table("Equations", ("What", "Value"), list(_rows(equations))),
            table("Integration", ("What", "Value"), list(_rows(result.statistics)), numeric=(1,)),
            table("Versions", ("Program", "Version"), list(_rows(versions))),
            class_="columns",
        ),
    )


def _rows(told: Mapping[str, Any], group: str = "") -> Iterator[list[str]]:
    """Names and values; a group within the group has its name before the names in it."""
    for key, value in told.items():
        name = f"{group}{key}".replace("_", " ")
        if isinstance(value, Mapping):
            yield from _rows(value, f"{name}: ")
        else:
            yield [name, f"{value:.6g}" if isinstance(value, float) else "–" if value is None else str(value)]
