# pyright: reportArgumentType=false, reportCallIssue=false
"""Random chains for property tests: trees of every kind of joint and link, and states that stay in the model's range.

A chain is drawn from one integer, so that a failing example is given by one number; how large it is, and whether it
bends, are arguments.
"""

from __future__ import annotations

import numpy as np
from numpy.random import Generator, default_rng
from numpy.typing import NDArray

from tmodes.chain.chain import Chain, Friction, Gear, Joint, Motor, Node, Point
from tmodes.frame import Placement
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.links.segment import Segment
from tmodes.kinds.links.strain import Beam, BeamPiece

__all__ = ["random_body", "random_chain", "random_placement", "random_state"]

Array = NDArray[np.float64]


def random_placement(rng: Generator, reach: float = 0.3) -> Placement:
    """Any direction, at most about ``reach`` [m] away."""
    matrix, triangle = np.linalg.qr(rng.normal(size=(3, 3)))
    matrix = matrix * np.sign(np.diag(triangle))
    matrix[:, 0] *= np.linalg.det(matrix)
    return Placement(matrix, rng.uniform(-reach, reach, 3))


def random_body(rng: Generator) -> Body:
    """A body of four points and a little, so that its inertia is a real body's."""
    places, masses = rng.uniform(-0.1, 0.1, (4, 3)), rng.uniform(0.05, 0.5, 4)
    center = masses @ places / masses.sum()
    arms = places - center
    inertia = np.einsum("m,mi,mj->ij", masses, arms, arms)
    return Body(float(masses.sum()), center, np.trace(inertia) * np.eye(3) - inertia + 1e-4 * np.eye(3))


def _axis(rng: Generator) -> Array:
    axis = rng.normal(size=3)
    return axis / np.linalg.norm(axis)


def _joint(rng: Generator, name: str, rigid: bool) -> Joint:
    kind = rng.choice([joint_kind("revolute"), joint_kind("revolute"), joint_kind("prismatic"), joint_kind("fixed")])
    placement, axis = random_placement(rng), _axis(rng)
    if kind == joint_kind("fixed"):
        return Joint(name, joint_kind("fixed"), placement)
    drive = (
        drive_kind("effort")
        if rigid
        else rng.choice([drive_kind("effort"), drive_kind("elastic"), drive_kind("spring")])
    )
    motor = None
    if drive is drive_kind("elastic") or (drive is drive_kind("effort") and rng.random() < 0.5):
        motor = Motor(float(rng.uniform(0.02, 0.3)), Friction(viscous=0.0 if rigid else float(rng.uniform(0, 0.5))))
    gear = (
        None
        if drive is drive_kind("effort")
        else Gear((float(rng.uniform(20, 300)),), damping=float(rng.uniform(0, 1)))
    )
    return Joint(name, joint_kind(str(kind)), placement, axis, drive=drive, motor=motor, gear=gear)


def _piece(rng: Generator, end: float, axial: bool, sheared: bool) -> BeamPiece:
    def pair(low: float, high: float) -> tuple[float, float]:
        value = float(rng.uniform(low, high))
        return value, value * float(rng.uniform(0.7, 1.0))

    polar, across = pair(5e-4, 2e-3), pair(2e-4, 1e-3)
    stretch = pair(1e3, 1e4) if axial else (0.0, 0.0)
    bending, twisting, mass = (pair(5, 50), pair(5, 50)), pair(5, 30), pair(0.2, 1.0)
    shears = (pair(5e2, 5e3), pair(5e2, 5e3)) if sheared else ((0.0, 0.0), (0.0, 0.0))
    return BeamPiece(end, *bending, twisting, stretch, mass, (polar, across, across), *shears)


def _beam(rng: Generator) -> Beam:
    counts = rng.integers(0, 4, 2)
    bend_y, bend_z = (int(n) for n in (counts if counts.any() else (1, 2)))
    stretch = int(rng.random() < 0.2)
    shears = [int(n) for n in rng.integers(0, 3, 2)] if rng.random() < 0.3 else [0, 0]
    ends = (0.45, 1.0) if rng.random() < 0.3 else (1.0,)
    return Beam(
        float(rng.uniform(0.3, 0.9)),
        tuple(_piece(rng, end, stretch > 0, max(shears) > 0) for end in ends),
        twist=int(rng.integers(0, 3)),
        bend_y=bend_y,
        bend_z=bend_z,
        stretch=stretch,
        shear_y=shears[0],
        shear_z=shears[1],
        basis="tip_weighted" if rng.random() < 0.2 else "legendre",
        points=max(bend_y, bend_z) + 2,
        damping_time=float(rng.uniform(0, 1e-3)),
        rest_curvature=rng.uniform(-0.3, 0.3, 3) if rng.random() < 0.3 else np.zeros(3),
        bodies=((1.0, random_body(rng)),) if rng.random() < 0.5 else (),
    )


def _link(rng: Generator, rigid: bool) -> RigidLink | Beam | Segment:
    kind = 0 if rigid else int(rng.integers(0, 4))
    if kind >= 2:
        return _beam(rng)
    if kind == 1:
        stiffness = rng.uniform(200, 2000, 2)
        return Segment(
            float(rng.uniform(0.2, 0.6)), float(stiffness[0]), float(stiffness[1]), 0.1, 0.2, bodies=(random_body(rng),)
        )
    return RigidLink((random_body(rng),))


def random_chain(seed: int, nodes: int = 4, *, rigid: bool = False) -> Chain:
    """A tree of ``nodes`` joints and links; ``rigid``: no spring and no flexible link anywhere."""
    rng = default_rng(seed)
    parents = [-1, *(int(max(0, i - 1 - rng.geometric(0.75) + 1)) for i in range(1, nodes))]
    made = tuple(Node(f"link{i}", parents[i], _joint(rng, f"joint{i}", rigid), _link(rng, rigid)) for i in range(nodes))
    if not any(_coordinates(node) for node in made):
        return random_chain(seed + 1_000_003, nodes, rigid=rigid)
    points = (Point("tool", nodes - 1, offset=random_placement(rng, 0.1)), Point("elbow", nodes // 2))
    return Chain(f"random{seed}", made, rng.uniform(-7, 7, 3), random_placement(rng), points)


def _coordinates(node: Node) -> bool:
    return node.joint.kind is not joint_kind("fixed")


def random_state(seed: int, coordinates: tuple[str, ...], bend: float = 0.3) -> tuple[Array, Array, Array]:
    """q, v and a: motors and joints anywhere, link coordinates (with a dot) within ``bend`` [rad]."""
    rng, size = default_rng(seed), len(coordinates)
    flexible = np.array(["." in name and not name.endswith(".motor") for name in coordinates])
    q = np.where(flexible, bend * rng.uniform(-1, 1, size), rng.uniform(-2, 2, size))
    stretched = np.array([".stretch" in name or ".shear" in name for name in coordinates])
    return np.where(stretched, 0.05 * q, q), rng.normal(size=size), rng.normal(size=size)
