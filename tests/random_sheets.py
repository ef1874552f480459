"""Random robots as data sheets, for properties of whole runs, and the same robots written in other ways.

A sheet is drawn from two integers: one for its structure, by which its code is compiled, one for its numbers. Joints of
every kind in a tree, free, driven, behind gears, prescribed; beams; dry friction; loads; a rough surface at the tip.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from copy import deepcopy
from typing import Any

import numpy as np
from numpy.random import Generator, default_rng
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from random_chains import random_body
from tmodes.model.model import Model
from tmodes.sheet import Robot

__all__ = ["heavier", "in_other_units", "mirrored", "random_sheet", "reversed_order", "rotation", "turned"]

Array = NDArray[np.float64]
Sheet = dict[str, Any]

_RUN = {"duration": 0.25, "output_step": 0.01, "line_points": 3, "error_estimate": False, "model_error": False}


def rotation(seed: int) -> Array:
    """Any attitude."""
    return np.asarray(Rotation.from_quat(default_rng(seed).normal(size=4)).as_matrix())


def _direction(rng: Generator) -> list[float]:
    axis = rng.normal(size=3)
    return (axis / np.linalg.norm(axis)).tolist()


def _rough(rng: Generator, level: float) -> Sheet:
    return {"viscous": float(rng.uniform(0, 0.2)), "coulomb": level * float(rng.uniform(0.3, 1)),
            "static_extra": level * float(rng.uniform(0, 0.5))}  # fmt: skip


def _move(rng: Generator) -> Sheet:
    return {"type": "quintic", "start": 0.0, "end": float(rng.uniform(-0.4, 0.4)), "duration": 0.2}


_JUMPS = {"type": "table", "times": [0.0, 0.1, 0.3], "interpolation": "linear"}

Drawn = tuple[Sheet, list[Sheet]]


def _free(rng: Generator, joint: Sheet) -> Drawn:
    del rng
    return joint | {"state": "free"}, []


def _efforts(rng: Generator, joint: Sheet) -> Drawn:
    signal = {"type": "sine", "amplitude": float(rng.uniform(0.5, 5)), "frequency": float(rng.uniform(1, 4))}
    rough = {"friction": _rough(rng, 2.0)}
    return joint | rough, [{"joint": joint["name"], "command": "effort", "signal": signal}]


def _geared(rng: Generator, joint: Sheet) -> Drawn:
    joint = joint | {
        "motor": {"inertia": float(rng.uniform(0.05, 0.3)), "side": "joint", "friction": _rough(rng, 1.0)},
        "gear": {"stiffness": float(rng.uniform(100, 600)), "damping": float(rng.uniform(0.05, 1))},
        "friction": _rough(rng, 0.5),
    }
    controller = {
        "type": "pd",
        "position_gain": float(rng.uniform(50, 300)),
        "velocity_gain": float(rng.uniform(2, 15)),
    }
    return joint, [{"joint": joint["name"], "command": "position", "signal": _move(rng), "controller": controller}]


def _given(rng: Generator, joint: Sheet) -> Drawn:
    return joint, [{"joint": joint["name"], "command": "prescribed", "signal": _move(rng)}]


def _jumping(rng: Generator, joint: Sheet) -> Drawn:
    signal = _JUMPS | {"values": [0.0, float(rng.uniform(-0.1, 0.1)), float(rng.uniform(-0.2, 0.2))]}
    return joint, [{"joint": joint["name"], "command": "prescribed", "signal": signal}]


def _sprung(rng: Generator, joint: Sheet) -> Drawn:
    gear = {"stiffness": float(rng.uniform(100, 600)), "damping": float(rng.uniform(0.05, 1))}
    return joint | {"state": "locked", "gear": gear}, []


_STATES: tuple[Callable[[Generator, Sheet], Drawn], ...] = (_free, _efforts, _geared, _given, _jumping, _sprung)


def _body(rng: Generator, name: str) -> Sheet:
    body = random_body(rng)
    inertia = {key: float(body.inertia["xyz".index(key[0]), "xyz".index(key[1])])
               for key in ("xx", "yy", "zz", "xy", "xz", "yz")}  # fmt: skip
    return {"name": name, "mass": body.mass, "center": body.center.tolist(), "inertia": inertia}


def _beam(rng: Generator) -> Sheet:
    section = {"bending_stiffness": float(rng.uniform(20, 80)), "torsional_stiffness": float(rng.uniform(20, 80)),
               "mass_per_length": float(rng.uniform(0.2, 0.8)), "polar_inertia_per_length": 5e-4}  # fmt: skip
    return {"model": "strain", "functions": 1, "length": float(rng.uniform(0.3, 0.6)), "section": section,
            "damping_time": 2e-3}  # fmt: skip


def random_sheet(structure: int, numbers: int = 0, *, beams: bool = True, kinds: tuple[str, ...] = ()) -> Sheet:
    """A sheet; ``kinds``: types of joints, all by default; ``beams``: links may bend."""
    pick, rng = default_rng([structure, 7]), default_rng([structure, numbers])
    kinds = kinds or ("revolute", "revolute", "revolute", "prismatic", "universal")
    count = int(pick.integers(1, 4))
    joints: list[Sheet] = []
    links: list[Sheet] = []
    drives: list[Sheet] = []
    for k in range(count):
        parent = "base" if not k else f"link{max(0, k - 1 - int(pick.integers(0, 2)))}"
        kind, state, bends = str(pick.choice(kinds)), _STATES[int(pick.integers(len(_STATES)))], pick.random() < 0.25
        joint = {"name": f"joint{k}", "type": kind, "parent": parent, "child": f"link{k}",
                 "origin": {"position": rng.uniform(-0.3, 0.3, 3).tolist()}}  # fmt: skip
        if kind == "universal":
            made, own = joint | {"state": "free"}, []
        else:
            made, own = state(rng, joint | {"axis": _direction(rng)})
        joints.append(made)
        drives += own
        beam = {"beam": _beam(rng)} if beams and bends else {}
        links.append({"name": f"link{k}", "bodies": [_body(rng, "body")] if not beam else [], **beam})
    tip = {
        "link": f"link{count - 1}",
        "position": [0.0] * 3 if "beam" in links[-1] else rng.uniform(-0.3, 0.3, 3).tolist(),
    }
    sheet: Sheet = {
        "format": 1, "kind": "arm", "name": f"random {structure} {numbers}", "gravity": rng.uniform(-7, 7, 3).tolist(),
        "joints": joints, "links": links, "drives": drives, "tip": tip, "integration": dict(_RUN),
        "loads": [{"point": "tip", "frame": "world", "force": rng.uniform(-3, 3, 3).tolist()}],
    }  # fmt: skip
    free = [name for name in _own_names(sheet) if not any(drive["joint"] == name for drive in drives)]
    sheet["initial"] = {"state": "zero", "rates": {name: float(rng.uniform(-1, 1)) for name in free}}
    if pick.random() < 0.6:
        sheet["contact"] = _surface(pick, rng, sheet)
    return sheet


def _own_names(sheet: Mapping[str, Any]) -> list[str]:
    found = []
    for joint in sheet["joints"]:
        ends = (".x", ".y") if joint["type"] == "universal" else ("",)
        found += [joint["name"] + end for end in ends if joint.get("state") != "locked"]
    return found


def _surface(pick: Generator, rng: Generator, sheet: Sheet) -> Sheet:
    """A plane a little beneath the tip, against the load and the weight."""
    chain = Robot.from_data(sheet).chain()
    model = Model(chain)
    place = model.points(np.zeros(model.nq)).position[0]
    normal = -(np.array(sheet["gravity"]) + np.array(sheet["loads"][0]["force"]))
    normal = normal / np.linalg.norm(normal) + rng.uniform(-0.2, 0.2, 3)
    normal /= np.linalg.norm(normal)
    law: Sheet = {"law": "unilateral" if pick.random() < 0.7 else "bilateral",
                  "stiffness": float(rng.uniform(2e3, 2e4)), "damping": float(rng.uniform(5, 40))}  # fmt: skip
    if pick.random() < 0.8:
        law |= {"friction": float(rng.uniform(0.1, 0.6))}
        law |= {"static_friction": law["friction"] * float(rng.uniform(1, 1.5))}
    if pick.random() < 0.25:
        law |= {"mass": float(rng.uniform(0.05, 0.5))}
    depth = rng.uniform(-1e-3, 2e-3)
    shape = {"type": "plane", "position": (place + depth * normal).tolist(), "normal": normal.tolist()}
    return law | {"point": "tip", "shape": shape, "velocity": rng.uniform(-0.1, 0.1, 3).tolist()}


def turned(sheet: Sheet, turn: Array) -> Sheet:
    """The whole world, turned: base, gravity, loads and surface."""
    return _carried(sheet, turn) | {"base": {"quaternion": Rotation.from_matrix(turn).as_quat().tolist()}}


def _carried(sheet: Sheet, matrix: Array) -> Sheet:
    """What stands in the world, carried by a matrix; what stands in the robot stays."""
    made = deepcopy(sheet)
    made["gravity"] = (matrix @ made["gravity"]).tolist()
    for load in made["loads"]:
        load["force"] = (matrix @ load["force"]).tolist()
    if "contact" in made:
        made["contact"]["velocity"] = (matrix @ made["contact"]["velocity"]).tolist()
        shape = made["contact"]["shape"]
        made["contact"]["shape"] = shape | {key: (matrix @ shape[key]).tolist() for key in ("position", "normal")}
    return made


def mirrored(sheet: Sheet) -> Sheet:
    """As seen in a mirror, with the same coordinates: turns go about the mirrored axis the other way. Rigid links."""
    mirror = np.diag([1.0, -1.0, 1.0])
    made = _carried(sheet, mirror)
    for joint in made["joints"]:
        joint["origin"]["position"] = (mirror @ joint["origin"]["position"]).tolist()
        sign = -1.0 if joint["type"] == "revolute" else 1.0
        joint["axis"] = (sign * mirror @ joint["axis"]).tolist()
    for body in (body for link in made["links"] for body in link["bodies"]):
        body["center"] = (mirror @ body["center"]).tolist()
        body["inertia"] = {key: value * (-1 if key in ("xy", "yz") else 1) for key, value in body["inertia"].items()}
    made["tip"]["position"] = (mirror @ made["tip"]["position"]).tolist()
    return made


def reversed_order(sheet: Sheet) -> Sheet:
    """All lists whose order means nothing, the other way round; a joint stands behind its parent."""
    made = deepcopy(sheet)
    for name in ("links", "drives", "loads"):
        made[name] = made[name][::-1]
    left, done = made["joints"][::-1], {"base"}
    made["joints"] = []
    while left:
        k = next(k for k, joint in enumerate(left) if joint["parent"] in done)
        done.add(left[k]["child"])
        made["joints"].append(left.pop(k))
    return made


_LENGTHS = ("position", "center", "length")


def in_other_units(sheet: Sheet) -> Sheet:
    """Lengths in millimetres, masses in grams, as texts."""
    made = deepcopy(sheet)

    def written(value: Any, factor: float, unit: str) -> Any:
        return [written(x, factor, unit) for x in value] if isinstance(value, list) else f"{value * factor!r} {unit}"

    def visit(node: Any) -> None:
        for key, value in list(node.items()) if isinstance(node, dict) else []:
            if key in _LENGTHS:
                node[key] = written(value, 1e3, "mm")
            elif key == "mass":
                node[key] = written(value, 1e3, "g")
            else:
                visit(value)
        for value in node if isinstance(node, list) else []:
            visit(value)

    visit(made)
    return made


_FORCES = (
    "mass", "inertia", "force", "stiffness", "damping", "coulomb", "static_extra", "viscous", "amplitude",
    "position_gain", "velocity_gain", "bending_stiffness", "torsional_stiffness", "mass_per_length",
    "polar_inertia_per_length",
)  # fmt: skip


def heavier(sheet: Sheet, factor: float) -> Sheet:
    """All masses, inertias, stiffnesses and forces ``factor`` times as large: the same motion."""
    made = deepcopy(sheet)

    def larger(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: larger(one) for key, one in value.items()}
        return [larger(one) for one in value] if isinstance(value, list) else value * factor

    def visit(node: Any) -> None:
        for key, value in list(node.items()) if isinstance(node, dict) else []:
            if key in _FORCES:
                node[key] = larger(value)
            else:
                visit(value)
        for value in node if isinstance(node, list) else []:
            visit(value)

    visit(made)
    return made
