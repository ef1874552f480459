"""A robot over time as a page shows it in space: links, those of reference and rigid robot, joints, contact."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.line.line import elastic_line
from tmodes.chain.line_names import node_of_line
from tmodes.model.model import Model
from tmodes.report.scene_arrays import colour, displaced, kept, quaternions, stations_shown
from tmodes.report.scene_meshes import carriers, meshes_in, nearest_drawn
from tmodes.report.scene_sections import section_of
from tmodes.report.thin import scene_frames
from tmodes.result.lines import without_elasticity
from tmodes.sheet import Robot

if TYPE_CHECKING:
    from tmodes.result import Result

__all__ = ["actual_robot", "drawn_links", "line_of", "lines_at", "scene_of"]

Array = NDArray[np.float64]
Frames = NDArray[np.intp]

_DRAWN = ("time", "link", "s", "axis")
_QUANTITIES = (
    ("deflection", "Deflection", "m", "plane"),
    ("slope", "Slope", "rad", "plane"),
    ("moment", "Moment", "N m", "moment_kind"),
    ("shear_force", "Shear force", "N", "plane"),
)


def actual_robot(result: Result) -> Robot:
    """The actual robot that ran, from its stored data sheet."""
    from tmodes.io.sheet_check import sheet_from_data

    return sheet_from_data(json.loads(result.data.attrs["robot_real"]))


def scene_of(result: Result, frames: Frames | None = None) -> dict[str, Any]:
    """The robot at the samples ``frames``; None chooses them by :func:`tmodes.report.thin.scene_frames`.

    Lengths in m, times in s; arrays are NumPy's or those of :mod:`tmodes.report.pack`.
    """
    frames = _frames(result) if frames is None else frames
    data, arm = result.data, actual_robot(result)
    model, drawn = Model(arm.chain()), drawn_links(data)
    names = [*drawn, *carriers(data, model.chain, drawn)]
    data = data.isel(time=frames, s=stations_shown(data.sizes["s"], len(frames), len(names)))
    stand, stations = _base(model, data), data["s"].values
    there, turned = lines_at(model, names, _coordinates(data, "q"), stations, stand)
    line, rigid = (_with_carriers(data, name, there, drawn) for name in ("line", "line_rigid"))
    parents = [nearest_drawn(model.chain, name, drawn) for name in names]
    _move_carriers(rigid, line, parents, len(drawn))
    base, planned, wanted = kept(rigid), [None, None], None
    if "q_reference" in data:
        bent = _coordinates(data, "q_reference")
        found = (lines_at(model, names, q, stations, stand)[0] for q in (bent, without_elasticity(model, bent)))
        planned = [displaced(line, rigid, base) for line in found]
        wanted = data["tip_reference"].transpose("time", "axis").values
    return {
        "times": data["time"].values,
        "links": [
            _link(arm, model, name, stations) | {"parent": parent} for name, parent in zip(names, parents, strict=True)
        ],
        "line": displaced(line, rigid, base),
        "rigid": base,
        "reference": planned[0],
        "referenceRigid": planned[1],
        "roots": quaternions(turned[:, :, 0]),
        "colours": _colours(data, names, line, rigid),
        "tip": data["tip"].transpose("time", "axis").values,
        "tipReference": wanted,
        "contact": _contact(data, arm),
        "joints": list(_joints(model, names)),
        "meshes": meshes_in(result.data, model.chain, names),
    }


def line_of(result: Result, frames: Frames | None = None) -> dict[str, Any] | None:
    """Deflection, slope, moment and shear along each elastic link at ``frames``; None where there is none."""
    frames = _frames(result) if frames is None else frames
    if "bending_link" not in result.data.dims:
        return None
    links = [str(name) for name in result.data["bending_link"].values]
    data = result.data.isel(time=frames, s=stations_shown(result.data.sizes["s"], len(frames), 3 * len(links)))
    model = Model(actual_robot(result).chain())
    lines = elastic_line(model, np.zeros(model.nq), stations=[0.0, 1.0])
    lengths = np.array([lines[name].length for name in links])
    quantities = [
        {"id": name, "label": label, "unit": unit, "planes": [str(plane) for plane in data[dim].values],
         "values": kept(data[name].transpose("time", "bending_link", "s", dim).values)}
        for name, label, unit, dim in _QUANTITIES if name in data
    ]  # fmt: skip
    return {"links": links, "places": lengths[:, None] * data["s"].values, "quantities": quantities}


def _frames(result: Result) -> Frames:
    data = result.data
    return scene_frames(data["time"].values, int(np.prod(data["line"].shape[1:])) if "line" in data else 0)


def lines_at(
    model: Model, names: list[str], q: Array, stations: Array, base: Array | None = None
) -> tuple[Array, Array]:
    """Places (n, L, S, 3) [m] and axes (n, L, S, 3, 3) along the named links at coordinates ``q`` (n, nq)."""
    lines = elastic_line(model, q, stations=[*map(float, stations)], base=base)
    position, rotation = ([getattr(lines[name], part) for name in names] for part in ("position", "rotation"))
    empty = np.zeros((len(q), 0, len(stations), 3))
    return (np.stack(position, axis=1), np.stack(rotation, axis=1)) if names else (empty, empty[..., None])


def drawn_links(data: Any) -> list[str]:
    """The links of which a result has lines."""
    return [str(name) for name in data["link"].values] if "link" in data.dims else []


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


def _link(arm: Robot, model: Model, name: str, stations: Array) -> dict[str, Any]:
    line = elastic_line(model, np.zeros(model.nq), stations=[0.0, 1.0])[name]
    bends = line.shape is not None
    return {
        "name": name, "bends": bends, "length": line.length if bends else 0.0,
        "section": section_of(arm, name, stations),
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
    bending = [str(name) for name in data["bending_link"].values] if "bending_link" in data.dims else []
    stressed = [str(name) for name in data["stressed_link"].values] if "stressed_link" in data.dims else []

    def over(values: Array, links: list[str]) -> Array:
        whole = np.zeros(line.shape[:3])
        whole[:, [names.index(name) for name in links]] = values
        return whole

    found = []
    if bending:
        moment = data["moment"].transpose("time", "bending_link", "s", "moment_kind").values
        bent = data["deflection"].transpose("time", "bending_link", "s", "plane").values
        found += [
            colour("bending_moment", "Bending moment", "N m", over(np.linalg.norm(moment[..., 1:], axis=-1), bending)),
            colour("torsion", "Torsional moment", "N m", over(np.abs(moment[..., 0]), bending)),
            colour("deflection", "Deflection from the root's tangent", "m",
                   over(np.linalg.norm(bent, axis=-1), bending)),
        ]  # fmt: skip
    for name, label, unit in (("stress", "Largest stress (von Mises)", "Pa"), ("strain", "Largest strain", "1")):
        if name in data and stressed:
            values = data[name].transpose("time", "stressed_link", "s").values
            found.append(colour(name, label, unit, over(values, stressed)))
    away = np.linalg.norm(line - rigid, axis=-1)
    return [*found, colour("displacement", "Displacement by all elasticity", "m", away)]


def _contact(data: Any, arm: Robot) -> dict[str, Any] | None:
    if "contact_force" not in data or arm.contact is None:
        return None
    place = data["position"].sel(point=arm.contact.point).transpose("time", "axis").values
    force = data["contact_force"].transpose("time", "axis").values
    return {"force": force, "at": place, "surface": arm.contact.shape.drawing()}
