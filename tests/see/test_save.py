"""Saving figures: whole files, the same bytes anywhere, and errors that tell."""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from pathlib import Path
from unittest.mock import patch

import pytest

from see.conftest import IN_ALL_FORMATS
from tmodes import plot
from tmodes.errors import InputError, ResultFileError
from tmodes.result import Result

Drawn = tuple[Path, list[tuple[int, int, str]]]

HASHES = """
import hashlib, sys
from pathlib import Path
from tmodes.plot import save_figures
from tmodes.report.page import page
from tmodes.result import Result
result, folder = Result.load(sys.argv[1]), Path(sys.argv[2])
for file in save_figures(result, folder, ("svg", "png", "pdf"), names=("joint_efforts", "tip_path")):
    print(file.name, hashlib.sha256(file.read_bytes()).hexdigest())
print("report", hashlib.sha256(page(result).encode()).hexdigest())
"""


@pytest.mark.nightly
def test_every_figure_and_every_format(good: Result, drawn_figures: Drawn) -> None:
    place, info = drawn_figures
    names = list(plot.all_figures(good))
    others = {f"{name}.{kind}" for name in IN_ALL_FORMATS for kind in ("png", "pdf")}
    assert {path.name for path in place.iterdir()} == {f"{name}.svg" for name in names} | others
    assert info == [(k, len(names), name) for k, name in enumerate([*names, ""])]
    starts = {".svg": b"<?xml", ".png": b"\x89PNG", ".pdf": b"%PDF"}
    assert all(file.read_bytes().startswith(starts[file.suffix]) for file in place.iterdir())
    assert all(1000 < file.stat().st_size < 600_000 for file in place.iterdir())


@pytest.mark.nightly
def test_the_same_bytes_in_any_process_on_any_day(
    good: Result, drawn_figures: Drawn, reports: dict[str, Path], tmp_path: Path
) -> None:
    """As here, of the stored result: in a process of another day, place and order of hashes."""
    stored = good.save(tmp_path / "result.nc")
    there = {"PYTHONHASHSEED": "2", "TZ": "Pacific/Kiritimati", "LC_ALL": "C.UTF-8", "SOURCE_DATE_EPOCH": "1"}
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", HASHES, str(stored), str(tmp_path / "there")], stdout=subprocess.PIPE,
        text=True, check=True, env=os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)} | there,
    )  # fmt: skip
    files = [drawn_figures[0] / f"{name}.{kind}" for name in IN_ALL_FORMATS for kind in ("svg", "png", "pdf")]
    contents = {file.name: file.read_bytes() for file in files} | {"report": reports["good"].read_bytes()}
    hashes = [f"{name} {hashlib.sha256(content).hexdigest()}" for name, content in contents.items()]
    assert done.stdout.splitlines() == hashes


def test_a_part_of_the_figures(good: Result, tmp_path: Path) -> None:
    assert plot.save_figures(good, tmp_path, ["pdf"], names=["joint_efforts"]) == [tmp_path / "joint_efforts.pdf"]


@pytest.mark.parametrize(
    ("name", "got"),
    [
        ("joint_effort", "unknown figure 'joint_effort', expected some of tip_tracking"),
        ("controller_states", "controller_states, which is left out: "),
    ],
)
def test_a_figure_that_is_not_there(good: Result, tmp_path: Path, name: str, got: str) -> None:
    with pytest.raises(InputError, match=got):
        plot.save_figures(good, tmp_path, names=[name])


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

    def fails(figure: object, kind: str, **more: object) -> bytes:
        raise ZeroDivisionError

    with patch("tmodes.plot.figure.rendered", fails), pytest.raises(ZeroDivisionError):
        plot.save_figures(good, tmp_path, ["svg"], names=["joint_efforts"])
    assert old.read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["joint_efforts.svg"]
