"""Random robots of every kind, to measure printed errors on: a data sheet from a kind and a seed.

All draws of a kind share their structure, so that their code is compiled once; numbers, motion and loads differ.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numpy.random import Generator, default_rng

from tmodes.sheet import Robot

__all__ = ["KINDS", "random_robot"]

Sheet = dict[str, Any]


def random_robot(kind: str, seed: int) -> Robot:
    """A robot of one of :data:`KINDS`; nearly all of its runs come to their end."""
    rng = default_rng([seed, *kind.encode()])
    sheet = KINDS[kind](rng)
    duration = float(rng.uniform(0.4, 1.2))
    integration = {"duration": duration, "output_step": duration / 400, "line_points": 5}
    sheet = {"format": 1, "kind": "arm", "name": f"{kind}_{seed}", "gravity": 9.81, **sheet}
    return Robot.from_data(sheet | {"integration": integration})


def _log(rng: Generator, low: float, high: float) -> float:
    return float(low * (high / low) ** rng.random())


def _joint(rng: Generator, name: str, child: str, axis: list[int], *, elastic: bool = True, **more: Any) -> Sheet:
    motor = {"inertia": _log(rng, 0.02, 0.2), "side": "joint", "friction": {"viscous": _log(rng, 0.01, 0.5)}}
    gear = {"gear": {"stiffness": _log(rng, 100, 5000), "damping": _log(rng, 0.01, 1.0)}} if elastic else {}
    return {"name": name, "type": "revolute", "child": child, "axis": axis, "motor": motor, **gear, **more}


def _body(rng: Generator, name: str, **place: Any) -> Sheet:
    mass = _log(rng, 0.3, 3.0)
    inertia = {key: mass * float(rng.uniform(0.002, 0.003)) for key in ("xx", "yy", "zz")}
    return {"name": name, "mass": mass, "inertia": inertia, **place}


def _rod(rng: Generator, name: str, functions: Any, **more: Any) -> Sheet:
    stiffness = _log(rng, 20, 500)
    section = {"bending_stiffness": stiffness, "torsional_stiffness": stiffness, "mass_per_length": _log(rng, 0.2, 1),
               "polar_inertia_per_length": 1e-4}  # fmt: skip
    beam = {"model": "strain", "functions": functions, "length": float(rng.uniform(0.4, 0.9)), "section": section,
            "damping_time": _log(rng, 1e-4, 3e-3)} | more  # fmt: skip
    return {"name": name, "beam": beam, "bodies": [_body(rng, "hub", at=0.0), _body(rng, "load", at=1.0)]}


def _move(rng: Generator) -> Sheet:
    """A move from rest to rest, or a vibration."""
    end, time = float(rng.choice([-1, 1]) * rng.uniform(0.2, 1.2)), float(rng.uniform(0.25, 0.6))
    ramp = {"type": "trapezoid", "ramp_fraction": float(rng.uniform(0.1, 0.4))}
    return {"start": 0.0, "end": end, "duration": time} | (ramp if rng.random() < 0.5 else {"type": "quintic"})


def _held(rng: Generator, joint: str, **more: Any) -> Sheet:
    controller = {"type": "pd", "position_gain": _log(rng, 60, 1000), "velocity_gain": _log(rng, 6, 40)} | more
    return {"joint": joint, "command": "position", "signal": _move(rng), "controller": controller}


def _two_links(rng: Generator, axes: tuple[list[int], list[int]]) -> list[Sheet]:
    reach = float(rng.uniform(0.3, 0.8))
    return [
        _joint(rng, "first", "upper", axes[0]),
        _joint(rng, "second", "fore", axes[1], origin={"position": [reach, 0, 0]}),
    ]


def _gears(rng: Generator) -> Sheet:
    links = [
        {"name": n, "bodies": [_body(rng, "body", center=[float(rng.uniform(0.2, 0.5)), 0, 0])]}
        for n in ("upper", "fore")
    ]
    tip = {"link": "fore", "position": [0.5, 0, 0]}
    joints = _two_links(rng, ([0, 1, 0], [0, 1, 0]))
    return {"joints": joints, "links": links, "tip": tip, "drives": [_held(rng, "first"), _held(rng, "second")],
            "real": {"joints.first.gear.stiffness": float(rng.uniform(0.6, 1.3))}}  # fmt: skip


def _beams(rng: Generator) -> Sheet:
    links = [_rod(rng, "upper", {"bend_z": 2}), _rod(rng, "fore", {"bend_z": 2})]
    joints = [_joint(rng, "first", "upper", [0, 0, 1]), _joint(rng, "second", "fore", [0, 0, 1], elastic=False)]
    return {"joints": joints, "links": links, "drives": [_held(rng, "first"), _held(rng, "second")]}


def _slewing(rng: Generator) -> Sheet:
    torque = f"{_log(rng, 1, 8):.4g}*sin({_log(rng, 3, 20):.4g}*t)**3"
    joint = _joint(rng, "hub", "rod", [0, 0, 1], elastic=False)
    drive = {"joint": "hub", "command": "torque", "signal": {"type": "expression", "formula": torque}}
    return {"joints": [joint], "links": [_rod(rng, "rod", {"bend_z": 3}, rotary_inertia="none")], "drives": [drive],
            "gravity": 0.0, "initial": {"state": "zero"}}  # fmt: skip


def _spatial(rng: Generator) -> Sheet:
    joint = _joint(rng, "shoulder", "rod", [0, 1, 1])
    return {"joints": [joint], "links": [_rod(rng, "rod", 2)], "drives": [_held(rng, "shoulder")],
            "real": {"links.rod.beam.section.bending_stiffness": float(rng.uniform(0.7, 1.2))}}  # fmt: skip


def _segments(rng: Generator) -> Sheet:
    joint = _joint(rng, "shoulder", "rod", [0, 1, 0])
    rod = _rod(rng, "rod", 1, model="segments", segments=1)
    del rod["beam"]["functions"]
    return {"joints": [joint], "links": [rod], "drives": [_held(rng, "shoulder")]}


def _pendulums(rng: Generator) -> Sheet:
    joints = [{"name": n, "type": "revolute", "child": c, "axis": [0, 1, 0], **more} for n, c, more in
              (("first", "upper", {}), ("second", "fore", {"origin": {"position": [0, 0, -0.5]}}))]  # fmt: skip
    links = [{"name": n, "bodies": [_body(rng, "body", center=[0, 0, -0.4])]} for n in ("upper", "fore")]
    rates = {"first": float(rng.uniform(-12, 12)), "second": float(rng.uniform(-12, 12))}
    return {"joints": joints, "links": links, "tip": {"link": "fore", "position": [0, 0, -0.5]},
            "initial": {"state": "zero", "rates": rates}}  # fmt: skip


def _pressing(rng: Generator) -> Sheet:
    length = float(rng.uniform(0.4, 0.6))
    joint = _joint(rng, "shoulder", "arm", [0, 1, 0])
    contact = {"shape": {"type": "plane", "position": [0, 0, float(rng.uniform(-0.12, -0.03))], "normal": [0, 0, 1]},
               "law": "unilateral", "stiffness": _log(rng, 1e3, 5e4), "damping": _log(rng, 1, 100)}  # fmt: skip
    drive = _held(rng, "shoulder") | {"signal": {"type": "quintic", "start": 0.0, "end": 0.3, "duration": 0.3}}
    return {"joints": [joint], "links": [{"name": "arm", "bodies": [_body(rng, "body", center=[length / 2, 0, 0])]}],
            "tip": {"link": "arm", "position": [length, 0, 0]}, "drives": [drive], "contact": contact}  # fmt: skip


def _falling(rng: Generator) -> Sheet:
    contact = {"shape": {"type": "plane", "position": [0, 0, -0.1], "normal": [0, 0, 1]}, "law": "unilateral",
               "stiffness": _log(rng, 2e3, 1e5), "damping": _log(rng, 0.1, 300)}  # fmt: skip
    joint = {"name": "slide", "type": "prismatic", "child": "block", "axis": [0, 0, 1]}
    drive = {"joint": "slide", "command": "effort", "signal": {"type": "constant", "value": 0.0}}
    initial = {"state": "zero", "rates": {"slide": float(rng.uniform(-2, 1))}}
    return {"joints": [joint], "links": [{"name": "block", "bodies": [_body(rng, "mass")]}], "drives": [drive],
            "initial": initial, "contact": contact}  # fmt: skip


def _one_arm(rng: Generator, axis: list[int], drive: Sheet) -> Sheet:
    return {"joints": [_joint(rng, "joint", "arm", axis)], "drives": [drive],
            "links": [{"name": "arm", "bodies": [_body(rng, "body", center=[0.4, 0, 0])]}],
            "tip": {"link": "arm", "position": [0.6, 0, 0]}}  # fmt: skip


def _sampled(rng: Generator) -> Sheet:
    law = {"type": "sampled_pid", "integral_gain": _log(rng, 1, 50), "sample_time": _log(rng, 2e-3, 2e-2)}
    gains = {"position_gain": _log(rng, 20, 100), "velocity_gain": _log(rng, 1, 5)}
    return _one_arm(rng, [0, 1, 0], _held(rng, "joint", **law, **gains))


def _rubbing(rng: Generator) -> Sheet:
    friction = {
        "coulomb": _log(rng, 0.1, 2.0),
        "static_extra": _log(rng, 0.1, 1.0),
        "viscous": 0.1,
        "stribeck_rate": 0.1,
    }
    noise = {
        "type": "noise",
        "deviation": _log(rng, 1e-4, 1e-2),
        "frequency": _log(rng, 10, 60),
        "seed": int(rng.integers(99)),
    }
    found = _one_arm(rng, [0, 0, 1], _held(rng, "joint") | {"noise": noise})
    found["joints"][0]["motor"]["friction"] = friction
    return found


def _shaken(rng: Generator) -> Sheet:
    base = {"z": {"type": "sine", "amplitude": _log(rng, 1e-3, 2e-2), "frequency": _log(rng, 1, 8)}}
    load = {
        "point": "tip",
        "frame": "world",
        "force": [0, 0, -_log(rng, 1, 10)],
        "signal": {"type": "step", "start": 0.0, "end": 1.0, "time": 0.2},
    }
    return _spatial(rng) | {"base_motion": base, "loads": [load]}


KINDS: dict[str, Callable[[Generator], Sheet]] = {
    "gears": _gears, "beams": _beams, "slewing": _slewing, "spatial": _spatial, "segments": _segments,
    "pendulums": _pendulums, "pressing": _pressing, "falling": _falling, "sampled": _sampled, "rubbing": _rubbing,
    "shaken": _shaken,
}  # fmt: skip
"""By name: elastic gears, flexible links, contact, chaos, sampled control, friction, a base that moves."""
