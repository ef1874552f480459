"""A robot over time as a page shows it in space: links, those of nominal and rigid robot, joints, contact."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.error_parts import without_elasticity
from tmodes.analysis.line.line import elastic_line
from tmodes.chain.chain import node_of_line
from tmodes.model.model import Model
from tmodes.plot.facts import names_of
from tmodes.report.pack import colour, displaced, kept, quaternions, scene_frames, stations_shown
from tmodes.report.scene_parts import actual, meshes_in, nearest_drawn, section_of
from tmodes.result import Result
from tmodes.sheet import Robot

__all__ = ["frames_of", "line_of", "lines_at", "scene_of"]

Array = NDArray[np.float64]
Frames = NDArray[np.intp]

_DRAWN = ("time", "link", "s", "axis")
_SLIGHT = 0.01
"""Share of the largest bending moment up to which torsion colours nothing."""

_QUANTITIES = (
    ("deflection", "Deflection", "m", "plane"),
    ("slope", "Slope", "rad", "plane"),
    ("moment", "Moment", "N m", "moment_kind"),
    ("shear_force", "Shear force", "N", "plane"),
)


def scene_of(result: Result, frames: Frames | None = None) -> dict[str, Any]:
    """The robot at the samples ``frames``; None chooses them by :func:`tmodes.report.pack.scene_frames`.

    Lengths in m, times in s; arrays are NumPy's or those of :mod:`tmodes.report.pack`. Of a robot that cannot be
    rebuilt only the lines that the result holds.
    """
    frames = frames_of(result) if frames is None else frames
    known, data = actual(result), result.record
    names, drawn = known.names, known.drawn
    data = data.isel(time=frames, s=stations_shown(data.sizes["s"], len(frames), len(names)))
    if known.missing:
        return _stored(data, drawn)
    robot, model = known.robot, known.model
    stand, stations = _base(model, data), data["s"].values
    there, turned = lines_at(model, names, _coordinates(data, "q"), stations, stand)
    parents = [nearest_drawn(model.chain, name, drawn) for name in names]
    if "line" in data or not drawn:
        line, rigid = (_with_carriers(data, name, there, drawn) for name in ("line", "line_rigid"))
        _move_carriers(rigid, line, parents, len(drawn))
    else:  # of a result that was just made, without its lines
        line = there
        rigid, _ = lines_at(model, names, without_elasticity(model, _coordinates(data, "q")), stations, stand)
    base, planned = kept(rigid), [None, None]
    if "q_nominal" in data:
        bent = _coordinates(data, "q_nominal")
        found = (lines_at(model, names, q, stations, stand)[0] for q in (bent, without_elasticity(model, bent)))
        planned = [displaced(line, rigid, base) for line in found]
    return _common(data, names, line, rigid) | {
        "links": [
            _link(robot, model, name, stations) | {"parent": parent}
            for name, parent in zip(names, parents, strict=True)
        ],
        "line": displaced(line, rigid, base),
        "rigid": base,
        "reference": planned[0],
        "referenceRigid": planned[1],
        "roots": quaternions(turned[:, :, 0]),
        "gravity": list(robot.gravity),
        "contact": _contact(data, robot),
        "joints": list(_joints(model, names)),
        "meshes": meshes_in(result.record, robot, model.chain, names),
    }


def _common(data: Any, names: list[str], line: Array, rigid: Array) -> dict[str, Any]:
    """What needs no robot."""
    tips = ("tip", "tip_nominal", "tip_commanded")
    own, planned, wanted = (data[name].transpose("time", "axis").values if name in data else None for name in tips)
    return {
        "times": data["time"].values, "tip": own, "tipReference": planned, "tipCommanded": wanted,
        "colours": _colours(data, names, line, rigid),
    }  # fmt: skip


def _stored(data: Any, drawn: list[str]) -> dict[str, Any]:
    """The lines alone, as straight as they are stored, without joints, surfaces and contact."""
    empty = np.zeros((data.sizes["time"], 0, data.sizes["s"], 3))
    line, rigid = (data[name].transpose(*_DRAWN).values if drawn else empty for name in ("line", "line_rigid"))
    parents = [str(name) for name in data["link_parent"].values] if drawn else []
    bending = names_of(data, "bending_link")
    return _common(data, drawn, line, rigid) | {
        "links": [
            {"name": name, "bends": name in bending, "length": 0.0, "section": None,
             "parent": drawn.index(parent) if parent in drawn else -1}
            for name, parent in zip(drawn, parents, strict=True)
        ],
        "line": displaced(line, rigid, kept(rigid)), "rigid": kept(rigid), "reference": None, "referenceRigid": None,
        "roots": np.tile(np.array([0, 0, 0, 1], dtype=np.float32), (len(line), len(drawn), 1)),
        "contact": None, "joints": [], "meshes": [],
    }  # fmt: skip


def line_of(result: Result, frames: Frames | None = None) -> dict[str, Any] | None:
    """Deflection, slope, moment and shear along each elastic link at ``frames``; None where there is none."""
    frames = frames_of(result) if frames is None else frames
    if "bending_link" not in result.record.dims or actual(result).missing:
        return None
    links = names_of(result.record, "bending_link")
    data = result.record.isel(time=frames, s=stations_shown(result.record.sizes["s"], len(frames), 3 * len(links)))
    model = actual(result).model
    lines = elastic_line(model, np.zeros(model.nq), stations=[0.0, 1.0])
    lengths = np.array([lines[name].length for name in links])
    quantities = [
        {"id": name, "label": label, "unit": unit, "planes": [str(plane) for plane in data[dim].values],
         "values": kept(data[name].transpose("time", "bending_link", "s", dim).values)}
        for name, label, unit, dim in _QUANTITIES if name in data
    ]  # fmt: skip
    return {"links": links, "places": lengths[:, None] * data["s"].values, "quantities": quantities}


def frames_of(result: Result) -> Frames:
    """The samples at which a scene shows the robot."""
    sizes = result.record.sizes
    numbers = sizes["link"] * sizes["s"] * sizes["axis"] if "link" in sizes else 0
    return scene_frames(np.asarray(result.record["time"].values, dtype=float), numbers)


def lines_at(
    model: Model, names: list[str], q: Array, stations: Array, base: Array | None = None
) -> tuple[Array, Array]:
    """Places (n, L, S, 3) [m] and axes (n, L, S, 3, 3) along the named links at coordinates ``q`` (n, nq)."""
    lines = elastic_line(model, q, stations=[*map(float, stations)], base=base)
    position, rotation = ([getattr(lines[name], part) for name in names] for part in ("position", "rotation"))
    empty = np.zeros((len(q), 0, len(stations), 3))
    return (np.stack(position, axis=1), np.stack(rotation, axis=1)) if names else (empty, empty[..., None])


def _with_carriers(data: Any, name: str, there: Array, drawn: list[str]) -> Array:
    """The stored lines of the links that are drawn, and after them where the carriers of surfaces are."""
    if not drawn:
        return there
    return np.concatenate([data[name].transpose(*_DRAWN).values, there[:, len(drawn) :]], axis=1)


def _move_carriers(rigid: Array, line: Array, parents: list[int], drawn: int) -> None:
    """Without elasticity the carriers of surfaces are where the ends of their parents then are."""
    for index, parent in enumerate(parents):
        if index >= drawn and parent >= 0:
            rigid[:, index] -= line[:, parent, -1:] - rigid[:, parent, -1:]


def _coordinates(data: Any, name: str) -> Array:
    return data[name].transpose("time", "coordinate").values


def _base(model: Model, data: Any) -> Array:
    """Rows (n, 24) of a base that stands where the base was: found from the tip, whose position and axes are stored."""
    q = _coordinates(data, "q")
    still, turned = model.pose(q)
    axes = data["rotation"].transpose("time", "point", "axis", "direction").values[:, 0]
    place = data["position"].transpose("time", "point", "axis").values[:, 0]
    rotation = axes @ turned[:, 0].swapaxes(-1, -2)
    rows = np.tile(model.at_rest(), (len(q), 1))
    first = rows[0, 9:18].reshape(3, 3)
    rows[:, 18:21] = place - (rotation @ (still[:, 0] - rows[0, 18:21])[..., None])[..., 0]
    rows[:, 9:18] = (rotation @ first).reshape(-1, 9)
    return rows


def _link(robot: Robot, model: Model, name: str, stations: Array) -> dict[str, Any]:
    line = elastic_line(model, np.zeros(model.nq), stations=[0.0, 1.0])[name]
    bends = line.shape is not None
    return {
        "name": name, "bends": bends, "length": line.length if bends else 0.0,
        "section": section_of(robot, name, stations),
    }  # fmt: skip


def _joints(model: Model, names: list[str]) -> Any:
    """The joints that move, each at the root of a link that is drawn, its axis in the axes of that root."""
    for node in model.chain.nodes:
        own = [k for k, name in enumerate(names) if node_of_line(model.chain, name) is node]
        if own and node.joint.moves:
            yield {
                "name": node.joint.name,
                "link": own[0],
                "drawing": node.joint.kind.drawing,
                "axis": [float(x) for x in node.joint.axis],
                "elastic": node.joint.gear is not None,
            }


def _colours(data: Any, names: list[str], line: Array, rigid: Array) -> list[dict[str, Any]]:
    bending, stressed = names_of(data, "bending_link"), names_of(data, "stressed_link")

    def over(values: Array, links: list[str]) -> Array:
        whole = np.zeros(line.shape[:3])
        whole[:, [names.index(name) for name in links]] = values
        return whole

    found = []
    if bending:
        moment = data["moment"].transpose("time", "bending_link", "s", "moment_kind").values
        torsion, across = np.abs(moment[..., 0]), np.linalg.norm(moment[..., 1:], axis=-1)
        bent = data["deflection"].transpose("time", "bending_link", "s", "plane").values
        found.append(colour("bending_moment", "Bending moment", "N m", over(across, bending)))
        if torsion.max() > _SLIGHT * across.max():
            found.append(colour("torsion", "Torsional moment", "N m", over(torsion, bending)))
        size = over(np.linalg.norm(bent, axis=-1), bending)
        found.append(colour("deflection", "Deflection from the root's tangent", "m", size))
    for name, label, unit in (("stress", "Largest stress (von Mises)", "Pa"), ("strain", "Largest strain", "1")):
        if name in data and stressed:
            values = data[name].transpose("time", "stressed_link", "s").values
            found.append(colour(name, label, unit, over(values, stressed)))
    away = np.linalg.norm(line - rigid, axis=-1)
    return [*found, colour("displacement", "Displacement by all elasticity", "m", away)] if away.any() else found


def _contact(data: Any, robot: Robot) -> dict[str, Any] | None:
    if "contact_force" not in data or robot.contact is None:
        return None
    place = data["position"].sel(point=robot.contact.point).transpose("time", "axis").values
    force = data["contact_force"].transpose("time", "axis").values
    return {"force": force, "at": place, "surface": robot.contact.shape.drawing()}
