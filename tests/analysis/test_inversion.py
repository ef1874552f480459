"""Inverse dynamics of robots that bend: differences over time, what hardly decays, random arms, kinks of gears."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import tmodes
from tmodes.analysis.follow import Arm
from tmodes.analysis.inversion import _differences, inverted
from tmodes.errors import TmodesError

LINE = {"type": "line", "to": [0.7, 0.0, 0.2]}


def test_differences_are_exact_and_vanish_for_what_alternates() -> None:
    """Else a damped zero that passes the frequency of the instants makes the equations singular."""
    weights = _differences()
    at = np.arange(weights.shape[1]) - weights.shape[1] // 2.0
    assert weights @ (-1.0) ** at == pytest.approx([1.0, 0.0, 0.0], abs=1e-12)
    for power in range(8):
        wanted = [float(power == 0), float(power == 1), 2.0 * (power == 2)]
        assert weights @ at**power == pytest.approx(wanted, abs=1e-9)


def test_what_hardly_decays_rests_in_the_end() -> None:
    """A hundredth of the damping: without giving way the forearm swings on at the ends, 3e-4 of its largest rate."""
    robot = tmodes.load("two_link_arm", {
        "links.forearm.beam.damping_time": 2e-6, "joints.shoulder.gear.damping": 0.1, "joints.elbow.gear.damping": 0.05,
    })  # fmt: skip
    path = robot.follow(LINE, profile={"type": "polynomial", "duration": 0.26}).found
    own = inverted(robot, path, 1e-6)
    assert 0 < own.aside < 1e-6
    assert own.left < 1e-5 * np.abs(own.rates).max()


def random_arm(seed: int) -> tmodes.Robot:
    """Three to six axes with elastic gears, one or two links that bend."""
    rng = np.random.default_rng(seed)
    count = int(rng.integers(3, 7)) if seed else 3
    bends = {*rng.choice(np.arange(1, count), size=int(rng.integers(1, 3)), replace=False).tolist()}
    usual = [[0, 0, 1], [0, -1, 0], [0, -1, 0], [1, 0, 0], [0, -1, 0], [0, 0, 1]]
    joints, links, drives = [], [], list[dict[str, Any]]()
    for k in range(count):
        axis = np.array(usual[k], dtype=float) if rng.random() < 0.7 else rng.normal(size=3)
        size, name = 0.7**k, f"joint{k}"
        joints.append({
            "name": name, "type": "revolute", "parent": f"link{k - 1}" if k else "base", "child": f"link{k}",
            "axis": (axis / np.linalg.norm(axis)).tolist(),
            "motor": {"inertia": float(1e-4 * size**2 * 10 ** rng.uniform(-0.5, 0.5)), "side": "motor", "ratio": 100,
                      "friction": {"viscous": float(1e-4 * rng.random())}},
            "gear": {"stiffness": float(4e4 * size**2 * 10 ** rng.uniform(-0.5, 0.5)),
                     "damping": float(20 * size**2 * 10 ** rng.uniform(-2, 0))},
        })  # fmt: skip
        tube = {"shape": "tube", "outer_diameter": 0.06, "thickness": 0.003}
        beam = {"model": "rigid", "length": float(rng.uniform(0.15, 0.5)), "material": "aluminium_6061"}
        if k in bends:
            tube |= {"outer_diameter": float(rng.uniform(0.018, 0.035)), "thickness": 0.0015}
            beam |= {"model": "strain", "functions": int(rng.integers(1, 4)) if seed else 1, "basis": "tip_weighted",
                     "damping_time": float(10 ** rng.uniform(-4.5, -3))}  # fmt: skip
        body = {"name": f"body{k}", "mass": float(rng.uniform(0.3, 2) * size), "inertia": 4e-3 * size, "at": 1.0}
        links.append({"name": f"link{k}", "bodies": [body], "beam": beam | {"section": tube}})
        law = {"type": "pd", "position_gain": 2e4 * size**2, "velocity_gain": 600.0 * size**2}
        signal = {"type": "constant", "value": float(rng.uniform(-1, 1))}
        drives.append({"joint": name, "command": "position", "signal": signal, "controller": law})
    return tmodes.Robot.from_data({
        "format": 1, "kind": "arm", "name": f"random {seed}", "gravity": 9.81, "joints": joints, "links": links,
        "drives": drives, "integration": {"duration": 1.0, "output_step": 2e-3},
    })  # fmt: skip


@pytest.mark.nightly
@pytest.mark.parametrize("seed", [0, *(pytest.param(k, marks=pytest.mark.nightly) for k in range(1, 12))])
def test_random_arms_keep_to_their_lines_in_open_loop(seed: int) -> None:
    """In 0.5 to 4 periods of the first mode; one that does not is refused with a reason."""
    robot, rng = random_arm(seed), np.random.default_rng(seed)
    first = float(np.ravel(robot.modes().data["frequency"].values)[0])
    arm = Arm(robot)
    values = np.array([*arm.start.values()])
    line = {"type": "line", "to": arm.pose(values + rng.uniform(-0.1, 0.1, len(values)))[0][0].tolist()}
    profile = {"type": "polynomial", "duration": float(rng.uniform(0.5, 4.0)) / first}
    try:
        found = robot.follow(line, profile=profile, reference="inverse")
    except TmodesError as error:
        if seed:
            pytest.skip(str(error))
        raise
    assert found.checks["open loop"] < max(1e-3 * found.checks["rigid"], 1e-6)


def test_a_kink_of_a_gear_is_not_blamed_on_the_profile() -> None:
    gear = {"stiffness": [80.0, 120.0], "torque_limits": [5.0], "damping": 0.1}
    robot = tmodes.load("spong1987", {"joints.joint.gear": gear})
    turn = {"type": "joints", "points": [[1.0]]}
    profiles = {
        "torque_limits": {"type": "polynomial", "duration": 1.0},
        "--profile": {"type": "quintic", "duration": 1},
    }
    for word, profile in profiles.items():
        (warning,) = robot.follow(turn, profile=profile, reference="inverse").warnings
        assert [name for name in profiles if name in warning] == [word]
