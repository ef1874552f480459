"""Saving figures: whole files, the same bytes anywhere, and errors that tell."""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tmodes import plot
from tmodes.errors import InputError, ResultFileError
from tmodes.plot.figure import Drawing
from tmodes.result import Result

HASHES = """
import hashlib, sys
from tmodes.plot import drawings
from tmodes.report.page import page
from tmodes.result import Result
result = Result.load(sys.argv[1])
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


def test_the_same_bytes_in_any_process_on_any_day(
    good: Result, drawn_figures: dict[str, Drawing], reports: dict[str, Path], tmp_path: Path
) -> None:
    """As here, of the stored result: in a process of another day, place and order of hashes."""
    stored = good.save(tmp_path / "result.nc")
    there = {"PYTHONHASHSEED": "2", "TZ": "Pacific/Kiritimati", "LC_ALL": "C.UTF-8", "SOURCE_DATE_EPOCH": "1"}
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", HASHES, str(stored)], stdout=subprocess.PIPE, text=True, check=True,
        env=os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)} | there,
    )  # fmt: skip
    contents = {name: drawing.content("svg") for name, drawing in drawn_figures.items()}
    contents |= {kind: drawn_figures["joint_efforts"].content(kind) for kind in ("png", "pdf")}
    contents["report"] = reports["good"].read_bytes()
    hashes = [f"{name} {hashlib.sha256(content).hexdigest()}" for name, content in contents.items()]
    assert len(hashes) > 10
    assert done.stdout.splitlines() == hashes


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
