"""The robot in space in a real browser: drawn, moved by the clock, changed by controls, silent, gone when asked.

With WebGL and without: the same data and choices.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from see.scene_window import NASTY, WEB, Window, differing, look
from see.scenes import arm_result

pytestmark = pytest.mark.nightly


@pytest.fixture(scope="module", params=["browser", "bare"])
def opened(request: pytest.FixtureRequest, pages: Callable[[str], Path]) -> Iterator[Window]:
    """The page of the 2010 robot, once for all tests: in space, and on a flat canvas where there is no WebGL."""
    window = look(request.getfixturevalue(request.param), pages("robot"))
    yield window
    window.close()


solid = pytest.mark.parametrize("opened", ["browser"], indirect=True)
"""Of the scene in 3D alone."""


@pytest.fixture
def robot(opened: Window) -> Window:
    """The 2010 robot's scene, made again."""
    opened.do("view.dispose(); clock.seek(0); window.view = mount()")
    return opened


def test_it_is_drawn_and_moved_by_the_clock_alone(robot: Window) -> None:
    first = robot.picture()
    assert len(np.unique(first.reshape(-1, 3), axis=0)) > 300
    assert differing(first, robot.picture()) == 0
    robot.do("clock.seek(0.2)")
    assert differing(first, robot.picture()) > 300
    robot.do("clock.seek(0)")
    assert differing(first, robot.picture()) == 0


def test_enlarged_deformation_changes_the_picture_and_says_so(robot: Window) -> None:
    robot.do("clock.seek(0.15)")
    first = robot.picture()
    assert robot.page.locator(".scene-factor").is_hidden()
    robot.enlarge(70)
    assert differing(first, robot.picture()) > 300
    factor = robot.page.locator(".scene-factor-row output").text_content()
    assert robot.page.locator(".scene-factor").text_content() == f"Deformation × {factor[1:]}, not to scale"
    robot.enlarge(0)
    assert differing(first, robot.picture()) == 0


def test_ghosts_surface_and_force_come_and_go(robot: Window) -> None:
    robot.do("clock.seek(0.15)")
    for thing in ("surface", "force", "traces", "floor", "reference", "rigid"):
        robot.enlarge(80 if thing in {"reference", "rigid"} else 0)
        first = robot.picture()
        robot.choose(thing)
        assert differing(first, robot.picture()) > 40, thing
        robot.choose(thing)
        assert differing(first, robot.picture()) == 0, thing


def test_cameras_show_other_sides_and_come_back(robot: Window) -> None:
    views = robot.page.get_by_label("View", exact=True)
    seen = []
    for name in ("iso", "front", "side", "top", "tip"):
        views.select_option(name)
        seen.append(robot.picture())
    pairs = [(one, other) for k, one in enumerate(seen) for other in seen[:k]]
    assert all(differing(one, other) > 300 for one, other in pairs)
    views.select_option("iso")
    robot.page.locator("canvas[tabindex]").focus()
    robot.page.keyboard.press("ArrowLeft")
    robot.page.keyboard.press("+")
    turned = robot.picture()
    assert differing(seen[0], turned) > 300
    robot.page.get_by_role("button", name="Reset view").click()
    assert differing(seen[0], robot.picture()) == 0


def test_it_opens_bent_and_no_scale_leaves_the_picture(robot: Window) -> None:
    """What bends much is to scale; at the largest scale, and back, all of the robot is seen."""
    robot.do("view.dispose(); window.view = mount(true); clock.seek(view.opensAt)")
    shown = """(() => {
      const { line, rigid, times } = page.runs[0].scene;
      const [count, size] = [times.data.length, line.data.length / times.data.length];
      const far = Array.from({ length: count }, (_, k) => Math.max(...Array.from({ length: size / 3 }, (_, j) =>
        Math.hypot(...[0, 1, 2].map((c) => line.data[k * size + 3 * j + c] - rigid.data[k * size + 3 * j + c])))));
      return [view.opensAt, times.data[far.indexOf(Math.max(...far))], Math.max(...far)];
    })()"""
    opens, bent, size = robot.do(shown)
    assert opens == bent
    factor = float(robot.page.locator(".scene-factor-row output").text_content()[1:])
    assert factor == 1 or 0.05 < factor * size < 0.15
    assert "Undeformed" in robot.page.locator(".scene-legend").text_content()
    robot.choose("floor")
    robot.choose("surface")
    for step in (100, 0):
        robot.enlarge(step)
        shot = robot.picture()
        assert differing(shot[[0, -1], 1:], shot[[0, -1], :-1]) == 0  # nothing but the sky is at the edge


def test_a_wide_link_stays_in_the_picture(browser: Any, pages: Callable[[str], Path]) -> None:
    window = look(browser, pages("wide"))
    window.do("view.dispose(); window.view = mount(true)")
    window.choose("floor")
    for time in (0.0, 0.3, 0.5, 0.7, 1.0):
        window.do(f"clock.seek({time})")
        shot = window.picture()
        assert differing(shot[[0, -1], 1:], shot[[0, -1], :-1]) == 0
        assert differing(shot[1:, [0, -1]], shot[:-1, [0, -1]]) == 0
    window.close()


def test_modes_are_animated_and_end(robot: Window) -> None:
    first = robot.picture()
    robot.do("view.showMode(page.runs[0].modes[2], 0.15)")
    shown = robot.picture()
    assert differing(first, shown) > 300
    assert "Hz" in robot.page.locator(".scene-legend").text_content()
    robot.do("view.showMode(page.runs[0].modes[3], 0.15)")
    assert differing(shown, robot.picture()) > 300
    robot.do("view.showMode(null, 0)")
    assert differing(first, robot.picture()) == 0


def test_a_changed_run_stands_next_to_the_page_s_own(robot: Window) -> None:
    robot.do("clock.seek(0.15)")
    first = robot.picture()
    raised = """(() => {
      const scene = page.runs[0].scene;
      const raised = (array) => Float32Array.from(array.data, (x, k) => x + (k % 3 === 2 ? 0.1 : 0));
      const up = (array) => ({ shape: array.shape, data: raised(array) });
      const few = (array) => ({ shape: [array.shape[0] - 5, ...array.shape.slice(1)], data: array.data });
      view.replace(0, { ...scene, times: few(scene.times), line: few(up(scene.line)), tip: few(up(scene.tip)) });
    })()"""
    robot.do(raised)
    assert differing(first, robot.picture()) > 300
    assert "The run as it was" in robot.page.locator(".scene-legend").text_content()
    robot.do("view.replace(0, null)")
    assert differing(first, robot.picture()) == 0
    assert "The run as it was" not in robot.page.locator(".scene-legend").text_content()


@solid
def test_the_way_of_the_tip_is_whole_after_a_shorter_run(robot: Window) -> None:
    """Drawn after a run of a quarter of its frames, a run is the same picture as drawn at once."""
    robot.do("clock.seek(page.runs[0].duration)")
    robot.do("""void (window.shown = (frames) => {
      const scene = page.runs[0].scene;
      const cut = ({ shape: [all, ...rest], data }) =>
        ({ shape: [frames, ...rest], data: data.slice(0, data.length / all * frames) });
      const arrays = ["times", "line", "roots", "tip"].map((name) => [name, cut(scene[name])]);
      view.replace(0, { ...scene, ...Object.fromEntries(arrays) });
    })""")
    count = robot.do("page.runs[0].scene.times.shape[0]")
    robot.do(f"shown({count})")
    whole = robot.picture()
    robot.do("view.dispose(); window.view = mount()")
    robot.do(f"shown({count // 4})")
    assert differing(whole, robot.picture()) > 40
    robot.do(f"shown({count})")
    assert differing(whole, robot.picture()) < 20  # of 342 where the way ends early


@solid
def test_quality_is_low_while_it_moves_and_can_be_raised(robot: Window) -> None:
    """What stands still has twice the page's pixels, which smooth its edges."""
    first = robot.picture()
    across = robot.do("document.querySelector('canvas').clientWidth")
    assert robot.do("document.querySelector('canvas').width") == pytest.approx(2 * across, abs=1)
    moved = """new Promise((done) => { clock.seek(0.01); requestAnimationFrame(() => requestAnimationFrame(() =>
        done(document.querySelector('canvas').width))); })"""
    width = robot.page.evaluate(moved)
    assert width == pytest.approx(0.75 * across, abs=1)
    robot.do("clock.seek(0)")
    robot.page.get_by_role("button", name="Show").click()
    robot.page.get_by_label("Quality").select_option("high")
    robot.page.keyboard.press("Escape")
    assert robot.do("document.querySelector('canvas').width") > width
    assert differing(first, robot.picture()) > 300


def test_nothing_is_left_when_it_goes(robot: Window) -> None:
    robot.do("view.dispose()")
    assert robot.do("place.childElementCount") == 0
    robot.do("clock.seek(0.1)")
    robot.do("window.view = mount()")
    assert len(np.unique(robot.picture().reshape(-1, 3), axis=0)) > 300


def test_the_scale_reports_the_largest_value_and_its_unit(browser: Any, pages: Callable[[str], Path]) -> None:
    window = look(browser, pages("arm"))
    window.page.get_by_label("Colour").select_option("stress")
    info = window.page.locator(".scene-scale").inner_text().replace("\xa0", " ")
    largest = arm_result().data["stress"].max().item() / 1e6
    assert "[MPa]" in info
    assert f"{largest:.3g}" in info
    window.close()


def test_three_robots_in_one_scene_and_side_by_side(browser: Any, pages: Callable[[str], Path]) -> None:
    window = look(browser, pages("three"))
    legend = window.page.locator(".scene-legend").inner_text()
    assert all(name in legend for name in ("0.5 kg", "0.25 kg", "1.0 kg"))
    first = window.picture()
    window.choose("apart")
    assert differing(first, window.picture()) > 300
    window.close()


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_controls_have_names_and_a_nasty_name_stays_text(
    browser: Any, pages: Callable[[str], Path], scheme: str
) -> None:
    axe = WEB / "node_modules" / "axe-core" / "axe.min.js"
    window = look(browser, pages("robot"), color_scheme=scheme)
    assert NASTY in window.page.locator("canvas[tabindex]").get_attribute("aria-label")
    window.page.get_by_role("button", name="Show").click()
    window.page.evaluate(axe.read_text(encoding="utf-8"))
    found = window.page.evaluate("axe.run('.scene', { resultTypes: ['violations'] })")
    assert [one["id"] for one in found["violations"] if one["impact"] in {"serious", "critical"}] == []
    window.close()


def test_enlarging_is_linear_about_the_rigid_robot(browser: Any, pages: Callable[[str], Path]) -> None:
    window = look(browser, pages("arm"))
    script = """(factor) => {
      const motion = new Motion(page.runs[0].scene);
      motion.seek(0.2, factor, null);
      return [[...motion.line], [...motion.rigid], [...motion.tip]];
    }"""
    once, rigid, tip = (np.array(part) for part in window.page.evaluate(script, 1))
    enlarged, same, far = (np.array(part) for part in window.page.evaluate(script, 50))
    assert rigid == pytest.approx(same)
    assert np.abs(enlarged - (rigid + 50 * (once - rigid))).max() < 1e-4
    end = slice(len(once) - 3, len(once))
    assert far - tip == pytest.approx(enlarged[end] - once[end], abs=1e-4)
    window.close()
