"""The robot in space as a page of its own in a real browser: built, opened, listened to, looked at."""

from __future__ import annotations

import base64
import hashlib
import io
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from patience import LONG, WAIT
from see.scenes import arm_result, robot_result
from tmodes import load, run
from tmodes.report.data import modes_of
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
SIZE = (460, 340)
NASTY = "<script>alert(1)</script>"

Picture = NDArray[np.int16]


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

        written = ".scene-note, .scene-overlay"
        notes = f"document.querySelectorAll('{written}').forEach((note) => (note.style.visibility = '{{}}'))"
        self.do(notes.format("hidden"))  # where they are, the robot is not: they keep their places
        self.page.wait_for_selector(".scene-view[data-still=true]")
        shot = self.page.locator(".scene-view").screenshot()
        self.page.evaluate(notes.format(""))
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
    context = browser.new_context(**options)
    context.set_default_timeout(WAIT)
    window = Window(context.new_page())
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


def built(folder: Path) -> str:
    """The program of the test page, built; skipped where Node or the packages are not."""
    node = shutil.which("node")
    if node is None or not (WEB / "node_modules" / "esbuild").is_dir():
        pytest.skip("needs Node and the packages of web/ (npm ci) to build the page")
    out = folder / "scene.js"
    command = [node, "--input-type=module", "-e", BUILD, "--", str(HERE / "scene_page.ts"), str(out)]
    subprocess.run(command, cwd=WEB, check=True, timeout=LONG)
    return out.read_text(encoding="utf-8").replace("</script", "<\\/script")


def run_of(result: Any, name: str) -> dict[str, Any]:
    """What the page gets of a run, as far as the scene needs it."""
    return {"name": name, "duration": float(result.data["time"][-1]), "scene": scene_of(result),
            "line": line_of(result), "modes": modes_of(result), "charts": [{}]}  # fmt: skip


def scene_pages(folder: Path) -> Callable[[str], Path]:
    """Pages by name, each made when it is asked for: the robot alone, an arm, three robots."""
    program = built(folder)
    made = {
        "robot": lambda: [run_of(robot_result(), NASTY)],
        "arm": lambda: [run_of(arm_result(), "arm")],
        "wide": lambda: [run_of(run(load("quanser_2dsfl", {"integration.duration": 1.0})), "wide")],
        "three": lambda: [run_of(robot_result(mass), f"{mass} kg") for mass in (0.5, 0.25, 1.0)],
    }
    digest = base64.b64encode(hashlib.sha256(program.encode()).digest()).decode()

    def page(name: str) -> Path:
        path = folder / f"{name}.html"
        if not path.exists():
            data = embedded(pack({"runs": made[name]()}))
            path.write_text(
                '<!doctype html><html lang=en><meta charset=utf-8><meta name="color-scheme" content="light dark">'
                f"<title>{name}</title>"
                f'<meta http-equiv="Content-Security-Policy" content="{POLICY.format(digest)}">'
                "<style>body { margin: 0; background: light-dark(#fff, #111) } #place { height: calc(100vh - 20px) }"
                "</style>"
                '<div id="place"></div>'
                f'<script type="text/plain" id="tmodes-data">{data}</script><script>{program}</script>',
                encoding="utf-8",
            )
        return path

    return page
