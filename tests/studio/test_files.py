"""Files in and out of the studio's page: what is refused, what is kept, and what is shown meanwhile."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from patience import steady, until
from see.test_small import PAPER
from studio.tabs import Tab

pytestmark = pytest.mark.nightly


def stale(tab: Tab) -> bool:
    """Whether the picture is shown as that of another sheet."""
    return "stale" in (tab.page.get_attribute(".view", "class") or "")


def save(tab: Tab, name: str) -> None:
    tab.page.get_by_label("Name of the study").fill(name)
    tab.page.get_by_role("button", name="Save", exact=True).click()


def test_a_refused_file_leaves_the_picture_as_true_as_it_was(tab: Tab) -> None:
    """The picture is of the sheet where only its file was refused, and of another where the sheet itself was."""
    errors = tab.page.locator(".errors")
    tab.info("New curves")
    save(tab, "../x")
    errors.locator("p", has_text="plain name").wait_for()
    assert not stale(tab)
    mass: Any = tab.page.locator("[data-slider='links.0.bodies.0.mass'] input.number")
    before = mass.input_value()
    mass.fill("-1")
    mass.press("Enter")
    errors.locator("p", has_text="payload.mass").wait_for()
    assert stale(tab)
    with tab.page.expect_response("**/api/studies/y.yaml") as answer:
        save(tab, "y")
    assert answer.value.status == 422
    assert stale(tab)
    mass.fill(before)
    tab.fresh(lambda: mass.press("Enter"))
    assert not stale(tab)


def test_a_report_that_is_asked_for_twice_is_made_once(tab: Tab) -> None:
    """Its button waits for it; one that was ended all the same is reported in a sentence, not by an empty box."""
    tab.info("New curves")
    begun: list[str] = []
    tab.page.on("request", lambda one: begun.append(one.post_data) if one.method == "POST" else None)
    report = tab.page.get_by_role("button", name="Report", exact=True)
    with tab.page.expect_download() as kept:
        report.evaluate("(it) => { it.focus(); it.click(); it.click(); }")
    assert kept.value.suggested_filename.endswith(".html")
    tab.info("The report is among")
    assert sum('"product":"report"' in one for one in begun) == 1
    assert report.is_enabled()
    assert report.evaluate("(it) => it === document.activeElement")
    ended = '{"job": "x", "state": "cancelled", "stage": "", "share": 0, "info": {}, "errors": []}'
    tab.page.route("**/api/jobs", lambda one: one.fulfill(body=ended, content_type="application/json"))
    report.click()
    tab.info("The report was ended")
    assert not tab.page.is_visible(".errors")
    assert report.is_enabled()


@pytest.mark.parametrize("kind", ["exists", None])
def test_replace_is_offered_for_a_file_that_is_there_alone(tab: Tab, kind: str | None) -> None:
    """Not where the disk is full, or nothing may be written: the answer is the same but for its kind."""
    info = {"path": "name", "message": "cannot be kept", "got": "", "expected": "", "hint": "", "where": ""}
    answer = {"errors": [info | {"steps": None} | ({"kind": kind} if kind else {})]}
    tab.page.route("**/api/studies/there.yaml", lambda one: one.fulfill(status=409, json=answer))
    save(tab, "there")
    tab.page.locator(".errors p", has_text="cannot be kept").wait_for()
    assert tab.page.get_by_role("button", name="Replace").is_visible() == (kind == "exists")
    save(tab, f"free_{kind}")
    tab.info("Saved as")
    assert not tab.page.get_by_role("button", name="Replace").is_visible()


def test_the_list_of_robots_names_what_is_shown(tab: Tab) -> None:
    """A file of one's own is none of them: the robot that was there before can be chosen again."""
    robots = tab.page.get_by_label("Robot", exact=True)
    shown = robots.locator("option:checked")
    tab.info("New curves")
    assert robots.input_value() == "filipovic2010"
    save(tab, "own")
    tab.info("Saved as")
    tab.fresh(lambda: tab.page.get_by_label("Open a study").select_option("own.yaml"))
    assert (robots.input_value(), shown.text_content()) == ("", "from a file")
    tab.page.route("**/api/robots/spong1987", lambda one: one.fulfill(status=422, json={"errors": []}))
    with tab.page.expect_response("**/api/robots/spong1987"):
        robots.select_option("spong1987")
    tab.page.wait_for_function("() => document.querySelector('header select').value === ''")
    tab.fresh(lambda: robots.select_option("filipovic2010"))
    assert robots.input_value() == "filipovic2010"


GONE_ENTRY = """(kind) => {
  const gone = (_, failed) => failed(new DOMException("gone", "NotFoundError"));
  const inner = { isFile: true, isDirectory: false, name: "arm.urdf", fullPath: "/arms/arm.urdf", file: gone };
  let left = [inner];
  const entries = (done) => { done(left); left = []; };
  const folder = {
    isFile: false, isDirectory: true, name: "arms", fullPath: "/arms",
    createReader: () => ({ readEntries: kind === "file" ? entries : gone }),
  };
  const event = new Event("drop", { cancelable: true });
  Object.assign(event, { dataTransfer: { items: [{ webkitGetAsEntry: () => folder }], files: [] } });
  document.dispatchEvent(event);
}"""
"""A folder that is dropped, of which a file or the folder itself is no longer there."""


def test_a_file_that_is_gone_is_reported(tab: Tab, tmp_path: Path) -> None:
    """What was chosen and changed on the disk before it was read; what was dropped and taken away."""
    tab.info("New curves")
    errors = tab.page.locator(".errors p", has_text="cannot be read")
    (chosen := tmp_path / "two.urdf").write_text("<robot/>", encoding="utf-8")
    tab.page.evaluate("""() => {
      const read = File.prototype.arrayBuffer;
      File.prototype.arrayBuffer = () => {
        File.prototype.arrayBuffer = read;
        return Promise.reject(new DOMException("gone", "NotReadableError"));
      };
    }""")
    tab.page.get_by_label("Upload", exact=True).set_input_files(chosen)
    errors.wait_for()
    assert re.fullmatch(r"two\.urdf it cannot be read \(NotReadableError\).*\. choose it again", errors.inner_text())
    assert not stale(tab)
    for kind, name in (("file", "arm.urdf"), ("folder", "arms")):
        tab.page.evaluate(GONE_ENTRY, kind)
        errors.filter(has_text=name).wait_for()
        assert "NotFoundError" in errors.inner_text()


def test_a_dark_studio_has_light_curves_on_paper(tab: Tab) -> None:
    """As a light one prints them, without the data sheet next to them; dark again afterwards."""
    tab.info("New curves")
    tab.page.wait_for_selector("section[aria-label^=Modes] table")  # the last of what follows the curves
    printed = []

    def apart(other: Sequence[Sequence[float]]) -> float:
        """By how much the colours of the first chart, which is in view, differ from those of another capture."""
        return float(np.abs(np.subtract(tab.page.evaluate(PAPER)[0], other[0])[:3]).max())

    for scheme in ("light", "dark"):
        tab.page.emulate_media(color_scheme=scheme)
        until(lambda: all(apart(one) > 10.0 for one in printed), "charts in the other colours")
        before = steady(lambda: until(lambda: tab.page.evaluate(PAPER), "charts"))
        tab.page.evaluate("dispatchEvent(new Event('beforeprint'))")
        tab.page.emulate_media(media="print", color_scheme=scheme)
        printed.append(tab.page.evaluate(PAPER))
        assert tab.page.locator(".controls, header.top").first.is_hidden()
        tab.page.emulate_media(media="screen", color_scheme=scheme)
        tab.page.evaluate("dispatchEvent(new Event('afterprint'))")
        until(lambda before=before: apart(before) < 3.0, f"{scheme} again")
    light, dark = map(np.array, printed)
    assert len(light) > 4
    assert np.abs(light - dark)[:, :3].max() < 3.0  # edges are smoothed by chance
    assert apart(printed[1]) > 10.0
