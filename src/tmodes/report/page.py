"""The page: how the run ended, the first numbers, the figures, the robot, and where it all came from."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, cast

from tmodes.plot.paper.figures import FIGURES, left_out
from tmodes.report.data import facts_of, live_page
from tmodes.report.facts import fact_list
from tmodes.report.markup import Markup, tag
from tmodes.report.numbers import deformation_table, error_table, frequency_tables
from tmodes.report.parts import SECTIONS, document, figures_section, rows_of, section, status, title_of, warnings
from tmodes.report.sheet import data_sheet
from tmodes.report.tables import table
from tmodes.report.viewer import application, policy

if TYPE_CHECKING:
    from tmodes.plot.save import Drawing
    from tmodes.result.record import PaperResult

__all__ = ["page"]


def page(result: PaperResult, figures: Mapping[str, Drawing], *, live: bool = True) -> str:
    """The whole page as one HTML document; ``figures`` by name, in the order of the page.

    ``live``: whether it holds the robot's equations, to be simulated anew in the page.
    """
    sheet = json.loads(result.data.attrs["robot"])
    name = str(sheet.get("name") or "robot")
    return document(
        title_of(result, name),
        policy(),
        SECTIONS,
        _header(result, sheet, name),
        status(result),
        warnings(result),
        application(live_page(result, live=live)),
        _numbers(result),
        figures_section(figures, cast("Any", FIGURES), left_out(result)),
        section("robot", data_sheet(sheet, json.loads(result.data.attrs["parameters"]))),
        _provenance(result, sheet),
    )


def _header(result: PaperResult, sheet: Mapping[str, Any], name: str) -> Markup:
    space = "in contact with the environment" if "contact_force" in result.data else "in free space"
    span = f"{float(result.data['time'][-1]):g} s simulated"
    info = f"Reading “{result.data.attrs['reading']}”, {space}, {span}"
    return tag(
        "header", tag("h1", name), tag("p", str(sheet.get("title", "")), class_="lead"), tag("p", info), class_="top"
    )


def _numbers(result: PaperResult) -> Markup:
    info = result.summary()
    note = "Frequencies in free space, about the rest under gravity: under control as in this run, with the motor "
    note += "held still, and with the motor free to turn."
    return section(
        "numbers",
        tag("div", fact_list(facts_of(result)), class_="unprogrammed"),
        tag("h3", "Frequencies"),
        tag("p", note, class_="note"),
        frequency_tables(result.frequencies),
        tag("h3", "Elastic angles"),
        deformation_table(info["deformations"]),
        tag("h3", "Error of the integration"),
        error_table(info["error"]),
    )


def _provenance(result: PaperResult, sheet: Mapping[str, Any]) -> Markup:
    attributes = result.data.attrs
    versions = json.loads(attributes["versions"])
    equations = {key: attributes[key] for key in ("reading", "mechanism")}
    return section(
        "provenance",
        tag("p", str(sheet.get("citation", ""))),
        tag(
            "div",
            table("Equations", ("What", "Value"), list(rows_of(equations))),
            table("Integration", ("What", "Value"), list(rows_of(result.statistics)), numeric=(1,)),
            table("Versions", ("Program", "Version"), list(rows_of(versions))),
            class_="columns",
        ),
    )
