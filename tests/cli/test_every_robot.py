"""Every published robot with every command: it works, or is refused for a physical reason."""

from __future__ import annotations

import json
import re
import signal
import subprocess
import urllib.request
from collections.abc import Iterator
from pathlib import Path

import pytest

import tmodes
from command import COMMAND, Done, called, started
from command import tmodes as done_by
from patience import LONG
from tmodes.robots import installed_models
from tmodes.robots.load import sheet_names

SHORT = ("--set", "integration.duration=0.02", "--set", "integration.output_step=0.01")
REASONS = ("no rest", "moves without force", "no spring", "nothing moves", "not positive definite",
           "cannot be followed", "no link with a beam", "snaps through")  # fmt: skip
"""Words of refusals that are about the robot's physics."""

ROBOTS = [name for name in sheet_names() if installed_models() or name not in ("panda_elastic", "ur5_elastic")]


def accepted(done: Done) -> bool:
    """Exit 0 with JSON, or a refusal with a physical reason."""
    if done.returncode == 0:
        return bool(json.loads(done.stdout))
    return done.returncode in (2, 3) and any(word in done.stderr for word in REASONS)


@pytest.fixture(scope="module", params=ROBOTS)
def run(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Path]:
    """The name of a robot and the folder of a short run of it."""
    folder = tmp_path_factory.mktemp(request.param) / "run"
    done_by("run", request.param, *SHORT, "--no-report", "--no-live", "--out", folder)
    return request.param, folder


@pytest.fixture(scope="module")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[str, str]]:
    """The address and the token of a studio, which is ended as by Ctrl-C."""
    pytest.importorskip("fastapi")
    line = [*COMMAND, "studio", ROBOTS[0], "--folder", str(tmp_path_factory.mktemp("studio")), "--no-open"]
    with started(line, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        try:
            assert process.stdout is not None
            address = re.search(r"(http\S+)/\?token=(\S+)", process.stdout.readline())
            assert address
            yield address[1], address[2]
        finally:
            process.send_signal(signal.SIGINT)
        assert process.wait(LONG) in (0, 130)


@pytest.mark.slow
class TestEveryRobot:
    @pytest.mark.parametrize("command", ["check", "describe", "static", "modes"])
    def test_is_described(self, run: tuple[str, Path], command: str) -> None:
        done = called(command, run[0], "--json")
        assert accepted(done), done.stderr

    @pytest.mark.nightly
    def test_has_a_hierarchy_of_models(self, run: tuple[str, Path]) -> None:
        done = called("hierarchy", run[0], "--finest", 1, *SHORT, "--json")
        assert accepted(done), done.stderr

    def test_is_evaluated(self, run: tuple[str, Path], tmp_path: Path) -> None:
        """At one state, at zero, by the names of its coordinates."""
        path = tmp_path / "states.json"
        path.write_text(json.dumps([{"q": {}, "v": {}, "effort": {}}]), encoding="utf-8")
        (state,) = json.loads(done_by("eval", run[0], "--states", path, "--json").stdout)["states"]
        assert len(state["M"]) == len(state["q"])

    def test_runs_in_a_batch(self, run: tuple[str, Path]) -> None:
        done = done_by("batch", run[0], "--vary", "integration.line_points=21:21:1", *SHORT, "--json", code=2)
        assert "one integration" in done.stderr
        vary = ("--vary", "real.gravity=0.9:1:2")
        assert json.loads(done_by("batch", run[0], *vary, *SHORT, "--json").stdout)["finished"] == 2

    def test_its_result_is_shown_and_viewed(self, run: tuple[str, Path], tmp_path: Path) -> None:
        found = json.loads(done_by("show", run[1], "--json").stdout)
        assert found["status"] == "finished"
        lines = [line for line in done_by("show", run[1]).stdout.splitlines() if str(run[1]) not in line]
        assert max(map(len, lines)) <= 80
        assert " ".join(lines).startswith(found["summary"]["verdict"]["sentence"])
        rows = [line for line in lines if line[:2] == "  " and line[2:3].isalpha()]
        assert 2 <= len(rows) <= 1 + 12
        assert any("Settling" in row for row in rows)
        done_by("view", run[1], "--no-open", "--out", tmp_path / "view.html")
        assert (tmp_path / "view.html").read_text(encoding="utf-8").startswith("<!doctype html>")

    def test_is_exported(self, run: tuple[str, Path], tmp_path: Path) -> None:
        done_by("export", run[0], "--wasm", *SHORT, "--out", tmp_path)
        assert {path.suffix for path in tmp_path.iterdir()} == {".wasm", ".js", ".ts", ".html"}

    def test_is_served_by_the_studio(self, run: tuple[str, Path], studio: tuple[str, str]) -> None:
        headers = {"X-Tmodes-Token": studio[1]}
        asked = urllib.request.Request(f"{studio[0]}/api/robots/{run[0]}", headers=headers)  # noqa: S310
        with urllib.request.urlopen(asked, timeout=LONG) as answer:  # noqa: S310
            assert json.load(answer)["sheet"]["name"] == run[0]

    def test_from_python_the_same(self, run: tuple[str, Path]) -> None:
        """Load, run, and what the command stored is the same."""
        robot = tmodes.load(run[0], {"integration.duration": 0.02, "integration.output_step": 0.01})
        stored, result = tmodes.Result.load(run[1] / "result.nc"), tmodes.run(robot)
        assert (result.status, stored.status) == ("finished", "finished")
        assert (result.data["q"].values == stored.data["q"].values).all()
        assert list(tmodes.Model(robot.chain()).coordinates) == list(result.data["coordinate"].values)
