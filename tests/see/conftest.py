"""Results to look at: as they should be, and as they come on a bad day."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from browsing import OPTIONS, WITHOUT_WEBGL
from see.runs import result_of
from see.scene_window import scene_pages
from tmodes import load, plot, run
from tmodes.report import write_report
from tmodes.result import Result

NASTY = """<script>alert("1")</script> & 'x' <img src=x onerror=alert(2)> ]]> --> &amp; {braces} %s"""
"""A text that breaks pages that do not escape."""


IN_ALL_FORMATS = ("joint_efforts", "tip_path")
"""Figures that tests write in every format: what a format does is the same for all."""


@cache
def seed_result(contact: bool = True) -> Result:
    """The run of the 2010 paper's robot as published, 2 s; or in free space."""
    return run(load("filipovic2010").with_({"contact": contact}))


def failed_result(name: str = NASTY) -> Result:
    """A run that diverged after three samples, with every text nasty."""
    data = seed_result(contact=False).data.isel(time=slice(0, 3)).copy()
    robot = json.loads(data.attrs["robot"]) | {"name": name, "title": name, "citation": name}
    data.attrs |= {
        "robot": json.dumps(robot),
        "status": "diverged",
        "message": f"q is not finite at t = 0.003 s. {name}",
        "warnings": json.dumps([f"Energy grew. {name}"]),
        "versions": json.dumps({name: name}),
    }
    return Result(data)


RESULTS = {
    "contact": lambda: result_of("swinging"),
    "2010": seed_result,
    "free": lambda: result_of("pendulum"),
    "at rest": lambda: result_of("cantilever"),
    "three samples": failed_result,
}


@pytest.fixture(scope="session", params=RESULTS)
def result(request: pytest.FixtureRequest) -> Result:
    """Each of the results in turn."""
    return RESULTS[request.param]()


@pytest.fixture(scope="session")
def good() -> Result:
    """A finished run in contact."""
    return seed_result()


@pytest.fixture(scope="session")
def reports(tmp_path_factory: pytest.TempPathFactory, good: Result, failed: Result) -> dict[str, Path]:
    """The report of a finished and of a failed run, in a folder whose name needs escaping."""
    folder = tmp_path_factory.mktemp("a report & more – ü")
    return {
        "good": write_report(good, folder / "good.html"),
        "failed": write_report(failed, folder / "failed.html"),
    }


@pytest.fixture(scope="session")
def failed() -> Result:
    """A run that diverged after three samples, with every text nasty."""
    return failed_result()


@pytest.fixture(scope="package")
def engine() -> Iterator[Any]:
    """What drives browsers; nothing else of this folder may run an event loop."""
    playwright = pytest.importorskip("playwright.sync_api", reason="needs playwright to look at the page")
    with playwright.sync_playwright() as started:
        yield started


@pytest.fixture(scope="package")
def browser(engine: Any, chromium: str) -> Iterator[Any]:
    """A headless browser that draws in software; skipped where there is none."""
    opened = engine.chromium.launch(executable_path=chromium, args=list(OPTIONS))
    yield opened
    opened.close()


@pytest.fixture(scope="package")
def bare(engine: Any, chromium: str) -> Iterator[Any]:
    """A browser that really has no WebGL."""
    opened = engine.chromium.launch(executable_path=chromium, args=list(WITHOUT_WEBGL))
    yield opened
    opened.close()


@pytest.fixture(scope="session")
def pages(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """Pages with nothing but a scene, by name."""
    return scene_pages(tmp_path_factory.mktemp("scenes"))


@pytest.fixture(scope="session")
def drawn_figures(good: Result, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[tuple[int, int, str]]]:
    """Every figure of the good run as SVG, ``IN_ALL_FORMATS`` in the others too, and the progress of the first."""
    info: list[tuple[int, int, str]] = []
    place = tmp_path_factory.mktemp("figures")
    plot.save_figures(good, place, ("svg",), progress=lambda *step: info.append(step))
    plot.save_figures(good, place, ("png", "pdf"), names=IN_ALL_FORMATS)
    return place, info
