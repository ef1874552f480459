"""Types are precise: a type checker sees no Any in what a user's script calls."""

from __future__ import annotations

import importlib.util
import json
import subprocess
import sys
from pathlib import Path

import pytest

from patience import LONG

ROOT = Path(__file__).resolve().parents[2]
SEEN = {
    'tmodes.load("x")': "Robot", "robot.with_({})": "Robot", "robot.run()": "Result", "robot.run().robot": "Robot",
    "robot.run().data": "Dataset", "robot.modes()": "Modes", "robot.static()": "Statics",
    "robot.describe()": "Description", "robot.linearize().mass": "ndarray[tuple[Any, ...], dtype[float64]]",
    "robot.hierarchy()": "Hierarchy", "robot.motion()": "Motion",
    "robot.batch()": "BatchResult", "robot.study({})": "StudyResult", "robot.motion().robot": "Robot",
    "robot.sensitivity({})": "Sensitivity", "robot.optimize({})": "Optimum", "robot.check()": "Check",
    "robot.eval([])": "Evaluation",
    "robot.outputs": "Outputs", "robot.show()": "Shown", "robot.chain()": "Chain", "robot.pair().real": "Robot",
    'robot.gradient(tmodes.tracking_error("tip", 0), [])': "GradientResult", 'tmodes.show("x")': "Result | StudyResult",
    "tmodes.Model(robot).energies(0, 0)": "dict[str, ndarray[tuple[Any, ...], dtype[float64]]]",
    "tmodes.run(robot)": "Result", "tmodes.modes(robot)": "Modes", "tmodes.Study.from_data({})": "Study",
}  # fmt: skip
"""Expressions, and their types; of an array only its shape is not known."""


@pytest.mark.skipif(importlib.util.find_spec("basedpyright") is None, reason="basedpyright is not installed")
def test_a_users_script_has_precise_types(tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    lines = ["import tmodes", 'robot = tmodes.load("x")', *(f"reveal_type({one})" for one in SEEN)]
    script.write_text("\n".join(lines), encoding="utf-8")
    settings = {"extraPaths": [str(ROOT / "src")], "typeCheckingMode": "standard", "include": [str(script)]}
    (tmp_path / "pyrightconfig.json").write_text(json.dumps(settings), encoding="utf-8")
    command = [sys.executable, "-m", "basedpyright", "--project", str(tmp_path), "--pythonpath", sys.executable]
    done = subprocess.run([*command, "--outputjson"], capture_output=True, text=True, timeout=LONG, check=False)
    said = [one["message"] for one in json.loads(done.stdout)["generalDiagnostics"]]
    assert [one.rpartition(" is ")[2].strip('"') for one in said] == list(SEEN.values())
