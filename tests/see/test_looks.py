"""Pages as they first look: the robot is off its notes, nothing is cut, blank, or mottled, and nobody is shut out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from patience import until
from see.conftest import seed_result
from see.looking import look
from see.pixels import drawn_under, notes_of, robot_pixels
from see.runs import result_of
from see.scenes import arm_result
from see.test_page import AXE
from tmodes import load, show
from tmodes.io.mesh_file import box, sphere
from tmodes.io.urdf_shapes import LinkShape
from tmodes.report.meshes import with_shapes

pytestmark = pytest.mark.nightly

PHONE = (390, 844)
SIZES = ((1280, 800), (1920, 1080), PHONE)
THICK = [LinkShape("hand", "#102030", sphere(0.25)), LinkShape("rod", "#102030", box([0.8, 0.2, 0.2]))]
"""Parts that reach far beyond the lines of their links."""
BLANK = """[...document.querySelectorAll('.chart-grid .chart')].filter((one) => !one.querySelector('canvas'))
  .map((one) => one.dataset.chart)"""
CUT = """() => { const view = document.querySelector('.scene-view').getBoundingClientRect();
  return [...document.querySelectorAll('.scene-note')].map((one) => [one.className, one.getBoundingClientRect()])
    .filter(([, box]) => box.height && (box.left < view.left || box.right > view.right + 0.5
      || box.top < view.top || box.bottom > view.bottom + 0.5)).map(([name]) => name) }"""
WIDE = """[...document.querySelectorAll('main *')].filter((one) => one.checkVisibility())
  .filter((one) => one.getBoundingClientRect().right > document.documentElement.clientWidth + 1)
  .map((one) => one.outerHTML.slice(0, 80))"""
BUTTONS = """[...document.querySelectorAll('main :is(button, select, input)')]
  .filter((one) => one.checkVisibility() && !one.matches('.jump, .toggle')).map((one) => one.outerHTML.slice(0, 80))"""


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory, reports: dict[str, Path]) -> dict[str, Path]:
    """A report, the viewer of two runs, robots with thick parts and at rest."""
    folder = tmp_path_factory.mktemp("looks")
    first = seed_result()
    two = show(first, seed_result(contact=False), names=["touching", "free"])
    return {
        "report": reports["good"],
        "two": two.save(folder / "two.html"),
        "same": show(first, first, names=["one", "other"]).save(folder / "same.html"),
        "bent": show(result_of("pendulum")).save(folder / "bent.html"),
        "thick": show(with_shapes(arm_result(), THICK)).save(folder / "thick.html"),
        "rest": show(load("spong1987")).save(folder / "rest.html"),
        "long": show(load("flexarm1990")).save(folder / "long.html"),
    }


def covered(frame: Any) -> dict[str, int]:
    """By note: pixels of the robot that it covers as the page opens; and those next to an edge of the view."""
    boxes = notes_of(frame)
    picture = robot_pixels(frame)
    assert drawn_under(picture, (0, 0, picture.shape[1] - 4, picture.shape[0])) > 300
    return {name: drawn_under(picture, box) for name, box in boxes.items()} | {"the edge": at_the_edge(picture)}


def at_the_edge(picture: np.ndarray) -> int:
    """Pixels of the robot next to an edge of the view."""
    high, wide, _ = picture.shape
    edges = (0, 0, 7, high), (wide - 11, 0, wide - 4, high), (0, 0, wide - 4, 7), (0, high - 7, wide - 4, high)
    return sum(drawn_under(picture, edge) for edge in edges)


@pytest.mark.parametrize("width", [700, 1100])
def test_in_a_notebook_the_view_is_as_wide_as_its_cell(browser: Any, tmp_path: Path, width: int) -> None:
    cell = f"<div id=cell style='width: {width}px'>{show(seed_result())._repr_html_()}</div>"
    (tmp_path / "cell.html").write_text(f"<!doctype html><body>{cell}", encoding="utf-8")
    context = browser.new_context(viewport={"width": 1280, "height": 900}, reduced_motion="reduce")
    page = context.new_page()
    page.goto((tmp_path / "cell.html").as_uri())
    frame = page.frames[1]
    frame.wait_for_selector("html.running")
    assert page.locator("iframe").bounding_box()["width"] == width
    assert frame.evaluate("document.documentElement.scrollWidth") == width
    assert frame.locator("#tmodes-app").bounding_box()["width"] > width - 60
    assert max(covered(frame).values()) == 0
    context.close()


@pytest.mark.parametrize(
    ("kind", "size"),
    [*(("report", size) for size in SIZES), *(("thick", size) for size in SIZES[::2]),
     ("two", PHONE), ("bent", SIZES[0]), ("rest", PHONE)],
)  # fmt: skip
def test_no_note_covers_the_robot_nor_is_either_cut(browser: Any, pages: dict[str, Path], kind: str, size: Any) -> None:
    window = look(browser, pages[kind], size)
    assert window.page.evaluate(CUT) == []
    assert window.page.evaluate("document.documentElement.scrollWidth") == size[0]
    assert {name: count for name, count in covered(window.page).items() if count} == {}
    assert window.said == []
    window.page.context.close()


def test_of_two_robots_in_one_place_one_hides_the_other(browser: Any, pages: dict[str, Path]) -> None:
    """No pattern of both colours: the first, blue, is before the second, red."""
    page = look(browser, pages["same"]).page
    page.locator("[data-scene=force]").evaluate("one => one.click()")
    picture = robot_pixels(page)
    more = picture[..., 2] - picture[..., 0]
    assert (more > 0.25).sum() > 300
    assert (more < -0.25).sum() < 0.03 * (more > 0.25).sum()
    page.context.close()


@pytest.mark.parametrize("kind", ["report", "two"])
def test_nothing_is_blank_in_a_picture_of_the_whole_page(browser: Any, pages: dict[str, Path], kind: str) -> None:
    """What is never scrolled to is drawn when there is time."""
    page = look(browser, pages[kind], (1280, 640), idle=True).page
    until(lambda: page.evaluate(BLANK) == [], "every chart")
    until(lambda: " s. The scales" in page.locator(".panel .note").first.text_content(), "the elastic line")
    assert page.evaluate("scrollY") == 0
    page.context.close()


@pytest.mark.parametrize("kind", ["report", "two", "rest"])
def test_paper_shows_all_and_nothing_to_press(browser: Any, pages: dict[str, Path], kind: str) -> None:
    page = look(browser, pages[kind], (794, 1123)).page
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    assert page.evaluate(BLANK) == []
    assert page.evaluate(WIDE) == []
    assert page.evaluate(BUTTONS) == []
    page.context.close()


def test_at_rest_nothing_is_said_of_what_is_not_there(browser: Any, pages: dict[str, Path]) -> None:
    page = look(browser, pages["rest"]).page
    assert page.locator(".status").inner_text() == "The robot stands still: nothing was simulated."
    assert page.locator(".scene-legend").is_hidden()
    assert page.locator(".scene-scale").is_hidden()
    page.context.close()


@pytest.mark.parametrize("kind", ["rest", "long"])
def test_on_a_phone_modes_can_be_shown(browser: Any, pages: dict[str, Path], kind: str) -> None:
    """Also where elements have long names."""
    page = look(browser, pages[kind], PHONE).page
    boxes = [one.bounding_box() for one in page.locator(".panel td button").all()]
    assert boxes
    assert all(box["x"] + box["width"] <= PHONE[0] - 16 for box in boxes)
    page.context.close()


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("kind", ["two", "rest"])
def test_axe_finds_nothing(browser: Any, pages: dict[str, Path], kind: str, scheme: str) -> None:
    if not AXE.is_file():
        pytest.skip("needs axe-core: npm ci in web/")
    window = look(browser, pages[kind], scheme=scheme, bypass_csp=True)
    window.page.add_script_tag(path=AXE)
    found = window.page.evaluate("axe.run(document, {resultTypes: ['violations']})")
    assert [(one["id"], one["nodes"][0]["html"][:120]) for one in found["violations"]] == []
    window.page.context.close()
