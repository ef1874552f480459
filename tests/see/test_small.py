# pyright: reportArgumentType=false
"""The page on a phone, by keyboard alone, on paper, and for who wants nothing to move."""

from __future__ import annotations

from datetime import datetime, timedelta
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from patience import steady, until
from result.synthetic import synthetic_result
from see.looking import SIZES, Window, look
from tmodes.report.data import page_data
from tmodes.report.parts import viewer_document

pytestmark = pytest.mark.nightly

PHONE = (400, 800)
TOUCH = 40
"""Least side of what a finger meets [px]."""
SMALL = """() => [...document.querySelectorAll('.app button, .app select, .app summary, .app input')]
  .filter((one) => one.checkVisibility() && one.type !== 'checkbox')
  .map((one) => [one.outerHTML.slice(0, 60), one.getBoundingClientRect()])
  .filter(([, box]) => Math.min(box.width, box.height) < %d).map(([text]) => text)"""
FOCUS = """() => {
  const one = document.activeElement;
  if (one === document.body) return null;
  const box = one.getBoundingClientRect();
  const x = Math.min(Math.max(box.x + Math.min(box.width / 2, 20), 0), innerWidth - 1);
  const there = document.elementFromPoint(x, Math.max(box.y, 0) + Math.min(box.height / 2, 20));
  const whole = box.height > innerHeight / 2; // a region that scrolls
  const seen = there !== null && (one.contains(there) || there.contains(one));
  return [one.outerHTML.slice(0, 80), seen || whole, getComputedStyle(one).outlineStyle];
}"""
PAPER = """() => [...document.querySelectorAll('.chart-grid canvas')].map((canvas) => {
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  const sums = [0, 0, 0, 0];
  for (let k = 0; k < data.length; k += 4) {
    for (let c = 0; c < 3; c += 1) sums[c] += data[k + c] * data[k + 3];
    sums[3] += data[k + 3];
  }
  return [...sums.slice(0, 3).map((sum) => sum / sums[3]), sums[3] / 2550];
})"""
"""Of the charts that are drawn: mean red, green and blue of their lines, and how much of them there is."""


@pytest.fixture(scope="module")
def compared(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A page of three runs side by side."""
    runs = [synthetic_result(duration=duration, samples=501) for duration in (2.0, 1.0, 1.5)]
    path = tmp_path_factory.mktemp("compared") / "three.html"
    path.write_text(viewer_document(page_data(runs, names=["one", "two", "three"])), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def on_phone(browser: Any, reports: dict[str, Path]) -> Any:
    """The report of a finished run on a phone."""
    window = look(browser, reports["good"], PHONE, has_touch=True, is_mobile=True)
    yield window
    window.page.context.close()


def test_on_a_phone_all_that_is_touched_is_large(browser: Any, on_phone: Window, compared: Path) -> None:
    runs = look(browser, compared, PHONE, has_touch=True, is_mobile=True)
    for window in (on_phone, runs):
        window.page.get_by_text("Show", exact=True).first.click()
        assert window.page.evaluate(SMALL % TOUCH) == []
        assert window.page.evaluate("document.documentElement.scrollWidth") == PHONE[0]
        assert window.said == []
    runs.page.context.close()


def test_on_a_phone_the_time_takes_one_row(on_phone: Window) -> None:
    window = on_phone
    parts = window.page.locator(".transport :is(.play, input, output, select)")
    boxes = [part.bounding_box() for part in parts.all()]
    assert len(boxes) == 4
    assert all(one["x"] + one["width"] <= other["x"] for one, other in pairwise(boxes))
    middles = [box["y"] + box["height"] / 2 for box in boxes]
    assert max(middles) - min(middles) < 6
    assert window.page.locator(".transport").bounding_box()["height"] < 56
    assert boxes[1]["width"] > 80


@pytest.mark.parametrize("size", SIZES)
def test_what_has_the_focus_is_seen(browser: Any, reports: dict[str, Path], size: tuple[int, int]) -> None:
    """Tab by tab through the whole page: nothing is under the bar of time, and a line is drawn about it."""
    page = look(browser, reports["good"], size).page
    found = []
    while len(found) < 300:
        page.keyboard.press("Tab")
        info = page.evaluate(FOCUS)
        if info is None:
            break
        found.append(info)
    assert 40 < len(found) < 300
    assert [name for name, seen, _ in found if not seen] == []
    assert [name for name, _, line in found if line == "none"] == []
    page.context.close()


def test_nothing_moves_by_itself(browser: Any, reports: dict[str, Path]) -> None:
    window = look(browser, reports["good"])
    window.page.emulate_media(reduced_motion="no-preference")
    window.page.clock.install()
    window.page.reload()
    window.page.wait_for_selector("html.running")
    before = window.page.locator(".time").inner_text()
    window.page.clock.run_for(1000)
    assert window.page.locator(".transport .play").get_attribute("aria-label") == "Play"
    assert window.page.locator(".time").inner_text() == before
    window.page.context.close()


def settled(page: Any) -> bytes:
    """The scene once two screenshots in a row agree; the page's own clock stands, so nothing is drawn in between."""
    return steady(page.locator(".scene-view").screenshot)


def test_another_view_is_there_at_once_where_motion_is_not_wanted(browser: Any, compared: Path) -> None:
    """By the page's clock, which the test holds: after a quarter of a second what stands still has all its pixels."""
    page = look(browser, compared).page
    page.clock.install()
    page.clock.pause_at(datetime.now() + timedelta(hours=1))
    before = settled(page)
    for motion, view in (("reduce", "top"), ("no-preference", "front")):
        page.emulate_media(reduced_motion=motion)
        page.get_by_label("View", exact=True).select_option(view)
        page.clock.run_for(250)
        soon = settled(page)
        page.clock.run_for(3000)
        assert soon != before
        before = settled(page)
        assert (before == soon) == (motion == "reduce")
    page.context.close()


def test_charts_are_on_paper(browser: Any, compared: Path) -> None:
    """All are drawn, also those never looked at; as in the light scheme though the screen is dark, until it is done."""
    shown, printed = [], []
    for scheme in ("light", "dark"):
        page = look(browser, compared, (1280, 640), scheme, idle=True).page
        count = page.locator(".chart-grid .chart").count()
        until(lambda page=page, count=count: page.locator(".chart-grid .chart canvas").count() == count, "all charts")
        before = page.evaluate(PAPER)
        shown.append(before)
        page.evaluate("dispatchEvent(new Event('beforeprint'))")
        page.emulate_media(media="print")
        printed.append(page.evaluate(PAPER))
        assert len(printed[-1]) == count > 4
        assert page.locator(".scene-view").is_hidden()
        assert page.locator(".facts-panel").is_visible()
        page.emulate_media(media="screen")
        page.evaluate("dispatchEvent(new Event('afterprint'))")
        assert np.abs(np.array(page.evaluate(PAPER)[: len(before)]) - before)[:, :3].max() < 3.0
        page.context.close()
    assert np.abs(np.subtract(*shown))[:, :3].max() > 10.0
    light, dark = map(np.array, printed)
    assert np.abs(light - dark)[:, :3].max() < 3.0  # edges are smoothed by chance
    assert light[:, 3].min() > 100


def test_what_is_opened_for_paper_is_closed_again(browser: Any, reports: dict[str, Path]) -> None:
    """What somebody opened stays open; also where the browser says twice that it prints."""
    page = look(browser, reports["good"]).page
    page.evaluate("""const robot = document.getElementById("robot");
      robot.append(robot.querySelector("details").cloneNode(true));
      robot.querySelectorAll("details").forEach((one, k) => { one.open = k === 0; })""")
    folded = page.locator("#robot details")
    before = folded.evaluate_all("(all) => all.map((it) => it.open)")
    assert set(before) == {True, False}
    page.evaluate("for (const _ of [1, 2]) dispatchEvent(new Event('beforeprint'))")
    assert all(folded.evaluate_all("(all) => all.map((it) => it.open)"))
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    assert folded.evaluate_all("(all) => all.map((it) => it.open)") == before
    page.context.close()


def test_on_a_phone_the_robot_stays_in_sight(on_phone: Window) -> None:
    """Above the chart that is looked at, in less than half of the screen."""
    page = on_phone.page
    page.evaluate("document.querySelector('#tm-charts .chart').scrollIntoView()")
    boxes = [page.locator(one).first.bounding_box() for one in ("#tmodes-app > .stage", "#tm-charts .chart")]
    bottom = boxes[0]["y"] + boxes[0]["height"]
    assert 0 < boxes[0]["y"] < bottom < 0.55 * PHONE[1]
    assert boxes[1]["y"] >= bottom - 1
