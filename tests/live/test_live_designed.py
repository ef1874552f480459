"""A page holds the gains of laws that are designed before the run: it offers what leaves them as they are, exactly."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from contracts.test_blocks import LQG, LQR, SHAPED, law, spong
from tmodes.live.bundle import live_bundle
from tmodes.live.map import live_map
from tmodes.sheet import Robot

from .node import drawn, live_in_node, worst_difference
from .test_live_run import result_of, scales

EQUAL = 1e-7
LAWS = {"lqg": (LQG, {"delay": 0.015}), "lqr": (LQR, {}), "loop_shaping": (SHAPED | {"sample_time": 0.01}, {})}


def arm(name: str, also: dict[str, Any] | None = None, **others: Any) -> Robot:
    block, more = LAWS[name]
    move = {"type": "quintic", "start": 0.0, "end": 0.4, "duration": 0.2}
    accurate = {"method": "dormand_prince", "relative_tolerance": 1e-11, "absolute_tolerance": 1e-13}
    return spong(move, 0.3, 0.01, initial={}, control=law(block | (also or {}), **more), integration=accurate, **others)


@pytest.mark.parametrize(
    "name", ["lqg", *(pytest.param(one, marks=pytest.mark.nightly) for one in ("lqr", "loop_shaping"))]
)
def test_the_actual_robot_changes_under_the_gains_of_the_known_one(name: str, tmp_path: Path) -> None:
    made = arm(name)
    live, bundle = live_map(made.pair(), (0.0, 1.0)), live_bundle(result_of(made))
    assert bundle is not None
    assert {slider.path for slider in live.sliders} == {
        f"real:joints.joint.gear.{one}" for one in ("stiffness.0", "damping")
    }
    values = drawn(live, 2, seed=5)
    for found, one in zip(live_in_node(bundle, values, tmp_path), values, strict=True):
        native = result_of(made.with_(live.changes(one)))
        difference, name = worst_difference(found["series"], native.data, scales(native.data))
        assert difference < EQUAL, name
        assert "natively" in found["vibration"]


def test_what_gains_follow_from_is_said_with_its_command() -> None:
    live = live_map(arm("lqr").pair(), (0.0, 1.0))
    for path in ("joints.joint.gear.stiffness.0", "control.law.block.state_weights.joint", "drives.0.signal.end"):
        assert "gains of `law` are designed" in live.left_out[path]
        assert "`tmodes run test.yaml --set PATH=VALUE`" in live.left_out[path]


def test_numbers_of_the_sensors_that_a_designed_law_reads_are_none_of_the_page() -> None:
    """They stand among the numbers of the linear robot, which compiled code reads: plain ones alone."""
    sensor = {"type": "encoder", "name": "teeth", "joint": "joint", "resolution": 1e-4}
    measured = {"measured": ["joint.motor.position", "teeth"], "measurement_noise": [1e-6, 1e-6]}
    live = live_map(arm("lqg", measured, sensors=[sensor]).pair(), (0.0, 1.0))
    assert "real:joints.joint.gear.stiffness.0" in {slider.path for slider in live.sliders}
    assert "gains of `law` are designed" in live.left_out["sensors.teeth.resolution"]
