"""The report in a real browser: silent, alone, within its window, and usable by keyboard."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from see.looking import SIZES, look

OVERFLOW = "document.documentElement.scrollWidth - document.documentElement.clientWidth"


@pytest.mark.nightly("dark")
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("name", ["good", "failed"])
def test_it_is_silent_alone_and_within_its_window(
    browser: Any, reports: dict[str, Path], name: str, size: tuple[int, int], scheme: str
) -> None:
    window = look(browser, reports[name], size, scheme)
    assert window.said == []
    assert [url for url in window.asked if not url.startswith("blob:")] == [reports[name].as_uri()]
    assert window.page.evaluate(OVERFLOW) == 0
    assert len(window.page.screenshot()) > 15_000
    window.page.context.close()


@pytest.mark.nightly
def test_a_failed_run_is_seen_without_scrolling(browser: Any, reports: dict[str, Path]) -> None:
    for size in SIZES:
        window = look(browser, reports["failed"], size)
        box = window.page.get_by_role("alert").bounding_box()
        assert box["y"] + 60 < size[1]
        assert "did not finish" in window.page.get_by_role("alert").inner_text()
        window.page.context.close()


def test_it_can_be_used_by_keyboard(browser: Any, reports: dict[str, Path]) -> None:
    page = look(browser, reports["good"]).page
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.textContent") == "Skip to the content"
    assert page.evaluate("document.activeElement.getBoundingClientRect().left") >= 0
    for _ in range(3):
        page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    assert page.evaluate("location.hash") == "#robot"
    assert abs(page.evaluate("document.getElementById('robot').getBoundingClientRect().top")) < 120


def test_what_a_screen_reader_hears(browser: Any, reports: dict[str, Path]) -> None:
    page = look(browser, reports["good"]).page
    assert page.get_by_role("navigation", name="Sections").count() == 1
    assert [page.get_by_role("region", name=name, exact=True).count() for name in ("Numbers", "Robot")] == [1, 1]
    assert page.locator(".chart").first.get_by_role("img").count() == 1
    assert page.get_by_role("heading", level=1).inner_text() == "filipovic2010"
