"""A report in headless Chromium, from a file: from a slider to the picture, and how it plays; drawn in software."""

from __future__ import annotations

import shutil
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

from .page_node import Missing

__all__ = ["Change", "Played", "changes", "played"]

BROWSERS = ("chromium", "chromium-browser", "google-chrome")
OPTIONS = ("--no-sandbox", "--enable-unsafe-swiftshader", "--use-gl=angle", "--use-angle=swiftshader")

LINES = ("--no-sandbox", "--disable-gpu", "--disable-3d-apis")
"""A browser without WebGL: the robot is drawn in lines, and no program that draws in 3D takes the processors."""

WATCH = """
window.answered = 0;
window.pictured = 0;
window.script = 0;
let last = -1;
window.Worker = class extends Worker {
  constructor(...given) {
    super(...given);
    this.addEventListener("message", ({ data }) => {
      if (data.kind !== "early") return;
      if (data.id !== last) [last, window.answered] = [data.id, performance.now()];
      if (data.run.scene) window.pictured = performance.now();
    });
  }
};
const ask = window.requestAnimationFrame;
window.requestAnimationFrame = (act) => ask.call(window, (now) => {
  const began = performance.now();
  act(now);
  window.script += performance.now() - began;
});
"""
"""Notes when the worker has answered what curves and picture need, and how long the page works on each frame."""

CHANGE = """async (share) => {
  const input = document.querySelector(".sliders-panel input[type=range]");
  const status = document.querySelector(".sliders-panel [role=status]");
  const reported = new Promise((done) => new MutationObserver((_, watch) => {
    if (!/^Simulated|could not/.test(status.textContent)) return;
    watch.disconnect();
    done(performance.now());
  }).observe(status, { childList: true, characterData: true, subtree: true }));
  status.textContent = "";
  const began = performance.now();
  input.value = String(Number(input.min) + share * (Number(input.max) - Number(input.min)));
  input.dispatchEvent(new Event("input", { bubbles: true }));
  const curves = await reported;
  const drawn = () => new Promise((done) => requestAnimationFrame(() => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = done;
    port2.postMessage(0);
  }));
  do await drawn(); while (window.pictured < began);
  const [answer, picture] = [window.answered, performance.now()];
  return { text: status.textContent, answer: answer - began, curves: curves - began, picture: picture - began };
}"""

PLAY = """async (seconds) => {
  const play = document.querySelector(".play");
  play.click();
  const [began, before] = [performance.now(), window.script];
  let frames = 0;
  await new Promise((done) => {
    const next = () => {
      if (performance.now() - began > 1000 * seconds) return done();
      frames += 1;
      requestAnimationFrame(next);
    };
    requestAnimationFrame(next);
  });
  play.click();
  return { rate: (1000 * frames) / (performance.now() - began), script: (window.script - before) / frames };
}"""


class Change(NamedTuple):
    """Since the slider moved [s]: time loops alone as the page reports, the model's answer, new curves, new picture."""

    loops: float
    answer: float
    curves: float
    picture: float


class Played(NamedTuple):
    """Time to open [s], frames in a second, script of a frame [s]."""

    opened: float
    rate: float
    script: float


@contextmanager
def _opened(report: Path, options: Sequence[str] = OPTIONS) -> Iterator[tuple[Any, float]]:
    """The page and the seconds after which its first picture was there."""
    try:
        from playwright.sync_api import sync_playwright
    except ImportError as absent:
        raise Missing("needs playwright: the extra test") from absent
    found = next(filter(None, map(shutil.which, BROWSERS)), None)
    if found is None:
        raise Missing(f"needs a browser: none of {', '.join(BROWSERS)} is installed")
    with sync_playwright() as engine:
        browser = engine.chromium.launch(executable_path=found, args=list(options))
        page = browser.new_context(viewport={"width": 1280, "height": 800}).new_page()
        page.add_init_script(WATCH)
        began = time.perf_counter()
        page.goto(report.as_uri())
        page.wait_for_selector("html.running", timeout=120_000)
        page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        yield page, time.perf_counter() - began
        browser.close()


def changes(report: Path, count: int, *, lines: bool = False, pause: float = 0.3) -> list[Change]:
    """The first slider moved so often, each time when all is at rest; what is loaded at the first two is left out."""
    with _opened(report, LINES if lines else OPTIONS) as (page, _):
        page.wait_for_selector(".sliders-panel [role=status]:text('Move a slider')", timeout=60_000)
        found = []
        for k in range(count + 2):
            time.sleep(pause)
            found.append(_change(page.evaluate(CHANGE, 0.3 + 0.4 * k / (count + 2))))
    return found[2:]


def _change(info: dict[str, Any]) -> Change:
    if "imulated in " not in info["text"]:
        raise RuntimeError(f"the page made no new run: {info['text']}")
    number, unit = info["text"].partition("imulated in ")[2].replace("\u00a0", " ").split(";")[0].split(" ")
    loops = float(number) * {"s": 1.0, "ms": 1e-3}[unit]
    return Change(loops, info["answer"] / 1e3, info["curves"] / 1e3, info["picture"] / 1e3)


def played(report: Path, seconds: float = 5.0) -> Played:
    """The page opened, and played for so long."""
    with _opened(report) as (page, opened):
        page.wait_for_timeout(3000)
        info = page.evaluate(PLAY, seconds)
    return Played(opened, info["rate"], info["script"] / 1e3)
