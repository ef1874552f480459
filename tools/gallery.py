"""Takes the pictures of docs/gallery.md from pages that commands made: ``python tools/gallery.py [NAME…]``.

Needs a Chromium browser and playwright (``pip install -e ".[test]"``). Each picture's command is next to it on the
page; this runs it, opens what it wrote, does what the caption says, and takes the picture.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

__all__ = ["SHOTS", "Shot", "main"]

TARGET = Path(__file__).resolve().parents[1] / "docs" / "images"
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
FLAGS = ["--no-sandbox", "--enable-unsafe-swiftshader", "--use-gl=angle", "--use-angle=swiftshader"]
TMODES = (sys.executable, "-m", "tmodes.cli.main")
SIZE = {"width": 1280, "height": 800}


@dataclass(frozen=True)
class Shot:
    """A picture: the commands that make its page, which page that is, and what is done there.

    ``page``: a file, or the command of a server that says its address.
    """

    commands: tuple[str, ...]
    page: str
    act: Callable[[Any], None]
    scheme: str = "light"


def _seek(page: Any, share: float) -> None:
    page.get_by_label("Time", exact=True).last.evaluate(
        f"bar => {{ bar.value = {1000 * share}; bar.dispatchEvent(new Event('input')); }}"
    )


def _slide(page: Any, label: str, share: float) -> None:
    """Move a slider to a share of its way."""
    page.get_by_label(label).first.evaluate(
        "(bar, share) => { bar.value = String(Number(bar.min) + share * (Number(bar.max) - Number(bar.min)));"
        " bar.dispatchEvent(new Event('input')); bar.dispatchEvent(new Event('change')); }",
        share,
    )


def _report(page: Any) -> None:
    _seek(page, 0.7)


def _arm(page: Any) -> None:
    _seek(page, 0.35)
    _slide(page, "Deformation", 0.45)


def _mode(page: Any) -> None:
    page.get_by_role("button", name="Show the mode").nth(1).click()
    page.evaluate("scrollTo(0, 0)")


def _compare(page: Any) -> None:
    _seek(page, 0.4)


def _what_if(page: Any) -> None:
    page.get_by_label("mass at the tip, in kg").fill("1.2")
    page.wait_for_selector("text=the run as it was")
    _seek(page, 0.7)


def _studio(page: Any) -> None:
    page.wait_for_selector("canvas", timeout=60_000)
    page.get_by_label("mass at the tip").first.fill("800")
    page.wait_for_selector("text=New curves", timeout=60_000)
    _seek(page, 0.7)


SHOTS: dict[str, Shot] = {
    "report": Shot(("run filipovic2010 --out seed",), "seed/report.html", _report),
    "report-dark": Shot(("run filipovic2010 --out seed",), "seed/report.html", _report, "dark"),
    "what-if": Shot(("run filipovic2010 --out seed",), "seed/report.html", _what_if),
    "arm": Shot(("run manutec_r3 --out manutec",), "manutec/report.html", _arm),
    "mode": Shot(("run deluca_siciliano1991 --out deluca",), "deluca/report.html", _mode),
    "compare": Shot(
        (
            "run filipovic2010 --out known",
            "run filipovic2010 --set payload.mass=0.6 --out heavier",
            "run filipovic2010 --set gear.stiffness=400 --out softer",
            "view known heavier softer --out compare.html --no-open",
        ),
        "compare.html",
        _compare,
    ),
    "studio": Shot((), "studio filipovic2010 --no-open --folder my-robot", _studio),
}


def main(wanted: list[str]) -> int:
    """Take the wanted pictures, or all; the exit code."""
    unknown = [name for name in wanted if name not in SHOTS]
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if unknown or browser is None:
        info = f"{unknown}; expected {', '.join(SHOTS)}" if unknown else "no browser; expected Chromium"
        print(f"gallery: got {info}", file=sys.stderr)
        return 2
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as work, sync_playwright() as engine:
        opened = engine.chromium.launch(executable_path=browser, args=FLAGS)
        for name in wanted or SHOTS:
            _take(opened, name, SHOTS[name], Path(work))
        opened.close()
    return 0


def _take(browser: Any, name: str, shot: Shot, work: Path) -> None:
    for command in shot.commands:
        words = command.split()
        if not (work / words[words.index("--out") + 1]).exists():
            subprocess.run([*TMODES, *words], cwd=work, check=True, capture_output=True)
    context = browser.new_context(viewport=SIZE, color_scheme=shot.scheme, reduced_motion="reduce")
    with _address(shot.page, work) as address:
        page = context.new_page()
        page.goto(address)
        page.wait_for_selector("canvas", timeout=60_000)
        shot.act(page)
        page.wait_for_timeout(3000)  # software rendering takes its time
        target = TARGET / f"gallery-{name}.png"
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
        yield next(line.split()[1] for line in server.stdout or () if line.startswith("open"))
        server.terminate()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
