"""The report in a real browser: silent, alone, within its window, and usable by keyboard."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

OVERFLOW = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
STROKE = "getComputedStyle(document.querySelector('#tip_tracking svg path[style*=\"0072b2\"]')).stroke"
SIZES = ((1280, 800), (400, 800))


@dataclass
class Window:
    """An open page, with all that it said and asked for."""

    page: Any
    said: list[str] = field(default_factory=list)
    asked: list[str] = field(default_factory=list)


@pytest.fixture(scope="module")
def browser(chromium: str) -> Iterator[Any]:
    """A headless browser; skipped where there is none."""
    playwright = pytest.importorskip("playwright.sync_api", reason="needs playwright to look at the page")
    with playwright.sync_playwright() as engine:
        options = ["--no-sandbox", "--disable-gpu", "--disable-background-networking"]
        opened = engine.chromium.launch(executable_path=chromium, args=options)
        yield opened
        opened.close()


def look(browser: Any, report: Path, size: tuple[int, int] = SIZES[0], scheme: str = "light") -> Window:
    """Open a report, and listen."""
    context = browser.new_context(viewport={"width": size[0], "height": size[1]}, color_scheme=scheme)
    window = Window(context.new_page())
    window.page.on("console", lambda message: window.said.append(message.text))
    window.page.on("pageerror", lambda error: window.said.append(str(error)))
    window.page.on("request", lambda request: window.asked.append(request.url))
    window.page.goto(report.as_uri())
    return window


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("name", ["good", "failed"])
def test_it_is_silent_alone_and_within_its_window(
    browser: Any, reports: dict[str, Path], name: str, size: tuple[int, int], scheme: str
) -> None:
    window = look(browser, reports[name], size, scheme)
    assert window.said == []
    assert window.asked == [reports[name].as_uri()]
    assert window.page.evaluate(OVERFLOW) == 0
    assert len(window.page.screenshot()) > 15_000
    window.page.context.close()


def test_a_failed_run_is_seen_without_scrolling(browser: Any, reports: dict[str, Path]) -> None:
    for size in SIZES:
        window = look(browser, reports["failed"], size)
        box = window.page.get_by_role("alert").bounding_box()
        assert box["y"] + 60 < size[1]
        assert "did not finish" in window.page.get_by_role("alert").inner_text()
        window.page.context.close()


def test_the_dark_scheme_turns_the_figures_but_not_on_paper(browser: Any, reports: dict[str, Path]) -> None:
    light = look(browser, reports["good"], scheme="light").page.evaluate(STROKE)
    window = look(browser, reports["good"], scheme="dark")
    assert light == "rgb(0, 114, 178)"
    assert window.page.evaluate(STROKE) == "rgb(79, 176, 234)"
    window.page.emulate_media(media="print")
    assert window.page.evaluate(STROKE) == light


def test_it_can_be_used_by_keyboard(browser: Any, reports: dict[str, Path]) -> None:
    page = look(browser, reports["good"]).page
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.textContent") == "Skip to the content"
    assert page.evaluate("document.activeElement.getBoundingClientRect().left") >= 0
    page.keyboard.press("Tab")
    page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    assert page.evaluate("location.hash") == "#figures"
    assert abs(page.evaluate("document.getElementById('figures').getBoundingClientRect().top")) < 120


def test_what_a_screen_reader_hears(browser: Any, reports: dict[str, Path]) -> None:
    page = look(browser, reports["good"]).page
    assert page.get_by_role("navigation", name="Sections").count() == 1
    assert [page.get_by_role("region", name=name, exact=True).count() for name in ("Numbers", "Robot")] == [1, 1]
    assert page.get_by_role("img").count() == 10
    assert page.get_by_role("heading", level=1).inner_text() == "filipovic2010"
