"""The report that is alive: a slider moved, and charts, numbers and sheet follow; the run as it was stays."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from patience import until
from see.looking import look
from see.scenes import short_report, short_robot
from see.test_page import ink
from tmodes import load, run
from tmodes.frame import along

PAYLOAD = '[data-path="links.link.bodies.payload.mass"] input.number'
REASON = '[data-path="links.link.bodies.payload.mass"] .refused'
STATUS = ".sliders-panel [role=status]"
WORST = "[data-fact='deviation.max'] strong"
EFFECTS = """[...document.querySelectorAll('.sliders-panel .slider')].map((one) => [one.dataset.path,
  one.querySelector('.effect').textContent, Boolean(one.closest('.leading')),
  one.querySelector('input.number').value * 1])"""
"""Path of each slider, what one per cent of it does, whether it is among the first, and its number."""
VALUE = "[data-chart=tip_deviation] .toggle .value"


@pytest.fixture(scope="module")
def robot() -> Any:
    return short_robot()


@pytest.fixture(scope="module")
def window(browser: Any, tmp_path_factory: pytest.TempPathFactory) -> Any:
    """Its report, open."""
    path = tmp_path_factory.mktemp("alive") / "report.html"
    path.write_text(short_report(), encoding="utf-8")
    window = look(browser, path, (1280, 1000), unfolded=True, idle=True)
    window.page.wait_for_selector(f"{STATUS}:text('Move a slider')")
    return window


def tip_error(robot: Any) -> float:
    """The number with which the page leads [m]."""
    return run(robot).summary()["tip_error"]["commanded"]["max_m"]


def give(window: Any, text: str) -> None:
    window.page.locator(PAYLOAD).fill(text)
    window.page.wait_for_selector(f"{STATUS}:text('Simulated in')")


@pytest.mark.nightly
def test_the_settings_that_lead_are_the_most_effective_ones(browser: Any, tmp_path: Path, robot: Any) -> None:
    """Once the page has time: the largest change of the tip error for one per cent of a setting, as natively."""
    (tmp_path / "report.html").write_text(short_report(), encoding="utf-8")
    window = look(browser, tmp_path / "report.html", (1280, 1000), idle=True)
    window.page.add_init_script("const now = performance.now.bind(performance); performance.now = () => now() / 100")
    window.page.reload()  # where a busy machine takes long, the page would not begin
    window.page.locator(".sliders-panel details").first.evaluate("(one) => { one.open = true }")
    window.page.wait_for_selector(".sliders-panel .note:text('Behind each setting: the change of the')")
    shown = window.page.evaluate(EFFECTS)
    values = {path: value for path, _, _, value in shown}
    shares = {path: float(text.removesuffix(" %")) if text else 0.0 for path, text, _, _ in shown}
    leading = [path for path, _, leads, _ in shown if leads]
    assert len(leading) == 5
    assert min(shares[path] for path in leading) >= max(share for path, share in shares.items() if path not in leading)
    assert [shares[path] for path in leading] == sorted((shares[path] for path in leading), reverse=True)
    whole = tip_error(robot)
    for path in (leading[0], "links.link.bodies.payload.mass"):
        more = tip_error(robot.with_({path: 1.01 * values[path]}))
        assert shares[path] == pytest.approx(100 * abs(more - whole) / whole, rel=0.06)  # two digits are shown
    window.page.context.close()


def test_a_changed_payload_is_simulated_as_natively(window: Any, robot: Any) -> None:
    before = ink(window, "tip_deviation")[1]
    give(window, "0.9")
    wanted = run(robot.with_({"payload.mass": 0.9})).summary()["deviation"]["max_m"]
    info = window.page.locator(WORST).inner_text().replace("\u00a0", " ").split(" ")
    assert info[1] == "mm"
    assert float(info[0]) == pytest.approx(1e3 * wanted, rel=1e-3)
    assert "was" in window.page.locator("[data-fact='deviation.max']").inner_text()
    until(lambda: ink(window, "tip_deviation")[1] > before, "the run as it was, pale behind the new one")


def test_the_changed_sheet_can_be_saved(window: Any, tmp_path: Path) -> None:
    give(window, "0.7")
    with window.page.expect_download() as given:
        window.page.locator(".sliders-panel").get_by_role("button", name="Save YAML").click()
    path = tmp_path / given.value.suggested_filename
    given.value.save_as(path)
    assert load(path).links[0].bodies[0].mass == 0.7


def test_the_way_back(window: Any) -> None:
    give(window, "0.8")
    window.page.get_by_role("button", name="reset all").click()
    window.page.wait_for_selector(f"{STATUS}:text('as it was.')")
    assert window.page.locator(PAYLOAD).input_value() == "0.5"
    assert "was" not in window.page.locator("[data-fact='deviation.max']").inner_text()


def test_what_cannot_be_simulated_shows_the_run_as_it_was(window: Any) -> None:
    give(window, "0.8")
    window.page.evaluate("""() => {
      window.post = Worker.prototype.postMessage;
      Worker.prototype.postMessage = () => { throw new Error("no more room."); };
    }""")
    window.page.locator(PAYLOAD).fill("0.9")
    window.page.wait_for_selector(f"{STATUS}:text('no more room; shown is the run as it was.')")
    assert "was" not in window.page.locator("[data-fact='deviation.max']").inner_text()
    assert "warned" in window.page.locator(STATUS).get_attribute("class")
    window.page.evaluate("() => { Worker.prototype.postMessage = window.post; }")


def test_the_keyboard_stays_where_a_number_was_given_back(window: Any) -> None:
    give(window, "0.8")
    window.page.locator('[data-path="links.link.bodies.payload.mass"] button').press("Enter")
    window.page.wait_for_selector(f"{STATUS}:text('as it was.')")
    assert "warned" not in window.page.locator(STATUS).get_attribute("class")
    focus = "[document.activeElement.type, document.activeElement.closest('[data-path]')?.dataset.path]"
    assert window.page.evaluate(focus) == ["range", "links.link.bodies.payload.mass"]


def test_a_number_beyond_the_slider_is_taken_and_one_that_the_sheet_refuses_is_refused_at_the_field(
    window: Any,
) -> None:
    field, reason = window.page.locator(PAYLOAD), window.page.locator(REASON)
    give(window, "3.5")  # the slider ends at 1.5
    assert field.input_value() == "3.5"
    field.fill("-1")
    assert "at least 0" in reason.inner_text()
    assert field.get_attribute("aria-invalid") == "true"
    field.fill("")
    field.blur()
    assert field.input_value() == "3.5"
    assert not reason.is_visible()
    window.page.get_by_role("button", name="reset all").click()


@pytest.mark.parametrize(
    ("typed", "wanted"),
    [("0,9", "a decimal point: 0.9"), ("0.9 kg", "a number, such as"), ("1e999", "a finite number"),
     ("-0.5", "at least 0"), ("NaN", "a number"), ("0x10", "a number")],
)  # fmt: skip
def test_what_is_no_number_that_the_sheet_takes_is_refused_with_the_reason(
    window: Any, typed: str, wanted: str
) -> None:
    """It says at the field what was got and what is expected; an emptied field says nothing."""
    field, reason = window.page.locator(PAYLOAD), window.page.locator(REASON)
    before = field.input_value()
    field.fill(typed)
    field.blur()
    assert wanted in reason.inner_text()
    assert f"Got {typed}" in reason.inner_text().replace("\u00a0", " ")
    assert field.get_attribute("aria-invalid") == "true"
    field.fill("")
    assert not reason.is_visible()
    field.blur()
    assert field.input_value() == before


def test_what_the_sheet_takes_is_taken_as_natively(window: Any, robot: Any) -> None:
    """A move far longer than the slider goes, and no damping by the controller."""
    for path, value in (("drives.0.signal.duration", 15.0), ("drives.0.controller.velocity_gain", 0.0)):
        window.page.locator(f'[data-path="{path}"] input.number').fill(f"{value:g}")
        wanted = run(robot.with_({path: value})).summary()["deviation"]["max_m"]
        until(lambda wanted=wanted: abs(shown_error(window) / wanted - 1) < 1e-3, f"{path} = {value}: {wanted}")
        window.page.get_by_role("button", name="reset all").click()
        window.page.wait_for_selector(f"{STATUS}:text('as it was.')")


def shown_error(window: Any) -> float:
    """The error from the nominal path that the page shows [m]."""
    value, unit = window.page.locator(WORST).inner_text().replace("\u00a0", " ").split(" ")
    return float(value) * {"m": 1.0, "mm": 1e-3, "µm": 1e-6}[unit]


def test_no_text_breaks_the_page(window: Any) -> None:
    """Two hundred odd texts: each is taken or refused with a reason, none stops the page."""
    random = np.random.default_rng(12)
    letters = list("0123456789.,-+eE xX_/*'\"<>%µ−∞٣½\u00a0")
    texts = ["".join(random.choice(letters, random.integers(1, 9))) for _ in range(190)]
    texts += ["", " ", "1e400", "-1e400", "1e-400", "Infinity", "null", "1.5.2", "--1", "9" * 400]
    odd = window.page.locator(PAYLOAD).evaluate(
        """(field, texts) => texts.flatMap((text) => {
      field.value = text
      for (const name of ["input", "change"]) field.dispatchEvent(new Event(name))
      const reason = field.closest(".slider").querySelector(".refused")
      const isNumber = text.trim() !== "" && field.value !== text && reason.hidden || !Number.isNaN(Number(text))
      return reason.hidden && !isNumber && text.trim() ? [text] : [] })""",
        texts,
    )
    assert odd == []
    window.page.get_by_role("button", name="reset all").click()
    window.page.wait_for_selector(f"{STATUS}:text('as it was.')")
    assert window.said == []


@pytest.mark.nightly
def test_nothing_of_the_original_run_stays_without_a_word(window: Any) -> None:
    """Numbers are of the new run, those that take longer too; what no slider changes says whose it is."""
    window.page.evaluate("document.querySelector('main').append(document.createElement('section'))")
    window.page.evaluate("document.querySelector('main > section:last-child').id = 'robot'")  # as a report has it
    give(window, "0.8")
    window.page.wait_for_function("() => !document.querySelector('.facts .computing, .verdict .computing')")
    facts = window.page.locator(".facts [data-fact]").all_inner_texts()
    assert len(facts) > 8
    assert not any("original run" in text or "computing" in text for text in facts)
    words = "getComputedStyle(document.querySelector('#robot'), '::before').content"
    assert "original run" in window.page.evaluate(words)
    window.page.get_by_role("button", name="reset all").click()
    window.page.wait_for_selector(f"{STATUS}:text('as it was.')")
    assert window.page.locator(".original").count() == 0


def test_it_is_silent_and_asks_for_nothing(window: Any) -> None:
    assert window.said == []
    assert {url.split(":")[0] for url in window.asked} <= {"file", "blob"}


def test_the_error_by_cause_follows_as_natively(window: Any, robot: Any) -> None:
    """Its chart, whose numbers are saved as CSV, and the note of the largest error."""
    give(window, "0.9")
    own = run(robot.with_({"payload.mass": 0.9}))
    with window.page.expect_download() as given:
        window.page.locator("[data-chart=tip_error]").get_by_role("button", name="CSV").click()
    head, *rows = csv.reader(given.value.path().read_text(encoding="utf-8").splitlines())
    table = np.array([[float(value or "nan") for value in row] for row in rows])
    parts = own.data["tip_error"].transpose("time", "error_part", "axis").values
    size = np.linalg.norm(parts.sum(axis=1), axis=1)
    wanted = {**dict(zip(own.data["error_part"].values, along(parts).T, strict=True)), "total": size}
    columns = [k for k, name in enumerate(head) if k and "original" not in name]
    assert len(columns) == 1 + np.count_nonzero(np.abs(parts).max(axis=(0, 2)))
    for k in columns:
        true = 1e3 * wanted[head[k].split(" ")[0]]
        assert np.allclose(np.interp(own.data["time"].values, table[:, 0], table[:, k]), true, atol=1e-5 * true.max())
    note = window.page.locator("[data-fact='tip_error.commanded'] .note").text_content().replace("\u00a0", " ")
    for name, value in own.summary()["tip_error"]["commanded"]["parts_m"].items():
        assert f" {name}" in note or abs(value) < 1e-12
