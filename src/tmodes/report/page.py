"""The page about a run: how it ended, headline numbers and tables, the robot, and the provenance."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from tmodes.io.arguments import checked_arguments
from tmodes.io.atomic import atomic_write
from tmodes.live.knobs import Ahead
from tmodes.live.map import Progress
from tmodes.plot.units import pretty
from tmodes.report.data import facts_of, live_page
from tmodes.report.facts import fact_list
from tmodes.report.markup import Markup, power_of_ten, table, tag, written
from tmodes.report.parts import SECTIONS, application, document, policy, rows_of, section, status, title_of, warnings
from tmodes.result import Result
from tmodes.result.events import counted
from tmodes.sheet import Robot

__all__ = ["error_table", "frequency_tables", "page", "summary_tables", "write_report"]


_MOST_MODES = 12
"""Frequencies that are shown of each case, the lowest ones."""

_LONG_SHEET = 120
"""Lines of a data sheet beyond which it is folded."""


def page(
    result: Result,
    *,
    live: bool = True,
    spent: Mapping[str, Sequence[float]] | None = None,
    ahead: Ahead | None = None,
    progress: Progress = lambda stage, share: None,
) -> str:
    """The whole page as one HTML document.

    ``live``: whether it holds the robot's equations, to be simulated again in the page; ``spent``: wall and processor
    time [s] by stage; ``ahead``: numbers whose sliders come first; ``progress``: is given ``report`` and its share.
    """
    robot = result.robot
    return document(
        title_of(result, robot.name),
        policy(),
        SECTIONS,
        _header(result, robot),
        status(result),
        warnings(result),
        application(live_page(result, live=live, ahead=ahead, progress=progress)),
        _numbers(result),
        section("robot", *_sheet(robot)),
        _provenance(result, robot, spent or {}),
    )


def _header(result: Result, robot: Robot) -> Markup:
    data = result.record
    space = "in contact with a surface" if "contact_force" in data else "in free space"
    bending = sum(link.beam is not None and link.beam.coordinate_count > 0 for link in robot.links)
    driven = len(robot.drives)
    counts = ", ".join(_count(*one) for one in ((driven, "driven joint"), (bending, "elastic link")))
    size, end = _count(len(data["coordinate"]), "coordinate"), float(data["time"][-1])
    info = f"{counts}, {size}; {space}, {end:g} s simulated"
    return tag("header", tag("h1", robot.name), tag("p", robot.title, class_="lead"), tag("p", info), class_="top")


def _count(number: int, thing: str) -> str:
    return f"{number or 'no'} {thing}{'' if number == 1 else 's'}"


def _numbers(result: Result) -> Markup:
    info = result.summary()
    where = "about the equilibrium under gravity and loads"
    note = (
        f"The lowest frequencies {where}: under control as in this run, with motors locked, and with motors free. "
        "All are of the pole p, an eigenvalue of mass, damping, stiffness and controllers: natural |p|/2π, damped "
        "Im p/2π, damping −Re p/|p|. Over-damped modes have two real poles, each with a time constant −1/p."
    )
    return section(
        "numbers",
        tag("div", fact_list(facts_of(result)), class_="unprogrammed"),
        *summary_tables(info),
        tag("h3", "Frequencies"),
        tag("p", note, class_="note"),
        frequency_tables(result.frequencies),
        tag("h3", "Errors"),
        error_table(info["error"], info["model_error"]),
    )


def _sheet(robot: Robot) -> tuple[Markup | None, ...]:
    """The data sheet as it can be run again, and how the actual robot differs."""
    from tmodes.io.sheet_write import robot_to_yaml

    factors = [[path, f"{factor:g}"] for path, factor in robot.real.items()]
    real = table("The actual robot, where it differs", ("Number", "Factor on the nominal value"), factors, numeric=(1,))
    note = "The data sheet as a file that runs again; comments give symbol, unit and meaning"
    text = robot_to_yaml(robot)
    sheet = tag("div", tag("pre", tag("code", text)), class_="scroll", role="region", tabindex="0", aria_label="Sheet")
    place = tag("details", tag("summary", note), sheet, open=text.count("\n") <= _LONG_SHEET)
    return tag("p", f"Assumed: {robot.assumed}") if robot.assumed else None, real if factors else None, place


def _provenance(result: Result, robot: Robot, spent: Mapping[str, Sequence[float]]) -> Markup:
    attributes = result.record.attrs
    method = {"method": attributes["method"], "end": result.message}
    method |= {"events": counted(result.events)} if result.events else {}
    times = [[stage, *(f"{time:.2f}" for time in each)] for stage, each in spent.items()]
    return section(
        "provenance",
        tag("p", robot.citation),
        tag(
            "div",
            table("Integration", ("What", "Value"), [*rows_of(method), *rows_of(result.statistics)]),
            table("Versions", ("Program", "Version"), list(rows_of(json.loads(attributes["versions"])))),
            table("Where the time went", ("Stage", "Wall [s]", "Processor [s]"), times, numeric=(1, 2))
            if times
            else None,
            class_="columns",
        ),
    )


@checked_arguments
def write_report(
    result: Result,
    path: Path | str,
    *,
    live: bool = True,
    spent: Mapping[str, Sequence[float]] | None = None,
    progress: Progress = lambda stage, share: None,
) -> Path:
    """Write the result's report as one self-contained HTML file; the same result gives the same bytes.

    ``live``: with the robot's equations; ``spent``: with wall and processor time [s] by stage; ``progress``: is given
    ``report`` and its share, and may raise, upon which nothing is written.
    Raises :class:`tmodes.errors.ResultFileError` when the file cannot be written.
    """
    text = page(result, live=live, spent=spent, progress=progress)
    with atomic_write(path) as temporary:
        temporary.write_text(text, encoding="utf-8", newline="\n")
    return Path(path)


CASES = {"controlled": "Controlled", "locked": "Motors locked", "free": "Motors free"}

_FREQUENCY_HEAD = ("natural [Hz]", "damped [Hz]", "damping [%]", "dominant element")
_MOST_ROWS = 30
_SI = {"m": "m", "N": "N", "Nm": "N m", "Pa": "Pa"}
_ROUNDING = 1e-12
"""A position [rad, m] that is as good as zero."""


def frequency_tables(frequencies: dict[str, list[dict[str, Any]]]) -> Markup:
    """Frequencies and damping ratios of the poles, and the dominant elements, of the lowest modes of each case."""
    tables = []
    for case, words in CASES.items():
        modes = sorted(frequencies.get(case, []), key=lambda mode: (bool(_decay(mode)), mode["frequency_Hz"]))
        rows = [_frequency_row(mode) for mode in modes[:_MOST_MODES]]
        if rows:
            tables.append(table(words, _FREQUENCY_HEAD, rows, numeric=(0, 1, 2)))
    return tag("div", *tables)


def _decay(mode: dict[str, Any]) -> float | None:
    """Time constant [s] of an over-damped mode; files of earlier versions have none."""
    return mode.get("time_constant_s")


def _frequency_row(mode: dict[str, Any]) -> list[str]:
    damped, decay = mode["damped_frequency_Hz"], _decay(mode)
    if decay:
        return ["–", "–", f"decays in {written(decay, 's')}", str(mode["element"])]
    ringing = "–" if damped is None else f"{damped:.4g}"
    return [f"{mode['frequency_Hz']:.4g}", ringing, f"{100 * mode['damping_ratio']:.3g}", str(mode["element"])]


def error_table(info: dict[str, Any] | None, model: dict[str, Any] | None = None) -> Markup:
    """The estimated errors of the integration and of the link models in each number of the summary, where known."""
    if info is None or not info["how"]:
        why = f": {info['why']}" if info else "."
        return tag("p", f"The error of the integration was not estimated{why}", class_="note")
    figures = info["figures"].items()
    rows = [_error_row(name, value, "≈" if name in info["approximate"] else "<") for name, value in figures]
    head, how = ["Number", "Error [SI]"], f"Error of the integration, by {info['how']}"
    if model and not model["how"]:
        how = f"{how}; of the link models not estimated: {model['why']}"
    elif model:
        head, how = [*head, "Of the link models [SI]"], f"{how}; of the link models, by a {model['how']}"
        bounds = [model["figures"].get(name) for name in info["figures"]]
        rows = [[*row, "–" if b is None else _error_row(name, b, "<")[1]]
                for row, name, b in zip(rows, info["figures"], bounds, strict=True)]  # fmt: skip
    caption = f"{how}: < holds in 99 % of runs, ≈ is an estimate"
    return table(caption, tuple(head), rows, numeric=(1, 2)[: len(head) - 1])


def _error_row(name: str, value: float, sign: str) -> list[str]:
    """``links.rod.deflection.max_m`` with words and unit apart."""
    place, _, last = name.rpartition(".")
    words, _, unit = last.rpartition("_")
    words, unit = (words, pretty(_SI[unit])) if unit in _SI else (last, "")
    text = ", ".join(filter(None, [place, words])).replace("_", " ")
    return [text, f"{sign if value else ''}\u00a0{power_of_ten(value)}\u00a0{unit}".strip("\u00a0")]


def _joint_row(name: str, one: dict[str, Any]) -> list[str]:
    force, gear = "N" if one["unit"] == "m" else "N m", one["largest_gear_torque"]
    places = (f"{value if abs(value) > _ROUNDING else 0.0:.4g}" for value in (one["least"], one["largest"]))
    return [name, *places, one["unit"], written(one["fastest"], f"{one['unit']}/s"),
            written(one["largest_effort"], force), written(gear, force) if gear else "–"]  # fmt: skip


def _link_row(name: str, link: dict[str, Any]) -> list[str]:
    moment, stress = link["bending_moment"], link["stress"]
    where = ["–" if one is None else f"s = {one['s']:.2g}, {one['time_s']:.3g} s" for one in (moment, stress)]
    return [name, written(link["deflection"]["max_m"], "m"), written(moment["max_Nm"], "N m"), where[0],
            "not known" if stress is None else written(stress["max_Pa"], "Pa"), where[1]]  # fmt: skip


def _coordinate_row(name: str, one: dict[str, Any]) -> list[str]:
    unit, keys = "-" if one["unit"] == "1" else one["unit"], ("max_stationary", "max_oscillatory", "max_nominal")
    parts = [written(one[key], unit) if key in one else "–" for key in keys]
    return [name, written(one["max"], unit), f"{one['time_of_max_s']:.3g} s", *parts]


_TABLES: dict[str, tuple[str, str, tuple[str, ...], tuple[int, ...], Callable[[str, Any], list[str]]]] = {
    "joints": (
        "Joints", "Driven joints over the run",
        ("Joint", "Least", "Largest", "Unit", "Fastest", "Largest effort", "Largest gear torque"),
        (1, 2, 4, 5, 6), _joint_row,
    ),
    "links": (
        "Elastic links", "Largest values over the run",
        ("Link", "Deflection of its end", "Bending moment", "where", "Stress", "where"), (1, 2, 4), _link_row,
    ),
    "deformations": (
        "Elastic coordinates", "Elastic coordinates over the run",
        ("Coordinate", "Largest", "at", "Static part", "Dynamic part", "Nominal"), (1, 2, 3, 4, 5), _coordinate_row,
    ),
}  # fmt: skip
"""By the part of a summary: title, caption, columns, the numeric ones, and a row from a name and its values."""


def summary_tables(summary: Mapping[str, Any]) -> Iterator[Markup]:
    """Titles and tables of joints, elastic links and elastic coordinates; none of what the robot does not have."""
    for part, (title, caption, head, numeric, row) in _TABLES.items():
        if info := summary[part]:
            rows = [row(name, one) for name, one in list(info.items())[:_MOST_ROWS]]
            more = f", the first {_MOST_ROWS} of {len(info)}" if len(info) > _MOST_ROWS else ""
            yield tag("h3", title)
            yield table(caption + more, head, rows, numeric=numeric)
