"""What a reader takes along: pictures, a film, an address that leads back; and the ways through a run's time."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from patience import until
from see.looking import look
from see.test_page import seek, shown
from tmodes import load, run
from tmodes.report import write_report

pytestmark = pytest.mark.nightly


@pytest.fixture(scope="module")
def window(browser: Any, reports: dict[str, Path]) -> Any:
    return look(browser, reports["good"])


def saved(window: Any, press: Any) -> bytes:
    with window.page.expect_download() as given:
        press()
    return Path(given.value.path()).read_bytes()


def test_pictures_of_robot_and_charts(window: Any) -> None:
    page = window.page
    page.locator(".save-menu .menu-button").click()
    robot = saved(window, page.get_by_role("button", name="Save the picture (PNG)").click)
    page.locator(".save-menu .menu-button").click()
    page.locator("[data-chart=tip_deviation]").scroll_into_view_if_needed()
    page.wait_for_selector("[data-chart=tip_deviation] canvas")
    chart = saved(window, page.locator("[data-chart=tip_deviation]").get_by_role("button", name="PNG").click)
    assert all(one.startswith(b"\x89PNG") and len(one) > 5_000 for one in (robot, chart))


def test_a_film_of_the_run(window: Any) -> None:
    page = window.page
    page.locator(".save-menu .menu-button").click()
    page.get_by_role("button", name="Record the run (WebM)").click()
    until(lambda: shown(window) > 0.05)
    film = saved(window, page.get_by_role("button", name="Stop recording").click)
    assert film.startswith(b"\x1a\x45\xdf\xa3")
    page.locator(".save-menu .menu-button").click()


def test_a_run_too_short_for_a_film_says_so(browser: Any, tmp_path: Path) -> None:
    short = run(load("spong1987").with_({"integration.duration": 0.002}))
    page = look(browser, write_report(short, tmp_path / "short.html")).page
    page.locator(".save-menu .menu-button").click()
    film = page.get_by_role("button", name="Record the run (WebM)")
    film.click()
    page.get_by_role("button", name="Too short for a film").wait_for()
    assert page.locator(".save-menu [aria-pressed=true]").count() == 0
    page.context.close()


def test_an_address_leads_back(window: Any, browser: Any) -> None:
    page = window.page
    page.wait_for_selector(".sliders-panel [role=status]:text('Move a slider')")
    seek(window, 0.25)
    place = page.locator(".leading [data-path]").first.get_attribute("data-path")  # by effect, once that is known
    number = f"[data-path='{place}'] input.number"
    wanted = f"{1.2 * float(page.locator(number).input_value()):.4g}"
    page.locator(number).fill(wanted)
    page.get_by_label("View", exact=True).select_option("top")
    page.locator(".save-menu .menu-button").click()
    page.locator(".copy-link").click()
    address = page.url
    other = page.context.new_page()
    other.goto(address)
    other.wait_for_selector("html.running")
    assert other.locator(".time").inner_text().startswith("0.500 s")
    assert other.locator(number).input_value() == wanted
    view = "document.querySelector('.copy-link').click(); location.hash"
    cameras = [one.evaluate(f"() => {{ {view.replace('; ', '; return ')} }}") for one in (page, other)]
    assert cameras[0] == cameras[1]
    other.close()
    page.get_by_role("button", name="reset all").click()
    page.wait_for_selector(".sliders-panel [role=status]:text('as it was.')")


def test_numbers_marks_and_keys_lead_to_their_time(window: Any, good: Any) -> None:
    page = window.page
    page.locator("[data-fact='tip_error.commanded'] .jump").click()
    worst = good.summary()["tip_error"]["commanded"]["time_of_max_s"]
    assert shown(window) == pytest.approx(worst, abs=1e-3)
    page.evaluate("document.activeElement.blur()")
    page.keyboard.press(".")
    assert shown(window) == pytest.approx(worst + 1e-3, abs=1e-6)
    page.keyboard.press(",")
    page.keyboard.press(",")
    assert shown(window) == pytest.approx(worst - 1e-3, abs=1e-6)
    page.locator(".time-mark[aria-label*='error from commanded path']").click()
    assert shown(window) == pytest.approx(worst, abs=0.03)


def test_at_1280_by_800_settings_numbers_and_robot_are_in_sight(window: Any) -> None:
    page = window.page
    page.evaluate("scrollTo(0, 0)")
    bar = page.locator(".transport").bounding_box()["y"]
    for what in (".leading .slider", ".facts > div:not(.rest)"):
        boxes = [one.bounding_box() for one in page.locator(what).all()]
        assert len(boxes) >= 5
        assert all(box["y"] + box["height"] < bar for box in boxes)
    page.locator("section[aria-label^=Modes]").scroll_into_view_if_needed()
    page.get_by_role("button", name="Show the mode of").first.click()
    scene = page.locator(".scene-view").bounding_box()
    assert scene["y"] >= 0
    assert scene["y"] + scene["height"] <= bar + 2
    assert window.said == []
