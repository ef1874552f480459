"""The page about a run: how it ended, the headline numbers, the figures, the robot, and the provenance."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmodes.io.atomic import atomic_write
from tmodes.plot import FIGURES, drawings, left_out
from tmodes.report.data import facts_of, live_page
from tmodes.report.facts import fact_list
from tmodes.report.markup import Markup, table, tag
from tmodes.report.numbers import deformations_table, error_table, frequency_tables, joints_table, links_table
from tmodes.report.parts import SECTIONS, document, figures_section, rows_of, section, status, title_of, warnings
from tmodes.report.viewer import application, policy

if TYPE_CHECKING:
    from tmodes.plot.save import Drawing
    from tmodes.result import Result
    from tmodes.sheet import Robot

__all__ = ["page", "write_report"]

_MOST_MODES = 12
"""Frequencies that are shown of each case, the lowest ones."""

_LONG_SHEET = 120
"""Lines of a data sheet beyond which it is folded."""


def page(result: Result, figures: Mapping[str, Drawing], *, live: bool = True) -> str:
    """The whole page as one HTML document; ``figures`` by name, in the order of the page.

    ``live``: whether it holds the robot's equations, to be simulated again in the page.
    """
    arm = result.robot
    return document(
        title_of(result, arm.name),
        policy(),
        SECTIONS,
        _header(result, arm),
        status(result),
        warnings(result),
        application(live_page(result, live=live)),
        _numbers(result),
        figures_section(figures, FIGURES, left_out(result)),
        section("robot", *_sheet(arm)),
        _provenance(result, arm),
    )


def _header(result: Result, arm: Robot) -> Markup:
    data = result.data
    space = "in contact with a surface" if "contact_force" in data else "in free space"
    bending = sum(link.beam is not None and link.beam.coordinate_count > 0 for link in arm.links)
    driven = len(data["drive"]) if "drive" in data.dims else 0
    counts = ", ".join(_count(*one) for one in ((driven, "driven joint"), (bending, "elastic link")))
    size, end = _count(len(data["coordinate"]), "coordinate"), float(data["time"][-1])
    info = f"{counts}, {size}; {space}, {end:g} s simulated"
    return tag("header", tag("h1", arm.name), tag("p", arm.title, class_="lead"), tag("p", info), class_="top")


def _count(number: int, thing: str) -> str:
    return f"{number or 'no'} {thing}{'' if number == 1 else 's'}"


def _numbers(result: Result) -> Markup:
    info = result.summary()
    where = "about the equilibrium under gravity and loads"
    note = f"The lowest frequencies {where}: under control as in this run, with motors locked, and with motors free."
    return section(
        "numbers",
        tag("div", fact_list(facts_of(result)), class_="unprogrammed"),
        *_titled("Joints", joints_table(info["joints"])),
        *_titled("Elastic links", links_table(info["links"])),
        *_titled("Elastic coordinates", deformations_table(info["deformations"])),
        tag("h3", "Frequencies"),
        tag("p", note, class_="note"),
        frequency_tables(_lowest(result.frequencies)),
        tag("h3", "Error of the integration"),
        error_table(info["error"]),
    )


def _titled(title: str, content: Markup | None) -> tuple[Markup | None, Markup | None]:
    return (tag("h3", title), content) if content else (None, None)


def _lowest(frequencies: dict[str, list[dict[str, Any]]]) -> dict[str, list[dict[str, Any]]]:
    return {
        case: sorted(modes, key=lambda mode: mode["frequency_Hz"])[:_MOST_MODES] for case, modes in frequencies.items()
    }


def _sheet(arm: Robot) -> tuple[Markup | None, ...]:
    """The data sheet as it can be run again, and how the actual robot differs."""
    from tmodes.io.sheet_write import robot_to_yaml

    factors = [[path, f"{factor:g}"] for path, factor in arm.real.items()]
    real = table("The actual robot, where it differs", ("Number", "Factor on the nominal value"), factors, numeric=(1,))
    note = "The data sheet as a file that runs again; comments give symbol, unit and meaning"
    text = robot_to_yaml(arm)
    sheet = tag("div", tag("pre", tag("code", text)), class_="scroll", role="region", tabindex="0", aria_label="Sheet")
    place = tag("details", tag("summary", note), sheet, open=text.count("\n") <= _LONG_SHEET)
    return tag("p", f"Assumed: {arm.assumed}") if arm.assumed else None, real if factors else None, place


def _provenance(result: Result, arm: Robot) -> Markup:
    attributes = result.data.attrs
    method = {"method": attributes["method"]}
    return section(
        "provenance",
        tag("p", arm.citation),
        tag(
            "div",
            table("Integration", ("What", "Value"), [*rows_of(method), *rows_of(result.statistics)], numeric=(1,)),
            table("Versions", ("Program", "Version"), list(rows_of(json.loads(attributes["versions"])))),
            class_="columns",
        ),
    )


def write_report(
    result: Result, path: Path | str, figures: Mapping[str, Drawing] | None = None, *, live: bool = True
) -> Path:
    """Write the result's report as one self-contained HTML file; the same result gives the same bytes.

    ``figures`` are drawings from :func:`tmodes.plot.drawings` (all, or a part of them), None draws them
    all. Raises :class:`tmodes.errors.ResultFileError` when the file cannot be written.
    ``live``: with the robot's equations.
    """
    text = page(result, drawings(result) if figures is None else figures, live=live)
    with atomic_write(path) as temporary:
        temporary.write_text(text, encoding="utf-8", newline="\n")
    return Path(path)
