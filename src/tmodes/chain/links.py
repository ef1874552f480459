"""From the sheet of a link to nodes of a chain: rigid, one strain beam, or segments in a row."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from tmodes.chain.chain import Beam, BeamPiece, Body, Joint, JointKind, Node, Placement, RigidLink, Segment
from tmodes.kinds.links.beam import Basis, BeamModel, BeamSheet, Functions, RotaryInertia
from tmodes.kinds.links.beam_pieces import Piece
from tmodes.kinds.links.body import BodySheet
from tmodes.kinds.links.rigid_beam import rigid_body
from tmodes.kinds.schema.axes import bent_line
from tmodes.kinds.schema.frames import Origin
from tmodes.sheet.parts import LinkSheet

__all__ = ["Lowered", "Spot", "lowered_link", "placed"]


class Spot(NamedTuple):
    """A place on the nodes of a link: ``node`` counts from the link's first, ``s`` along it, ``placement`` there."""

    node: int
    s: float
    placement: Placement


@dataclass(frozen=True)
class Lowered:
    """The nodes of a link, and where its places are.

    ``tip``: the tip frame in the chain's tip frame of the last node; ``undeformed``: the tip frame in the link's frame
    as it is at rest; ``spot``: the place of a station.
    """

    nodes: tuple[Node, ...]
    tip: Placement
    undeformed: Placement
    spot: Callable[[float], Spot]


def placed(origin: Origin | None) -> Placement:
    """The placement of a sheet's origin; none: no offset."""
    return Placement(origin.rotation(), np.array(origin.position)) if origin else Placement()


def lowered_link(link: LinkSheet, node: Node, frame: Placement, chord: float) -> Lowered:
    """Nodes of a link that hangs on the joint of ``node``.

    ``frame``: the link's frame in the frame that the joint has moved; ``chord`` [m]: distance of a rigid link's tip
    frame from its own frame along x.
    """
    if link.beam is None:
        return _rigid(link, node, frame, chord)
    if link.beam.model is BeamModel.RIGID or not _bends(link.beam):
        return _rigid_beam(link, link.beam, node, frame)
    if link.beam.model is BeamModel.SEGMENTS:
        return _segments(link, link.beam, node, frame)
    return _strain(link, link.beam, node, frame)


def _rigid(link: LinkSheet, node: Node, frame: Placement, chord: float) -> Lowered:
    bodies = tuple(_body(body, frame) for body in link.bodies)
    out = Placement(position=np.array([chord, 0.0, 0.0]))
    tip = frame @ out
    return Lowered((replace(node, link=RigidLink(bodies)),), tip, out, lambda _: Spot(0, 1.0, tip))


def _rigid_beam(link: LinkSheet, beam: BeamSheet, node: Node, frame: Placement) -> Lowered:
    """The beam as one rigid body; its places are where the unloaded line is."""

    def spot(s: float) -> Spot:
        return Spot(0, 1.0, frame @ _at_rest(beam, s))

    own = _moved(rigid_body(beam), frame @ placed(beam.root_mount))
    bodies = (own, *(_body(body, spot(body.station).placement) for body in link.bodies))
    nodes = (replace(node, link=RigidLink(bodies)),)
    return Lowered(nodes, spot(1.0).placement, _at_rest(beam, 1.0), spot)


def _strain(link: LinkSheet, beam: BeamSheet, node: Node, frame: Placement) -> Lowered:
    """One strain beam. ``auto`` is ``legendre``: only these functions can carry a moment at the tip, and whoever asks
    for the stiffness of an arm puts one on every tip.
    """  # noqa: D205
    first, joint = _root(node, frame @ placed(beam.root_mount))
    count, functions = len(first), _finite_functions(beam)
    pieces = beam.section_pieces()
    shape = Beam(
        length=beam.length,
        pieces=tuple(_chain_piece(piece, beam.rotary_inertia) for piece in pieces),
        twist=functions.twist,
        bend_y=functions.bend_y,
        bend_z=functions.bend_z,
        stretch=functions.stretch,
        basis=str(Basis.LEGENDRE if beam.basis is Basis.AUTO else beam.basis),
        points=beam.points,
        damping_time=beam.damping_time or 0.0,
        rest_curvature=np.array(beam.rest_curvature),
        bodies=tuple((body.station, _body(body, _mount(beam, body.station))) for body in link.bodies),
        outer=(max(_ends(pieces, "outer_y")), max(_ends(pieces, "outer_z"))),
        young=max(_ends(pieces, "young")),
        shear=max(_ends(pieces, "shear")),
    )
    nodes = (*first, Node(link.name, node.parent, joint, shape))
    return Lowered(nodes, placed(beam.tip_mount), _at_rest(beam, 1.0), lambda s: Spot(count, s, _mount(beam, s)))


def _segments(link: LinkSheet, beam: BeamSheet, node: Node, frame: Placement) -> Lowered:
    """The paper's modes in a row, joined rigidly; a body at the root needs a rigid link before them."""
    count = beam.segments or 1
    at_root = tuple(_body(body, Placement()) for body in link.bodies if body.station == 0)
    root, joint = _root(node, frame @ placed(beam.root_mount), at_root)
    nodes = list(root)
    for k in range(count):
        bodies = [body for body in link.bodies if body.station > 0 and round(body.station * count) == k + 1]
        carried = tuple(_body(body, _mount(beam, body.station)) for body in bodies)
        name = link.name if count == 1 else f"{link.name}.{k + 1}"
        own = joint if k == 0 else Joint(name, JointKind.FIXED)
        nodes.append(Node(name, node.parent, own, _segment(beam, k, carried)))

    def spot(s: float) -> Spot:
        k = min(int(s * count), count - 1)
        return Spot(len(root) + k, s * count - k, _mount(beam, s))

    return Lowered(tuple(nodes), placed(beam.tip_mount), _at_rest(beam, 1.0), spot)


def _segment(beam: BeamSheet, index: int, bodies: tuple[Body, ...]) -> Segment:
    """Segment ``index`` with the section at its middle: 3 EI/l^3 against its tip, and the mass of Eq. (13) there."""
    count = beam.segments or 1
    length, middle = beam.length / count, (index + 0.5) / count
    bend_y, bend_z, mass = (_between(beam.section_pieces(), name, middle) for name in ("bend_y", "bend_z", "mass"))
    tip_mass = 33 / 140 * mass * length
    inertia = np.diag([0.0, 1.0, 1.0]) * tip_mass * (length / 2) ** 2
    functions, damping_time = _finite_functions(beam), beam.damping_time or 0.0
    stiffness_y, stiffness_z = 3 * bend_y / length**3, 3 * bend_z / length**3
    return Segment(
        length=length,
        stiffness_y=stiffness_y,
        stiffness_z=stiffness_z,
        damping_y=damping_time * stiffness_y if functions.bend_y else 0.0,
        damping_z=damping_time * stiffness_z if functions.bend_z else 0.0,
        bend_y=bool(functions.bend_y),
        bend_z=bool(functions.bend_z),
        bodies=(Body(tip_mass, np.zeros(3), inertia), *bodies),
    )


def _root(node: Node, root: Placement, bodies: tuple[Body, ...] = ()) -> tuple[tuple[Node, ...], Joint]:
    """What stands before a beam whose root is at ``root`` in the joint's moved frame, and the joint that carries it.

    Turning the frames of the joint itself is enough where its motion commutes with the offset of the root: always but
    for a revolute joint whose axis misses the root. There, and for bodies at the root, a rigid link comes first.
    """
    joint = node.joint
    across = np.cross(joint.axis, root.position)
    commutes = joint.kind is not JointKind.REVOLUTE or float(np.abs(across).max()) == 0.0
    if commutes and not bodies:
        axis = joint.axis if joint.kind is JointKind.FIXED else root.rotation.T @ joint.axis
        return (), replace(joint, placement=joint.placement @ root, axis=axis)
    name = f"{node.name}.root"
    first = replace(node, name=name, link=RigidLink(tuple(_moved(body, root) for body in bodies)))
    return (first,), Joint(name, JointKind.FIXED, root)


def _bends(beam: BeamSheet) -> bool:
    functions = _finite_functions(beam)
    counts = (functions.bend_y, functions.bend_z)
    return any(counts if beam.model is BeamModel.SEGMENTS else (*counts, functions.twist, functions.stretch))


def _finite_functions(beam: BeamSheet) -> Functions:
    """The functions of the directions that are not rigid; segments bend both ways when none are told."""
    wanted, pieces = beam.functions or Functions(bend_y=1, bend_z=1), beam.section_pieces()
    rigid = {name: 0 for name in ("bend_y", "bend_z") if np.isinf(_ends(pieces, name)).any()}
    return wanted.model_copy(update=rigid)


def _mount(beam: BeamSheet, s: float) -> Placement:
    """The frame of things at a station in its section's axes: that of the tip mount at the tip."""
    return placed(beam.tip_mount) if s == 1 else Placement()


def _at_rest(beam: BeamSheet, s: float) -> Placement:
    """The frame of things at a station, of the unloaded line, in the link's frame."""
    return placed(beam.root_mount) @ Placement(*bent_line(beam.rest_curvature, s * beam.length)) @ _mount(beam, s)


def _body(body: BodySheet, frame: Placement) -> Body:
    return _moved(Body(body.mass, np.array(body.center), body.inertia_matrix()), frame)


def _moved(body: Body, frame: Placement) -> Body:
    """The body as seen from where ``frame`` is given."""
    center = frame.rotation @ body.center + frame.position
    return Body(body.mass, center, frame.rotation @ body.inertia @ frame.rotation.T)


def _chain_piece(piece: Piece, rotary: RotaryInertia) -> BeamPiece:
    ends = {name: (getattr(piece.start, name), getattr(piece.stop, name)) for name in piece.start._fields}
    counted = {RotaryInertia.NONE: 0, RotaryInertia.TWIST: 1, RotaryInertia.FULL: 3}[rotary]
    x, y, z = (ends[f"inertia_{axis}"] if k < counted else (0.0, 0.0) for k, axis in enumerate("xyz"))
    own = {name: ends[name] for name in ("bend_y", "bend_z", "torsion", "axial", "mass")}
    return BeamPiece(end=piece.end, inertia=(x, y, z), **own)


def _ends(pieces: list[Piece], name: str) -> list[float]:
    return [getattr(numbers, name) for piece in pieces for numbers in (piece.start, piece.stop)]


def _between(pieces: list[Piece], name: str, s: float) -> float:
    """A number of the section at s."""
    start = 0.0
    for piece in pieces:
        if s <= piece.end or piece is pieces[-1]:
            first, last = getattr(piece.start, name), getattr(piece.stop, name)
            return first if first == last else first + (last - first) * (s - start) / (piece.end - start)
        start = piece.end
    return 0.0
