"""The robot in space in a real browser: drawn, moved by the clock, changed by controls, silent, gone when asked."""

from __future__ import annotations

import base64
import hashlib
import io
import shutil
import subprocess
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from see.scenes import arm_result, robot_result
from tmodes.report.mode_shapes import modes_of
from tmodes.report.pack import embedded, pack
from tmodes.report.scene import line_of, scene_of

HERE = Path(__file__).parent
WEB = HERE.parents[1] / "web"
BUILD = """
import { build } from "esbuild";
const [entry, outfile] = process.argv.slice(-2);
await build({ entryPoints: [entry], outfile, bundle: true, minify: true, format: "iife", target: "es2022",
  nodePaths: ["node_modules"] });
"""
POLICY = (
    "default-src 'none'; script-src 'sha256-{}' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; img-src data: blob:; "
    "worker-src blob:; connect-src 'none'"
)
OPTIONS = ["--no-sandbox", "--enable-unsafe-swiftshader", "--use-gl=angle", "--use-angle=swiftshader"]
SIZE = (460, 340)
NASTY = "<script>alert(1)</script>"

Picture = NDArray[np.int16]


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The program of the test page, built; skipped where Node or the packages are not."""
    node = shutil.which("node")
    if node is None or not (WEB / "node_modules" / "esbuild").is_dir():
        pytest.skip("needs Node and the packages of web/ (npm ci) to build the page")
    out = tmp_path_factory.mktemp("scene") / "scene.js"
    command = [node, "--input-type=module", "-e", BUILD, "--", str(HERE / "scene_page.ts"), str(out)]
    subprocess.run(command, cwd=WEB, check=True, timeout=60)
    return out.read_text(encoding="utf-8").replace("</script", "<\\/script")


@pytest.fixture(scope="module")
def engine() -> Iterator[Any]:
    """What drives browsers."""
    playwright = pytest.importorskip("playwright.sync_api", reason="needs playwright to look at the page")
    with playwright.sync_playwright() as started:
        yield started


@pytest.fixture(scope="module")
def browser(engine: Any, chromium: str) -> Iterator[Any]:
    """A headless browser that draws by a program."""
    opened = engine.chromium.launch(executable_path=chromium, args=OPTIONS)
    yield opened
    opened.close()


def run_of(result: Any, name: str) -> dict[str, Any]:
    """What the page gets of a run, as far as the scene needs it."""
    return {"name": name, "duration": float(result.data["time"][-1]), "scene": scene_of(result),
            "line": line_of(result), "modes": modes_of(result)}  # fmt: skip


@pytest.fixture(scope="module")
def pages(program: str, tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """Pages by name: the robot alone, an arm, three robots."""
    made = {
        "robot": lambda: [run_of(robot_result(), NASTY)],
        "arm": lambda: [run_of(arm_result(), "arm")],
        "three": lambda: [run_of(robot_result(mass), f"{mass} kg") for mass in (0.5, 0.25, 1.0)],
    }
    folder = tmp_path_factory.mktemp("pages")
    digest = base64.b64encode(hashlib.sha256(program.encode()).digest()).decode()

    def page(name: str) -> Path:
        path = folder / f"{name}.html"
        if not path.exists():
            data = embedded(pack({"runs": made[name]()}))
            path.write_text(
                '<!doctype html><html lang=en><meta charset=utf-8><meta name="color-scheme" content="light dark">'
                f"<title>{name}</title>"
                f'<meta http-equiv="Content-Security-Policy" content="{POLICY.format(digest)}">'
                "<style>body { margin: 0; background: light-dark(#fff, #111) } #place { height: 320px }</style>"
                '<div id="place"></div>'
                f'<script type="text/plain" id="tmodes-data">{data}</script><script>{program}</script>',
                encoding="utf-8",
            )
        return path

    return page


@dataclass
class Window:
    """An open page, with all that it said and asked for."""

    page: Any
    said: list[str] = field(default_factory=list)
    asked: list[str] = field(default_factory=list)

    def do(self, script: str) -> Any:
        """Run a script, and wait until the picture is drawn."""
        found = self.page.evaluate(script)
        self.page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        return found

    def picture(self) -> Picture:
        """The canvas as pixels, without what is written over it."""
        from PIL import Image

        self.do("document.querySelectorAll('.scene-note').forEach((note) => (note.style.display = 'none'))")
        shot = self.page.locator(".scene-view").screenshot()
        return np.asarray(Image.open(io.BytesIO(shot)).convert("RGB")).astype(np.int16)

    def choose(self, thing: str) -> None:
        """Tick or untick what may be shown."""
        self.do(f"document.querySelector('[data-scene={thing}]').click()")

    def enlarge(self, step: int) -> None:
        """Move the slider of the deformation."""
        slider = "document.querySelector('[data-scene=factor]')"
        self.do(f"(s => {{ s.value = {step}; s.dispatchEvent(new Event('input')); }})({slider})")

    def close(self) -> None:
        """Close it; it must have said nothing and asked for nothing but itself."""
        said = [line for line in self.said if "GPU stall" not in line]
        self.page.context.close()
        assert said == []
        assert len(self.asked) == 1


def look(browser: Any, path: Path, **how: Any) -> Window:
    """Open a page, and listen."""
    options = {"viewport": {"width": SIZE[0], "height": SIZE[1]}, "reduced_motion": "reduce"} | how
    window = Window(browser.new_context(**options).new_page())
    window.page.on("console", lambda message: window.said.append(message.text))
    window.page.on("pageerror", lambda error: window.said.append(str(error)))
    window.page.on("request", lambda request: window.asked.append(request.url))
    window.page.goto(path.as_uri())
    window.page.wait_for_function("window.ready")
    window.do("0")
    return window


def differing(one: Picture, other: Picture) -> int:
    """Number of pixels that differ to the eye."""
    return int((np.abs(one - other).max(axis=-1) > 24).sum())


@pytest.fixture(scope="module")
def opened(browser: Any, pages: Callable[[str], Path]) -> Iterator[Window]:
    """The page of the 2010 robot, once for all tests."""
    window = look(browser, pages("robot"))
    yield window
    window.close()


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
    factor = round(200**0.7)
    assert robot.page.locator(".scene-factor").text_content() == f"Deformation × {factor}"
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
    robot.page.locator("canvas").focus()
    robot.page.keyboard.press("ArrowLeft")
    robot.page.keyboard.press("+")
    turned = robot.picture()
    assert differing(seen[0], turned) > 300
    robot.page.get_by_role("button", name="Reset view").click()
    assert differing(seen[0], robot.picture()) == 0


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


def test_quality_is_low_by_itself_here_and_can_be_raised(robot: Window) -> None:
    width = robot.do("document.querySelector('canvas').width")
    assert width == pytest.approx(0.75 * robot.do("document.querySelector('canvas').clientWidth"), abs=1)
    first = robot.picture()
    robot.do("document.querySelector('details').open = true")
    robot.page.get_by_label("Quality").select_option("high")
    robot.do("document.querySelector('details').open = false")
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
    assert NASTY in window.page.locator("canvas").get_attribute("aria-label")
    window.do("document.querySelector('details').open = true")
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
