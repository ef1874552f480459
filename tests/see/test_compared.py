"""Runs side by side that have little in common: other kinds of gears, units, joints, and lengths of time."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

from patience import until
from see.looking import Window, look
from tmodes.report.data import page_data
from tmodes.report.parts import viewer_document
from tmodes.result import Result, assemble_result
from tmodes.sheet import Robot
from tmodes.simulation.simulate import simulate_motion

INERTIA = {"xx": 0.01, "yy": 0.01, "zz": 0.01}


@cache
def driven(kinds: tuple[str, ...], duration: float) -> Result:
    """A chain of joints on elastic gears, each of a kind, that moves for 0.1 s."""
    joints = [
        {"name": f"j{k}", "type": kind, "child": f"l{k}", "axis": [0, 0, 1],
         "origin": {"position": [0.4 if k else 0.0, 0, 0]},
         "gear": {"stiffness": 400.0, "damping": 0.5}, "motor": {"inertia": 0.5, "side": "joint"}}
        for k, kind in enumerate(kinds)
    ]  # fmt: skip
    bodies = [{"name": "bar", "mass": 1.0, "inertia": INERTIA, "center": [0.2, 0, 0]}]
    drives = [
        {"joint": f"j{k}", "command": "position",
         "signal": {"type": "quintic", "start": 0.0, "end": 0.1, "duration": 0.1},
         "controller": {"type": "pd", "position_gain": 300.0, "velocity_gain": 20.0}}
        for k in range(len(kinds))
    ]  # fmt: skip
    arm = Robot.from_data({
        "format": 1, "kind": "arm", "name": " and ".join(kinds), "gravity": [0, 0, 0], "joints": joints,
        "drives": drives, "links": [{"name": f"l{k}", "bodies": bodies} for k in range(len(kinds))],
        "integration": {"duration": duration, "output_step": 0.002, "line_points": 3},
    })  # fmt: skip
    return assemble_result(simulate_motion(arm), arm)


COLOURS = {"turns": "var(--blue)", "slides": "var(--red)", "both": "var(--green)"}
RUNS = {"turns": (("revolute",), 0.2), "slides": (("prismatic",), 0.3), "both": (("revolute", "prismatic"), 0.25)}


@pytest.fixture(scope="module")
def info() -> dict[str, Any]:
    return page_data([driven(*how) for how in RUNS.values()], list(RUNS))


@pytest.fixture(scope="module")
def window(browser: Any, info: dict[str, Any], tmp_path_factory: pytest.TempPathFactory) -> Window:
    path = tmp_path_factory.mktemp("compared") / "mixed.html"
    path.write_text(viewer_document(info), encoding="utf-8")
    return look(browser, path, (1280, 1000))


def value(window: Window, chart: str, name: str) -> str:
    """What the legend of a chart shows of a run at the page's time."""
    rows = window.page.locator(f"[data-chart='{chart}'] .legend-row").first.locator(".toggle, .key")
    (found,) = [one for one in rows.all() if one.inner_text().split("\n")[0].strip() == name]
    return found.locator(".value").inner_text().partition("\u00a0")[0]


def test_charts_of_one_name_are_of_one_unit(info: dict[str, Any]) -> None:
    """Angles and lengths never share an axis; what all runs have, they share."""
    units: dict[str, set[str]] = {}
    known: dict[str, int] = {}
    for chart in (chart for run in info["runs"] for chart in run["charts"]):
        units.setdefault(chart["id"], set()).add(chart["unit"])
        known[chart["id"]] = known.get(chart["id"], 0) + 1
    assert all(len(found) == 1 for found in units.values())
    assert known["tip_deviation"] == 3
    turning = [name for name in known if name.startswith("joint_rad")]
    sliding = [name for name in known if name.startswith("joint_m")]
    assert [known[name] for name in turning + sliding] == [2, 2]
    assert {next(iter(units[name])) for name in turning} <= {"rad", "mrad"}
    assert {next(iter(units[name])) for name in sliding} <= {"m", "mm"}


def test_numbers_of_one_name_keep_their_own_units(window: Window, info: dict[str, Any]) -> None:
    cells = window.page.locator("[data-fact='gear.max'] td").all_inner_texts()
    facts = [{fact["id"]: fact for fact in run["facts"]}["gear.max"] for run in info["runs"]]
    assert [fact["unit"] for fact in facts] == ["rad", "m", "rad"]
    assert [cell.split()[-1].lstrip("mµ") for cell in cells] == ["rad", "", "rad"]
    for cell, fact in zip(cells, facts, strict=True):
        factor = {"mrad": 1e3, "rad": 1.0, "mm": 1e3, "µm": 1e6, "m": 1.0}[cell.split()[-1]]
        assert float(cell.split()[0]) == pytest.approx(factor * fact["value"], rel=1e-3)


def test_a_run_has_its_colour_in_every_chart(window: Window, info: dict[str, Any]) -> None:
    window.page.get_by_role("tab", name="Motors").click()
    for chart in window.page.locator(".chart-grid .chart").all():
        name = chart.get_attribute("data-chart")
        having = [run["name"] for run in info["runs"] if name in {one["id"] for one in run["charts"]}]
        rows = chart.locator(".legend-row").first
        assert rows.get_attribute("aria-label") == "Runs"
        toggles = rows.locator(".toggle").all()
        assert [one.inner_text().split("\n")[0].strip() for one in toggles] == having
        drawn = [one.locator("line").evaluate("line => line.style.stroke") for one in toggles]
        assert drawn == [COLOURS[name] for name in having]
    window.page.get_by_role("tab", name="Overview").click()
    assert window.said == []


def test_after_the_end_of_a_shorter_run_the_longer_one_goes_on(window: Window) -> None:
    """The time is that of the longest run; what has ended shows no value, and its robot rests where it ended."""
    assert window.page.locator(".transport .time").inner_text().endswith("of 0.3 s")
    window.page.locator("[data-chart=tip_deviation]").scroll_into_view_if_needed()
    window.page.wait_for_selector("[data-chart=tip_deviation] canvas")
    window.page.locator(".scrub").fill("500")
    values = [value(window, "tip_deviation", name) for name in RUNS]
    assert all(np.isfinite([float(one.replace("−", "-")) for one in values]))
    window.page.locator(".scrub").fill("900")
    values = [value(window, "tip_deviation", name) for name in RUNS]
    assert [one.strip("–") != "" for one in values] == [False, True, False]
    window.page.get_by_label("View", exact=True).select_option("side")
    assert len(window.page.locator(".scene-view").screenshot()) > 3000
    assert window.said == []


FILLED = """(canvas) => { const { width, height } = canvas
  const all = canvas.getContext("2d").getImageData(0, 0, width, height)
  let coloured = 0
  for (let k = 0; k < all.data.length; k += 4) {
    const [r, g, b, a] = all.data.subarray(k, k + 4)
    coloured += a > 128 && Math.max(r, g, b) - Math.min(r, g, b) > 40 }
  return coloured / (width * height) }"""
"""Share of a chart that is in colour."""


def test_parts_of_several_runs_are_curves_not_areas(window: Window) -> None:
    """They do not add up: the total of each run at first, and the parts as curves."""
    window.page.get_by_role("tab", name="Error", exact=True).click()
    chart = window.page.locator("[data-chart=tip_error]")
    chart.scroll_into_view_if_needed()
    window.page.wait_for_selector("[data-chart=tip_error] canvas")
    curves = chart.get_by_role("group", name="Curves").locator(".toggle")
    names = {one.inner_text().split("\n")[0].strip(): one.get_attribute("aria-pressed") for one in curves.all()}
    assert {name for name, pressed in names.items() if pressed == "true"} == {"total"}
    assert len(names) > 2
    for one in curves.all():
        if one.get_attribute("aria-pressed") == "false":
            one.click()
    until(lambda: chart.locator("canvas").evaluate(FILLED) > 0, "curves")
    assert chart.locator("canvas").evaluate(FILLED) < 0.1
    window.page.get_by_role("tab", name="Overview").click()
    assert window.said == []
