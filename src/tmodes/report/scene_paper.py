"""The robot of the 2010 paper over time, as a page shows it in space: its two modes as links, its one motor."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.equations.lagrange.coordinates import basis, deformations
from tmodes.paper.mechanism import Drive
from tmodes.paper.model import PaperModel
from tmodes.report.scene_arrays import colour, displaced, kept, quaternions
from tmodes.report.scene_sections import solid_bar

if TYPE_CHECKING:
    from tmodes.paper.sheet import PaperRobot
    from tmodes.result.record import PaperResult

__all__ = ["line_at", "real_robot", "robot_line_panel", "robot_scene"]

Array = NDArray[np.float64]

_QUANTITIES = (
    ("deflection", "Deflection", "m"),
    ("slope", "Slope", "rad"),
    ("bending_moment", "Bending moment", "N m"),
    ("shear_force", "Shear force", "N"),
)


def real_robot(result: PaperResult) -> PaperRobot:
    """The robot that really ran, from its stored data sheet."""
    from tmodes.io.check import robot_from_data

    return robot_from_data(json.loads(result.data.attrs["robot_real"]))


def robot_scene(result: PaperResult, frames: NDArray[np.intp]) -> dict[str, Any]:
    """The scene at the samples ``frames``."""
    data = result.data.isel(time=frames)
    robot, stations = real_robot(result), data["s"].values
    q = data["q"].transpose("time", "coordinate").values
    line = data["line"].transpose("time", "mode", "s", "axis").values
    rigid = line_at(robot, q[:, 5:] * basis()[:, 0], stations)
    wanted = data["q_reference"].transpose("time", "coordinate").values
    reference = line_at(robot, wanted, stations)
    planned = line_at(robot, wanted[:, 5:] * basis()[:, 0], stations)
    base = kept(rigid)
    return {
        "times": data["time"].values,
        "links": [_link(robot, mode, len(stations)) for mode in range(2)],
        "line": displaced(line, rigid, base),
        "rigid": base,
        "reference": displaced(reference, rigid, base),
        "referenceRigid": displaced(planned, rigid, base),
        "roots": quaternions(_roots(q)),
        "colours": _colours(data, line, rigid),
        "tip": data["tip"].transpose("time", "axis").values,
        "tipReference": data["tip_reference"].transpose("time", "axis").values,
        "contact": _contact(data, robot),
        "joints": [_joint(robot)],
        "meshes": [],
    }


def robot_line_panel(result: PaperResult, frames: NDArray[np.intp]) -> dict[str, Any]:
    """The elastic line of both modes at the samples ``frames``."""
    data = result.data.isel(time=frames)
    lengths = np.array([mode.length for mode in real_robot(result).link.modes])
    planes = [str(plane) for plane in data["plane"].values]
    quantities = [
        {"id": name, "label": label, "unit": unit, "planes": planes,
         "values": kept(data[name].transpose("time", "mode", "s", "plane").values)}
        for name, label, unit in _QUANTITIES
    ]  # fmt: skip
    return {"links": ["Mode 1", "Mode 2"], "places": lengths[:, None] * data["s"].values, "quantities": quantities}


def line_at(robot: PaperRobot, phi: Array, stations: Array) -> Array:
    """The elastic line (n, 2, S, 3) [m] at coordinates ``phi`` (n, 6) [rad]."""
    mechanism, parameters = robot.split(Drive.CONTROLLED)
    motion = np.zeros((len(phi), 21))
    motion[:, :6] = phi
    return PaperModel(mechanism).line(motion, stations, parameters)["line"]


def _roots(q: Array) -> Array:
    """Axes (n, 2, 3, 3) of each mode's root: x along the line's tangent there, turned about z and then about y."""
    angles = deformations(q.T)
    azimuth = np.stack([q[:, 2], q[:, 0] + angles.th11q / 2], axis=1)
    elevation = np.stack([np.zeros(len(q)), q[:, 3] + angles.th11m / 2], axis=1)
    (c, s), (up, rise) = ((np.cos(angle), np.sin(angle)) for angle in (azimuth, elevation))
    none = np.zeros_like(c)
    rows = [[c * up, -s, -c * rise], [s * up, c, -s * rise], [rise, none, up]]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def _link(robot: PaperRobot, mode: int, stations: int) -> dict[str, Any]:
    info = robot.link.modes[mode]
    bends = f"mode{mode + 1}" not in robot.rigid_elements()
    section = solid_bar(info.bending_stiffness, info.bending_stiffness, info.mass_per_length, stations)
    return {
        "name": f"Mode {mode + 1}", "parent": mode - 1, "bends": bends, "length": info.length, "section": section
    }  # fmt: skip


def _joint(robot: PaperRobot) -> dict[str, Any]:
    elastic = "gear" not in robot.rigid_elements()
    return {"name": "Motor and gear", "link": 0, "kind": "revolute", "axis": [0.0, 0.0, 1.0], "elastic": elastic}


def _colours(data: Any, line: Array, rigid: Array) -> list[dict[str, Any]]:
    def size(name: str) -> Array:
        return np.linalg.norm(data[name].transpose("time", "mode", "s", "plane").values, axis=-1)

    return [
        colour("bending_moment", "Bending moment", "N m", size("bending_moment")),
        colour("deflection", "Deflection from the root's tangent", "m", size("deflection")),
        colour("displacement", "Displacement by all elasticity", "m", np.linalg.norm(line - rigid, axis=-1)),
    ]


def _contact(data: Any, robot: PaperRobot) -> dict[str, Any] | None:
    """The environment of the paper is a sphere about the base, on whose inside the tip is."""
    if "contact_force" not in data:
        return None
    reach = sum(mode.length for mode in robot.link.modes)
    surface = {"kind": "ball", "center": [0.0, 0.0, 0.0], "radius": reach, "inside": True}
    tip, force = (data[name].transpose("time", "axis").values for name in ("tip", "contact_force"))
    return {"force": force, "at": tip, "surface": surface}
