"""Takes the pictures of the pages in docs/: ``python tools/gallery.py [NAME…]``.

``python tools/gallery.py --look FOLDER [PAGE…]`` takes those to judge the pages by: the first screen of each of
``LOOKED_AT``, at four widths, light and dark; they are in no repository.

Needs a Chromium browser and playwright (``pip install -e ".[test]"``). Each picture's command is next to it in
docs/gallery.md, docs/how-stiff.md or docs/paper.md; this runs it in a folder with the files of examples/studies, opens
what it wrote, does what the caption says, and takes the picture. A figure for print is copied.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

__all__ = ["LOOKED_AT", "SHOTS", "Shot", "main"]

ROOT = Path(__file__).resolve().parents[1]
TARGET = ROOT / "docs" / "images"
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
FLAGS = ["--no-sandbox", "--enable-unsafe-swiftshader", "--use-gl=angle", "--use-angle=swiftshader"]
TMODES = (sys.executable, "-m", "tmodes.cli.main")
WAIT = 60_000
DRAWN = ".scene-view canvas, .study-area > svg:not(:empty)"


@dataclass(frozen=True)
class Shot:
    """A picture: the commands that make its page, which page that is, and what is done there.

    ``page``: a file, or the command of a server that says its address.
    """

    commands: tuple[str, ...]
    page: str
    act: Callable[[Any], None] = lambda page: None
    scheme: str = "light"
    height: int = 800
    width: int = 1280


def _mode(page: Any) -> None:
    page.locator("button[aria-label^='Show the mode']").nth(1).click()
    page.evaluate("scrollTo(0, 0)")


def _what_if(page: Any) -> None:
    page.get_by_label("mass, payload on forearm, in kg").first.fill("3")
    page.wait_for_selector("text=run as it was", timeout=WAIT)


def _studio(page: Any) -> None:
    line = page.locator(".line", has_text="New curves")
    line.wait_for(timeout=WAIT)
    page.evaluate("document.querySelector('.line').textContent = ''")
    page.locator("[data-slider='links.1.bodies.1.mass'] input.number").fill("3")
    page.keyboard.press("Enter")
    line.wait_for(timeout=WAIT)


def _worst(page: Any) -> None:
    page.get_by_role("button", name="largest", exact=True).click()


_ARM = ("run two_link_arm --out arm",)
_PAPER = ("run filipovic2010_vibrating --out vibrating", "figures vibrating --paper")
SHOTS: dict[str, Shot] = {
    "gallery-report": Shot(_ARM, "arm/report.html"),
    "gallery-report-dark": Shot(_ARM, "arm/report.html", scheme="dark"),
    "gallery-what-if": Shot(_ARM, "arm/report.html", _what_if),
    "gallery-arm": Shot(("run manutec_r3 --out manutec",), "manutec/report.html"),
    "gallery-mode": Shot(("run deluca_siciliano1991 --out deluca",), "deluca/report.html", _mode),
    "gallery-compare": Shot(
        (
            "run two_link_arm --out known",
            "run two_link_arm --set payload.mass=3 --out heavier",
            "run two_link_arm --set elbow.gear.stiffness=4000 --out softer",
            "view known heavier softer --out compare.html --no-open",
        ),
        "compare.html",
    ),
    "gallery-studio": Shot((), "studio two_link_arm --no-open --folder my-robot", _studio),
    "how-stiff-sweep": Shot(("study gear_sweep.yaml --out sweep",), "sweep/study.html", height=470),
    "how-stiff-known": Shot(("study gear_known.yaml --out known",), "known/study.html", _worst),
    "how-stiff-both": Shot(("study gear_and_payload.yaml --out both",), "both/study.html", height=560),
    "how-stiff-compared": Shot(
        (
            "run filipovic2010 --out before",
            "run filipovic2010 --set gear.stiffness=11800 --set gear.damping=4.1 --out after",
            "view before after --out compared.html --no-open",
        ),
        "compared.html",
    ),
    **{f"paper-figure-{k}": Shot(_PAPER, f"vibrating/figures/figure_{k}.svg") for k in (6, 7, 8)},
    "paper-figure-8-first": Shot(
        ("run filipovic2010 --out first", "figures first --paper"), "first/figures/figure_8.svg"
    ),
}


_ROBOTS = (
    "two_link_arm", "filipovic2010", "filipovic2010_vibrating", "deluca_siciliano1991", "flexarm1990", "manutec_r3",
    "quanser_2dsfl", "spong1987",
)  # fmt: skip
LOOKED_AT: dict[str, tuple[str, ...]] = {
    **{name: (f"run {name} --out {name}", f"{name}/report.html") for name in _ROBOTS},
    "study": ("study gear_sweep.yaml --out sweep", "sweep/study.html"),
    "sensitivity": ("sensitivity elastic_arm.yaml --out sensitive", "sensitive/study.html"),
    "optimize": ("optimize tube.yaml --out best", "best/designs.html"),
    "viewer": (*SHOTS["gallery-compare"].commands, "compare.html"),
}
"""By the name of a page the commands that make it, and its file: robots of all kinds, studies and the viewer."""

_SIZES = ((1280, 800), (1440, 900), (1920, 1080), (390, 844))


def _looks(pages: list[str]) -> dict[str, Shot]:
    """The pictures by which some pages, or all, are judged."""
    return {
        f"{name}-{width}-{scheme}": Shot(
            LOOKED_AT[name][:-1], LOOKED_AT[name][-1], scheme=scheme, height=height, width=width
        )
        for name in pages or LOOKED_AT
        for width, height in _SIZES
        for scheme in ("light", "dark")
    }


def main(wanted: list[str]) -> int:
    """Take the wanted pictures, or all; the exit code."""
    target, shots = TARGET, SHOTS
    if wanted[:1] == ["--look"]:
        target, pages = Path(wanted[1]), wanted[2:]
        target.mkdir(parents=True, exist_ok=True)
        shots, wanted = _looks(pages), []
    unknown = [name for name in wanted if name not in shots]
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if unknown or browser is None:
        info = f"{unknown}; expected {', '.join(shots)}" if unknown else "no browser; expected Chromium"
        print(f"gallery: got {info}", file=sys.stderr)
        return 2
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as folder, sync_playwright() as engine:
        opened = engine.chromium.launch(executable_path=browser, args=FLAGS)
        for name in wanted or shots:
            _take(opened, target / name, shots[name], _made(Path(folder), shots[name].commands))
        opened.close()
    return 0


@cache
def _made(place: Path, commands: tuple[str, ...]) -> Path:
    """The folder in which some commands ran, once, next to the files of the examples."""
    work = Path(tempfile.mkdtemp(dir=place))
    shutil.copytree(ROOT / "examples" / "studies", work, dirs_exist_ok=True)
    for command in commands:
        subprocess.run([*TMODES, *command.split()], cwd=work, check=True, capture_output=True)
    return work


def _take(browser: Any, place: Path, shot: Shot, work: Path) -> None:
    if shot.page.endswith(".svg"):
        shutil.copy(work / shot.page, place.with_suffix(".svg"))
        return
    size = {"width": shot.width, "height": shot.height}
    context = browser.new_context(viewport=size, color_scheme=shot.scheme, reduced_motion="reduce")
    with _address(shot.page, work) as address:
        page = context.new_page()
        page.goto(address)
        page.wait_for_selector(DRAWN, timeout=WAIT)
        shot.act(page)
        page.locator(".advice.computing, .verdict-sentence[data-state=' computing …']").first.wait_for(
            state="hidden", timeout=WAIT
        )
        page.wait_for_timeout(3000)  # software rendering takes its time
        target = place.with_suffix(".png")
        page.screenshot(path=target)
        context.close()
    print(f"{target.name}: {target.stat().st_size / 1e3:.0f} kB")


@contextmanager
def _address(page: str, work: Path) -> Iterator[str]:
    """Where a page is, as long as its server runs."""
    if (work / page).exists():
        yield (work / page).as_uri()
        return
    words = page.split()
    (work / words[words.index("--folder") + 1]).mkdir(exist_ok=True)  # its name is in the picture
    with subprocess.Popen([*TMODES, *words], cwd=work, stdout=subprocess.PIPE, text=True) as server:
        try:
            yield next(word for line in server.stdout or () for word in line.split() if word.startswith("http://"))
        finally:
            server.terminate()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
