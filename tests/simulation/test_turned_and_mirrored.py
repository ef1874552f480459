"""Margins, designed gains and runs are those of the robot: not of its world, the signs of its joints, its units."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from contracts.test_drive_limits import public
from simulation.sheets import arm
from tmodes.simulation.control import designs

JOINTS, PERIOD = ("shoulder", "elbow"), 0.002
STATES = {name: 1e3 for joint in JOINTS for name in (joint, f"{joint}.motor")}
ENCODERS = [f"{joint}.motor.position" for joint in JOINTS]
LQR: dict[str, Any] = {"type": "lqr", "state_weights": STATES, "effort_weight": 1e-2}
NOISE = {f"{name}'": 1e-3 for name in STATES}
LAWS: dict[str, dict[str, Any]] = {
    "lqr": LQR,
    "lqg": {**LQR, "type": "lqg", "sample_time": PERIOD, "measured": ["teeth", "elbow.motor.position"],
            "measurement_noise": [1e-8], "process_noise": NOISE},
    "shaped": {"type": "loop_shaping", "measured": ENCODERS, "gains": {"shoulder": 900.0, "elbow": 300.0},
               "integral_frequency": 0.5, "lead_frequency": 3.0, "lead_ratio": 5.0},
    "torque": {"type": "computed_torque", "position_gain": 90.0, "velocity_gain": 15.0},
    "pid": {"type": "pid", "position_gain": 900.0, "integral_gain": 800.0, "velocity_gain": 60.0, "filter_time": 0.005},
}  # fmt: skip


def robot(law: str, *, turn: Any = None, signs: tuple[float, float] = (1.0, 1.0), units: bool = False) -> Any:
    """Two elastic joints that are not parallel, under a law; in a turned world, with other signs, in other units."""
    turned = Rotation.identity() if turn is None else turn
    axes = np.array([[0.0, -1.0, 0.0], [0.3, -0.8, 0.5]])

    def number(value: float, factor: float, unit: str) -> Any:
        return f"{value * factor!r} {unit}" if units else value

    joints, drives = [], []
    for k, (name, sign) in enumerate(zip(JOINTS, signs, strict=True)):
        origin = {"quaternion": turned.as_quat().tolist()} if k == 0 else {"position": [0.4, 0.0, 0.05]}
        stiffness, inertia = (2e4, 9e3)[k], (1.0, 0.4)[k]
        joints.append({
            "name": name, "type": "revolute", "child": f"link{k}", "axis": (sign * axes[k]).tolist(), "origin": origin,
            "parent": "base" if k == 0 else "link0",
            "motor": {"inertia": number(inertia, 1e7, "g*cm^2"), "side": "joint"},
            "gear": {"stiffness": number(stiffness, 1e3 * np.pi / 180, "N*mm/deg"), "damping": 12.0},
        })  # fmt: skip
        start, end = (-0.4, 1.0)[k], (0.2, 0.5)[k]
        drives.append({
            "joint": name, "command": "position",
            "signal": {"type": "quintic", "start": number(sign * start, 180 / np.pi, "deg"),
                       "end": number(sign * end, 180 / np.pi, "deg"), "duration": number(0.3, 1e3, "ms")},
            **({"controller": LAWS[law]} if law == "pid" else {}),
        })  # fmt: skip
    body = {"center": [number(0.25, 1e3, "mm"), 0.0, 0.02], "inertia": {"xx": 0.01, "yy": 0.03, "zz": 0.02}}
    links = [{"name": f"link{k}", "bodies": [{"name": "own", "mass": number(mass, 1e3, "g"), **body}]}
             for k, mass in enumerate((3.0, 2.0))]  # fmt: skip
    sensors = [{"name": "teeth", "type": "encoder", "joint": "shoulder", "sample_time": PERIOD, "delay": PERIOD / 2}]
    control = [] if law == "pid" else [{"name": "law", "drives": [*JOINTS], "block": LAWS[law]}]
    return public(arm(
        gravity=(turned.apply([0.0, 0.0, -9.81])).tolist(), joints=joints, links=links, drives=drives, control=control,
        sensors=sensors if law == "lqg" else [], tip={"link": "link1", "position": [0.4, 0.0, 0.0]},
        integration={"duration": 0.4, "output_step": 0.01, "method": "dormand_prince", "relative_tolerance": 1e-10,
                     "absolute_tolerance": 1e-12},
    ))  # fmt: skip


OTHERS: dict[str, dict[str, Any]] = {
    "turned": {"turn": Rotation.from_rotvec([0.4, -0.9, 1.3])},
    "mirrored": {"signs": (-1.0, 1.0)},
    "both mirrored": {"signs": (-1.0, -1.0)},
    "units": {"units": True},
}


@pytest.mark.nightly("lqr", "shaped", "torque")
@pytest.mark.parametrize("law", LAWS)
def test_a_loop_is_the_same(law: str) -> None:
    first = robot(law)
    own, result = first.linearize(closed=True), first.run()
    assert result.status == "finished"
    assert own.is_stable
    for name, how in OTHERS.items():
        other, signs = robot(law, **how), how.get("signs", (1.0, 1.0))
        closed = other.linearize(closed=True)
        assert np.sort_complex(closed.poles) == pytest.approx(np.sort_complex(own.poles), rel=1e-6, abs=1e-6), name
        for joint in JOINTS:
            here, there = (one.loops[joint].margins()._asdict() for one in (own, closed))
            assert there == pytest.approx(here, rel=1e-5, abs=1e-9, nan_ok=True), name
        motion = other.run()
        for joint, sign in zip(JOINTS, signs, strict=True):
            moved, known = (np.asarray(one.output(f"{joint}.position")) for one in (motion, result))
            assert sign * moved == pytest.approx(known, abs=1e-7), name
        assert closed.e_max == pytest.approx(own.e_max, rel=1e-6)
        found: Any = designs(other)
        wanted: Any = designs(first)
        for block, design in wanted.items():
            gains = getattr(design.design, "K", None)
            if gains is not None and law != "shaped":
                both = np.abs(np.asarray(gains)), np.abs(np.asarray(found[block].design.K))
                assert both[1] == pytest.approx(both[0], rel=1e-6, abs=1e-7 * both[0].max()), name
