"""The rest of a data sheet: its signals are asked at time 0 only, whatever they are beyond the sheet's own run."""

from __future__ import annotations

from typing import Any

import pytest

from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.analysis.statics.loads import first_value, sheet_loads
from tmodes.sheet import Robot
from tmodes.simulation.simulate import simulate_motion

ENDING = {"type": "expression", "formula": "sqrt(0.6 - t)"}
FAST = {"type": "sine", "frequency": 9000, "amplitude": 0.1, "offset": 0.3}


def sheet(signal: dict[str, Any], duration: float) -> Robot:
    """A rod on a hinge about z that follows a signal, with a force of the same signal on its tip."""
    hinge = {"name": "hinge", "type": "revolute", "parent": "base", "child": "rod", "axis": [0, 0, 1]}
    body = {"name": "body", "mass": 1.0, "center": [0.5, 0, 0]}
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "short", "joints": [hinge], "links": [{"name": "rod", "bodies": [body]}],
        "tip": {"link": "rod", "position": [1, 0, 0]},
        "drives": [{"joint": "hinge", "command": "prescribed", "signal": signal}],
        "loads": [{"point": "tip", "frame": "world", "force": [0, 0, 2], "signal": signal}],
        "integration": {"duration": duration, "output_step": duration / 10},
    })  # fmt: skip


@pytest.mark.parametrize(
    ("signal", "duration", "first"),
    [(ENDING, 0.5, 0.6**0.5), (FAST, 0.1, 0.3)],
    ids=["no value after 0.6 s", "too fast for more than its run"],
)
def test_a_signal_that_holds_for_the_run_alone_rests_and_runs(signal, duration, first):
    arm = sheet(signal, duration)
    assert first_value(arm, arm.drives[0].signal) == pytest.approx(first, abs=1e-12)
    assert robot_rest(arm).named == {"hinge": pytest.approx(first, abs=1e-12)}
    assert sheet_loads(arm)[0].force == pytest.approx([0.0, 0.0, 2 * first], abs=1e-12)
    run = simulate_motion(arm)
    assert run.status == "finished"
    assert run.q[0] == pytest.approx([first], abs=1e-12)


@pytest.mark.parametrize("duration", [0.5, 20.0])
def test_a_jump_within_the_run_is_not_at_its_start(duration):
    arm = sheet({"type": "step", "start": 0.2, "end": 0.9, "time": 0.3}, duration)
    assert robot_rest(arm).named == {"hinge": 0.2}
