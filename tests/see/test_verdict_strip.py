"""The strip that leads a page: the verdict, each of its causes shown alone, what lessens the error; and the menus."""

from __future__ import annotations

import io
import re
from pathlib import Path
from typing import Any

import matplotlib.image
import pytest

from patience import until
from see.looking import Window, look, words_of
from see.test_page import shown
from tmodes import load, run
from tmodes.io.printed import written
from tmodes.live.knobs import knobs_of
from tmodes.live.sliders import Slider, sliders_of
from tmodes.result import Result
from tmodes.result.verdict import damping_words

WIDTHS = ((1280, 800), (1440, 900), (1920, 1080), (390, 844))

DRAWN = """() => { const { width, height } = document.querySelector(".scene-overlay");
  const { data } = document.querySelector(".scene-overlay").getContext("2d").getImageData(0, 0, width, height);
  let count = 0; for (let k = 3; k < data.length; k += 4) count += data[k] > 0; return count / (width * height) }"""
"""Which share of the picture has something drawn over it."""

OUTSIDE = """(selector) => [...document.querySelectorAll(selector)].flatMap((one) => {
  const { left, right, top, bottom, width } = one.getBoundingClientRect();
  const { clientWidth, clientHeight } = document.documentElement;
  const inside = left >= 0 && right <= clientWidth && (one.popover === null || (top >= 0 && bottom <= clientHeight));
  const whole = one.scrollWidth <= Math.ceil(width);
  return !width || (inside && whole) ? [] : [[one.textContent, left, right, top, bottom, one.scrollWidth]]; })"""
"""What reaches out of the window, or has less room than its words need."""


@pytest.fixture(scope="module")
def window(browser: Any, reports: dict[str, Path]) -> Window:
    return look(browser, reports["good"])


def page_sliders(name: str) -> list[Slider]:
    return sliders_of(load(name), knobs_of(load(name)))


def factor(window: Window) -> str:
    return str(window.page.locator(".scene-factor-row output").text_content())


def test_it_has_the_verdict_of_the_run(window: Window, good: Result) -> None:
    verdict, strip = good.verdict, window.page.locator(".verdict")
    assert words_of(strip.locator(".verdict-sentence")) == verdict["sentence"]
    assert strip.get_attribute("data-level") == verdict["level"]
    settling, residual = verdict["settling"], verdict["residual"]
    wanted = {
        "Largest error": f"{written(verdict['largest_m'], 'm', 3)} at {written(verdict['time_s'], 's', 3)}",
        "Final error": written(verdict["final_m"], "m", 3),
        "Settling after the move":
            f"{written(settling['time_s'], 's', 3)} (within {written(settling['within_m'], 'm', 3)})",
        "Residual vibration": f"{written(residual['amplitude_m'], 'm', 3)}, "
            f"{written(residual['frequency_Hz'], 'Hz', 3)}, {damping_words(residual['damping'])} damping",
    }  # fmt: skip
    terms, numbers = (strip.locator(f".verdict-numbers {part}").all_text_contents() for part in ("dt", "dd"))
    assert dict(zip(terms, (text.replace("\u00a0", " ") for text in numbers), strict=True)) == wanted
    names = strip.locator(".culprits button")
    assert [one.get_attribute("data-key") for one in names.all()] == [
        f"{one['cause']} {one['element'] or ''}" for one in verdict["culprits"]
    ]
    pieces = strip.locator(".culprit-bar i").evaluate_all("all => all.map((one) => one.getBoundingClientRect().width)")
    sizes = [abs(one["value_m"]) for one in verdict["culprits"]]
    whole = [width / sum(pieces) for width in pieces]
    assert whole == pytest.approx([size / sum(sizes) for size in sizes], abs=0.01)
    assert window.page.locator("main > p.status").is_hidden()  # said once


@pytest.mark.parametrize("key", ["click", "Enter"])
def test_a_cause_is_shown_alone_and_all_comes_back(window: Window, good: Result, key: str) -> None:
    page, verdict = window.page, good.verdict
    name = page.locator(".culprits button").first
    before, then, drawn = factor(window), shown(window), page.evaluate(DRAWN)
    if key == "click":
        name.click()
    else:
        name.press(key)
    until(lambda: page.evaluate(DRAWN) > 1.5 * drawn)
    assert name.get_attribute("aria-pressed") == "true"
    assert shown(window) == pytest.approx(verdict["time_s"], abs=1e-3)
    assert factor(window) != before
    if key == "click":
        name.click()
    else:
        page.keyboard.press("Escape")
    assert name.get_attribute("aria-pressed") == "false"
    assert factor(window) == before
    assert shown(window) == pytest.approx(then, abs=1e-3)
    until(lambda: page.evaluate(DRAWN) < 1.2 * drawn)


def test_a_saved_picture_has_twice_the_pixels(window: Window) -> None:
    page = window.page
    page.locator(".save-menu .menu-button").click()
    with page.expect_download() as given:
        page.get_by_role("button", name="Save the picture (PNG)").click()
    page.keyboard.press("Escape")
    picture = matplotlib.image.imread(io.BytesIO(Path(given.value.path()).read_bytes()))
    view = page.locator(".scene-view").bounding_box()
    assert picture.shape[1] == pytest.approx(2 * view["width"], abs=2)
    assert picture.shape[0] == pytest.approx(2 * (view["height"] + 30), abs=2)


@pytest.mark.nightly("1280", "1920", "390")
@pytest.mark.parametrize("size", WIDTHS, ids=str)
def test_menus_and_tabs_are_inside_the_window(browser: Any, reports: dict[str, Path], size: tuple[int, int]) -> None:
    page = look(browser, reports["good"], size).page
    for opener in page.locator(".menu-button").all():
        opener.press("Enter")
        panel = page.locator(".menu-panel:popover-open")
        until(lambda: page.evaluate(OUTSIDE, ".menu-panel:popover-open, .menu-panel:popover-open *") == [])
        beneath = opener.bounding_box()
        below = beneath["y"] + beneath["height"]
        until(lambda below=below, panel=panel: panel.bounding_box()["y"] >= below or size[0] == 390, "the panel below")
        page.keyboard.press("Escape")
        assert panel.count() == 0
        assert opener.evaluate("one => document.activeElement === one")
        opener.click()
        assert panel.count() == 1
        opener.click()
        assert panel.count() == 0
    if size[0] > 390:  # there they are in one line that scrolls
        assert page.evaluate(OUTSIDE, "[role=tab]") == []
    page.context.close()


@pytest.mark.nightly
def test_on_a_phone_the_robot_is_in_the_first_screen(browser: Any, reports: dict[str, Path]) -> None:
    """What the strip has too much scrolls sideways."""
    page = look(browser, reports["good"], WIDTHS[-1]).page
    stage = page.locator(".scene-view").bounding_box()
    assert stage["y"] + 0.6 * stage["height"] < WIDTHS[-1][1]
    assert page.evaluate(OUTSIDE, ".verdict") == []
    assert page.evaluate("document.documentElement.scrollWidth") <= WIDTHS[-1][0]
    page.context.close()


@pytest.mark.nightly
def test_what_lessens_the_error_is_true_and_applied(browser: Any, reports: dict[str, Path]) -> None:
    page = look(browser, reports["good"], idle=True).page
    first = page.locator(".advice button").first
    first.wait_for()
    words = words_of(first)
    names = [str(one.text_content()).partition(",")[0] for one in page.locator(".advice button").all()]
    design = {slider.label.partition(",")[0] for slider in page_sliders("filipovic2010") if slider.design}
    assert {re.sub(r" [×÷].*", "", name) for name in names} <= design  # what nobody chooses is not proposed
    error = page.locator("[data-fact='tip_error.commanded']")
    first.click()
    until(lambda: "%" in str(error.locator(".was").text_content()))
    assert page.locator(".slider.changed").count() == 1
    assert words_of(error.locator(".was")).startswith(words.rpartition(": ")[2].replace(" %", ""))
    page.context.close()


@pytest.mark.nightly
def test_it_follows_a_slider(browser: Any, reports: dict[str, Path], good: Result) -> None:
    """The sentence of another setting, by the run of `tmodes run --set`; a cause that is shown stays."""
    page = look(browser, reports["good"]).page
    page.wait_for_selector(".sliders-panel [role=status]:text('Move a slider')")
    path = page.locator(".leading [data-path]").first.get_attribute("data-path")
    number = page.locator(f"[data-path='{path}'] input.number")
    page.locator(".culprits button").first.click()
    value = float(f"{1.1 * float(number.input_value()):.4g}")
    number.fill(str(value))
    wanted = run(good.robot.with_({str(path): value})).verdict["sentence"]
    sentence = page.locator(".verdict-sentence")
    until(lambda: words_of(sentence) == wanted, f"{words_of(sentence)} for {wanted}")
    assert sentence.get_attribute("data-state") == ""
    until(lambda: page.locator(".verdict .computing:not(.advice)").count() == 0)
    assert page.locator(".culprits button[aria-pressed=true]").count() == 1
    page.get_by_role("button", name="reset all").click()
    until(lambda: words_of(sentence) == good.verdict["sentence"])
    page.context.close()
