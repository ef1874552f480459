"""Sheets of the arms that are run here, and the reference values (computed with independent solvers)."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from tmodes.sheet import Robot

REFERENCE = json.loads((Path(__file__).parent / "data" / "reference_values.json").read_text(encoding="utf-8"))

ZERO = {"type": "constant", "value": 0.0}
TIGHT = {"relative_tolerance": 1e-12, "absolute_tolerance": 1e-13, "output_step": 0.01}


def arm(**more: Any) -> Robot:
    """A sheet with what every sheet has."""
    return Robot.from_data({"format": 1, "kind": "arm", "name": "test", **more})


def at_times(run: Any, times: Any) -> np.ndarray:
    """Indices of the samples at the given times."""
    indices = np.searchsorted(run.times, np.asarray(times) - 1e-9)
    assert np.allclose(run.times[indices], times, atol=1e-9)
    return indices


def pendulum(motor: dict[str, Any], gear: dict[str, Any], drive: dict[str, Any], **more: Any) -> Robot:
    """Spong's arm: a bob of 1 kg at 1 m that hangs at angle 0, on an elastic joint."""
    return arm(
        gravity=more.pop("gravity", 9.8),
        joints=[{"name": "joint", "type": "revolute", "parent": "base", "child": "link", "axis": [0, 1, 0],
                 "motor": {"side": "joint", **motor}, "gear": {"damping": 0.0, **gear}}],
        links=[{"name": "link", "bodies": [{"name": "bob", "mass": 1.0, "center": [0, 0, -1]}]}],
        tip={"link": "link", "position": [0, 0, -1]},
        drives=[{"joint": "joint", **drive}],
        **{"integration": {"duration": 5.0, **TIGHT}, **more},
    )  # fmt: skip


def torque(value: float) -> dict[str, Any]:
    """A constant torque."""
    return {"command": "torque", "signal": {"type": "constant", "value": value}}


def ur5(**more: Any) -> Robot:
    """The six joints of the UR5 as given, with motors and elastic gears, under control with constant gravity terms."""
    case = REFERENCE["g21"]
    elastic = case["elastic"]
    joints, links, drives, coordinates = [], [], [], {}
    for k, info in enumerate(case["joints"]):
        name, child = f"j{k}", f"l{k}"
        turn = np.array(info["placement_R"])
        quaternion = _quaternion(turn)
        joints.append({
            "name": name, "type": "revolute", "child": child, "axis": [float(x) for x in info["axis"]],
            **({"parent": "base"} if k == 0 else {}),
            "origin": {"position": info["placement_p"], "quaternion": quaternion},
            "motor": {"inertia": elastic["B"][k], "side": "joint"},
            "gear": {"stiffness": elastic["K"][k], "damping": elastic["D"][k]},
        })  # fmt: skip
        inertia = np.array(info["inertia_com"])
        places = {"xx": (0, 0), "yy": (1, 1), "zz": (2, 2), "xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
        links.append({"name": child, "bodies": [{
            "name": "body", "mass": info["mass"], "center": info["com"],
            "inertia": {key: float(inertia[place]) for key, place in places.items()},
        }]})  # fmt: skip
        shift = elastic["g_qd"][k] / elastic["KP"][k]
        drives.append({
            "joint": name, "command": "position",
            "signal": {"type": "quintic", "start": elastic["q00"][k] + shift, "end": elastic["qd"][k] + shift,
                       "duration": 1.0},
            "controller": {"type": "pd", "position_gain": elastic["KP"][k], "velocity_gain": elastic["KV"][k]},
        })  # fmt: skip
        coordinates[name], coordinates[f"{name}.motor"] = case["y0"][k], case["y0"][6 + k]
    return arm(
        joints=joints, links=links, drives=drives, initial={"state": "zero", "coordinates": coordinates},
        **{"integration": {"duration": 2.0, **TIGHT}, **more},
    )  # fmt: skip


def _quaternion(turn: np.ndarray) -> list[float]:
    from scipy.spatial.transform import Rotation

    return [float(x) for x in Rotation.from_matrix(turn).as_quat()]


def beam(functions: dict[str, int], length: float, stiffness: float, mass: float, **more: Any) -> dict[str, Any]:
    """A bare beam without rotary inertia."""
    section = {"bending_stiffness": stiffness, "torsional_stiffness": stiffness, "mass_per_length": mass,
               "polar_inertia_per_length": 1e-6}  # fmt: skip
    return {"model": "strain", "functions": {"twist": 0, "bend_y": 0, "bend_z": 0, **functions}, "length": length,
            "damping_time": 0.0, "section": section, "rotary_inertia": "none", **more}  # fmt: skip


def landing(damping: float = 3e5, stiffness: float = 2e5, **integration: Any) -> Any:
    """A mass that falls 50 mm onto a surface, whose damper makes its motion stiff: b/m = 2e5 1/s."""
    return arm(
        gravity=9.81,
        joints=[{"name": "s", "type": "prismatic", "child": "b", "axis": [0, 0, 1]}],
        links=[{"name": "b", "bodies": [{"name": "m", "mass": 1.5}]}],
        drives=[{"joint": "s", "command": "effort", "signal": {"type": "constant", "value": 0.0}}],
        initial={"state": "zero", "coordinates": {"s": 0.05}},
        contact={"shape": {"type": "plane", "position": [0, 0, 0], "normal": [0, 0, 1]}, "law": "unilateral",
                 "stiffness": stiffness, "damping": damping},
        integration={"duration": 0.6, "output_step": 0.01, "relative_tolerance": 1e-8, "absolute_tolerance": 1e-10,
                     **integration},
    )  # fmt: skip


def sunk(time: np.ndarray) -> np.ndarray:
    """Closed form of the height: free fall, then a spring and an overdamped damper."""
    mass, damping, stiffness = 1.5, 3e5, 2e5
    touch, speed = np.sqrt(2 * 0.05 / 9.81), np.sqrt(2 * 0.05 * 9.81)
    root = np.sqrt(damping**2 - 4 * mass * stiffness)
    fast, slow = -(damping + root) / (2 * mass), -2 * stiffness / (damping + root)
    rest = -mass * 9.81 / stiffness
    first = (-speed + slow * rest) / (fast - slow)
    later = np.maximum(time - touch, 0.0)
    depth = rest + first * np.exp(fast * later) + (-rest - first) * np.exp(slow * later)
    return np.where(time < touch, 0.05 - 9.81 * time**2 / 2, depth)


def ringing(**integration: Any) -> Robot:
    """A gear that hardly damps, 3,600 1/s, and a torque that sets it ringing by 1e-7 rad."""
    sheet = {"motor": {"inertia": 0.3}, "gear": {"stiffness": 3e6, "damping": 0.01}, "drive": torque(0.2)}
    info = {"duration": 8.0, "output_step": 0.01, "relative_tolerance": 1e-6, "absolute_tolerance": 1e-8}
    return pendulum(**sheet, integration={**info, **integration})


def sliding(**integration: Any) -> Robot:
    """A mass that lands on a rough surface and is dragged along it: friction, which no method takes implicit, is stiff.

    Two carriages carry it; the eigenvalue is friction times load over speed and mass, 1.2e5 1/s.
    """
    axes, masses, forces = {"x": [1, 0, 0], "s": [0, 0, 1]}, {"a": 0.5, "b": 1.5}, {"x": 2.0, "s": 0.0}
    return arm(
        gravity=9.81,
        joints=[{"name": "x", "type": "prismatic", "child": "a", "axis": axes["x"]},
                {"name": "s", "type": "prismatic", "parent": "a", "child": "b", "axis": axes["s"]}],
        links=[{"name": name, "bodies": [{"name": "m", "mass": mass}]} for name, mass in masses.items()],
        drives=[{"joint": name, "command": "effort", "signal": {"type": "constant", "value": force}}
                for name, force in forces.items()],
        initial={"state": "zero", "coordinates": {"s": 1e-7}},
        contact={"shape": {"type": "plane", "position": [0, 0, 0], "normal": [0, 0, 1]}, "law": "unilateral",
                 "stiffness": 2e5, "damping": 1e3, "friction": 0.5, "friction_velocity": 3e-5},
        integration={"duration": 1.0, "output_step": 0.01, "relative_tolerance": 1e-6, "absolute_tolerance": 1e-8,
                     **integration},
    )  # fmt: skip
