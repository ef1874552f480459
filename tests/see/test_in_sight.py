"""What has the focus is in sight, what is in sight moves nothing, and a chart that comes into sight shows the time."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from patience import until
from see.looking import look

pytestmark = pytest.mark.nightly

SIZES = ((1280, 800), (1280, 1000), (390, 844))

MOVED = """(parts) => [...document.querySelectorAll(parts)].filter((one) => {
  if (one.disabled || one.checkVisibility() === false) return false;
  const before = scrollY;
  one.focus();
  return scrollY !== before;
}).map((one) => one.outerHTML.slice(0, 90))"""
"""Which of these move the page when they get the focus."""

HIDDEN = """() => [...document.querySelectorAll(".charts button, .sliders-panel input, #numbers summary, #numbers a")]
  .filter((one) => {
    if (one.disabled || one.checkVisibility() === false) return false;
    scrollTo(0, one.getBoundingClientRect().y + scrollY > 2000 ? 0 : document.documentElement.scrollHeight);
    one.focus();
    const { left, right, top, bottom } = one.getBoundingClientRect();
    const seen = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
    return seen?.closest(".transport, nav, #tmodes-app > .stage");
  }).map((one) => one.outerHTML.slice(0, 90))"""
"""Which are under a bar that stays in sight when they get the focus, wherever the page was."""

LINE = "document.querySelector('[data-chart=tip_deviation] .time-line').style.transform"


@pytest.fixture(scope="module", params=SIZES, ids=lambda size: f"{size[0]}x{size[1]}")
def page(browser: Any, reports: dict[str, Path], request: pytest.FixtureRequest) -> Any:
    """The report of a finished run in a window of this size."""
    found = look(browser, reports["good"], request.param).page
    yield found
    found.context.close()


def test_a_part_that_stays_in_sight_moves_nothing(page: Any) -> None:
    page.evaluate("document.activeElement.blur()")
    page.evaluate("scrollTo(0, 400)")
    assert page.evaluate("scrollY") == 400
    assert page.evaluate(MOVED, ":is(.transport, nav, .stage) :is(a, button, input, select)") == []
    assert page.evaluate("scrollY") == 400


def test_what_has_the_focus_is_not_under_a_bar(page: Any) -> None:
    assert page.evaluate(HIDDEN) == []


def test_a_section_that_is_gone_to_is_not_under_the_bar(page: Any) -> None:
    page.get_by_role("link", name="Numbers").first.click()
    nav, section = page.locator("nav").bounding_box(), page.locator("#numbers").bounding_box()
    assert nav["y"] + nav["height"] <= section["y"] < 200


def test_a_chart_that_comes_back_into_sight_shows_the_time(browser: Any, reports: dict[str, Path]) -> None:
    page = look(browser, reports["good"], (1280, 800)).page
    page.wait_for_selector("[data-chart=tip_deviation] .time-line")
    page.locator(".scrub").fill("0")
    assert page.evaluate(LINE) == "translateX(0px)"
    page.evaluate("scrollTo(0, document.documentElement.scrollHeight)")
    assert page.locator("[data-chart=tip_deviation]").evaluate("(one) => one.getBoundingClientRect().bottom") < -200
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))")
    page.locator(".scrub").fill("500")
    page.evaluate("scrollTo(0, 0)")
    until(lambda: page.evaluate(LINE) != "translateX(0px)", "the chart's time")
    assert page.locator("[data-chart=tip_deviation] .toggle .value").first.inner_text() != "0"
    page.context.close()
