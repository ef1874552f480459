"""Rigid joints by the short way: any placement, aligned, parallel, coaxial or nearly so, equals Newton and Euler's."""

from __future__ import annotations

from dataclasses import replace

import casadi as ca
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from random_chains import random_body, random_placement
from tmodes.chain.chain import Chain, Joint, Motor, Node, Point
from tmodes.compile.ir.program import kernel_function
from tmodes.equations.recursion.framing import STRAIGHT, Framing, ScrewWay
from tmodes.equations.recursion.screw import rates_kernel
from tmodes.frame import Placement
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.rigid import RigidLink
from tmodes.model.model import Model

X, Z = np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])


def placed(rotvec, position) -> Placement:
    return Placement(Rotation.from_rotvec(rotvec).as_matrix(), np.array(position, dtype=float))


PLACES = {
    "general": placed([0.3, -0.8, 0.5], [0.1, -0.2, 0.3]),
    "parallel": placed([0, 0, 0.4], [0.3, 0.1, 0.2]),
    "parallel, in line": placed([0, 0, 0], [0, 0, 0.5]),
    "opposite": placed([np.pi, 0, 0], [0.2, 0.1, 0.1]),
    "opposite, about y": placed([0, np.pi, 0], [0.2, 0.1, -0.1]),
    "coaxial, on one point": placed([0, 0, 0], [0, 0, 0]),
    "crossing": placed([np.pi / 2, 0, 0], [0, 0, 0.4]),
    "quarter": placed([0, np.pi / 2, 0], [0.1, 0.2, 0.0]),
    "nearly parallel": placed([1e-3, 2e-3, 0.2], [0.4, 0.1, 0.1]),
    "parallel but for rounding": placed([3e-16, 0, 0], [0.4, 0.0, 0.1]),
    "all but parallel": placed([2e-9, 1e-9, 0], [0.2, 0.3, 0.1]),
    "slightly oblique": placed([0.15, 0.05, 0.0], [0.2, 0.3, 0.1]),
    "nearly opposite": placed([np.pi - 1e-4, 1e-3, 0], [0.2, 0.3, 0.1]),
}


def tree(place: Placement, kinds: str = "RRRR", seed: int = 0, **changed) -> Chain:
    """Four joints in a row, and a branch of two at the second; each joint stands on the one before as ``place``."""
    rng = np.random.default_rng(seed)
    named = {"R": joint_kind("revolute"), "P": joint_kind("prismatic"), "F": joint_kind("fixed")}
    nodes = []
    for k, (kind, parent) in enumerate(zip(kinds + "RR", (-1, 0, 1, 2, 1, 4), strict=True)):
        joint = Joint(f"j{k}", named[kind], random_placement(rng) if k == 0 else place, Z)
        bodies = (random_body(rng), random_body(rng))[: 2 - k % 2]
        nodes.append(Node(f"l{k}", parent, replace(joint, **changed), RigidLink(bodies)))
    points = (Point("tool", 3, offset=random_placement(rng, 0.1)), Point("branch", 5, offset=random_placement(rng)))
    return Chain("tree", tuple(nodes), np.array([0.3, -0.5, -9.81]), random_placement(rng), points)


def newton_euler(chain: Chain, q, v, a):
    """Forces along the moving joints and places of the points, link by link in world axes, and nothing else."""
    order = iter(range(len(q)))
    states, result = [], np.zeros(len(q))
    for node in chain.nodes:
        still = (chain.base, np.zeros(3), np.zeros(3), -chain.gravity)
        frame, w, alpha, linear = states[node.parent][:4] if node.parent >= 0 else still
        joint = frame @ node.joint.placement
        arm, axis = joint.position - frame.position, joint.rotation @ node.joint.axis
        linear = linear + np.cross(alpha, arm) + np.cross(w, np.cross(w, arm))
        k, link = None, joint
        if node.joint.kind is not joint_kind("fixed"):
            k = next(order)
        if node.joint.kind is joint_kind("revolute"):
            link = joint @ Placement(Rotation.from_rotvec(q[k] * node.joint.axis).as_matrix())
            alpha = alpha + np.cross(w, v[k] * axis) + a[k] * axis
            w = w + v[k] * axis
        elif node.joint.kind is joint_kind("prismatic"):
            slid = q[k] * axis
            link = Placement(joint.rotation, joint.position + slid)
            linear = linear + np.cross(alpha, slid) + np.cross(w, np.cross(w, slid))
            linear = linear + 2 * v[k] * np.cross(w, axis) + a[k] * axis
        states.append([link, w, alpha, linear, k, axis, np.zeros(3), np.zeros(3)])
    for node, state in zip(reversed(chain.nodes), reversed(states), strict=True):
        frame, w, alpha, linear, k, axis, moment, force = state
        assert isinstance(node.link, RigidLink)
        for body in node.link.bodies:
            arm, inertia = frame.rotation @ body.center, frame.rotation @ body.inertia @ frame.rotation.T
            push = body.mass * (linear + np.cross(alpha, arm) + np.cross(w, np.cross(w, arm)))
            moment = moment + np.cross(arm, push) + inertia @ alpha + np.cross(w, inertia @ w)
            force = force + push
        if k is not None:
            turning = node.joint.kind is joint_kind("revolute")
            motor = node.joint.motor.inertia if node.joint.motor else 0.0
            result[k] = axis @ (moment if turning else force) + motor * a[k]
        if node.parent >= 0:
            before = states[node.parent]
            before[6] = before[6] + moment + np.cross(frame.position - before[0].position, force)
            before[7] = before[7] + force
    return result, [states[point.node][0] @ point.offset for point in chain.points]


def assert_moves_as_newton_and_euler_say(chain: Chain) -> None:
    model, rng = Model(chain), np.random.default_rng(1)
    for _ in range(3):
        q, v, a = rng.uniform(-3, 3, model.nq), rng.normal(size=model.nq), rng.normal(size=model.nq)
        effort, points = newton_euler(chain, q, v, a)
        size = np.abs(effort).max()
        assert np.abs(model.inverse_dynamics(q, v, a) - effort).max() <= 1e-12 * size
        back = newton_euler(chain, q, v, model.forward_dynamics(q, v, effort))[0]
        assert np.abs(back - effort).max() <= 1e-12 * size
        for found, turned, point in zip(*model.pose(q), points, strict=True):
            assert np.abs(found - point.position).max() <= 1e-13
            assert np.abs(turned - point.rotation).max() <= 1e-13


@pytest.mark.parametrize("name", PLACES)
def test_tree_moves_as_newton_and_euler_say(name: str) -> None:
    assert_moves_as_newton_and_euler_say(tree(PLACES[name]))


@pytest.mark.parametrize("kinds", ["RPRR", "PRPR", "RFRR", "FRRR", "RRPF"])
def test_other_joints_between(kinds: str) -> None:
    assert_moves_as_newton_and_euler_say(tree(PLACES["general"], kinds))


@pytest.mark.parametrize("axis", [X, np.array([0.0, 0.6, 0.8])])
def test_any_axis_with_rotors(axis) -> None:
    """Inertia of a rotor stays along the axis: the whole articulated inertia is passed on."""
    assert_moves_as_newton_and_euler_say(tree(PLACES["general"], axis=axis, motor=Motor(0.3)))


@pytest.mark.parametrize("name", PLACES)
def test_way_is_the_placement(name: str) -> None:
    """Two turns about one axis each, with their shifts, make the placement between frames on the axes."""
    framing = Framing(tree(PLACES[name], seed=4))
    for index, node in enumerate(framing.chain.nodes):
        way, placement = framing.screws[index], framing.placements[index]
        assert way is not None
        info = way.placement()
        assert np.abs(info.rotation - placement.rotation).max() <= 2e-14
        assert np.abs(info.position - placement.position).max() <= 2e-14
        if framing.heirs.get(node.parent) == index:
            assert way.beta == STRAIGHT
            assert way.lever[2] == 0


def test_foot_far_away_is_not_stood_on() -> None:
    """Frames stay near the link, however far the common normal of nearly parallel axes is."""
    framing = Framing(tree(placed([1e-6, 0, 0], [0.3, 0.4, 0.2])))
    assert max(float(np.abs(frame.position).max()) for frame in framing.frames) < 1


def test_general_way_has_its_lever_and_its_turn() -> None:
    """A way that no frame was chosen for, as from the base."""
    place = PLACES["general"]
    way = ScrewWay.of(place, heir=False)
    assert way.along == 0
    assert way.beta != STRAIGHT
    assert np.abs(way.placement().rotation - place.rotation).max() <= 1e-15
    assert np.abs(way.placement().position - place.position).max() <= 1e-15


def test_quarter_turns_are_exact() -> None:
    """A chain that hangs straight down hangs still, to the bit, whichever way its axes and frames are turned."""
    quarter = Placement(np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]))
    joint = Joint("a", joint_kind("revolute"), Placement(), np.array([0.0, 1.0, 0.0]))
    other = Joint("b", joint_kind("revolute"), Placement(quarter.rotation, np.array([0.0, 0.0, -0.5])), Z)
    last = Joint("c", joint_kind("revolute"), Placement(quarter.rotation.T, np.array([0.0, -0.25, 0.0])), X)
    bodies = [(0.0, 0.0, -0.3), (0.0, -0.2, 0.0), (0.0, 0.0, -0.1)]
    links = [RigidLink((Body(1.5, np.array(center), np.diag([0.1, 0.2, 0.3])),)) for center in bodies]
    nodes = (Node("one", -1, joint, links[0]), Node("two", 0, other, links[1]), Node("three", 1, last, links[2]))
    model = Model(Chain("plumb", nodes, np.array([0.0, 0.0, -9.81])))
    assert not model.forward_dynamics(np.zeros(3), np.zeros(3)).any()


def test_prescribed_joint_among_others() -> None:
    """A given motion, with the joints around it free: the free ones need no effort but their own."""
    chain = tree(PLACES["general"])
    held = replace(chain.nodes[2], joint=replace(chain.nodes[2].joint, drive=drive_kind("prescribed")))
    chain = replace(chain, nodes=(*chain.nodes[:2], held, *chain.nodes[3:]))
    model, rng = Model(chain), np.random.default_rng(2)
    q, v, a = (rng.normal(size=model.nq) for _ in range(3))
    effort = newton_euler(chain, q, v, a)[0]
    free = [k for k in range(model.nq) if k != 2]
    found = model.forward_dynamics(q, v, effort[free], given=a[2:3])
    assert np.abs(found - a).max() <= 1e-11 * np.abs(a).max()


def operations(kernels) -> int:
    """Operations of kernels, not counted what is read and written."""
    function = [kernel_function(kernel) for kernel in kernels]
    moved = (ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST)
    return sum(f.instruction_id(k) not in moved for f in function for k in range(f.n_instructions()))


def test_short_way_has_fewer_operations() -> None:
    """From joint to joint of a general chain: two thirds of the operations of the general way."""
    part = Model(tree(PLACES["general"])).parts.nodes[2]
    assert part.screw
    short, general = part.screw.as_free(), part.hinge
    found = operations([rates_kernel(short, with_body=False), short.outward(), short.onward()])
    assert found < 0.67 * operations([general.inward(), general.outward(), general.onward()])
