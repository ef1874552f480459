"""Robots of the tests as chains: UR5 from a table of numbers, arms of beams with oblique joints."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from tmodes.chain.chain import Chain, Friction, Gear, Joint, Motor, Node, Point
from tmodes.frame import Placement
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.links.segment import Segment
from tmodes.kinds.links.strain import Beam, BeamPiece

__all__ = ["GRAVITY", "arms", "piece", "turned", "ur5", "ur5_table"]

GRAVITY = np.array([0.0, 0.0, -9.81])
TABLE = Path(__file__).parents[2] / "equations" / "data" / "ur5.json"


def turned(axis: list[float], angle: float, position: list[float] | None = None) -> Placement:
    """A placement turned about ``axis`` (any length) by ``angle`` [rad] at ``position`` [m]."""
    from scipy.spatial.transform import Rotation

    unit = np.array(axis) / np.linalg.norm(axis)
    return Placement(Rotation.from_rotvec(angle * unit).as_matrix(), np.array(position or [0.0, 0.0, 0.0]))


def ur5_table() -> dict[str, Any]:
    """The UR5's numbers and reference states."""
    return json.loads(TABLE.read_text(encoding="utf-8"))


def ur5(elastic: bool = False) -> Chain:
    """UR5 of rigid links, its joints driven directly or behind the table's elastic gears."""
    table = ur5_table()
    nodes = tuple(_ur5_node(table, i, elastic) for i in range(6))
    tip = Placement(np.array(table["tip"]["R"]), np.array(table["tip"]["p"]))
    return Chain("ur5", nodes, np.array(table["gravity"]), points=(Point("tip", 5, offset=tip),))


def _ur5_node(table: dict[str, Any], i: int, elastic: bool) -> Node:
    row, gear = table["joints"][i], table["elastic"]
    joint = Joint(
        row["name"],
        joint_kind("revolute"),
        Placement(np.array(row["placement_R"]), np.array(row["placement_p"])),
        np.array(row["axis"], float),
        drive=drive_kind("elastic") if elastic else drive_kind("effort"),
        motor=Motor(gear["B"][i]) if elastic else None,
        gear=Gear((gear["K"][i],), damping=gear["D"][i]) if elastic else None,
    )
    body = Body(row["mass"], np.array(row["com"]), np.array(row["inertia_com"]))
    return Node(f"link{i + 1}", i - 1, joint, RigidLink((body,)))


def piece(
    bending: float,
    mass: float,
    *,
    end: float = 1.0,
    torsion: float = 0.0,
    axial: float = 0.0,
    rotary: float = 0.0,
    polar: float | None = None,
    taper: float = 1.0,
    shear: tuple[float, float] = (np.inf, np.inf),
) -> BeamPiece:
    """A round piece: EI, rhoA, rhoI of bending and of twist (twice that); ``taper``: end over start of everything."""

    def both(value: float) -> tuple[float, float]:
        return value, value * taper

    inertia = (both(2 * rotary if polar is None else polar), both(rotary), both(rotary))
    bends, shears = (both(bending), both(1.3 * bending)), (both(shear[0]), both(shear[1]))
    return BeamPiece(end, *bends, both(torsion), both(axial), both(mass), inertia, *shears)


def _elastic(name: str, placement: Placement, axis: list[float], stiffness: float, rotor: float) -> Joint:
    return Joint(
        name,
        joint_kind("revolute"),
        placement,
        np.array(axis) / np.linalg.norm(axis),
        drive=drive_kind("elastic"),
        motor=Motor(rotor, Friction(viscous=0.4)),
        gear=Gear((stiffness,), damping=0.8),
    )


PAYLOAD = Body(1.3, np.array([0.05, -0.03, 0.04]), np.diag([2e-3, 3e-3, 4e-3]) + 3e-4 * (np.ones((3, 3)) - np.eye(3)))


def _twist_and_bend() -> Chain:
    """Two beams in space, oblique axes, twist inertia, an offset payload with inertia."""
    first = Beam(
        0.8, (piece(30.0, 0.7, torsion=25.0, polar=2e-3),), twist=1, bend_y=3, bend_z=3, points=5, damping_time=1e-3
    )
    second = Beam(
        0.55,
        (piece(9.0, 0.4, torsion=7.0, polar=1e-3),),
        twist=1,
        bend_y=2,
        bend_z=3,
        points=5,
        damping_time=5e-4,
        bodies=((1.0, PAYLOAD),),
    )
    nodes = (
        Node("upper", -1, _elastic("shoulder", turned([1, 0, 0], 0.3), [0, 0, 1], 300.0, 0.2), first),
        Node(
            "fore", 0, _elastic("elbow", turned([0.6, 0.8, 0], 0.7, [0.1, 0.02, 0.03]), [0, 3, 4], 200.0, 0.1), second
        ),
    )
    return Chain("twist_and_bend", nodes, GRAVITY)


def _curved_and_stretched() -> Chain:
    """A tapered, curved beam of two pieces that stretches and shears, after a rigid link and a slide."""
    beam = Beam(
        0.7,
        (
            piece(20.0, 0.6, end=0.4, torsion=15.0, axial=4e3, rotary=1e-3, taper=0.8, shear=(2e3, 1.5e3)),
            piece(12.0, 0.5, torsion=9.0, axial=3e3, rotary=8e-4, taper=0.7, shear=(1.2e3, 1e3)),
        ),
        twist=2,
        bend_y=2,
        bend_z=2,
        stretch=2,
        shear_y=2,
        shear_z=1,
        points=4,
        damping_time=1e-3,
        rest_curvature=np.array([0.2, 0.3, -0.4]),
        bodies=((0.4, Body(0.3, np.array([0.0, 0.02, 0.01]), np.diag([1e-4, 2e-4, 2e-4]))), (1.0, PAYLOAD)),
    )
    slide = Joint("slide", joint_kind("prismatic"), turned([0, 1, 0], 0.4), np.array([0.6, 0.0, 0.8]), motor=Motor(0.7))
    fixed = Joint("flange", joint_kind("fixed"), turned([1, 1, 0], 0.5, [0.0, 0.1, 0.2]))
    nodes = (
        Node("carriage", -1, slide, RigidLink((Body(2.0, np.array([0.1, 0, 0.05]), 0.02 * np.eye(3)),))),
        Node("mount", 0, fixed, RigidLink()),
        Node("boom", 1, _elastic("swing", turned([0, 1, 1], 0.9, [0.2, 0, 0]), [1, 0, 2], 150.0, 0.05), beam),
    )
    return Chain("curved_and_stretched", nodes, GRAVITY, base=turned([1, 2, 0], 0.6, [0.3, -0.2, 0.5]))


def _branched() -> Chain:
    """A flexible trunk that carries a rigid arm, a tip-weighted planar beam and a sprung passive joint."""
    trunk = Beam(
        0.5, (piece(40.0, 0.9, torsion=30.0, rotary=2e-3),), twist=1, bend_y=2, bend_z=2, points=4, damping_time=1e-3
    )
    blade = Beam(0.6, (piece(6.0, 0.3),), bend_z=3, basis="tip_weighted", points=5, damping_time=1e-3)
    passive = Joint(
        "wrist",
        joint_kind("revolute"),
        turned([1, 0, 0], 1.2, [0.2, 0, 0.1]),
        np.array([0.0, 1.0, 0.0]),
        drive=drive_kind("spring"),
        gear=Gear((25.0,), damping=0.2),
        friction=Friction(viscous=0.1),
    )
    hinge = Joint(
        "hinge", joint_kind("revolute"), turned([0, 0, 1], 0.8), np.array([0.0, 0.6, -0.8]), motor=Motor(0.03)
    )
    hand = RigidLink((Body(0.6, np.array([0.1, 0.02, 0.0]), np.diag([1e-3, 2e-3, 2e-3])),))
    nodes = (
        Node("trunk", -1, _elastic("waist", Placement(), [0, 1, 4], 400.0, 0.3), trunk),
        Node("arm", 0, hinge, RigidLink((PAYLOAD,))),
        Node("blade", 0, _elastic("root", turned([0, 1, 0], -0.6, [0, 0.1, 0]), [1, 1, 1], 80.0, 0.04), blade),
        Node("hand", 1, passive, hand),
    )
    points = (Point("hand", 3, offset=turned([1, 0, 0], 0.2, [0.1, 0, 0])), Point("end", 2), Point("top", 0))
    points += (Point("gauge", 0, 0.37, turned([0, 1, 1], 0.4, [0.0, 0.03, 0.01])),)
    return Chain("branched", nodes, GRAVITY, points=points)


def _segmented() -> Chain:
    """The paper's modes as links: two segments in both planes behind an elastic gear, then one in one plane."""
    lump, payload = Body(0.12, inertia=0.01 * np.eye(3)), PAYLOAD
    fixed = Joint("lower_upper", joint_kind("fixed"))
    lower = Segment(0.6, 2e3, 1.5e3, 0.4, 0.3, bodies=(lump,))
    nodes = (
        Node(
            "lower",
            -1,
            _elastic("base", Placement(), [0, 0, 1], 500.0, 0.2),
            lower,
        ),
        Node("higher", 0, fixed, Segment(0.3, 4e2, 5e2, 0.1, 0.2, bodies=(lump,))),
        Node(
            "last",
            1,
            _elastic("tilt", turned([1, 0, 0], 0.6), [0, 3, 4], 90.0, 0.03),
            Segment(0.2, 0.0, 3e2, 0.0, 0.1, bend_y=False, bodies=(payload,)),
        ),
    )
    return Chain("segmented", nodes, GRAVITY)


def arms() -> dict[str, Chain]:
    """Arms that together hold every kind of joint and link."""
    chains = (_twist_and_bend(), _curved_and_stretched(), _branched(), _segmented(), ur5(elastic=True))
    return {chain.name: chain for chain in chains}
