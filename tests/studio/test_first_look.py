"""The studio's status in sight, wrong fields found, a robot that nothing moves, and numbers of one robot alone."""

from __future__ import annotations

import json
from typing import Any

import pytest

from see.looking import words_of
from studio.tabs import drag
from tmodes import load, run
from tmodes.io.sheet_write import robot_to_yaml
from tmodes.report.data import page_data
from tmodes.report.rest import first_move
from tmodes.result.early import LATER, early_result
from tmodes.studio.sheets import plain_sheet
from tmodes.studio.work import Workshop

pytestmark = pytest.mark.nightly

SAVE = """async ([name, sheet]) => {
  const headers = { "Content-Type": "application/json" };
  await fetch(`api/studies/${name}`, { method: "PUT", headers, body: JSON.stringify({ sheet, overwrite: true }) });
}"""
IN_SIGHT = """(one) => {
  const { left, top, bottom } = one.getBoundingClientRect();
  const seen = document.elementFromPoint(left + 4, (top + bottom) / 2);
  return top >= 0 && bottom <= innerHeight && (seen === one || one.contains(seen) || seen.contains(one));
}"""
SPONG = plain_sheet(load("spong1987"))
MASS = "links.0.bodies.0.mass"


def still() -> dict[str, Any]:
    """A robot of one joint that nothing moves."""
    return {key: value for key, value in SPONG.items() if key != "drives"}


def open_study(tab: Any, name: str, sheet: Any) -> None:
    tab.page.evaluate(SAVE, [name, sheet])
    tab.page.reload()
    tab.info("New curves")
    tab.page.get_by_label("Open a study").select_option(name)


@pytest.mark.parametrize("size", [(1280, 800), (390, 844)])
def test_status_and_errors_stay_in_sight(tab: Any, size: tuple[int, int]) -> None:
    """However far the page is scrolled."""
    tab.page.set_viewport_size({"width": size[0], "height": size[1]})
    tab.page.evaluate("scrollTo(0, 1200)")
    tab.fresh(lambda: drag(tab, MASS, 0.6))
    assert tab.page.evaluate("scrollY") > 600
    assert tab.page.locator(".line").evaluate(IN_SIGHT)
    drag_to(tab, "-3")
    tab.page.locator(".errors", has_text="payload.mass").wait_for()
    assert tab.page.locator(".errors p").first.evaluate(IN_SIGHT)


def test_the_verdict_is_marked_until_it_is_whole_and_what_lessens_the_error_is_proposed(tab: Any) -> None:
    """As in a report, by runs of the server; a click applies it."""
    page, sentence = tab.page, tab.page.locator(".verdict-sentence")
    page.add_init_script("window.requestIdleCallback = queueMicrotask.bind(window)")  # after all, there is time
    page.reload()
    page.locator(".verdict-numbers .computing").first.wait_for()
    assert sentence.get_attribute("data-state") == " computing …"
    page.locator(".verdict-sentence[data-state='']").wait_for()
    assert page.locator(".verdict-numbers .computing").count() == 0
    assert words_of(sentence) == run(load("filipovic2010")).verdict["sentence"]
    first = page.locator(".advice button").first
    first.wait_for()
    share = words_of(first).rpartition("−")[2]
    tab.fresh(first.click)
    assert share.replace(" %", "") in words_of(page.locator("[data-fact='tip_error.commanded'] .was"))


def drag_to(tab: Any, value: str) -> None:
    """Type next to the slider, without the focus that would scroll there."""
    tab.page.locator(f"[data-slider='{MASS}'] input.number").evaluate(
        "(one, value) => { one.value = value; one.dispatchEvent(new Event('change', { bubbles: true })); }", value
    )


def test_the_wrong_field_is_marked_and_scrolled_to(tab: Any) -> None:
    """In the form, whose groups open, and next to its slider; both marks go with a right number."""
    drag_to(tab, "-3")
    field = tab.page.locator(".sheet input[aria-invalid=true]")
    field.wait_for()
    assert field.evaluate(IN_SIGHT)
    slider = tab.page.locator(f"[data-slider='{MASS}'] input.number")
    assert slider.get_attribute("aria-invalid") == "true"
    tab.fresh(lambda: drag_to(tab, "0.4"))
    assert slider.get_attribute("aria-invalid") == "false"
    assert field.count() == 0


def test_who_types_stays_where_he_types(tab: Any) -> None:
    typed = tab.page.locator(f"[data-slider='{MASS}'] input.number")
    typed.fill("-3")
    typed.press("Enter")
    tab.page.locator(".sheet input[aria-invalid=true]").wait_for()
    assert typed.evaluate(IN_SIGHT)
    assert typed.evaluate("(one) => document.activeElement === one")


def test_a_robot_that_nothing_moves_is_drawn_at_rest_and_a_move_is_offered(tab: Any) -> None:
    open_study(tab, "still.yaml", still())
    offer = tab.page.get_by_role("button", name="Add a move")
    offer.wait_for()
    assert tab.line() == "At rest: nothing moves this robot yet."
    assert not tab.page.locator(".errors").is_visible()
    assert tab.page.locator(".view .scene canvas[tabindex]").is_visible()
    assert not tab.page.locator(".view .facts-panel").is_visible()
    tab.page.locator(".view .modes-table, .view [aria-label^='Modes']").first.wait_for()
    tab.fresh(offer.click)
    assert not offer.is_visible()
    assert float(tab.fact("tip_error.commanded").split()[0]) >= 0
    assert tab.page.locator("details[data-path='drives.0']").count() == 1


def test_numbers_of_the_robot_before_never_stand_next_to_another(tab: Any) -> None:
    """Also where nothing of the new one can be shown."""
    assert tab.page.locator("[data-fact]").count() > 3
    wrong = {"path": "integration.output_step", "message": "too fine", "got": "", "expected": "", "hint": "",
             "where": "", "steps": ["integration", "output_step"]}  # fmt: skip
    tab.page.route("**/api/jobs", lambda route: route.fulfill(status=422, json={"errors": [wrong]}))
    tab.page.get_by_label("Robot", exact=True).select_option("spong1987")
    tab.page.locator(".errors p", has_text="too fine").wait_for()
    assert tab.page.input_value(".sheet input") == "spong1987"
    assert tab.page.locator("[data-fact], .chart, .view canvas").count() == 0
    assert "Nothing is shown yet" in tab.page.inner_text(".view")


def test_slower_numbers_and_modes_come_a_little_later(tab: Any) -> None:
    """To the first run, and to one that a slider changed."""
    for name in ("settling", "vibration.residual", "frequency.first"):
        tab.page.locator(f"[data-fact='{name}']").wait_for(state="attached")
    before = tab.page.text_content("[data-fact='frequency.first'] strong")
    tab.fresh(lambda: drag(tab, MASS, 0.9))
    tab.page.wait_for_function(
        "(before) => document.querySelector(\"[data-fact='frequency.first'] strong\").textContent !== before",
        arg=before,
    )


def test_an_early_page_has_the_numbers_of_the_whole_one() -> None:
    result = run(load("filipovic2010"))
    early = page_data([early_result(result)], light=True)["runs"][0]
    whole = page_data([result])["runs"][0]
    own = [fact["id"] for fact in early["facts"]]
    assert own == [fact["id"] for fact in whole["facts"] if not fact["id"].startswith(LATER)]
    assert len(own) >= 8
    known = {fact["id"]: fact["value"] for fact in whole["facts"]}
    assert {fact["id"]: fact["value"] for fact in early["facts"]} == {name: known[name] for name in own}
    assert early["warnings"] == whole["warnings"]
    assert [chart["id"] for chart in early["charts"]] == [chart["id"] for chart in whole["charts"]]
    assert early["events"] == whole["events"]


def test_a_result_that_is_whole_is_no_longer_early() -> None:
    result = run(load("spong1987"))
    assert early_result(result) is not result
    assert "vibration" in result.data.attrs
    assert early_result(result) is result


def test_the_first_move_can_be_run() -> None:
    sheet = load("spong1987").with_({"drives": []})
    moved = sheet.with_({"drives": first_move(sheet)})
    assert robot_to_yaml(moved)
    tip = run(moved).data["tip"].values
    assert abs(tip[-1] - tip[0]).max() > 0.1


def test_what_is_asked_of_a_robot_at_rest_is_no_run() -> None:
    """Its report still needs something that moves it."""
    workshop = Workshop()
    answer = workshop.answer("curves", still(), lambda stage, share: None)
    assert [drive["joint"] for drive in answer.info["offer"]] == ["joint"]
    assert json.dumps(answer.info)
    with pytest.raises(Exception, match="drives"):
        workshop.answer("data", still(), lambda stage, share: None)
