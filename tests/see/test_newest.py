"""What is out of sight waits for time; what comes into sight, or is saved, is the newest; nothing is made twice."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from see.looking import look
from see.scenes import short_report, short_robot
from tmodes import run

PAYLOAD = '[data-path="links.link.bodies.payload.mass"] input.number'
STATUS = ".sliders-panel [role=status]"
LOW = (1280, 420)
"""A window so low that the last charts of the overview and the elastic line are far below it."""

DRAWN = "(place) => document.querySelectorAll(place + ' canvas').length"
INK = """(place) => [...document.querySelectorAll(place + ' canvas')].map((canvas) => {
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  return data.reduce((sum, value, k) => (sum + value * (1 + k % 8191)) % 1e9, 0);
})"""


@pytest.fixture(scope="module")
def robot() -> Any:
    return short_robot()


@pytest.fixture(scope="module")
def window(browser: Any, tmp_path_factory: pytest.TempPathFactory) -> Any:
    """Its report, open."""
    path = tmp_path_factory.mktemp("newest") / "report.html"
    path.write_text(short_report(), encoding="utf-8")
    window = look(browser, path, LOW, unfolded=True)
    window.page.wait_for_selector(f"{STATUS}:text('Move a slider')")
    return window


def give(window: Any, mass: float) -> None:
    window.page.locator(STATUS).evaluate("(status) => { status.textContent = ''; }")
    window.page.locator(PAYLOAD).evaluate(
        "(input, text) => { input.value = text; input.dispatchEvent(new Event('input')); }", str(mass)
    )
    window.page.wait_for_function(f"() => document.querySelector('{STATUS}').textContent.startsWith('Simulated')")


def test_a_chart_that_comes_into_sight_shows_the_newest_run(window: Any, robot: Any) -> None:
    page, place = window.page, "[data-chart=energy]"
    assert page.evaluate(DRAWN, place) == 0
    give(window, 0.9)
    give(window, 1.1)
    assert page.evaluate(DRAWN, place) == 0  # not drawn for nobody
    page.locator(place).scroll_into_view_if_needed()
    page.wait_for_selector(f"{place} canvas")
    text = page.locator(f"{place} .plot-area").get_attribute("aria-label")
    low, high = map(float, re.findall(r"kinetic actual, from (-?[\d.]+) to (-?[\d.]+)", text)[0])
    true = unit_of(window, place) * run(robot.with_({"payload.mass": 1.1})).data["energy"].values[:, 0]
    assert (low, high) == pytest.approx((true.min(), true.max()), rel=2e-3, abs=2e-3 * true.max())


def unit_of(window: Any, place: str) -> float:
    """How much an SI value is multiplied by in a chart."""
    name = window.page.locator(f"{place} h4 .unit").inner_text().strip(" []")
    return {"J": 1.0, "mJ": 1e3, "µJ": 1e6, "N·m": 1.0, "mN·m": 1e3}[name]


def test_the_file_of_a_chart_out_of_sight_has_the_newest_run(window: Any, robot: Any, tmp_path: Path) -> None:
    page, place = window.page, "[data-chart^=gear_torque]"
    page.evaluate("scrollTo(0, 0)")
    page.locator("[data-group=motors]").evaluate("(tab) => tab.click()")
    give(window, 1.2)
    assert page.evaluate(DRAWN, place) == 0
    with page.expect_download() as given:
        page.locator(f"{place} [title*=CSV]").evaluate("(button) => button.click()")
    given.value.save_as(tmp_path / "saved.csv")
    head, *rows = (tmp_path / "saved.csv").read_text(encoding="utf-8").splitlines()
    column = next(k for k, name in enumerate(head.split('","')) if " actual" in name and "original" not in name)
    values = np.array([float(row.split(",")[column]) for row in rows])
    true = unit_of(window, place) * run(robot.with_({"payload.mass": 1.2})).data["gear_torque"].values[:, 0]
    assert values == pytest.approx(true, rel=1e-6, abs=1e-6 * np.abs(true).max())


def test_elastic_lines_and_numbers_are_updated_in_place(window: Any) -> None:
    page, place = window.page, ".line-grid"
    page.locator(place).scroll_into_view_if_needed()
    page.wait_for_selector(f"{place} canvas")
    page.evaluate(
        "() => document.querySelectorAll('.line-grid canvas, .facts strong').forEach((e) => { e.mine = true; })"
    )
    first, scales = (
        page.evaluate(INK, place),
        page.locator(f"{place} [role=img]").evaluate_all("(all) => all.map((e) => e.ariaLabel)"),
    )
    page.locator(".scrub").evaluate("(bar) => { bar.value = 900; bar.dispatchEvent(new Event('input')); }")
    page.wait_for_function(
        f"(old) => ({INK})('.line-grid').every((ink, k) => ink !== old[k])", arg=first
    )  # follows the time
    second = page.evaluate(INK, place)
    give(window, 1.1)
    page.wait_for_function(f"(old) => ({INK})('.line-grid').every((ink, k) => ink !== old[k])", arg=second)
    assert page.locator(f"{place} [role=img]").evaluate_all("(all) => all.map((e) => e.ariaLabel)") != scales
    assert page.evaluate("[...document.querySelectorAll('.line-grid canvas, .facts strong')].every((e) => e.mine)")


def test_it_is_silent(window: Any) -> None:
    assert window.said == []
