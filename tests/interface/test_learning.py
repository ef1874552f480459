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


def test_under_a_sampled_controller() -> None:
    """The response is that of the sampled loop with its delay, whose period is not that of the corrections."""
    pid = {"type": "sampled_pid", "sample_time": 7e-3, "position_gain": 80.0, "velocity_gain": 12.0,
           "integral_gain": 5.0, "filter_time": 0.01}  # fmt: skip
    robot = ARM.with_({"drives.0.controller": pid, "drives.0.delay": 5e-3, "real": {"gear.stiffness": 0.9}})
    rms = robot.learn(iterations=4, samples=100).rms
    assert (np.diff(rms) < 0).all()
    assert rms[4] < 0.02 * rms[0]


def test_the_tip_learns_what_links_bend() -> None:
    """The sag of a flexible link, which the joints leave; the learnt robot is judged by the path of the sheet."""
    robot = tmodes.load("flexarm1990").with_({"integration.duration": 1.5})
    learnt = robot.learn(iterations=2, samples=60, by="tip")
    ends = np.linalg.norm(learnt.errors[:, :, -1], axis=1)
    assert ends[2] < 0.05 * ends[0]
    assert learnt.robot.run(error_estimate=False).verdict["final_m"] == pytest.approx(ends[2], rel=1e-3)
    assert learnt.rms == pytest.approx(np.sqrt((learnt.errors**2).sum(axis=1).mean(axis=1)))
    assert learnt.data.error.sizes["output"] == 3
    assert learnt.plot()[0].get_ylabel().endswith("[m]")


def test_a_step_is_learnt() -> None:
    """A signal without a rate, under a law that reads one."""
    stepped = ARM.with_({"drives.0.signal": {"type": "step", "start": 0.0, "end": 0.3, "time": 0.1}})
    rms = stepped.learn(iterations=2, samples=60).rms
    assert rms[2] < 0.7 * rms[0]


def test_a_tip_that_no_joint_moves_is_not_learnt() -> None:
    drive = ARM.model_dump(mode="json", by_alias=True, exclude_none=True) | {
        "tip": {"link": "link", "position": [0, 0, 0]}
    }
    with pytest.raises(InputError) as wrong:
        tmodes.Robot.from_data(drive).learn(by="tip")
    assert wrong.value.which == "--by"


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
    wrongs: list[dict[str, Any]] = [{"iterations": 0}, {"samples": 5}, {"caution": 0.0}, {"by": "elbow"}]
    for wrong in wrongs:
        with pytest.raises(InputError):
            ARM.learn(**wrong)
    torque = {"joint": "joint", "command": "torque", "signal": {"type": "constant", "value": 1.0}}
    pushed = ARM.with_({"drives.0": torque})
    with pytest.raises(InputError, match="position control"):
        pushed.learn()
