"""The robot without WebGL: the same data and choices as lines on a flat canvas, also when a context is lost."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import combinations, pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from patience import until
from see.scene_window import Picture, Window, differing, look

pytestmark = pytest.mark.nightly

FORCE = (0xB3, 0x26, 0x1E)
"""Colour of the arrow of the contact force on white."""
LOSE = "window.lost = document.querySelector('canvas').getContext('webgl2').getExtension('WEBGL_lose_context')"
MESH = """(() => {
  view.dispose();
  page.runs[0].scene.meshes.push({ link: 0, colour: "#888888", vertices: { data: new Float32Array(9), shape: [3, 3] },
    faces: { data: new Uint32Array([0, 1, 2]), shape: [1, 3] } });
  window.view = mount();
  page.runs[0].scene.meshes.pop();
})()"""


@pytest.fixture(scope="module")
def opened(bare: Any, pages: Callable[[str], Path]) -> Iterator[Window]:
    """The page of the 2010 robot in that browser; it says nothing and asks for nothing."""
    window = look(bare, pages("robot"))
    assert window.do("document.createElement('canvas').getContext('webgl2') ?? 'none'") == "none"
    yield window
    window.close()


@pytest.fixture
def robot(opened: Window) -> Window:
    """The 2010 robot's scene, made again."""
    opened.do("view.dispose(); clock.seek(0); window.view = mount()")
    return opened


def colours(picture: Picture) -> int:
    """How many colours it shows."""
    return len(np.unique(picture.reshape(-1, 3), axis=0))


def middle(picture: Picture, colour: tuple[int, int, int]) -> tuple[np.ndarray, int]:
    """Where in the picture a colour is [px], and of how many pixels."""
    found = np.argwhere(np.abs(picture - np.array(colour)).max(axis=-1) < 12)
    return found.mean(axis=0), len(found)


def test_mouse_wheel_keys_and_presets_turn_it(robot: Window) -> None:
    first = robot.picture()
    box = robot.page.locator("canvas[tabindex]").bounding_box()
    robot.page.mouse.move(box["x"] + 200, box["y"] + 100)
    robot.page.mouse.down()
    robot.page.mouse.move(box["x"] + 260, box["y"] + 100, steps=3)
    robot.page.mouse.up()
    turned = robot.picture()
    assert differing(first, turned) > 300
    robot.page.mouse.wheel(0, -300)
    until(lambda: differing(turned, robot.picture()) > 300)
    robot.page.get_by_role("button", name="Reset view").click()
    assert differing(first, robot.picture()) == 0
    robot.page.locator("canvas[tabindex]").focus()
    robot.page.keyboard.press("ArrowLeft")
    assert differing(first, robot.picture()) > 300
    robot.page.get_by_label("View", exact=True).select_option("top")
    assert differing(first, robot.picture()) > 300


def test_colours_are_of_the_chosen_quantity_and_have_their_scale(robot: Window) -> None:
    first = robot.picture()
    assert "Bending moment [" in robot.page.locator(".scene-scale").inner_text().replace("\xa0", " ")
    robot.page.get_by_label("Colour").select_option("run")
    assert robot.page.locator(".scene-scale").is_hidden()
    assert differing(first, robot.picture()) > 100


def test_a_surface_that_moved_is_drawn_where_it_is(robot: Window) -> None:
    robot.do("""void (window.moved = (up) => {
      const { scene } = page.runs[0];
      const surface = structuredClone(scene.contact.surface);
      (surface.center ?? surface.position)[0] += up;
      view.replace(0, { ...scene, contact: { ...scene.contact, surface } });
    })""")
    robot.do("moved(0)")
    first = robot.picture()
    robot.do("moved(0.1)")
    assert differing(first, robot.picture()) > 100
    robot.do("moved(0)")
    assert differing(first, robot.picture()) == 0


def test_it_reports_what_it_leaves_out(robot: Window) -> None:
    info = robot.page.locator(".scene-flat")
    assert info.text_content() == "Drawn in lines, without WebGL"
    robot.do(MESH)
    assert "meshes) are left out" in info.text_content()


def test_it_has_no_choice_of_quality(robot: Window) -> None:
    assert robot.page.locator(".menu-panel").get_by_text("Quality").count() == 0


ROBOTS = ((79, 176, 234), (255, 143, 69), (62, 207, 155))
"""Colours of three runs, in the dark."""


def columns(picture: np.ndarray) -> list[tuple[int, int]]:
    """From where to where each robot is drawn, across the picture."""
    near = (np.abs(picture[..., :3].astype(int) - colour).max(axis=-1) < 12 for colour in ROBOTS)
    return [(int(found.min()), int(found.max())) for found in (np.flatnonzero(one.any(axis=0)) for one in near)]


@pytest.mark.parametrize("view", ["iso", "front", "side", "top"])
def test_dark_and_with_several_robots(bare: Any, pages: Callable[[str], Path], view: str) -> None:
    """One robot's runs lie over each other; side by side they do so from wherever one looks."""
    window = look(bare, pages("three"), color_scheme="dark")
    window.page.get_by_label("View", exact=True).select_option(view)
    for thing in ("traces", "force"):
        window.choose(thing)
    together = window.picture()
    assert together[:30].mean() < 128
    window.choose("apart")
    apart = columns(window.picture())
    assert all(one[1] < other[0] for one, other in pairwise(sorted(apart))), apart
    window.close()


def test_it_is_seen_where_webgl_shows_it_and_follows_a_lost_context(
    browser: Any, bare: Any, pages: Callable[[str], Path]
) -> None:
    """The arrow of the contact force is in the same place, drawn either way; and again, once the context is lost."""
    large = {"viewport": {"width": 460, "height": 640}}  # the arrow is thicker than a pixel
    window, flat = look(browser, pages("robot"), **large), look(bare, pages("robot"), **large)
    for one in (window, flat):
        one.do("clock.seek(0.15)")
        one.choose("surface")
    solid, lines = window.picture(), flat.picture()
    (there, count), (here, few) = middle(solid, FORCE), middle(lines, FORCE)
    assert min(count, few) > 25
    assert np.abs(there - here).max() < 4.0
    window.do(LOSE)
    window.do("lost.loseContext()")
    window.page.wait_for_selector(".scene-flat:not([hidden])", state="attached")
    window.do("0")
    assert differing(window.picture(), lines) < 0.2 * differing(solid, lines)  # edges are smoothed otherwise
    window.said[:] = [line for line in window.said if "Context Lost" not in line]
    window.close()
    flat.close()


def test_a_context_that_comes_back_is_used_again(browser: Any, pages: Callable[[str], Path]) -> None:
    window = look(browser, pages("robot"))
    window.page.clock.install()
    first = window.picture()
    window.do(LOSE)
    window.do("lost.loseContext()")
    window.do("lost.restoreContext()")
    window.page.clock.run_for(10_000)
    assert window.page.locator(".scene-flat").is_hidden()
    assert differing(first, window.picture()) == 0
    window.said[:] = [line for line in window.said if "Context" not in line]
    window.close()


def test_lines_can_be_chosen_where_there_is_webgl(browser: Any, pages: Callable[[str], Path]) -> None:
    """They are quicker to draw where a program does it; what is chosen otherwise stays."""
    window = look(browser, pages("robot"))
    window.enlarge(70)
    first = window.picture()
    window.page.get_by_role("button", name="Show").click()
    window.page.get_by_label("Quality").select_option("lines")
    window.page.keyboard.press("Escape")
    assert window.page.locator(".scene-flat").text_content() == "Drawn in lines"
    lines = window.picture()
    assert differing(first, lines) > 300
    assert window.page.locator(".scene-factor").text_content().startswith("Deformation × ")
    window.page.get_by_role("button", name="Show").click()
    window.page.get_by_label("Quality").select_option("auto")
    window.page.keyboard.press("Escape")
    assert differing(first, window.picture()) < 0.1 * differing(first, lines)
    window.close()


NOTES = """() => [...document.querySelectorAll('.scene-note')].filter((one) => one.checkVisibility())
  .map((one) => [one.className, one.getBoundingClientRect()])
  .map(([name, { left, top, right, bottom }]) => [name, left, top, right, bottom])"""
"""The notes over the picture and where they stand [px]."""


@pytest.mark.parametrize("width", [375, 700])
def test_no_note_covers_another(bare: Any, pages: Callable[[str], Path], width: int) -> None:
    """Also on a phone, where the words about the grid take two lines, with the deformation enlarged."""
    window = look(bare, pages("robot"), viewport={"width": width, "height": 740})
    window.do(MESH)
    window.enlarge(70)
    found = window.page.evaluate(NOTES)
    assert {"scene-flat", "scene-grid", "scene-factor"} <= {name.split()[-1] for name, *_ in found}
    apart = [
        min(one[3], other[3]) <= max(one[1], other[1]) or min(one[4], other[4]) <= max(one[2], other[2])
        for one, other in combinations(found, 2)
    ]
    assert all(apart), found
    assert all(left >= 0 and right <= width for _, left, _, right, _ in found)
    window.close()
