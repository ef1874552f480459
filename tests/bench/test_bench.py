"""``python -m benchmarks.engines``: its options, its figures as JSON and as tables, races at equal error, starts."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import typer
from benchmarks.engines import measure
from benchmarks.engines.__main__ import bench
from benchmarks.engines.contender import Runner, at_equal_error
from benchmarks.engines.rigid import RigidChain
from benchmarks.engines.runs import ChainRun
from benchmarks.engines.start import started
from benchmarks.engines.tables import exponents, left_out, tables
from typer.testing import CliRunner

from tmodes.errors import InputError

pytestmark = pytest.mark.nightly

APP = typer.Typer()
APP.command()(bench)

START = {"equations": 0.1, "compile": 0.2, "first_call": 1e-3, "reload": 2e-3, "memory": 1e8, "memory_before": 9e7}


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without processes of its own."""
    monkeypatch.setattr(measure, "started", lambda joints: START)


def test_json_has_every_figure_with_its_error(quick: None, tmp_path: Path) -> None:
    """One small benchmark, to a file and on the screen."""
    file = tmp_path / "figures.json"
    options = ["--sizes", "2", "--rounds", "1", "--peers", "none", "--json", str(file)]
    done = CliRunner().invoke(APP, options, catch_exceptions=False)
    assert done.exit_code == 0
    info = json.loads(file.read_text(encoding="utf-8"))
    assert [size["n"] for size in info["sizes"]] == [2]
    for size in info["sizes"]:
        assert len(size["contenders"]) == 3
        for one in size["contenders"]:
            assert 0 < one["seconds"]["low"] <= one["seconds"]["median"] <= one["seconds"]["high"]
            assert 0 <= one["error"] < 1e-12
        assert size["limit"]["changing"] <= size["limit"]["operations"]
        assert all(race["reached"] and race["error"] <= 1e-6 for race in size["runs"]["races"])
    names = [race["name"] for race in info["seed"]["races"]]
    assert "tmodes, rk4, the paper's step" in names
    assert not [name for name in names if "SciPy" in name]
    for word in ("2 joints", "limit, by throughput", "The closed loop of the 2010 robot", info["machine"]["processor"]):
        assert word in done.stdout


def test_json_on_the_screen_is_json_alone(quick: None) -> None:
    done = CliRunner().invoke(APP, ["--quick", "--rounds", "1", "--peers", "none", "--json", "-"])
    info = json.loads(done.stdout)
    assert [size["n"] for size in info["sizes"]] == [6, 12]
    assert "seed" not in info


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--sizes", "6,many"], ("--sizes", "6,many", "whole numbers")),
        (["--sizes", "0"], ("--sizes", "1 to 1000")),
        (["--sizes", ""], ("--sizes",)),
        (["--peers", "gcc,drake"], ("--peers", "drake", "pinocchio")),
        (["--rounds", "0"], ("--rounds", "at least 1")),
    ],
)
def test_wrong_options_are_reported(options: list[str], words: tuple[str, ...]) -> None:
    done = CliRunner().invoke(APP, options)
    assert isinstance(done.exception, InputError)
    for word in words:
        assert word in str(done.exception)


def test_the_loosest_setting_that_is_good_enough_is_taken() -> None:
    """Errors fall with the setting; one runner never gets there, and says so; one has no choice."""
    ran: list[tuple[str, float]] = []

    def runner(name: str, least: float, *, given: bool = False) -> Runner:
        def run(setting: float) -> tuple[float, float]:
            ran.append((name, setting))
            return 10 * setting, max(1 / setting, least)

        return Runner(name, run, (1, 10, 100, 1000), "{:g} steps", given=given)

    races = at_equal_error([runner("good", 0), runner("bad", 0.5), runner("given", 0, given=True)], 0.01, 2.0, 3)
    info = {race.name: (race.setting, race.error, race.reached, race.time.median) for race in races}
    assert info == {
        "good": ("100 steps", 0.01, True, 500.0),
        "bad": ("10 steps", 0.5, False, 50.0),
        "given": ("1 steps", 1.0, False, 5.0),
    }
    assert ran[-3:] == [("good", 100), ("bad", 10), ("given", 1)]


def test_integrators_agree_on_the_falling_chain() -> None:
    """Methods of ours and SciPy's on our accelerations end at the same place, at the tightest that each can do."""
    run = ChainRun(RigidChain(3))
    adaptive = [runner for runner in run.runners() if "rk4" not in runner.name]
    errors = {runner.name: runner.run(runner.settings[-1])[1] for runner in adaptive}
    assert errors.pop("tmodes, extrapolation") < 2e-9  # its least tolerance is 1e-10
    errors["rk4"] = run._fixed(2000)[1]
    assert len(errors) >= 3
    assert max(errors.values()) < 1e-9
    assert np.abs(run.exact[:3]).max() > 0.1 * run.duration


@pytest.mark.slow
def test_start_is_measured_in_processes_of_its_own() -> None:
    """Compiled once, then read: entries are there, and reading them is quicker than making them."""
    info = started(1)
    assert info["cache_entries"] > 0
    assert 0 < info["reload"] < info["compile"]
    assert info["memory"] >= info["memory_before"]


def test_who_was_left_out_is_said_once() -> None:
    size: dict[str, Any] = {"left_out": {"gcc": "given up", "mujoco": "not installed"}}
    info = {"sizes": [size | {"n": 36}, size | {"n": 102}]}
    assert left_out(info) == ["gcc, 36, 102 joints: given up", "mujoco, 36, 102 joints: not installed"]


def test_power_law_is_found() -> None:
    """Costs of known powers; a peer that is missing at one size has none, nor have two sizes."""

    def size(n: int) -> dict[str, Any]:
        times = {"ours": 3e-6 * n, "theirs": 1e-9 * n**3, "sometimes": 1.0}
        names = [name for name in times if n != 36 or name != "sometimes"]
        start = {"equations": 0.01 * n, "compile": 0.02 * n, "memory": 1e8 + n**2, "memory_before": 1e8}
        return {"n": n, "contenders": [{"name": k, "seconds": {"median": times[k]}} for k in names], "start": start}

    found = exponents([size(6), size(12), size(36)])
    assert found == pytest.approx({"ours": 1.0, "theirs": 3.0, "compile": 1.0, "memory": 2.0}, abs=1e-9)
    assert exponents([size(6), size(12)]) == {}


def test_what_was_not_measured_is_a_dash() -> None:
    """Contenders that took part at one size only."""
    limit = {"throughput": 1e-6, "critical_path": 5e-7, "changing": 1234}

    def size(n: int, *names: str) -> dict[str, Any]:
        times = {"seconds": {"median": 1e-6}, "error": 1e-15, "compile": None}
        return {"n": n, "contenders": [times | {"name": name} for name in names], "start": START, "limit": limit}

    ((_, columns, rows),) = tables({"rounds": 3, "scaling": {}, "sizes": [size(6, "ours", "theirs"), size(12, "ours")]})
    assert columns == ("", "6 joints", "12 joints")
    assert rows[:2] == [["ours", "1  1e-15", "1  1e-15"], ["theirs", "1  1e-15", "-"]]
