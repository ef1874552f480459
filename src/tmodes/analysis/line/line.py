"""The elastic line of any link, at any point and sample: where it is, how it bends, what it carries, its stress.

All of it is computed by one compiled schedule, see :mod:`tmodes.equations.line.schedule`.

Eq. (29)-(33) [derived]: the moment along any link in space, of all that moves outboard of it.
{test_static_tip_force, test_rotating_beam}
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.analysis.worst import worst_place
from tmodes.chain.chain import Chain, Node
from tmodes.equations.line.schedule import MOVING, RIGID, ROOTS, Lines
from tmodes.errors import InputError, SimulationError
from tmodes.kinds.links.line import SAME, LineOfLink, layout
from tmodes.kinds.noted.functions import array, distinct
from tmodes.kinds.noted.number import is_noted, plain_value
from tmodes.model.model import Model
from tmodes.model.rows import StateRows

__all__ = ["Largest", "LineShape", "LinkLine", "LinkLines", "Stress", "elastic_line", "inner_forces", "line_places"]

Array = NDArray[np.float64]


def inner_forces(
    model: Model, index: int, s: Array, rows: Array, roots: Array, wrenches: Array | None
) -> tuple[Array, Array, Array, Array]:
    """Of a node's rigid beam at the places ``s`` (S,), for n samples.

    ``rows`` (n, 27): what the schedule gives of the node; ``roots`` (n, 6 nodes): loads of all roots; ``wrenches``
    (n, points, 6) on the points. Returns position (n, S, 3) and rotation (n, S, 3, 3) in the world, and the load of the
    outboard part on the inboard one in section axes: moment (n, S, 3) and force (n, S, 3), tension positive.

    The part from the root to s moves as one rigid body: it needs m a + alpha x c + omega x (omega x c), with m, c and J
    about the link's frame. What its root gives and it does not need is the load at s. Joints hang on the tip.
    """
    beam: Any = model.chain.nodes[index].link.mass_line
    axes, start = rows[:, RIGID["rotation"]].reshape(-1, 3, 3), rows[:, RIGID["position"]]
    place, rate, turning, acceleration = (rows[:, part] for part in MOVING.values())
    arm = start - place
    own = acceleration + np.cross(turning, arm) + np.cross(rate, np.cross(rate, arm))
    loads = roots.reshape(len(rows), -1, 6)
    others = _pushed(model, index, wrenches, axes, len(rows))
    found: list[list[Array]] = [[], [], [], []]
    for place_s, beyond in zip(s.tolist(), _beyond(s), strict=True):
        mass, first, inertia = beam.inboard(place_s, beyond=beyond)
        lever, tensor = axes @ first, axes @ inertia @ axes.swapaxes(1, 2)
        spun = (tensor @ rate[..., None])[..., 0]
        force = mass * own + np.cross(turning, lever) + np.cross(rate, np.cross(rate, lever))
        moment = np.cross(lever, own) + (tensor @ turning[..., None])[..., 0] + np.cross(rate, spun)
        force, moment = loads[:, index, :3] + force, loads[:, index, 3:] + moment
        for station, pull, turn in others:
            if station < place_s - SAME or (beyond and station <= place_s + SAME):
                force, moment = force - pull, moment - turn
        section = beam.place(place_s)
        reach = axes @ section.position
        about, rotation = moment - np.cross(reach, force), axes @ section.rotation
        found[0].append(start + reach)
        found[1].append(rotation)
        for values, vector in zip(found[2:], (about, force), strict=True):
            values.append((rotation.swapaxes(1, 2) @ vector[..., None])[..., 0])
    position, rotation, moment, force = (np.stack(values, axis=1) for values in found)
    return position, rotation, moment, force


def _beyond(s: Array) -> list[bool]:
    """Whether a place bears what is fixed at itself already: the root, and the second of two that are the same."""
    return [bool(here <= SAME or again) for here, again in zip(s, np.diff(s, prepend=-1.0) < SAME, strict=True)]


def _station(beam: Any, position: Array) -> float:
    """The place along the beam that is nearest to one in the link's frame."""
    grid = np.linspace(0.0, 1.0, 1001)
    chord = beam.place(1.0).position - beam.root.position
    if not any(beam.beam.rest_curvature):
        return float(np.clip((position - beam.root.position) @ chord / (chord @ chord), 0.0, 1.0))
    return float(grid[np.argmin([np.linalg.norm(beam.place(each).position - position) for each in grid])])


Load = tuple[float, Array, Array]
"""Station, force (n, 3) [N] and moment (n, 3) about the link's frame [N*m], in the world."""


def _pushed(model: Model, index: int, wrenches: Array | None, axes: Array, count: int) -> list[Load]:
    """Loads on the points of the link, each at the place of the beam that is nearest."""
    if wrenches is None:
        return []
    beam, found = model.chain.nodes[index].link.mass_line, []
    forces = np.broadcast_to(wrenches, (count, *wrenches.shape[-2:]))
    for number, point in enumerate(model.parts.points):
        if point.node == index:
            position = point.offset.position
            force, moment = forces[:, number, :3], forces[:, number, 3:]
            found.append((_station(beam, position), force, moment + np.cross(axes @ position, force)))
    return found


STATIONS = 21
"""Places along each link where none are asked."""

DRAWN, NO_NODE = "drawn", -1

_POINT_LIKE = 1e-9
"""A link shorter than this [m] is not drawn."""

_MOST_NUMBERS = 500_000_000
"""Numbers of an answer (4 GB) beyond which it is refused."""


@dataclass(frozen=True, eq=False)
class LineShape:
    """n samples, S places. ``deflection`` (n, S, 2) [m] along y and z of the root, off its tangent; ``slope`` (n, S, 2)
    [rad]: angle of the tangent against the root's, seen in its x-y and x-z planes.

    ``curvature`` (n, S, 2) [1/m] about y and z and ``twist`` (n, S) [rad/m] in section axes, with those of the unloaded
    line; ``stretch`` (n, S) [-]. ``elastic_moment`` (n, S, 3) [N*m]: torsion, about y, about z, as curvature and its
    rate ask of the material, EI (kappa + eta kappa'); ``elastic_force`` (n, S) [N] likewise of the stretch.
    """  # noqa: D205

    deflection: Array
    slope: Array
    curvature: Array
    twist: Array
    stretch: Array
    elastic_moment: Array
    elastic_force: Array


@dataclass(frozen=True, eq=False)
class Stress:
    """Largest stresses of each section, (n, S), n samples, S places.

    ``strain`` [-] and ``normal_stress`` [Pa] of the outer fibre where axial force and bending add up; ``shear_stress``
    [Pa] of torsion and of the transverse force together; ``mises_stress`` [Pa]: the larger of that of the outer fibre
    and that of the middle of the section, where the transverse force shears most.
    Exact for round sections and the corners of boxes; for others not less than the true values.
    """

    strain: Array
    normal_stress: Array
    shear_stress: Array
    mises_stress: Array


@dataclass(frozen=True)
class Largest:
    """The value of largest size of a quantity, where it is (``s``) and at which ``sample`` it comes first."""

    value: float
    s: float
    sample: int


@dataclass(frozen=True, eq=False)
class LinkLine:
    """The line of one link at the places ``s`` (S,), 0 its root and 1 its tip; n samples, SI.

    Loads are those in the beam: at its root just beyond a body that is fixed there, at its tip just before one; a place
    inside that is given twice has both sides of a body there.

    ``position`` (n, S, 3) and ``rotation`` (n, S, 3, 3) in the world (columns: tangent, and the section's y and z).
    ``shape``: how it bends. ``moment`` (n, S, 3) [N*m]: torsion, about y, about z; ``shear`` (n, S, 2) [N] along y and
    z; ``axial`` (n, S) [N], tension positive: the load of the outboard part on the inboard one, in section axes.
    ``stress`` is None where section or material are not known. A rigid link has a straight line, no shape, and loads
    that are not a number where its mass has no place along it: bodies without a beam. So is a line of the kind
    ``drawn`` between two points of a system stated by its energies, whose ``node`` is -1.
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
    shape: LineShape | None = None
    stress: Stress | None = None

    @property
    def is_point(self) -> bool:
        """Whether there is nothing to draw."""
        # A word of the line itself, drawn by points of a system or along a link; no kind of link is asked.
        return self.kind != DRAWN and self.length <= _POINT_LIKE

    def largest(self, quantity: str, component: int | None = None) -> Largest | None:
        """The largest of a quantity (of the line, its shape or its stress), by size; None where it is not known."""
        owners = [owner for owner in (self, self.shape, self.stress) if hasattr(owner, quantity)]
        values = getattr(owners[0], quantity) if owners else None
        if values is None or np.isnan(values).all():
            return None
        info = values if component is None else values[..., component]
        size = np.abs(info) if info.ndim == 2 else np.linalg.norm(info, axis=-1)
        sample, place = worst_place(size)
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

    def loaded(self) -> list[LinkLine]:
        """The lines whose inner forces are known: of links that bend, and of beams that do not."""
        return [line for line in self.links.values() if line.shape is not None or not np.isnan(line.axial).any()]


def elastic_line(
    model: Model, q: ArrayLike, v: ArrayLike = 0.0, a: ArrayLike = 0.0, *,
    stations: int | Sequence[float] = STATIONS, wrenches: ArrayLike | None = None, base: ArrayLike | None = None,
) -> LinkLines:  # fmt: skip
    """The lines of all links at n samples of coordinates, rates and accelerations, each (n, nq) or (nq,).

    ``stations``: how many places along each link, or which (0..1); ``wrenches`` (n, points, 6) and ``base`` (n, 24) as
    :meth:`tmodes.model.model.Model.inverse_dynamics` takes them. Raises :class:`tmodes.errors.InputError` for places
    off the link and :class:`tmodes.errors.SimulationError` for more than memory should hold.
    """
    asked = _asked(stations)
    q = np.atleast_2d(np.asarray(q, dtype=float))
    lines = model.passes.lines(tuple(asked), loaded=wrenches is not None)
    _refuse_huge(len(q) * lines.schedule.output_size)
    found = model.passes.on_lines(lines, StateRows(q, v, model.nq, finite=not model.trials), a, base, wrenches)
    forces = None if wrenches is None else np.asarray(wrenches, dtype=float)
    named = [
        line for index in range(len(model.chain.nodes)) for line in _lines(model, index, asked, lines, found, forces)
    ]
    named += [_between(name, asked, found[name]) for name in lines.drawn]
    return LinkLines({line.name: line for line in named}, found[ROOTS].reshape(len(q), -1, 6))


def line_places(chain: Chain, count: int) -> Array:
    """``count`` places from root to tip, with those of bodies inside a link twice: just before and just beyond them."""
    grid = np.linspace(0.0, 1.0, count)
    carrying = [s for node in chain.nodes if node.link.has_stations for s in node.link.body_places]
    carrying += [s for node in chain.nodes if node.link.mass_line for s, _ in node.link.mass_line.stations]
    inside = distinct(s for s in carrying if 0.0 < s < 1.0)
    known = [plain_value(s) for s in inside]
    others = [place for place in grid if all(abs(place - s) > SAME for s in known)]
    places = np.sort(np.concatenate([others, *([s, s] for s in known)]))
    return _moving(places, [0.0, *inside, 1.0], [0.0, *known, 1.0]) if is_noted(inside) else places


def _moving(places: Array, ends: Sequence[Any], known: Sequence[float]) -> Array:
    """Places that keep their shares of the way between noted ``ends``, which are ``known`` now."""
    found: list[Any] = []
    for place in places.tolist():
        k = min(int(np.searchsorted(known, place, side="right")), len(ends) - 1) - 1
        share = (place - known[k]) / (known[k + 1] - known[k])
        found.append(ends[k] + share * (ends[k + 1] - ends[k]) if share < 1.0 else ends[k + 1])
    return array(found)


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
            f"{_MOST_NUMBERS * 8 / 1e9:.0f} GB. Ask for fewer samples at once, or fewer stations"
        )


def _lines(
    model: Model, index: int, asked: Array, lines: Lines, found: dict[str, Array], wrenches: Array | None
) -> list[LinkLine]:
    node = model.chain.nodes[index]
    if node.link.mass_line is not None:
        return [_rigid_beam(model, index, asked, found, wrenches)]
    if not lines.links[index]:
        length = float(np.linalg.norm(lines.ends[index]))
        return [_straight(node.name, index, "rigid", asked, length, found[node.name])]
    return [_bent(node, index, line, found[node.name + line.suffix]) for line in lines.links[index]]


def _bent(node: Node, index: int, line: LineOfLink, found: Array) -> LinkLine:
    rows = found.reshape(len(found), len(line.s), -1)
    places = {name: rows[..., part] for name, part in layout(stressed=line.stressed).items()}
    values = {name: part[..., 0] if part.shape[-1] == 1 else part for name, part in places.items()}
    rotation = places["rotation"].reshape(*rows.shape[:2], 3, 3)

    def owned(kind: type) -> dict[str, Any]:
        return {field.name: values[field.name] for field in fields(kind)}

    return LinkLine(
        node.name + line.suffix, index, node.link.kind, line.length, line.s, values["position"], rotation,
        values["moment"], values["shear"], values["axial"], LineShape(**owned(LineShape)),
        Stress(**owned(Stress)) if line.stressed else None,
    )  # fmt: skip


def _rigid_beam(model: Model, index: int, asked: Array, found: dict[str, Array], wrenches: Array | None) -> LinkLine:
    """The line of a beam that does not bend, with its inner forces."""
    node, rows = model.chain.nodes[index], found[model.chain.nodes[index].name]
    position, rotation, moment, force = inner_forces(model, index, asked, rows, found[ROOTS], wrenches)
    length = node.link.mass_line.beam.length
    return LinkLine(
        node.name, index, node.link.kind, length, asked, position, rotation, moment, force[..., 1:], force[..., 0]
    )


def _between(name: str, asked: Array, found: Array) -> LinkLine:
    """A line that a system draws between two of its points, as long as it ever is."""
    lengths = np.linalg.norm(found[:, RIGID["end"]] - found[:, RIGID["position"]], axis=1)
    return _straight(name, NO_NODE, DRAWN, asked, float(lengths.max(initial=0.0)), found)


def _straight(name: str, index: int, kind: str, asked: Array, length: float, found: Array) -> LinkLine:
    """From the root of a rigid link to the farthest thing on it: a joint, else a point, else a center of mass."""
    start, stop = (found[:, None, RIGID[part]] for part in ("position", "end"))
    position = start + asked[:, None] * (stop - start)
    rotation = np.broadcast_to(found[:, RIGID["rotation"]].reshape(-1, 1, 3, 3), (*position.shape[:2], 3, 3))
    unknown = np.full(position.shape, np.nan)
    return LinkLine(name, index, kind, length, asked, position, rotation, unknown, unknown[..., 1:], unknown[..., 0])
