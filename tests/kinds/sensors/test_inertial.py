"""Accelerometer and gyro along their own axes, in any attitude."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import tmodes
from simulation.sheets import arm

RATES = {"type": "pid", "position_gain": 100.0, "velocity_gain": 10.0, "integral_gain": 1.0}


def raised(angle: float) -> Any:
    """A beam that turns about the vertical and is raised by an angle; both sensors at its tip."""
    moved = {"type": "revolute", "motor": {"inertia": 0.5, "side": "joint"}}
    beam = {"model": "strain", "length": 0.5, "material": "aluminium_6061", "damping_time": 1e-3,
            "section": {"shape": "round", "diameter": 0.012}, "functions": {"bend_y": 1, "bend_z": 1}}  # fmt: skip
    signals = {"turn": 0.7, "lift": angle}
    return arm(
        gravity=9.81,
        joints=[{"name": "turn", "child": "mast", "axis": [0, 0, 1]} | moved,
                {"name": "lift", "parent": "mast", "child": "beam", "axis": [0, -1, 0]} | moved],
        links=[{"name": "mast"}, {"name": "beam", "beam": beam,
               "bodies": [{"name": "load", "mass": 1.0, "at": 1.0, "inertia": 1e-3}]}],
        tip={"link": "beam"},
        drives=[{"joint": joint, "command": "position", "signal": {"type": "constant", "value": value},
                 "controller": RATES} for joint, value in signals.items()],
        sensors=[{"name": "felt", "type": "accelerometer"}, {"name": "rate", "type": "gyro"}],
        integration={"duration": 0.05, "output_step": 0.01},
    )  # fmt: skip


@pytest.mark.parametrize("beyond", [0.0, 1e-15, -1e-12])
def test_upright_they_are_what_they_are_next_to_it(beyond: float) -> None:
    """Where roll and yaw are one: the slopes of all readings are those a millionth of a radian away."""
    names = [f"{sensor}.{axis}" for sensor in ("felt", "rate") for axis in "xyz"]
    here, near = (
        tmodes.linearize(raised(np.pi / 2 + angle), inputs=["turn.torque", "lift.torque"], outputs=names)
        for angle in (beyond, -1e-6)
    )
    for one, other in ((here.C, near.C), (here.D, near.D)):
        assert np.asarray(one) == pytest.approx(np.asarray(other), abs=2e-5 * np.abs(other).max())


def test_at_rest_it_feels_the_ground_in_every_world() -> None:
    """9.81 m/s^2 against gravity along its own axes; turned with its world it reads the same."""
    for angle in (0.3, np.pi / 2, 2.5):
        run = tmodes.run(raised(angle))
        felt = np.array([np.asarray(run.output(f"felt.{axis}"))[-1] for axis in "xyz"])
        pitch = -np.asarray(run.output("tip.pitch"))[-1]
        pitch = pitch if angle < np.pi / 2 else np.pi - pitch
        assert felt == pytest.approx(9.81 * np.array([np.sin(pitch), 0.0, np.cos(pitch)]), abs=1e-6)
        assert [np.asarray(run.output(f"rate.{axis}"))[-1] for axis in "xyz"] == pytest.approx([0.0] * 3, abs=1e-9)


def test_a_loop_that_reads_it_starts_where_it_feels_gravity() -> None:
    """An observer that measures it finds at rest what it knows, so that nothing moves off."""
    data = raised(0.3).model_dump(mode="json", by_alias=True, exclude_none=True)
    for drive in data["drives"]:
        del drive["controller"]
    states = ("turn", "lift", "beam.bend_y1", "beam.bend_z1")
    block = {"type": "lqg", "sample_time": 1e-3, "measured": ["turn.position", "lift.position", "felt.z"],
             "measurement_noise": [1e-8, 1e-8, 1e-2], "state_weights": {"turn": 1e4, "lift": 1e4},
             "process_noise": {f"{name}'": 1e-3 for name in states}}  # fmt: skip
    control = [{"name": "law", "drives": ["turn", "lift"], "block": block}]
    run = tmodes.run(tmodes.Robot.from_data(data | {"control": control}))
    lift = np.asarray(run.output("lift.position"))
    assert np.abs(lift - lift[0]).max() < 1e-6
    assert np.asarray(run.output("felt.z"))[0] == pytest.approx(9.81 * np.cos(0.3), abs=0.2)
