"""Every published robot with every command: it works, or is refused for a physical reason."""

import json
import os
import re
import signal
import subprocess
import sys
import urllib.request
from pathlib import Path

import pytest

import tmodes
from tmodes.errors import InputError, SimulationError
from tmodes.robots.load import sheet_names
from tmodes.robots.packages import installed_models

COMMAND = (sys.executable, "-c", "from tmodes.cli.main import main; main()")
SHORT = ("--set", "integration.duration=0.02", "--set", "integration.output_step=0.01")
REASONS = ("no rest", "moves without force", "no spring", "nothing moves", "not positive definite",
           "cannot be followed", "no link with a beam", "snaps through")  # fmt: skip
"""Words of refusals that tell of the robot's physics."""

ROBOTS = [name for name in sheet_names() if installed_models() or name not in ("panda_elastic", "ur5_elastic")]


def states_of(name: str, folder: Path) -> Path:
    """One state of a robot, at zero, by the names of its coordinates."""
    path = folder / "states.json"
    path.write_text(json.dumps([{"q": {}, "v": {}, "effort": {}}]), encoding="utf-8")
    del name
    return path


def tmodes_of(*arguments: object) -> subprocess.CompletedProcess[str]:
    line = [*COMMAND, *map(str, arguments)]
    return subprocess.run(line, capture_output=True, text=True, check=False, timeout=600)


def accepted(done: subprocess.CompletedProcess[str]) -> bool:
    """Exit 0, or a refusal with a physical reason."""
    if done.returncode == 0:
        return True
    return done.returncode in (2, 3) and any(word in done.stderr for word in REASONS)


@pytest.fixture(scope="module", params=ROBOTS)
def run(request, tmp_path_factory) -> tuple[str, Path]:
    """The name of a robot and the folder of a short run of it."""
    folder = tmp_path_factory.mktemp(request.param) / "run"
    done = tmodes_of("run", request.param, *SHORT, "--no-figures", "--no-live", "--out", folder)
    assert done.returncode == 0, done.stderr
    return request.param, folder


@pytest.mark.slow
class TestEveryRobot:
    @pytest.mark.parametrize("command", ["check", "describe", "static", "modes"])
    def test_is_described(self, run, command):
        done = tmodes_of(command, run[0], "--json")
        assert accepted(done), done.stderr
        assert done.returncode or json.loads(done.stdout)

    def test_has_a_hierarchy_of_models(self, run):
        done = tmodes_of("ladder", run[0], "--finest", 1, *SHORT, "--json")
        assert accepted(done), done.stderr

    def test_is_evaluated(self, run, tmp_path):
        done = tmodes_of("eval", run[0], "--states", states_of(run[0], tmp_path), "--json")
        assert done.returncode == 0, done.stderr
        (state,) = json.loads(done.stdout)["states"]
        assert len(state["M"]) == len(state["q"])

    def test_runs_in_a_batch(self, run):
        done = tmodes_of("batch", run[0], "--vary", "gravity=9.0:9.81:2", *SHORT, "--json")
        assert done.returncode == 0 or "gravity" in done.stderr, done.stderr

    def test_its_result_is_shown_and_viewed(self, run, tmp_path):
        shown = tmodes_of("show", run[1], "--json")
        assert shown.returncode == 0, shown.stderr
        assert json.loads(shown.stdout)["status"] == "finished"
        viewed = tmodes_of("view", run[1], "--no-open", "--out", tmp_path / "view.html")
        assert viewed.returncode == 0, viewed.stderr
        assert (tmp_path / "view.html").read_text(encoding="utf-8").startswith("<!doctype html>")

    def test_is_exported(self, run, tmp_path):
        done = tmodes_of("export", run[0], "--wasm", *SHORT, "--out", tmp_path)
        assert done.returncode == 0, done.stderr
        assert {path.suffix for path in tmp_path.iterdir()} == {".wasm", ".js", ".ts", ".html"}

    def test_is_served_by_the_studio(self, run, tmp_path):
        pytest.importorskip("fastapi")
        line = [*COMMAND, "studio", run[0], "--folder", str(tmp_path), "--no-open"]
        with subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as studio:
            try:
                assert studio.stdout is not None
                address = re.search(r"http\S+", studio.stdout.readline())
                assert address
                with urllib.request.urlopen(address[0], timeout=30) as page:  # noqa: S310
                    assert "tmodes studio" in page.read().decode()
            finally:
                studio.send_signal(signal.SIGINT)
            assert studio.wait(30) in (0, 130)


@pytest.mark.slow
@pytest.mark.parametrize("name", ROBOTS)
def test_from_python_the_same(name, tmp_path):
    """Load, run, save, load, show."""
    robot = tmodes.load(name, {"integration.duration": 0.02, "integration.output_step": 0.01})
    result = tmodes.run(robot)
    assert result.status == "finished"
    assert tmodes.Result.load(result.save(tmp_path / "result.nc")).summary()["status"] == "finished"
    assert "<!doctype html>" in tmodes.show(result).document.lower()
    try:
        assert tmodes.Model(robot.chain()).coordinates
    except (InputError, SimulationError) as error:  # pragma: no cover
        raise AssertionError(os.linesep.join([name, str(error)])) from error
