"""Figures drawn by several processes: the same files, whatever becomes of the helpers; nothing is left by Ctrl-C."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from command import COMMAND, started
from patience import LONG, until
from tmodes import plot
from tmodes.plot import drawing, figure
from tmodes.result import Result

pytestmark = pytest.mark.nightly

NAMES = ("joint_efforts", "tip_errors", "energies")

FILES = [f"{name}.{kind}" for name in NAMES for kind in ("svg", "png")]


@pytest.fixture(scope="module")
def stored(good: Result, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return good.save(tmp_path_factory.mktemp("stored") / "result.nc")


@pytest.fixture(scope="module")
def alone(good: Result, tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """The files as this process draws them."""
    files = plot.save_figures(good, tmp_path_factory.mktemp("alone"), ("svg", "png"), names=NAMES)
    return {file.name: file.read_bytes() for file in files}


@pytest.fixture
def helped(monkeypatch: pytest.MonkeyPatch) -> None:
    """One helper, to which this process leaves every figure."""
    monkeypatch.setattr(drawing, "helpers_for", lambda figures: 1)
    monkeypatch.setattr(drawing, "_take_first", lambda taken, place: False)


def fails(drawn: object, kind: str, **more: object) -> bytes:
    raise ZeroDivisionError(kind)


@pytest.mark.usefixtures("helped")
def test_a_helper_draws_the_same_files(good, stored, alone, tmp_path, monkeypatch) -> None:
    monkeypatch.setattr(figure, "rendered", fails)  # here; not in the helper
    info: list[tuple[int, int, str]] = []
    files = plot.save_figures(good, tmp_path, ("svg", "png"), lambda *step: info.append(step), NAMES, stored)
    assert {file.name: file.read_bytes() for file in files} == alone
    assert [file.name for file in files] == FILES
    assert info == [(k, 3, name) for k, name in enumerate((*NAMES, ""))]


@pytest.mark.usefixtures("helped")
def test_what_a_helper_cannot_draw_is_drawn_here(good, alone, tmp_path) -> None:
    """It finds no result, and ends."""
    files = plot.save_figures(good, tmp_path, ("svg", "png"), names=NAMES, stored=tmp_path / "gone.nc")
    assert {file.name: file.read_bytes() for file in files} == alone


@pytest.mark.usefixtures("helped")
def test_a_figure_that_fails_is_an_error_here(good, tmp_path, monkeypatch) -> None:
    monkeypatch.setattr(figure, "rendered", fails)
    with pytest.raises(ZeroDivisionError):
        plot.save_figures(good, tmp_path, ["svg"], names=NAMES, stored=tmp_path / "gone.nc")
    assert list(tmp_path.iterdir()) == []


def test_each_figure_is_taken_once() -> None:
    taken = drawing.multiprocessing.get_context("spawn").Array("i", [0, 3])
    assert drawing._take_first(taken, 0)
    assert [drawing._take_last(taken) for _ in range(3)] == [2, 1, -1]
    assert not drawing._take_first(taken, 1)


@pytest.mark.skipif(not hasattr(os, "sched_getaffinity"), reason="cores of a process are known on Linux alone")
@pytest.mark.parametrize(("cores", "figures", "helpers"), [(1, 16, 0), (2, 3, 0), (2, 16, 1), (8, 16, 4)])
def test_helpers_are_for_many_figures_and_several_cores(cores, figures, helpers, monkeypatch) -> None:
    monkeypatch.setattr(os, "sched_getaffinity", lambda pid: set(range(cores)))
    assert drawing.helpers_for(figures) == helpers


def test_interrupts_are_heard_again() -> None:
    before = signal.getsignal(signal.SIGINT)
    with drawing._without_interrupts():
        assert signal.getsignal(signal.SIGINT) == signal.SIG_IGN
    assert signal.getsignal(signal.SIGINT) == before


@pytest.mark.skipif(sys.platform == "win32", reason="a terminal of POSIX sends Ctrl-C to a group of processes")
def test_ctrl_c_ends_all_of_them_quietly(stored, tmp_path) -> None:
    """Sent to the command and its helpers, as a terminal does."""
    process = started(
        [sys.executable, "-W", "error", *COMMAND[1:], "figures", str(stored), "--png", "--out", str(tmp_path)],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True,
    )  # fmt: skip
    until(lambda: any(file.suffix == ".svg" and file.name[0] != "." for file in tmp_path.iterdir()), "a figure")
    os.killpg(process.pid, signal.SIGINT)
    out, errors = process.communicate(timeout=LONG)
    assert process.returncode == 130
    assert "Traceback" not in errors
    assert errors.splitlines()[-1] == "tmodes: interrupted; run the same command again to continue"
    assert out == ""
    assert not [file for file in tmp_path.iterdir() if file.suffix not in (".svg", ".png")]
