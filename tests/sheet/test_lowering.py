"""From the sheet to the chain: every state of a joint, every model of a link, places on them, free ends."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad_vec

from sheet.cases import SECTION, arm_of, at, beam, body, changed, joint, matrix, one_link, points, sheet, turned
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.links.segment import Segment
from tmodes.kinds.links.strain import Beam
from tmodes.kinds.schema.axes import bent_line

MOTOR = {"inertia": 0.1, "side": "joint"}
GEAR = {"stiffness": 900.0, "damping": 1.5}
RIGID_GEAR = {"stiffness": math.inf, "damping": 1.5}
PRESCRIBED = [{"joint": "pivot", "command": "prescribed", "signal": {"type": "constant", "value": 0.0}}]


@pytest.mark.parametrize(
    ("more", "drives", "drive", "motor", "gear"),
    [
        ({"motor": MOTOR, "gear": GEAR}, [], drive_kind("elastic"), True, True),
        ({"motor": MOTOR, "gear": GEAR}, PRESCRIBED, drive_kind("elastic"), True, True),
        ({"motor": MOTOR, "gear": RIGID_GEAR}, [], drive_kind("effort"), True, False),
        ({"gear": RIGID_GEAR}, [], drive_kind("effort"), False, False),
        ({"motor": MOTOR}, [], drive_kind("effort"), True, False),
        ({}, [], drive_kind("effort"), False, False),
        ({}, PRESCRIBED, drive_kind("prescribed"), False, False),
        ({"motor": MOTOR, "gear": RIGID_GEAR}, PRESCRIBED, drive_kind("prescribed"), False, False),
        ({"state": "locked", "locked_at": 0.3, "gear": GEAR}, [], drive_kind("spring"), False, True),
        ({"state": "locked", "locked_at": 0.3, "gear": GEAR, "motor": MOTOR}, [], drive_kind("spring"), False, True),
    ],
)
def test_what_drives_a_joint(more, drives, drive, motor: bool, gear: bool) -> None:
    data = one_link({"bodies": [body()]}, limits={"lower": -1, "upper": 2}, friction={"viscous": 0.7}, **more)
    found = arm_of({**data, "drives": drives}).chain().nodes[0].joint
    assert (found.kind, found.drive) == (joint_kind("revolute"), drive)
    assert (found.motor is not None, found.gear is not None) == (motor, gear)
    assert (found.lower, found.upper, found.friction.viscous) == (-1, 2, 0.7)
    assert found.rest == more.get("locked_at", 0.0)


@pytest.mark.parametrize("more", [{}, {"gear": RIGID_GEAR}, {"motor": MOTOR}])
@pytest.mark.parametrize("kind", ["revolute", "prismatic"])
def test_a_locked_joint_without_a_spring_is_fixed_where_it_is_locked(kind: str, more) -> None:
    axis, origin = [0.0, 0.6, 0.8], {"position": [0.1, 0.2, 0.3], "rpy": [0.4, 0.5, 0.6]}
    data = one_link({"bodies": [body()]}, type=kind, axis=axis, origin=origin, state="locked", locked_at=0.7, **more)
    found = arm_of(data).chain().nodes[0].joint
    motion = turned(axis, 0.7) if kind == "revolute" else at(0.7 * np.array(axis))
    assert found.kind is joint_kind("fixed")
    np.testing.assert_allclose(matrix(found.placement), at(origin["position"], origin["rpy"]) @ motion, atol=1e-15)


MOUNTS = [
    {"position": [0.2, 0, 0], "rpy": [0, 0, 0]},
    {"position": [0, 0, 0.15], "rpy": [0.3, -0.4, 0.5]},
    {"position": [0.1, -0.2, 0.3], "rpy": [1.1, 0.2, -0.7]},
]
"""Roots of a beam: off the joint's axis, on it, anywhere."""

TIP_MOUNT = {"position": [0.02, 0.03, -0.04], "rpy": [0.2, 0.1, -0.9]}


@pytest.mark.parametrize("mount", MOUNTS)
@pytest.mark.parametrize("kind", ["revolute", "prismatic", "fixed"])
@pytest.mark.parametrize("model", ["strain", "segments", "rigid"])
def test_every_model_of_a_link_ends_at_the_same_place(kind: str, model: str, mount) -> None:
    """Against matrices multiplied as the sheet says: base, origin, joint, root, beam, tip mount, next joint, point."""
    origin = {"position": [0.1, 0.2, 0.3], "rpy": [0.4, 0.5, 0.6]}
    next_origin = {"position": [0.05, 0, 0.02], "rpy": [-1, 0.3, 0.2]}
    base = {"position": [1, 2, 3], "rpy": [0.1, 0.2, 0.3]}
    first = joint("a", "upper", type=kind, origin=origin, axis=None if kind == "fixed" else [0, 0, 2])
    shape = beam(model=model, segments=3, root_mount=mount, tip_mount=TIP_MOUNT)
    data = sheet(
        base=base,
        joints=[first, joint("b", "fore", origin=next_origin, axis=[1, 1, 0])],
        links=[{"name": "upper", "beam": shape}, {"name": "fore", "bodies": [body()]}],
        tip={"link": "fore", "position": [0.3, 0.1, 0.2], "rpy": [0.7, 0, 0]},
        points=[
            {"name": "middle", "link": "upper", "at": 1 / 3, "position": [0, 0.01, 0]},
            {"name": "end", "link": "upper", "position": [0, 0, 0.01]},
            {"name": "root", "link": "upper", "at": 0},
        ],
    )
    a, b = 0.6, -0.8
    motion = {"revolute": turned([0, 0, 1], a), "prismatic": at([0, 0, a]), "fixed": np.eye(4)}[kind]
    link = at(base["position"], base["rpy"]) @ at(origin["position"], origin["rpy"]) @ motion
    root = link @ at(mount["position"], mount["rpy"])
    end = root @ at([0.6, 0, 0]) @ at(TIP_MOUNT["position"], TIP_MOUNT["rpy"])
    tip = end @ at(next_origin["position"], next_origin["rpy"]) @ turned([1, 1, 0], b)
    found = points(arm_of(data).chain(), {"a": a, "b": b})
    np.testing.assert_allclose(found["tip"], tip @ at([0.3, 0.1, 0.2], [0.7, 0, 0]), atol=1e-14)
    np.testing.assert_allclose(found["middle"], root @ at([0.2, 0.01, 0]), atol=1e-14)
    np.testing.assert_allclose(found["end"], end @ at([0, 0, 0.01]), atol=1e-14)
    np.testing.assert_allclose(found["root"], root, atol=1e-14)


def test_frames_are_turned_where_they_may_be_and_a_link_is_put_before_where_not() -> None:
    """On the axis the joint's own frames are turned; off it, a massless link stands between."""
    counts = [len(arm_of(one_link({"beam": beam(root_mount=mount)})).chain().nodes) for mount in MOUNTS]
    assert counts == [2, 1, 2]
    before = arm_of(one_link({"beam": beam(root_mount=MOUNTS[0])})).chain().nodes
    assert before[0].link.bodies == ()
    assert (before[0].name, before[1].name, before[1].parent) == ("rod.root", "rod", 0)


def test_segments_are_the_modes_of_the_paper() -> None:
    """Eq. (13) and Cs = 3 EI/l^3, of l = L/n."""
    data = one_link({"beam": beam(model="segments", segments=3), "bodies": [body(2.0, center=[0, 0.1, 0])]})
    nodes = arm_of(data).chain().nodes
    assert [node.name for node in nodes] == ["rod.1", "rod.2", "rod.3"]
    assert [node.parent for node in nodes] == [-1, 0, 1]
    assert [str(node.joint.kind) for node in nodes] == ["revolute", "fixed", "fixed"]
    mass = 33 / 140 * 0.7 * 0.2
    for node in nodes:
        link = node.link
        assert isinstance(link, Segment)
        assert (link.length, link.stiffness_y) == pytest.approx((0.2, 3 * 120 / 0.008))
        assert (link.stiffness_z, link.damping_y) == pytest.approx((3 * 80 / 0.008, 2e-4 * 3 * 120 / 0.008))
        assert link.bodies[0].mass == pytest.approx(mass)
        np.testing.assert_allclose(link.bodies[0].inertia, np.diag([0, 1, 1]) * mass * 0.01, rtol=1e-14)
    assert [len(node.link.bodies) for node in nodes] == [1, 1, 2]
    np.testing.assert_allclose(nodes[2].link.bodies[1].center, [0, 0.1, 0])


def test_segments_bend_where_functions_say() -> None:
    data = one_link({"beam": beam(model="segments", segments=1, functions={"bend_z": 1})})
    (node,) = arm_of(data).chain().nodes
    assert (node.link.bend_y, node.link.bend_z) == (False, True)


def test_bodies_on_segments_ride_on_their_ends() -> None:
    bodies = [body(1.0, at=0), body(2.0, at=0.5), body(3.0)]
    nodes = arm_of(one_link({"beam": beam(model="segments", segments=2), "bodies": bodies})).chain().nodes
    masses = [[carried.mass for carried in node.link.bodies] for node in nodes]
    assert masses[0] == [1.0]
    assert [own[1:] for own in masses[1:]] == [[2.0], [3.0]]


def test_bodies_on_a_strain_beam() -> None:
    """In section axes at their stations; at the end in the frame of the tip mount."""
    bodies = [body(1.0, at=0.25, center=[0, 0.1, 0]), body(2.0, center=[0.1, 0.2, 0.3])]
    data = one_link({"beam": beam(tip_mount=TIP_MOUNT), "bodies": bodies})
    (node,) = arm_of(data).chain().nodes
    (s, middle), (end, last) = node.link.bodies
    assert (s, end) == (0.25, 1.0)
    np.testing.assert_allclose(middle.center, [0, 0.1, 0])
    mount = at(TIP_MOUNT["position"], TIP_MOUNT["rpy"])
    np.testing.assert_allclose(last.center, (mount @ [0.1, 0.2, 0.3, 1])[:3], atol=1e-15)
    turn = mount[:3, :3]
    np.testing.assert_allclose(last.inertia, turn @ np.diag([0.02, 0.03, 0.025]) @ turn.T, atol=1e-16)


@pytest.mark.parametrize("curvature", [(0.0, 0.0, 0.0), (0.3, -1.2, 2.0)])
def test_a_rigid_beam_has_the_inertia_of_its_line(curvature) -> None:
    """Two pieces of different mass, with full rotary inertia; about the link's origin, by adaptive quadrature."""
    heavy = {**SECTION, "mass_per_length": 2.0, "polar_inertia_per_length": 5e-3}
    pieces = [{"end": 0.2, "section": heavy}, {"end": 0.6, "section": SECTION}]
    more = {"section": None, "pieces": pieces, "rest_curvature": list(curvature), "rotary_inertia": "full"}
    mount = MOUNTS[2]
    data = one_link({"beam": beam(model="rigid", root_mount=mount, **more)})
    (node,) = arm_of(data).chain().nodes
    assert isinstance(node.link, RigidLink)
    (found,) = node.link.bodies
    root = at(mount["position"], mount["rpy"])

    def density(x, mass, polar):
        rotation, position = bent_line(curvature, x)
        place, turn = (root @ [*position, 1])[:3], root[:3, :3] @ rotation
        own = turn @ np.diag([polar, 0.6 * polar, 0.4 * polar]) @ turn.T
        spread = mass * (place @ place * np.eye(3) - np.outer(place, place)) + own
        return np.concatenate([[mass], mass * place, spread.ravel()])

    parts = [(0.0, 0.2, 2.0, 5e-3), (0.2, 0.6, 0.7, 2e-4)]
    sums = [quad_vec(lambda x, m=m, p=p: density(x, m, p), a, b, epsrel=1e-12)[0] for a, b, m, p in parts]
    exact = np.sum(sums, axis=0)
    assert found.mass == pytest.approx(exact[0], rel=1e-13)
    np.testing.assert_allclose(found.mass * found.center, exact[1:4], rtol=1e-12)
    about = found.inertia + found.mass * (
        found.center @ found.center * np.eye(3) - np.outer(found.center, found.center)
    )
    np.testing.assert_allclose(about.ravel(), exact[4:], rtol=1e-10, atol=1e-14)


PUSH = {"force": [0, 0, 1], "frame": "world"}

FREE_ENDS = [
    ({}, {}),
    ({"bodies": [{"mass": 1}]}, {}),
    ({"bodies": [body()]}, {}),
    ({}, {"loads": [PUSH]}),
    ({}, {"loads": [{"moment": [0, 0, 1], "frame": "world"}]}),
]


@pytest.mark.parametrize(("link", "more"), FREE_ENDS)
def test_the_automatic_basis_can_carry_a_moment_at_the_tip(link, more) -> None:
    """Whatever the sheet says of the end: its stiffness against moments may be asked."""
    (node,) = arm_of({**one_link({"beam": beam(), **link}), **more}).chain().nodes
    assert isinstance(node.link, Beam)
    assert node.link.basis == "legendre"


def test_a_basis_that_is_asked_for() -> None:
    chosen = changed(lambda data: data["links"][0]["beam"].update(basis="tip_weighted"))
    link = arm_of(chosen).chain().nodes[0].link
    assert isinstance(link, Beam)
    assert link.basis == "tip_weighted"


def test_gravity_and_its_shorthand() -> None:
    for given, expected in (
        (9.81, (0, 0, -9.81)),
        ("9.81 m/s^2", (0, 0, -9.81)),
        ([1, 2, 3], (1, 2, 3)),
        (0, (0, 0, 0)),
    ):
        np.testing.assert_array_equal(arm_of(sheet(gravity=given)).chain().gravity, expected)


def test_parents_come_before_children_whatever_the_order_of_the_sheet() -> None:
    joints = [
        joint("hand", "palm", parent="fore"),
        joint("elbow", "fore", parent="upper"),
        joint("shoulder", "upper", parent="base"),
        joint("other", "left", parent="upper"),
    ]
    links = [{"name": name, "bodies": [body()]} for name in ("palm", "fore", "upper", "left")]
    nodes = arm_of(sheet(joints=joints, links=links)).chain().nodes
    assert [node.name for node in nodes] == ["upper", "fore", "palm", "left"]
    assert [node.parent for node in nodes] == [-1, 0, 1, 0]


def test_couplings_are_rows_of_gears_over_motors() -> None:
    more = {"motor": MOTOR, "gear": GEAR}
    joints = [joint("a", "x", **more), joint("b", "y"), joint("c", "z", **more)]
    links = [{"name": name, "bodies": [body(center=[0.1, 0, 0])]} for name in "xyz"]
    data = sheet(joints=joints, links=links, couplings={"c": {"a": -0.5, "c": 1.0}})
    np.testing.assert_array_equal(arm_of(data).chain().couplings, [[1, 0], [-0.5, 1]])
    assert arm_of({**data, "couplings": {}}).chain().couplings is None
    assert arm_of(sheet()).chain().points[0].name == "tip"
