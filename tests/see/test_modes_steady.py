"""While a slider moves, modes and numbers stay until newer ones are there, and the keyboard keeps its place."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from see.looking import look
from see.test_modes_follow import KINDS, PANEL, STATUS, report_of

pytestmark = pytest.mark.nightly

FREQUENCY = "[data-fact='frequency.first'] strong"
NOTE = f"{PANEL} .note"
BUTTON = f"{PANEL} tbody button"
FOCUSED = f"() => [...document.querySelectorAll(`{BUTTON}`)].indexOf(document.activeElement)"
RECORD = """([fact, panel]) => {
  const info = (element) => element.innerText.split("\\n")[0];
  const seen = () => ({
    fact: info(document.querySelector(fact)),
    cells: [...document.querySelectorAll(`${panel} tbody tr`)].map((row) => [...row.cells].slice(0, 2).map(info)),
    others: [...document.querySelectorAll(".facts-panel div > dd > .was")]
      .filter((one) => !/^(settling|vibration|tip_error)/.test(one.closest("[data-fact]").dataset.fact)).map(info),
  });
  window.records = [seen()];
  window.watching?.disconnect();
  window.watching = new MutationObserver(() => window.records.push(seen()));
  window.watching.observe(document.body, { subtree: true, childList: true, characterData: true, attributes: true });
}"""
HOLD = """() => {
  const post = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function (...given) {
    const [hear, held] = [this.onmessage, []];
    this.onmessage = (event) => {
      const { id, kind, run } = event.data;
      const later = kind === "done" || (kind === "early" && run?.pending && !run.pending.includes("settling"));
      if (!held.length && (!later || id !== given[0].id)) return hear(event);
      held.push(event);
      window.release = () => { this.onmessage = hear; held.forEach((one) => hear(one)); };
    };
    Worker.prototype.postMessage = post;
    return post.apply(this, given);
  };
}"""
"""The next run is reported early, and how it settles and all else only when `release` is called."""


@pytest.fixture(scope="module", params=[*KINDS])
def opened(request: Any, browser: Any, tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Any, str, float]]:
    """A report, one of its sliders, and a value for it."""
    _, slider, value, _ = KINDS[request.param]
    path = tmp_path_factory.mktemp("steady") / "report.html"
    path.write_text(report_of(request.param), encoding="utf-8")
    window = look(browser, path, (1280, 1000), unfolded=True)
    window.page.wait_for_selector(f"{STATUS}:text('Move a slider')")
    yield window, slider, value
    assert window.said == []
    window.page.context.close()


@pytest.fixture
def fresh(opened: tuple[Any, str, float]) -> tuple[Any, str, float]:
    """The same as it was opened."""
    page = opened[0].page
    reset = page.get_by_role("button", name="reset all")
    if reset.is_enabled():
        reset.click()
        page.wait_for_selector(f"{STATUS}:text('as it was.')")
    return opened


def move(page: Any, slider: str, value: float) -> None:
    """Give a slider's number without touching the keyboard's place."""
    page.locator(f'[data-path="{slider}"] input.number').evaluate(
        "(field, value) => { field.value = value; field.dispatchEvent(new Event('input')); }", str(value)
    )


def move_and_wait(page: Any, slider: str, value: float) -> None:
    """The same, until another first frequency is reported and the modes are those of the new run."""
    before = page.locator(FREQUENCY).inner_text()
    move(page, slider, value)
    page.wait_for_function(
        "([fact, before]) => document.querySelector(fact).innerText !== before", arg=[FREQUENCY, before]
    )
    page.wait_for_selector(f"{NOTE}:text('under each number')")


def test_no_number_of_the_original_run_comes_back_between_two_settings(fresh: tuple[Any, str, float]) -> None:
    """Settling and vibration apart, where they were found beyond the end of the run, and the error by cause."""
    window, slider, value = fresh
    window.page.evaluate(RECORD, [FREQUENCY, PANEL])
    move_and_wait(window.page, slider, value)
    move_and_wait(window.page, slider, 0.8 * value)
    records = window.page.evaluate("() => window.records")
    facts = [one["fact"].lstrip("≈ \xa0") for one in records]  # the sign comes when it is known how exact it is
    for info in (facts, [one["cells"] for one in records]):
        kinds = [one for k, one in enumerate(info) if k == 0 or one != info[k - 1]]
        assert len(kinds) == 3  # the original run's, and those of either setting, each once
        assert kinds[0] not in kinds[1:]
    assert [text for text in records[-1]["others"] if "original" in text] == []


def test_the_settling_of_the_setting_before_stays_until_its_own_is_there(fresh: tuple[Any, str, float]) -> None:
    window, slider, value = fresh
    info = window.page.locator("[data-fact='settling']")
    move_and_wait(window.page, slider, value)
    before = info.inner_text()
    window.page.evaluate(HOLD)
    move(window.page, slider, 0.8 * value)
    window.page.wait_for_function("() => window.release")
    assert info.locator("strong").inner_text() in before
    window.page.evaluate("() => { window.release(); delete window.release; }")


def test_what_stays_for_long_says_of_what_it_is(fresh: tuple[Any, str, float]) -> None:
    window, slider, value = fresh
    page = window.page
    words = {
        0: ("the run as it was; the new", "computing"),
        1: ("the setting before", "computing"),
    }
    for k, (note, was) in words.items():
        before = page.locator(FREQUENCY).inner_text()
        cells = page.locator(f"{PANEL} tbody").inner_text()
        page.evaluate(HOLD)
        move(page, slider, (1 - 0.2 * k) * value)
        page.wait_for_selector(f"{NOTE}:text('{note}')")
        assert page.locator("[data-fact='frequency.first'] .was").inner_text() == was
        assert page.locator(FREQUENCY).inner_text() == before
        assert page.locator(f"{PANEL} tbody").inner_text() == cells
        page.wait_for_function("() => window.release")
        page.evaluate("() => { window.release(); delete window.release; }")
        page.wait_for_selector(f"{NOTE}:text('under each number')")
        assert page.locator(FREQUENCY).inner_text() != before
        assert page.locator("[data-fact='frequency.first'] .was").inner_text() != was


def test_the_keyboard_stays_on_the_button_of_a_mode(fresh: tuple[Any, str, float]) -> None:
    window, slider, value = fresh
    page = window.page
    place = min(1, page.locator(BUTTON).count() - 1)
    row = page.locator(BUTTON).nth(place)
    row.focus()
    for text in ("stop", "show", "stop"):
        page.keyboard.press("Enter")
        assert (row.inner_text(), page.evaluate(FOCUSED)) == (text, place)
    move_and_wait(page, slider, value)
    assert (row.inner_text(), page.evaluate(FOCUSED)) == ("stop", place)
    page.get_by_role("button", name="back to the motion").focus()
    page.keyboard.press("Enter")
    assert (row.inner_text(), page.evaluate(FOCUSED)) == ("show", place)
