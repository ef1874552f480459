"""Modes under a limited law away from zero are those of the law without its limit, which nothing reaches there."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import tmodes
from analysis.test_network_modes import assert_same, assert_those_of_linear, poles
from contracts.test_blocks import LINK, PD, constant, spong

FILTERED = PD | {"type": "pid", "integral_gain": 70.0, "filter_time": 0.004}
LAWS = {
    "continuous": FILTERED, "own samples": FILTERED | {"type": "sampled_pid", "sample_time": 1e-3},
    "back calculation": FILTERED | {"anti_windup": "back_calculation", "tracking_time": 0.2},
}  # fmt: skip


def robot(law: dict[str, Any], at: float, **more: Any) -> Any:
    """A weight that the law carries, or (with ``block``) a law of the section `control`."""
    drive = {"controller": law} | more
    made = spong(constant(at), 1.0, 0.1, LINK | {"g": 1.0}, initial={}, drive=drive)
    return tmodes.Robot.from_data(made.model_dump(mode="json", by_alias=True, exclude_none=True))


@pytest.mark.parametrize("at", [0.0, 1.3])
@pytest.mark.parametrize("name", LAWS)
def test_a_limit_that_is_not_reached_changes_no_mode(name: str, at: float) -> None:
    law = LAWS[name]
    free = {key: value for key, value in law.items() if key not in {"anti_windup", "tracking_time"}}
    limited = robot(law | {"limit": 4.0}, at)
    assert_same(poles(limited), poles(robot(free, at)), 1e-9)
    assert_those_of_linear(limited)


@pytest.mark.parametrize("more", [{}, {"sample_time": 1e-3, "delay": 1.5e-3}])
def test_nor_about_another_pose_than_that_of_the_run(more: dict[str, Any]) -> None:
    """The law has its setpoint there, and what it remembers settles to that."""
    pose = {"joint.motor": 1.3}
    law, found = LAWS["continuous"], []
    for limit in ({"limit": 4.0}, {}):
        modes = robot(law | limit, -0.4, **more).modes(at=pose)
        found.append(np.array([complex(*one) for one in modes.found["real"].poles]))
    assert_same(found[0], found[1], 1e-9)
