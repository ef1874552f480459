"""Saving figures: whole files, the same bytes anywhere, and errors that tell."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tmodes import plot
from tmodes.errors import InputError, ResultFileError
from tmodes.plot.save import Drawing
from tmodes.result import Result

TESTS = Path(__file__).parents[1]

HASHES = """
import hashlib
from arm.see.runs import result_of
from tmodes.plot import drawings
from tmodes.report.page import page
result = result_of("swinging")
figures = drawings(result)
for name, drawing in figures.items():
    print(name, hashlib.sha256(drawing.content("svg")).hexdigest())
for kind in ("png", "pdf"):
    print(kind, hashlib.sha256(figures["joint_efforts"].content(kind)).hexdigest())
print("report", hashlib.sha256(page(result, figures).encode()).hexdigest())
"""


def test_every_figure_in_every_format(good: Result, drawn_figures: dict[str, Drawing], tmp_path: Path) -> None:
    info: list[tuple[int, int, str]] = []
    folder = tmp_path / "figures"
    files = plot.save_figures(good, folder, progress=lambda *step: info.append(step), figures=drawn_figures)
    names = list(drawn_figures)
    assert [file.name for file in files] == [f"{name}.{kind}" for name in names for kind in ("svg", "png")]
    assert sorted(path.name for path in folder.iterdir()) == sorted(file.name for file in files)
    assert info == [(k, len(names), name) for k, name in enumerate([*names, ""])]
    assert all(file.read_bytes().startswith(b"\x89PNG" if file.suffix == ".png" else b"<?xml") for file in files)
    assert all(1000 < file.stat().st_size < 600_000 for file in files)


def test_the_same_bytes_in_any_process_on_any_day() -> None:
    def started(**environment: str) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [sys.executable, "-W", "error", "-c", HASHES],
            stdout=subprocess.PIPE,
            text=True,
            env=os.environ | {"PYTHONPATH": os.pathsep.join([str(TESTS), *sys.path])} | environment,
        )

    here = started(PYTHONHASHSEED="1", TZ="UTC", LC_ALL="C")
    there = started(PYTHONHASHSEED="2", TZ="Pacific/Kiritimati", LC_ALL="C.UTF-8", SOURCE_DATE_EPOCH="1")
    hashes, others = here.communicate()[0], there.communicate()[0]
    assert here.returncode == there.returncode == 0
    assert len(hashes.splitlines()) > 10 + 3
    assert hashes == others


def test_a_drawing_is_drawn_and_rendered_once(good: Result) -> None:
    calls: list[int] = []

    def draw() -> list:
        calls.append(1)
        return plot.joint_efforts(good)

    drawing = Drawing(draw)
    assert not calls
    first = drawing.content("svg")
    assert drawing.content("svg") is first
    assert drawing.content("png", 60).startswith(b"\x89PNG")
    assert len(calls) == 1


def test_a_part_of_the_figures(good: Result, tmp_path: Path) -> None:
    chosen = {name: drawing for name, drawing in plot.drawings(good).items() if name == "joint_efforts"}
    assert plot.save_figures(good, tmp_path, ["pdf"], figures=chosen) == [tmp_path / "joint_efforts.pdf"]


def test_an_unknown_format_is_refused_before_anything_is_written(good: Result, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="formats must be some of svg, png, pdf, got 'bmp'"):
        plot.save_figures(good, tmp_path / "new", ["svg", "bmp"])
    assert not (tmp_path / "new").exists()


def test_a_folder_that_is_a_file(good: Result, tmp_path: Path) -> None:
    place = tmp_path / "figures"
    place.write_text("mine")
    with pytest.raises(ResultFileError, match="which is a file"):
        plot.save_figures(good, place)
    assert place.read_text() == "mine"


def test_a_figure_that_fails_leaves_the_old_file(good: Result, tmp_path: Path) -> None:
    old = tmp_path / "joint_efforts.svg"
    old.write_text("old")

    def fails() -> list:
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        plot.save_figures(good, tmp_path, ["svg"], figures={"joint_efforts": Drawing(fails)})
    assert old.read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["joint_efforts.svg"]
