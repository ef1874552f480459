"""A Python controller that is called once a sample: as one of the sheet, by names, refused where it is none."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmodes
from patience import LONG
from tmodes.errors import InputError, SimulationError

PERIOD, GAINS = 2e-3, {"position_gain": 40.0, "integral_gain": 3.0, "velocity_gain": 5.0}
LINK = tmodes.load("spong1987").with_({"integration.duration": 0.3, "integration.error_estimate": False})
TOUCHING = tmodes.load("filipovic2010").with_({"integration.duration": 0.2, "integration.error_estimate": False})


class PID:
    """The law of the kind sampled_pid, with a state of its own."""

    def __init__(self) -> None:
        self.sum, self.seen = np.nan, 0

    def reset(self) -> None:
        self.sum = 0.0

    def __call__(self, m: Any) -> dict[str, float]:
        self.seen += 1
        error = m.setpoint("joint") - m.position("joint.motor")
        slope = m.setpoint_rate("joint") - m.velocity("joint.motor")
        command = GAINS["position_gain"] * error + GAINS["integral_gain"] * self.sum + GAINS["velocity_gain"] * slope
        self.sum += PERIOD * error
        return {"joint": command}


@pytest.mark.parametrize("robot", [LINK, TOUCHING], ids=lambda robot: robot.name)
def test_it_is_the_native_law_to_rounding(robot: tmodes.Robot) -> None:
    """Torque and voltage, free and in contact: states and commands of the kind that does the same natively."""
    law = {"type": "sampled_pid", "sample_time": PERIOD, **GAINS}
    native = robot.with_({"drives.0.controller": law}).run()
    pid = PID()
    robot.run(controller=pid, period=PERIOD)
    found = robot.run(controller=pid, period=PERIOD)  # it begins again
    assert (native.status, found.status) == ("finished", "finished")
    assert pid.seen == 2 * round(robot.integration.duration / PERIOD)
    for name in [one for one in ("q", "v", "effort", "voltage") if one in native.data]:
        scale = np.abs(native.data[name].values).max()
        assert np.abs(found.data[name].values - native.data[name].values).max() < 1e-9 * scale
    assert found.summary()["energy"]["worst_residual_over_moved"] < 1e-6


def test_a_condition_ends_it_where_it_triggers() -> None:
    whole = LINK.run(controller=PID(), period=PERIOD)
    found = LINK.run(controller=PID(), period=PERIOD, stop="joint.position > 0.01 rad")
    assert found.status == "stopped_by_condition"
    end = float(found.data["time"][-1])
    assert abs(float(found.data["q"].sel(coordinate="joint")[-1]) - 0.01) < 1e-9
    same = whole.data["q"].sel(time=found.data["time"][:-1])
    assert 0.01 < end < 0.3
    assert np.allclose(found.data["q"][:-1], same, rtol=0, atol=1e-12)


def test_measurements_have_names() -> None:
    seen: list[Any] = []

    def watching(m: Any) -> float:
        seen.append(m)
        return 0.0

    LINK.run(controller=watching, period=0.1)
    assert [m.t for m in seen] == pytest.approx([0.0, 0.1, 0.2])
    last = seen[-1]
    assert last.q.tolist() == [last.position("joint.motor"), last.position("joint")]
    assert last.v.tolist() == [last.velocity("joint.motor"), last.velocity("joint")]
    assert last.setpoint("joint") == pytest.approx(10 * 0.2**3 - 15 * 0.2**4 + 6 * 0.2**5, rel=1e-9)
    with pytest.raises(ValueError, match="read-only"):
        last.q[0] = 1.0
    with pytest.raises(InputError) as wrong:
        last.position("jiont")
    assert "joint" in wrong.value.hint


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        (lambda m: [1.0, 2.0], "commands of joint"),
        (lambda m: np.nan, "finite"),
        (lambda m: "much", "an answer"),
        (lambda m: {"elbow": 1.0}, "joint"),
        (lambda m: 1 / 0, "ZeroDivisionError"),
        (lambda m: None, "an answer|finite"),
    ],
)
def test_nonsense_is_refused(answer: Any, words: str) -> None:
    with pytest.raises(SimulationError, match=words):
        LINK.run(controller=answer, period=PERIOD)


def test_later_it_stops_and_keeps_what_it_has() -> None:
    found = LINK.run(controller=lambda m: 0.0 if m.t < 0.1 else np.inf, period=PERIOD)
    assert found.status == "stopped"
    assert float(found.data["time"][-1]) == pytest.approx(0.1)
    assert "0.1 s" in found.message


@pytest.mark.parametrize(
    ("controller", "period"), [(None, 1e-3), (PID(), 0.0), (PID(), -1.0), (PID(), 1e3), (PID(), np.nan)]
)
def test_a_wrong_period_is_refused(controller: Any, period: float) -> None:
    with pytest.raises(InputError) as wrong:
        LINK.run(controller=controller, period=period)
    assert wrong.value.which == "period"


def test_the_example_of_the_guide_runs(tmp_path: Path) -> None:
    guide = (Path(__file__).resolve().parents[2] / "docs" / "controllers.md").read_text(encoding="utf-8")
    (example,) = re.findall(r"^```python\n(.*?)^```$", guide, re.MULTILINE | re.DOTALL)
    command = [sys.executable, "-W", "error", "-c", example]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=LONG, check=False)
    assert done.returncode == 0, done.stderr
    status, error, _ = done.stdout.split()
    assert status == "finished"
    assert float(error) < 1e-3
