"""Modes under controllers with own states, motor currents and samples follow the sliders: all equal the native ones."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from simulation.test_closed_start import random_robot
from tmodes import load, run
from tmodes.analysis.modes.of_sheet import sheet_frequencies
from tmodes.live.bundle import live_bundle
from tmodes.live.map import live_map
from tmodes.sheet import Robot

from .chain import chain
from .node import drawn, live_in_node

EQUAL = 1e-6
MOST = 8
"""Modes that a page shows of each case."""

PID = {"type": "pid", "position_gain": 300.0, "integral_gain": 400.0, "velocity_gain": 12.0}
SAMPLED = PID | {"type": "sampled_pid", "sample_time": 0.002}
ALL = {
    "type": "state_feedback", "position_gains": {"j0.motor": 250.0, "j0": 40.0, "j1": -15.0},
    "velocity_gains": {"j0.motor": 12.0, "j1.motor": 0.5},
}  # fmt: skip
WINDING = {"resistance": 1.2, "torque_constant": 0.8, "back_emf_constant": 0.7, "inductance": 0.02}
LAWS: dict[str, dict[str, Any]] = {
    "own states": {
        "drives.0.controller": PID | {"filter_time": 0.004, "limit": 60.0, "anti_windup": "clamp"},
        "drives.1.controller": PID | {"limit": 60.0, "anti_windup": "back_calculation", "tracking_time": 0.1},
    },
    "currents": {"joints.0.motor": {"inertia": 0.1, "side": "joint"} | WINDING},
    "all states": {"drives.0.controller": ALL},
    "samples": {"drives.0.controller": SAMPLED, "drives.1.controller": SAMPLED | {"sample_time": 0.003}},
    "samples and currents": {
        "joints.1.motor": {"inertia": 0.1, "side": "joint"} | WINDING,
        "drives.0.controller": SAMPLED | {"filter_time": 0.01}, "drives.1.controller": PID,
    },
}  # fmt: skip


def assert_modes_follow(arm: Robot, folder: Path, changes: int = 2, seed: int = 3, least: int = 3) -> None:
    """Frequency, damping and element of all modes that ring, under control and not, at random settings."""
    live, bundle = live_map(arm.pair(), (0.0, 1.0)), live_bundle(run(arm))
    assert bundle is not None
    values, controlled = [live.start, *drawn(live, changes, seed)], []
    for found, one in zip(live_in_node(bundle, values, folder), values, strict=True):
        if not isinstance(found.get("vibration", ""), dict):  # no rest is found at these settings, which the page says
            continue
        native = sheet_frequencies(arm.with_(live.changes(one)).pair().real)
        first = [mode["frequency_Hz"] for mode in native["controlled"] if mode["frequency_Hz"]]
        assert (found["facts"]["frequency.first"]["value"] or 0.0) == pytest.approx(min(first, default=0.0), rel=EQUAL)
        for case, modes in native.items():
            true = [mode for mode in modes if mode["frequency_Hz"]][:MOST]
            own = [mode for mode in found["vibration"]["modes"] if mode["case"] == case]
            assert [mode["element"] for mode in own] == [mode["element"] for mode in true]
            for name, key in (("frequency", "frequency_Hz"), ("damping", "damping_ratio")):
                expected = pytest.approx([mode[key] for mode in true], rel=EQUAL, abs=EQUAL)
                assert [mode[name] for mode in own] == expected, case
        controlled.append(first)
    assert len({*map(tuple, controlled)}) >= least


@pytest.mark.nightly
def test_two_link_arm(tmp_path: Path) -> None:
    assert_modes_follow(load("two_link_arm").with_({"integration.duration": 0.05}), tmp_path)


SEEN = ("own states", "samples")
"""Laws that stand for all in every suite."""


@pytest.mark.parametrize("law", [one if one in SEEN else pytest.param(one, marks=pytest.mark.nightly) for one in LAWS])
def test_laws(law: str, tmp_path: Path) -> None:
    assert_modes_follow(chain(2).with_(LAWS[law] | {"integration.duration": 0.05}), tmp_path)


@pytest.mark.nightly
@pytest.mark.parametrize("seed", range(24))
def test_random_robots_under_random_gains(seed: int, tmp_path: Path) -> None:
    arm = random_robot(seed)
    assert_modes_follow(arm, tmp_path, seed=seed, least=1)
