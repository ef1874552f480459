"""Iterative learning: errors fall from run to run, though the robot is not the one that is known."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmodes
from command import tmodes as command
from tmodes.errors import InputError

ARM = tmodes.load("spong1987")


@pytest.mark.parametrize("real", [{}, {"real": {"gear.stiffness": 0.8}}])
def test_the_error_falls_from_run_to_run(real: dict) -> None:
    """Each run is better than the one before; the learnt robot is the one of the last run."""
    robot = ARM.with_(real) if real else ARM
    learnt = robot.learn(iterations=5)
    assert (np.diff(learnt.rms) < 0).all()
    assert learnt.rms[5] < 0.006 * learnt.rms[0]
    result = learnt.robot.run()
    far = np.asarray(result.output("joint.position")) - _signal(np.asarray(result.data["time"]))
    assert np.sqrt(np.mean(far**2)) < 0.01 * learnt.rms[0]
    assert learnt.data.error.shape == (6, 1, 201)


def test_a_correction_that_makes_it_worse_is_undone() -> None:
    """A gear far softer than known, and bold steps: the setpoints of the best run are kept."""
    learnt = ARM.with_({"real": {"gear.stiffness": 0.4}}).learn(iterations=8, caution=0.003)
    assert (np.diff(learnt.rms) > 0).any()
    assert learnt.cautions[-1] > 0.003
    assert learnt.best == learnt.rms.argmin() > 0
    assert learnt.rms[learnt.best] < 0.72 * learnt.rms[0]
    far = np.asarray(learnt.robot.run().output("joint.position"))
    assert len(far) > 100


def _signal(times: np.ndarray) -> np.ndarray:
    """The quintic of the sheet, by hand."""
    s = np.minimum(times, 1.0)
    return 10 * s**3 - 15 * s**4 + 6 * s**5


def test_the_command(tmp_path: Path) -> None:
    out, figure = tmp_path / "learnt.yaml", tmp_path / "learnt.svg"
    done = command("learn", "spong1987", "--iterations", "1", "--samples", "50", "--out", str(out), "--figure",
                   str(figure), "--json")  # fmt: skip
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert found["rms"][1] < 0.2 * found["rms"][0]
    assert tmodes.load(out).drives[0].signal.type == "sum"
    assert figure.exists()


def test_what_can_not_be_learnt() -> None:
    wrongs: list[dict[str, Any]] = [{"iterations": 0}, {"samples": 5}, {"caution": 0.0}]
    for wrong in wrongs:
        with pytest.raises(InputError):
            ARM.learn(**wrong)
    torque = {"joint": "joint", "command": "torque", "signal": {"type": "constant", "value": 1.0}}
    pushed = ARM.with_({"drives.0": torque})
    with pytest.raises(InputError, match="position control"):
        pushed.learn()
