"""Residual vibration as it is seen: never more than the motion, the same however long is drawn, by what moves."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import pytest

import tmodes
from random_robots import KINDS, random_robot
from tmodes.analysis.vibration import AT_REST, residual_vibration
from tmodes.result.assemble import ResultAssembly
from tmodes.result.settling import AfterMove
from tmodes.sheet import Robot
from tmodes.simulation.simulate import simulate_motion

COUNT = int(os.environ.get("TMODES_RANDOM_RUNS", "0"))
"""Random robots of each kind; of 0 one of some kinds."""

ALONE = {"integration.error_estimate": False, "integration.model_error": False}


def vibrating(robot: Robot) -> tuple[dict[str, Any], dict[str, AfterMove]]:
    """Residual vibrations of a robot's run, and the motions that they are of."""
    made = ResultAssembly(simulate_motion(robot.with_(ALONE)), robot)
    found = made.vibration
    assert made.failed == {}
    return found, made._afters


def width(points: np.ndarray) -> float:
    """The largest distance of two points of a motion, to that of its samples."""
    some = np.concatenate([points[:1000], points[:: max(1, len(points) // 1000)]])  # it is largest at first
    return float(np.linalg.norm(some[:, None] - some, axis=2).max())


@pytest.mark.nightly("spatial")
@pytest.mark.parametrize("kind", KINDS if COUNT else ("gears", "spatial", "sampled", "falling"))
def test_never_more_than_the_motion(kind: str) -> None:
    """Of random runs: size and distance within the range after the move, shares of modes, elements that do move."""
    for seed in range(COUNT or 1):
        found, motions = vibrating(random_robot(kind, 400 + seed))
        for which, one in found.items():
            if one["amplitude_m"] is None:
                assert one["reason"]
                continue
            after = motions[which]
            assert after.end is not None
            late = after.times >= after.end * (1 - 1e-12)
            most = 1.005 * width(after.tip[late]) + 1e-12
            assert one["amplitude_m"] <= most
            assert one["largest_m"] <= most
            assert all(mode["amplitude_m"] <= most for mode in one["modes"])
            assert max(one["along_m"].values(), default=0.0) <= one["largest_m"] + 1e-15
            shares = [mode["share"] for mode in one["modes"]]
            assert min(shares, default=0.0) >= 0
            assert sum(shares) + one["unexplained"] == pytest.approx(1.0) or not shares
            assert shares or one["reason"]


@pytest.mark.parametrize(("omega", "ratio"), [(20.0, 0.03), (31.0, 0.0), (12.0, 0.15)])
@pytest.mark.parametrize("phase", [0.0, 1.1, 2.5])
def test_one_decaying_vibration(omega: float, ratio: float, phase: float) -> None:
    """Its size is its envelope at the end of the command, the distance seen that of its samples; also by direction."""
    time = np.linspace(0.0, 4.0, 2001)
    swing = np.exp(-ratio * omega * time) * np.cos(omega * np.sqrt(1 - ratio**2) * time + phase)
    points = np.stack([3 + 0.03 * swing, 0.04 * swing, 0 * swing + 0.2 * np.exp(-time)], axis=1)
    found = residual_vibration(time + 7.0, points, 7.0)
    assert found.amplitude == pytest.approx(0.05, rel=1e-4)
    assert found.largest == pytest.approx(0.05 * np.abs(swing).max(), rel=1e-3)
    assert found.along == pytest.approx([0.03 * np.abs(swing).max(), 0.04 * np.abs(swing).max(), 0.0], abs=1e-5)
    assert len(found.modes) == 1
    assert found.modes[0].share == pytest.approx(1.0, abs=1e-4)
    assert found.unexplained < 1e-4


def test_two_vibrations_are_two_modes() -> None:
    """Their largest envelope is the sum of both, which is seen when they meet; each has its share."""
    time = np.linspace(0.0, 10.0, 5001)
    one, other = 0.02 * np.cos(15 * time), 0.01 * np.sin(23 * time)
    found = residual_vibration(time, np.stack([one + other, one * 0, one * 0], axis=1))
    assert found.amplitude == pytest.approx(0.03, rel=1e-3)
    assert [mode.amplitude for mode in found.modes] == pytest.approx([0.02, 0.01], rel=1e-3)
    assert [mode.share for mode in found.modes] == pytest.approx([0.8, 0.2], abs=0.01)
    assert [mode.drift for mode in found.modes] == [None, None]


def test_a_frequency_that_drifts_is_said() -> None:
    """A swing whose period shrinks as it decays is one mode with two frequencies, not many that cancel."""
    time = np.linspace(0.0, 20.0, 4001)
    size = np.exp(-0.1 * time)
    turned = np.cumsum(2 * np.pi * (1.0 - 0.1 * size**2)) * time[1]
    found = residual_vibration(time, np.stack([0.3 * size * np.cos(turned), 0 * time, 0 * time], axis=1))
    assert found.amplitude == pytest.approx(0.3, rel=0.01)
    assert len(found.modes) == 1
    assert found.modes[0].drift is not None
    assert found.modes[0].drift == pytest.approx((0.91, 0.98), abs=0.01)
    assert sum(mode.amplitude for mode in found.modes) < 0.31


def test_a_period_without_modes() -> None:
    """What is no sum of decaying vibrations has the distance that is seen from a mean over its period, and says so."""
    time = np.linspace(0.0, 10.0, 2001)
    random = np.random.default_rng(5)
    jumps = np.repeat(random.uniform(0.6, 1.0, 21), 100)[:2001]
    found = residual_vibration(time, np.stack([0.1 * jumps * np.sin(2 * np.pi * 2 * time), 0 * time], axis=1))
    assert found.reason
    assert found.modes == ()
    assert found.amplitude == pytest.approx(0.1 * jumps.max(), rel=0.1)


def rod(**more: Any) -> Robot:
    """A rod of spring steel that bends by more than half its length, in one plane; it can bend in the other too."""
    beam = {"model": "strain", "functions": {"bend_y": 3, "bend_z": 1}, "length": 1.0, "damping_time": 2e-3,
            "material": {"young": "200 GPa", "shear": "77 GPa", "density": 7850.0},
            "section": {"shape": "round", "diameter": "5 mm"}}  # fmt: skip
    joint = {"name": "grip", "type": "revolute", "child": "rod", "axis": [0, -1, 0],
             "motor": {"inertia": 0.3, "side": "joint", "friction": {"viscous": 0.05}},
             "gear": {"stiffness": 400.0, "damping": 0.5}}  # fmt: skip
    drive = {"joint": "grip", "command": "position",
             "signal": {"type": "quintic", "start": 0.2, "end": 1.2, "duration": 0.6},
             "controller": {"type": "pd", "position_gain": 600.0, "velocity_gain": 20.0}}  # fmt: skip
    links = [{"name": "rod", "beam": beam, "bodies": [{"name": "fish", "mass": 0.25, "inertia": 1e-5, "at": 1.0}]}]
    return Robot.from_data({"format": 1, "kind": "arm", "name": "fishing_rod", "gravity": 9.81, "joints": [joint],
                            "links": links, "drives": [drive],
                            "integration": {"duration": 2.0, "output_step": 2e-3} | more})  # fmt: skip


BODY = {"name": "body", "mass": 1.0, "inertia": 0.02}
FREE = {"state": "free"}
MOVE = {"type": "quintic", "start": 0.0, "end": 0.5, "duration": 0.5}


def lever(joint: dict[str, Any], drive: dict[str, Any] | None = None, **more: Any) -> Robot:
    """A body on one joint, without weight, and a tip at 0.3 m."""
    joint = {"name": "j", "type": "revolute", "child": "rod", "axis": [0, 0, 1]} | joint
    sheet = {
        "joints": [joint],
        "links": [{"name": "rod", "bodies": [BODY]}],
        "tip": {"link": "rod", "position": [0.3, 0, 0]},
    }
    drives = [{"joint": "j"} | drive] if drive else []
    integration = {"duration": 1.5, "output_step": 2e-3}
    return Robot.from_data({"format": 1, "kind": "arm", "name": "lever", "gravity": 0.0, "drives": drives,
                            "integration": integration} | sheet | more)  # fmt: skip


def held(damping_ratio: float, signal: dict[str, Any] = MOVE, gear: dict[str, Any] | None = None) -> Robot:
    """The lever behind its motor, under a PD of this damping ratio."""
    motor = {"motor": {"inertia": 0.05, "side": "joint"}}
    control = {"type": "pd", "position_gain": 40.0, "velocity_gain": 2 * damping_ratio * (40.0 * 0.07) ** 0.5}
    return lever(motor | ({"gear": gear} if gear else {}),
                 {"command": "position", "signal": signal, "controller": control})  # fmt: skip


def thrown(speed: float) -> dict[str, Any]:
    return {"initial": {"state": "zero", "rates": {"j": speed}}}


PLAY = {"stiffness": 1000.0, "damping": 1.0, "backlash": 0.1}
ZERO = {"command": "torque", "signal": {"type": "constant", "value": 0.0}}
LOOSE = {"motor": {"inertia": 0.01, "side": "joint"}, "gear": PLAY}


@pytest.mark.parametrize("robot", [
    lever(FREE, **thrown(1.0)), lever(FREE, **thrown(30.0)),
    lever(LOOSE, ZERO, initial={"state": "zero", "rates": {"j.motor": 1.0}}),
    held(0.6, gear={"stiffness": 300.0, "damping": 0.05, "backlash": 0.02}),
], ids=["turns", "turns fast", "turns and rattles", "rattles"])  # fmt: skip
def test_what_is_no_vibration(robot: Robot) -> None:
    """A joint that turns on, teeth within their play: no size, no modes, and the joint that it is by."""
    made = ResultAssembly(simulate_motion(robot.with_(ALONE)), robot)
    found = made.vibration["actual"]
    assert found["amplitude_m"] is None
    assert found["modes"] == []
    assert found["reason"].startswith("j")
    assert found["reason"] in made.settling["reason"]


def test_a_straight_drift_is_said() -> None:
    robot = lever({"type": "prismatic", **FREE}, **thrown(0.7))
    made = ResultAssembly(simulate_motion(robot.with_(ALONE)), robot)
    assert "0.7 m/s" in made.settling["reason"]
    found = made.vibration["actual"]
    assert not found["amplitude_m"]
    assert "0.7 m/s" in found["reason"]


@pytest.mark.parametrize("ratio", [0.58, 0.8, 1.5])
def test_what_is_damped_strongly_has_a_reason(ratio: float) -> None:
    found, _ = vibrating(held(ratio))
    assert found["actual"]["amplitude_m"] == 0.0
    assert found["actual"]["reason"]
    assert (f"{ratio:.2g}" in found["actual"]["reason"]) == (ratio < 1)


def test_a_robot_at_constant_setpoints_is_at_rest() -> None:
    """Of rounding nothing is printed."""
    robot = held(0.3, {"type": "constant", "value": 0.3}, {"stiffness": 300.0, "damping": 0.1})
    made = ResultAssembly(simulate_motion(robot.with_(ALONE)), robot)
    assert (made.settling["time_s"], made.settling["reason"]) == (0.0, AT_REST)
    for one in made.vibration.values():
        assert (one["amplitude_m"], one["modes"], one["reason"]) == (0.0, [], AT_REST)
    assert tmodes.run(robot.with_(ALONE)).summary()["energy"]["worst_residual_over_moved"] is None


@pytest.mark.nightly
def test_a_rod_that_swings_far() -> None:
    """About the half of its range, of its bending in that plane alone, and the same however long is drawn."""
    sizes = []
    for duration in (0.9, 2.0007, 8.0):
        found, motions = vibrating(rod(duration=duration))
        one, after = found["actual"], motions["actual"]
        swung = after.tip[after.times >= 0.6]
        assert one["amplitude_m"] < np.linalg.norm(np.ptp(swung, axis=0))
        assert one["amplitude_m"] == pytest.approx(np.linalg.norm(np.ptp(swung, axis=0)) / 2, rel=0.1)
        assert {mode["element"] for mode in one["modes"]} == {"rod.bend_y"}
        assert one["modes"][0]["share"] > 0.9
        assert one["along_m"]["y"] == 0.0
        sizes.append(one["amplitude_m"])
    assert sizes == pytest.approx([sizes[0]] * 3, rel=0.01)


@pytest.mark.parametrize("seed", range(COUNT or 1))
def test_a_mode_has_one_element(seed: int) -> None:
    """What is seen after the move, and the pole at the end that is its own, of a motor that its controller damps."""
    robot = random_robot("gears", 605 + seed)
    made = ResultAssembly(simulate_motion(robot.with_(ALONE)), robot)
    same = 0
    for which, one in made.vibration.items():
        for mode in one["modes"]:
            seen = pytest.approx((mode["frequency_Hz"], mode["damping_ratio"]), rel=0.01)
            ends = [one for one in made.end_frequencies[which] if one["damped_frequency_Hz"]]
            near = [one for one in ends if (one["damped_frequency_Hz"], one["damping_ratio"]) == seen]
            assert mode["element"] in [end["element"] for end in near] or not near
            same += len(near)
    assert same or seed
