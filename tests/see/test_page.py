"""The report used as a person would: time, charts, legends, keys, paper; and no text ever becomes a program."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from see.conftest import NASTY
from see.looking import look
from tmodes.report import write_report
from tmodes.report.data import page_data
from tmodes.report.parts import viewer_document
from tmodes.result import Result

AXE = Path(__file__).resolve().parents[2] / "web" / "node_modules" / "axe-core" / "axe.min.js"
INK = """id => { const c = document.querySelector(`[data-chart=${id}] canvas`); const d = c.getContext('2d')
  .getImageData(0, 0, c.width, c.height).data; const seen = new Set(); let count = 0;
  for (let k = 0; k < d.length; k += 4) { if (d[k + 3] > 200) seen.add((d[k] << 16) + (d[k + 1] << 8) + d[k + 2]);
    count += d[k + 3] > 60 && d[k + 3] < 140 }
  return [seen.size, count] }"""
"""How many colours a chart shows, and how many of its pixels are pale."""
LINE = "document.querySelector('[data-chart=tip_deviation] .time-line').style.transform"
PLAY = ".transport .play"


@pytest.fixture(scope="module")
def window(browser: Any, reports: dict[str, Path]) -> Any:
    """The report of a finished run, open in a large window."""
    return look(browser, reports["good"], (1280, 1000))


def shown(window: Any) -> float:
    """The time that the page shows [s]."""
    return float(window.page.locator(".transport .time").inner_text().split(" s of")[0])


def ink(window: Any, chart: str) -> list[int]:
    """How many colours a chart shows, and how many of its pixels are pale, once it is drawn."""
    window.page.locator(f"[data-chart={chart}]").scroll_into_view_if_needed()
    window.page.wait_for_selector(f"[data-chart={chart}] canvas")
    return window.page.evaluate(INK, chart)


def seek(window: Any, share: float) -> None:
    window.page.locator(".scrub").fill(str(round(1000 * share)))


def test_charts_are_drawn_in_colours(window: Any) -> None:
    assert ink(window, "tip_deviation")[0] > 20
    assert window.page.locator(".scene canvas[tabindex]").bounding_box()["width"] > 500


@pytest.mark.nightly
def test_the_first_charts_are_seen_without_scrolling(browser: Any, reports: dict[str, Path]) -> None:
    page = look(browser, reports["good"], (1280, 720)).page
    assert page.locator(".transport").bounding_box()["y"] + 40 < 720
    assert page.locator("[data-chart=tip_error] .legend .toggle").first.bounding_box()["y"] + 24 < 720
    for tab in page.locator(".charts [role=tab]").all():
        tab.click()
        for chart in page.locator("[data-chart]").all():
            chart.evaluate("(one) => one.scrollIntoView({ block: 'center' })")
            boxes = [chart.locator(part).bounding_box() for part in (".plot-area", ".legend")]
            assert min(box["y"] for box in boxes) >= 0
            assert max(box["y"] + box["height"] for box in boxes) <= 720, chart.get_attribute("data-chart")
            assert boxes[1]["x"] >= boxes[0]["x"] + boxes[0]["width"], "the legend is beside the plot"
    page.context.close()


@pytest.mark.nightly
def test_plots_have_most_of_the_width_of_their_charts(browser: Any, reports: dict[str, Path]) -> None:
    """At every width of the window; what a legend needs stands beside or below."""
    page = look(browser, reports["good"]).page
    for width in (390, 1280, 1440, 1920):
        page.set_viewport_size({"width": width, "height": 1080})
        for chart in page.locator("[data-chart]").all():
            plot, card = (one.bounding_box()["width"] for one in (chart.locator(".plot-area"), chart))
            assert plot > 0.55 * card, (width, chart.get_attribute("data-chart"))
    page.context.close()


def test_charts_and_numbers_follow_the_time(window: Any, good: Result) -> None:
    before = window.page.evaluate(LINE)
    seek(window, 0.5)
    assert shown(window) == pytest.approx(1.0)
    assert window.page.evaluate(LINE) != before
    info = window.page.locator("[data-chart=tip_deviation] .toggle .value").first.inner_text()
    assert float(info.removesuffix("\u00a0mm")) == pytest.approx(
        1e3 * float(good.data["deviation"].sel(time=1.0, method="nearest")), rel=1e-3
    )


def test_a_click_on_a_chart_chooses_the_time(window: Any) -> None:
    seek(window, 0.0)
    box = window.page.locator("[data-chart=tip_deviation] .u-over").bounding_box()
    window.page.mouse.click(box["x"] + 0.75 * box["width"], box["y"] + 40)
    assert shown(window) == pytest.approx(1.5, abs=0.01)


def test_shift_and_drag_zooms_all_charts_and_double_click_ends_it(window: Any) -> None:
    box = window.page.locator("[data-chart=tip_deviation] .u-over").bounding_box()
    mouse, keys = window.page.mouse, window.page.keyboard
    keys.down("Shift")
    mouse.move(box["x"] + 0.2 * box["width"], box["y"] + 40)
    mouse.down()
    mouse.move(box["x"] + 0.6 * box["width"], box["y"] + 40, steps=4)
    mouse.up()
    keys.up("Shift")
    resets = window.page.get_by_role("button", name="reset zoom")
    assert resets.count() > 3
    mouse.dblclick(box["x"] + 20, box["y"] + 40)
    assert resets.count() == 0


def test_the_legend_switches_curves(window: Any) -> None:
    button = window.page.locator("[data-chart=tip_deviation] .toggle").nth(1)
    before = ink(window, "tip_deviation")
    button.focus()
    window.page.keyboard.press("Enter")
    assert button.get_attribute("aria-pressed") == "false"
    assert ink(window, "tip_deviation") != before
    label = window.page.locator("[data-chart=tip_deviation] .plot-area").get_attribute("aria-label")
    assert "Δx" not in label
    assert "distance actual, from " in label
    window.page.keyboard.press("Enter")
    assert button.get_attribute("aria-pressed") == "true"


def test_keys_move_the_time(window: Any) -> None:
    seek(window, 0.5)
    window.page.evaluate("document.activeElement.blur()")
    window.page.keyboard.press("ArrowRight")
    assert shown(window) == pytest.approx(1.01)
    window.page.keyboard.press("ArrowLeft")
    assert shown(window) == pytest.approx(1.0)
    seek(window, 0.0)
    window.page.evaluate("document.activeElement.blur()")
    window.page.locator("[data-chart=tip_deviation]").scroll_into_view_if_needed()  # others are not drawn
    window.page.keyboard.press(" ")
    assert window.page.locator(PLAY).get_attribute("aria-label") == "Pause"
    window.page.wait_for_selector("[data-chart=tip_deviation] .time-line:not([style*='translateX(0px)'])")
    window.page.keyboard.press(" ")
    assert window.page.locator(PLAY).get_attribute("aria-label") == "Play"


def test_groups_of_charts_are_tabs(window: Any) -> None:
    window.page.get_by_role("tab", name="Error").click()
    window.page.keyboard.press("ArrowRight")
    assert window.page.get_by_role("tab", name="Tip").get_attribute("aria-selected") == "true"
    charts = window.page.locator(".chart-grid .chart")
    assert [one.get_attribute("data-chart") for one in charts.all()] == ["tip_deviation", "tip_x", "tip_y", "tip_z"]
    window.page.get_by_role("tab", name="Overview").click()


def test_a_logarithmic_ordinate_shows_the_size(window: Any) -> None:
    button = window.page.locator("[data-chart=tip_deviation]").get_by_role("button", name="log")
    before = ink(window, "tip_deviation")
    button.click()
    assert button.get_attribute("aria-pressed") == "true"
    assert ink(window, "tip_deviation") != before
    button.click()


def test_data_and_sheet_can_be_saved(window: Any, good: Result) -> None:
    with window.page.expect_download() as given:
        window.page.get_by_role("button", name="Save the YAML of this run").click()
    assert given.value.suggested_filename == "filipovic2010.yaml"
    assert "bending_stiffness: 1082.12944351063" in Path(given.value.path()).read_text(encoding="utf-8")
    with window.page.expect_download() as given:
        window.page.locator("[data-chart=tip_deviation]").get_by_role("button", name="CSV").click()
    head, *rows = Path(given.value.path()).read_text(encoding="utf-8").splitlines()
    assert head.split(",")[:2] == ['"time [s]"', '"distance actual [mm]"']
    last = [float(value) for value in rows[-1].split(",")]
    assert len(rows) == len(good.data["time"])
    assert last[:2] == pytest.approx([2.0, 1e3 * float(good.data["deviation"][-1])], rel=1e-6)


def test_nothing_was_said_and_nothing_asked_for(window: Any, reports: dict[str, Path]) -> None:
    assert window.said == []
    assert [url for url in window.asked if not url.startswith("blob:")] == [reports["good"].as_uri()]


def test_without_a_program_the_page_reports_what_it_can(browser: Any, reports: dict[str, Path]) -> None:
    window = look(browser, reports["good"], java_script_enabled=False)
    assert "need JavaScript" in window.page.locator("#viewer").inner_text()
    assert window.page.locator("#numbers .cards").is_visible()
    window.page.context.close()


@pytest.mark.nightly
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nobody_is_shut_out(browser: Any, reports: dict[str, Path], scheme: str) -> None:
    if not AXE.exists():
        pytest.skip("needs axe-core: npm ci in web/")
    window = look(browser, reports["good"], scheme=scheme, bypass_csp=True)
    window.page.add_script_tag(path=AXE)
    found = window.page.evaluate("axe.run(document, {resultTypes: ['violations']})")
    assert [(one["id"], [node["target"] for node in one["nodes"][:3]]) for one in found["violations"]] == []
    window.page.context.close()


HOSTILE = "</script><script>alert(1)</script><img src=x onerror=alert(2)>\"'"


def test_a_hostile_name_stays_text(browser: Any, good: Result, tmp_path: Path) -> None:
    robot = json.loads(good.data.attrs["robot"]) | {"name": HOSTILE, "title": NASTY}
    result = Result(good.data.assign_attrs(robot=json.dumps(robot), message=HOSTILE, warnings=json.dumps([HOSTILE])))
    pages = {"report": write_report(result, tmp_path / "r.html"), "several": tmp_path / "s.html"}
    text = viewer_document(page_data([result, result], [HOSTILE, NASTY]))
    pages["several"].write_text(text, encoding="utf-8")
    for path in pages.values():
        window = look(browser, path)
        assert window.said == []
        assert window.page.locator("img").count() == 0
        assert window.page.locator("script").count() == 4
        assert HOSTILE in window.page.locator("main").inner_text()
        window.page.context.close()


@pytest.mark.nightly
def test_runs_side_by_side_share_their_charts(browser: Any, good: Result, failed: Result, tmp_path: Path) -> None:
    path = tmp_path / "several.html"
    path.write_text(viewer_document(page_data([good, failed], ["good", "failed"])), encoding="utf-8")
    window = look(browser, path, (1280, 1000))
    window.page.locator("[data-chart=tip_deviation]").scroll_into_view_if_needed()
    window.page.wait_for_selector("[data-chart=tip_deviation] canvas")
    row = window.page.locator("[data-chart=tip_deviation] .legend-row").first
    assert row.get_attribute("aria-label") == "Runs"
    assert [one.inner_text().split("\n")[0].strip() for one in row.locator(".toggle").all()] == ["good", "failed"]
    heads = window.page.locator(".facts-panel thead th").all_inner_texts()
    assert heads == ["good", "failed"]
    regions = [one.get_attribute("aria-label") for one in window.page.locator(".lower > section:visible").all()]
    assert regions == ["Elastic line of good", "Modes of vibration of good"]
    assert window.page.locator(".sliders-panel").is_hidden()
    assert window.said == []
    window.page.context.close()
