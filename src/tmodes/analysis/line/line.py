"""The elastic line of any link, at any point and sample: where it is, how it bends, what it carries, its stress.

What a section carries is the balance of everything outboard of it. The beam's own inertia is that of the model at its
Gauss points, carried between them by the polynomials through them; so the balance at the root is exactly the model's
own, and along the line it is smooth. The moment that bends it, EI kappa, is its projection on the link's functions.

Eq. (29)-(33) [derived]: the moment along any link in space, of all that moves outboard of it.
{test_static_tip_force, test_rotating_beam}
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.analysis.line.loads import NodeLoads, node_loads
from tmodes.analysis.line.shape import Shape, beam_shape, segment_shape
from tmodes.analysis.line.stress import Stress, stress_of
from tmodes.analysis.line.tables import LineTables, line_tables
from tmodes.analysis.line.walk import Walked, info_places, walk
from tmodes.chain.chain import Beam, Node, RigidLink, Segment
from tmodes.errors import InputError, SimulationError
from tmodes.model.model import Model

__all__ = ["Largest", "LinkLine", "LinkLines", "elastic_line"]

Array = NDArray[np.float64]

STATIONS = 21
"""Places along each link where none are asked."""

_MOST_NUMBERS = 500_000_000
"""Numbers of an answer (4 GB) beyond which it is refused."""

_PER_PLACE = 40
"""Numbers told of one place at one sample, about."""


@dataclass(frozen=True)
class Largest:
    """The value of largest size of a quantity, where it is (``s``) and at which ``sample`` it comes first."""

    value: float
    s: float
    sample: int


@dataclass(frozen=True, eq=False)
class LinkLine:
    """The line of one link at the places ``s`` (S,), 0 its root and 1 its tip; n samples, SI.

    ``position`` (n, S, 3) and ``rotation`` (n, S, 3, 3) in the world (columns: tangent, and the section's y and z).
    ``shape``: how it bends. ``moment`` (n, S, 3) [N*m]: torsion, about y, about z; ``shear`` (n, S, 2) [N] along y and
    z; ``axial`` (n, S) [N], tension positive: the load of the outboard part on the inboard one, in section axes.
    ``stress`` is None where section or material are not known. A rigid link has a straight line, no shape, and loads
    that are not a number: its mass has no place along it.
    """

    name: str
    node: int
    kind: str
    length: float
    s: Array
    position: Array
    rotation: Array
    moment: Array
    shear: Array
    axial: Array
    shape: Shape | None = None
    stress: Stress | None = None

    def largest(self, quantity: str, component: int | None = None) -> Largest | None:
        """The largest of a quantity (of the line, its shape or its stress), by size; None where it is not known."""
        owners = [owner for owner in (self, self.shape, self.stress) if hasattr(owner, quantity)]
        values = getattr(owners[0], quantity) if owners else None
        if values is None or np.isnan(values).all():
            return None
        info = values if component is None else values[..., component]
        size = np.abs(info) if info.ndim == 2 else np.linalg.norm(info, axis=-1)
        sample, place = np.unravel_index(int(np.nanargmax(size)), size.shape)
        value = info[sample, place] if info.ndim == 2 else size[sample, place]
        return Largest(float(value), float(self.s[place]), int(sample))


@dataclass(frozen=True, eq=False)
class LinkLines:
    """Lines of all links by name, and what each node's root carries.

    ``roots`` (n, nodes, 6): force then moment about the node's root, world axes, by what it carries on what holds it.
    """

    links: dict[str, LinkLine]
    roots: Array

    def __getitem__(self, name: str) -> LinkLine:
        return self.links[name]

    def bending(self) -> list[LinkLine]:
        """The lines of the links that bend."""
        return [line for line in self.links.values() if line.shape is not None]


def elastic_line(
    model: Model, q: ArrayLike, v: ArrayLike = 0.0, a: ArrayLike = 0.0, *,
    stations: int | Sequence[float] = STATIONS, wrenches: ArrayLike | None = None, base: ArrayLike | None = None,
) -> LinkLines:  # fmt: skip
    """The lines of all links at n samples of coordinates, rates and accelerations, each (n, nq) or (nq,).

    ``stations``: how many places along each link, or which (0..1); ``wrenches`` (n, points, 6) and ``base`` (n, 24) as
    :meth:`tmodes.model.model.ArmModel.inverse_dynamics` takes them. Raises :class:`tmodes.errors.InputError` for places
    off the link and :class:`tmodes.errors.SimulationError` for more than memory should hold.
    """
    asked = _asked(stations)
    q = np.atleast_2d(np.asarray(q, dtype=float))
    v, a = (np.broadcast_to(np.asarray(x, dtype=float), q.shape) for x in (v, a))
    nodes = model.chain.nodes
    _refuse_huge(len(q) * len(asked) * len(nodes) * _PER_PLACE)
    tables = [_tables(model, index, asked) for index in range(len(nodes))]
    pushed = None if wrenches is None else _rows(wrenches, (len(q), len(model.parts.points), 6))
    bases = _rows(model.at_rest() if base is None else base, (len(q), 24))
    walked = walk(model, tables, asked, q, v, a, bases)
    loads = node_loads(model, tables, walked, pushed)
    lines = {}
    for index, node in enumerate(nodes):
        lines[node.name] = _line(model, index, asked, tables[index], walked, loads[index], q, v)
    roots = np.stack([np.concatenate([load.root.force, load.root.moment], axis=-1) for load in loads], axis=1)
    return LinkLines(lines, roots)


def _asked(stations: int | Sequence[float]) -> Array:
    asked = np.linspace(0, 1, stations) if isinstance(stations, int) else np.asarray(stations, dtype=float)
    if asked.ndim != 1 or not len(asked) or not np.all((asked >= 0) & (asked <= 1)):
        hint = "give numbers from 0, the root, to 1, the tip"
        raise InputError("stations", repr(stations)[:80], "places along the links, at least one, in 0..1", hint)
    return asked


def _refuse_huge(numbers: int) -> None:
    if numbers > _MOST_NUMBERS:
        raise SimulationError(
            f"the elastic lines would take {numbers * 8 / 1e9:.1f} GB; expected at most "
            f"{_MOST_NUMBERS * 8 / 1e9:.0f} GB. Ask fewer samples at once, or fewer stations"
        )


def _rows(values: ArrayLike, shape: tuple[int, ...]) -> Array:
    array = np.asarray(values, dtype=float)
    return np.broadcast_to(array.reshape((-1, *shape[1:])), shape)


def _tables(model: Model, index: int, asked: Array) -> LineTables | None:
    beam, link = model.chain.nodes[index].link, model.parts.nodes[index].link
    if link is None or not isinstance(beam, Beam):
        return None
    stations = tuple(s for s, _ in link.stations)
    return line_tables(beam, stations, info_places(asked, stations))


def _line(
    model: Model, index: int, asked: Array, table: LineTables | None, walked: list[Walked], loads: NodeLoads,
    q: Array, v: Array,
) -> LinkLine:  # fmt: skip
    node, way, part = model.chain.nodes[index], walked[index], model.parts.nodes[index].link
    if part is None or isinstance(node.link, RigidLink):
        return _straight(model, index, asked, way)
    info = slice(1, 1 + len(asked))
    rotation, position = way.rotation[:, info], way.position[:, info]
    if isinstance(node.link, Segment):
        shape = segment_shape(node.link, asked, position, q[:, part.own], v[:, part.own])
    else:
        assert table is not None  # noqa: S101
        shape = beam_shape(table, info, rotation, position, q[:, part.own], v[:, part.own])
    back = rotation.swapaxes(-1, -2)
    force, moment = ((back @ x[:, info, :, None])[..., 0] for x in (loads.places.force, loads.places.moment))
    axial = force[..., 0]
    stress = stress_of(node.link, asked, moment, axial) if isinstance(node.link, Beam) else None
    turned = way.root.rotation[:, None]
    world = way.root.position[:, None] + (turned @ position[..., None])[..., 0]
    kind = "segment" if isinstance(node.link, Segment) else "strain"
    return LinkLine(node.name, index, kind, node.link.length, asked, world, turned @ rotation, moment, force[..., 1:],
                    axial, shape, stress)  # fmt: skip


def _straight(model: Model, index: int, asked: Array, way: Walked) -> LinkLine:
    """From the root of a rigid link to the farthest thing on it: a joint, else a point, else a center of mass."""
    end = _far_end(model, index, model.chain.nodes[index])
    rotation, length = way.root.rotation, float(np.linalg.norm(end))
    position = way.root.position[:, None] + asked[:, None] * (rotation @ end)[:, None]
    turned = np.broadcast_to(rotation[:, None], (len(rotation), len(asked), 3, 3))
    unknown = np.full((len(rotation), len(asked), 3), np.nan)
    name = model.chain.nodes[index].name
    return LinkLine(name, index, "rigid", length, asked, position, turned, unknown, unknown[..., 1:], unknown[..., 0])


def _far_end(model: Model, index: int, node: Node) -> Array:
    joints = [other.joint.placement.position for other in model.chain.nodes if other.parent == index]
    points = [point.offset.position for point in model.parts.points if point.node == index]
    bodies = [body.center for body in node.link.bodies] if isinstance(node.link, RigidLink) else []
    for places in (joints, points, bodies):
        if places:
            return np.asarray(max(places, key=lambda place: float(np.linalg.norm(place))), dtype=float)
    return np.zeros(3)
