"""R20: a study that is killed at any moment resumes; the table is that of a run that nothing has disturbed."""

from __future__ import annotations

import signal
from pathlib import Path

import pyarrow.parquet as pq
import pytest

from command import tmodes
from study.store.processes import blocks_in, command, ended, reached

STUDY = """\
format: 1
kind: study
name: numbers
parameters:
  a: {distribution: {type: uniform, low: 0, high: 1}}
  b: {distribution: {type: uniform, low: 1, high: 3}}
plan: {type: monte_carlo, runs: RUNS, seed: 0}
quantities:
  y: {expression: "sin(a) + b*b"}
  z: {expression: "2*y - a"}
block: BLOCK
"""
RUNS, BLOCK = 3000, 10


@pytest.fixture(scope="module")
def sheet(tmp_path_factory) -> Path:
    file = tmp_path_factory.mktemp("study") / "numbers.yaml"
    file.write_text(STUDY.replace("RUNS", str(RUNS)).replace("BLOCK", str(BLOCK)))
    return file


def table(folder):
    return pq.read_table(folder / "table.parquet").sort_by("case").drop_columns("seconds").to_pydict()


@pytest.fixture(scope="module")
def whole(sheet, tmp_path_factory):
    out = tmp_path_factory.mktemp("whole")
    tmodes("study", sheet, "--out", out, "--no-page")
    return table(out)


def test_killed_three_times(sheet, whole, tmp_path):
    """At most one block is computed again each time: what is stored before stays, byte by byte."""
    kept: dict[str, bytes] = {}
    for at in (20, 90, 200):
        process = command("study", sheet, "--out", tmp_path, "--no-page")
        reached(process, tmp_path, at)
        process.kill()
        assert ended(process)[0] == -signal.SIGKILL
        now = {file.name: file.read_bytes() for file in (tmp_path / "blocks").glob("*.block")}
        assert kept.items() <= now.items()
        kept = now
        assert not (tmp_path / "table.parquet").exists()
    tmodes("study", sheet, "--out", tmp_path, "--no-page")
    assert blocks_in(tmp_path) == RUNS // BLOCK
    assert table(tmp_path) == whole
    assert not [*tmp_path.rglob("*.tmp")]


def test_ctrl_c_ends_cleanly_and_says_how_to_resume(sheet, whole, tmp_path):
    process = command("study", sheet, "--out", tmp_path, "--no-page")
    reached(process, tmp_path, 30)
    process.send_signal(signal.SIGINT)
    code, _, errors = ended(process)
    assert code == 130
    assert errors.endswith("tmodes: interrupted; run the same command again to continue\n")
    tmodes("study", sheet, "--out", tmp_path, "--no-page")
    assert table(tmp_path) == whole


def test_a_second_command_is_refused_while_the_first_runs(sheet, tmp_path):
    """R22."""
    process = command("study", sheet, "--out", tmp_path, "--no-page")
    reached(process, tmp_path, 10)
    done = tmodes("study", sheet, "--out", tmp_path, "--no-page", code=4)
    assert "held by process" in done.stderr
    assert ended(process)[0] == 0
