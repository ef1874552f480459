"""Kernels of links and rigid bodies: what hangs on a tip is carried to the root, and motion from the root to the tip.

The coordinates of a bending link are eliminated inside the recursion (a link-level Schur complement), so the cost stays
proportional to the number of links.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmodes.equations.recursion.hinge import PLACEMENT, POSE
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Kernel, kernel
from tmodes.kinds.kernel.spatial import (
    FORCE,
    INERTIA,
    Force,
    Inertia,
    body_bias,
    body_inertia,
    factor,
    forward_substitution,
)
from tmodes.kinds.links.contract import LinkStructure, Row
from tmodes.kinds.links.terms import LinkTerms, Section, frame_size

__all__ = [
    "BODY",
    "BendingLink",
    "body_inertia_kernel",
    "body_kernel",
    "body_moment_kernel",
    "point_kernel",
    "push_kernel",
    "sum_kernel",
    "times_kernel",
]

BODY = 10
"""Numbers of a rigid body: mass, first moment m c (3), inertia about the frame's origin (xx, yy, zz, xy, xz, yz)."""


def body_kernel(*, on_section: bool) -> Kernel:
    """(body, rotation of its frame, rate) -> its inertia and bias force about that frame's origin, in link axes."""

    def build(body: Any, rotation: Any, rate: Any) -> list[list[Any]]:
        moment, inertia = v.vec(body, 1), v.symmetric(body, 4)
        if on_section:
            turned = v.tri(rotation)
            moment, inertia = v.matvec(turned, moment), v.turn(turned, inertia, is_symmetric=True)
        bias = body_bias(moment, inertia, v.vec(rate))
        return [body_inertia(body[0], moment, inertia).packed(), bias.packed()]

    return Kernel(f"body{' on section' * on_section}", (BODY, 9, 3), (INERTIA, FORCE), build, plain=True)


@kernel("body inertia", (BODY,), (INERTIA,), plain=True)
def body_inertia_kernel(body: Any) -> list[list[Any]]:
    """Body -> its inertia about its frame's origin."""
    return [body_inertia(body[0], v.vec(body, 1), v.symmetric(body, 4)).packed()]


def push_kernel(*, on_section: bool) -> Kernel:
    """(pose of the link's axes, rotation of a frame, arm in it, wrench in the world, bias force) -> less the wrench."""

    def build(pose: Any, rotation: Any, arm: Any, wrench: Any, bias: Any) -> list[list[Any]]:
        back = v.transpose(v.tri(pose))
        lever = v.matvec(v.tri(rotation), v.vec(arm)) if on_section else v.vec(arm)
        push = Force(v.matvec(back, v.vec(wrench, 3)), v.matvec(back, v.vec(wrench))).force_at(lever)
        return [(Force.of(bias) - push).packed()]

    return Kernel(f"push{' on section' * on_section}", (POSE, 9, 3, 6, FORCE), (FORCE,), build)


def point_kernel(*, on_section: bool) -> Kernel:
    """Motion of a point in world axes: (pose of its frame, rotation of that in the link, rate, acceleration, offset).

    -> (pose, rate, [linear; angular] acceleration). Rate and acceleration of the frame are in the link's axes.
    """

    def build(pose: Any, rotation: Any, rate: Any, motion: Any, offset: Any) -> list[list[Any]]:
        world, w, arm, move = v.tri(pose), v.vec(rate), v.vec(offset, 9), Force.of(motion)
        if on_section:
            back = v.transpose(v.tri(rotation))
            w, move = v.matvec(back, w), move.turned(back)
        place = v.add(v.vec(pose, 9), v.matvec(world, arm))
        velocity = v.add(v.vec(pose, 12), v.matvec(world, v.cross(w, arm)))
        linear = v.add(move.motion_at(arm).linear, v.cross(w, v.cross(w, arm)))
        return [
            v.flat(v.matmul(world, v.tri(offset)), place, velocity), v.matvec(world, w),
            [*v.matvec(world, linear), *v.matvec(world, move.angular)],
        ]  # fmt: skip

    return Kernel(f"point{' on section' * on_section}", (POSE, 9, 3, FORCE, PLACEMENT), (POSE, 3, 6), build)


@kernel("times", (INERTIA, FORCE, FORCE), (FORCE,))
def times_kernel(inertia: Any, motion: Any, bias: Any) -> list[list[Any]]:
    """(inertia, acceleration, bias force) -> force."""
    return [(Inertia.of(inertia).times(Force.of(motion)) + Force.of(bias)).packed()]


@kernel("body moment", (BODY, POSE, 3), (3,))
def body_moment_kernel(body: Any, pose: Any, sum_: Any) -> list[list[Any]]:
    """(body, pose of its frame, sum) -> sum of mass times position, in the world."""
    return [v.add(v.vec(sum_), v.scale(body[0], v.vec(pose, 9)), v.matvec(v.tri(pose), v.vec(body, 1)))]


@kernel("sum", (INERTIA, FORCE, INERTIA, FORCE), (INERTIA, FORCE))
def sum_kernel(inertia: Any, bias: Any, more: Any, push: Any) -> list[list[Any]]:
    """(inertia, bias force, inertia, bias force) -> the two together."""
    return [[inertia[i] + more[i] for i in range(INERTIA)], [bias[i] + push[i] for i in range(FORCE)]]


@dataclass(frozen=True)
class BendingLink:
    """The kernels of bending links of one structure."""

    kind: LinkStructure

    @property
    def n(self) -> int:
        """Number of coordinates."""
        return self.kind.size

    @property
    def frame(self) -> int:
        """Numbers of a section."""
        return frame_size(self.n)

    @property
    def solved_size(self) -> int:
        """What elimination keeps: rows of L, 1/d, L^-1 M_qb, L^-1 of the free force."""
        return self.n * (self.n - 1) // 2 + self.n + 6 * self.n + self.n

    def inward(self) -> Kernel:
        """(tables, rate of the root, q, qd) -> (terms, section at the tip, sections at the stations)."""

        def build(tables: Any, rate: Any, q: Any, qd: Any) -> list[list[Any]]:
            terms, sections = self.kind.sections(tables, rate, q, qd)
            return [terms, *sections]

        outputs = (self.kind.terms_size, *(self.frame,) * (1 + len(self.kind.stations)))
        inputs = (self.kind.table_size, 3, self.n, self.n)
        return Kernel(f"inward {self.kind.fingerprint}", inputs, outputs, build, self.kind.long)

    @kernel("station load {0.kind.fingerprint}", ("kind.terms_size", "frame", BODY, FORCE), ("kind.terms_size",))
    def station_load(self, terms: Any, section: Any, body: Any, force: Any) -> list[list[Any]]:
        """A body and a bias force on a section at a station: (terms, section, body, force in link axes) -> terms."""
        link, place = LinkTerms.of(terms, self.n), Section.of(section, self.n)
        moment = v.matvec(place.rotation, v.vec(body, 1))
        inertia = v.turn(place.rotation, v.symmetric(body, 4), is_symmetric=True)
        load = Force.of(force) + body_bias(moment, inertia, place.rate)
        return [link.with_body(place, body_inertia(body[0], moment, inertia), load).packed()]

    @kernel(
        "outward {0.kind.fingerprint}",
        ("kind.terms_size", "frame", INERTIA, FORCE, "kind.stiffness_size", "kind.damping_size", "n", "n", 1),
        (INERTIA, FORCE, "solved_size"),
        long="kind.long",
    )
    def outward(self, *packed: Any) -> list[list[Any]]:
        """Eliminate the link's coordinates; ``step`` h adds h D + h^2 K to its inertia, as an implicit step wants it.

        (terms, section at the tip, I and p of the tip in the link's axes, stiffness, damping, q, qd, h)
        -> (I and p at the root, solved). Springs and dampers start from q and qd.
        """
        terms, tip, inertia, bias, stiffness, damping, q, qd, step = packed
        section, h = Section.of(tip, self.n), step[0]
        link = LinkTerms.of(terms, self.n) if self.kind.own_terms else LinkTerms.nothing(self.n)
        mass, coupling, base, bias_q, bias_b = link.with_load(section, Inertia.of(inertia), Force.of(bias))
        spring, damper, _, _ = self.kind.elastic(stiffness, damping, q, qd)
        free = [-s - d - p for s, d, p in zip(spring, damper, bias_q, strict=True)]
        _add_tangents(mass, h, *self.kind.tangents(stiffness, damping, q, qd))
        lower, share = factor(mass)
        columns = forward_substitution(lower, [[*c.packed(), f] for c, f in zip(coupling, free, strict=True)])
        parts = [Force.of(column) for column in columns]
        root = base.less(parts, [p.scaled(s) for p, s in zip(parts, share, strict=True)])
        for part, column, s in zip(parts, columns, share, strict=True):
            bias_b = bias_b + part.scaled(s * column[6])
        kept = v.flat(
            [row[:i] for i, row in enumerate(lower)], share, [c[:6] for c in columns], [c[6] for c in columns]
        )
        return [root.packed(), bias_b.packed(), kept]

    @kernel("onward {0.kind.fingerprint}", (FORCE, "solved_size", "frame"), ("n", FORCE))
    def onward(self, root: Any, solved: Any, tip: Any) -> list[list[Any]]:
        """(acceleration of the root, solved, section at the tip) -> (accelerations of the coordinates, of the tip)."""
        n, section, motion = self.n, Section.of(tip, self.n), Force.of(root)
        start = n * (n - 1) // 2
        lower = [[solved[i * (i - 1) // 2 + j] for j in range(i)] for i in range(n)]
        columns = [Force.of(solved, start + n + 6 * j) for j in range(n)]
        result = [solved[start + j] * (solved[start + 7 * n + j] - columns[j].dot(motion)) for j in range(n)]
        for i in reversed(range(n)):
            for k in range(i + 1, n):
                result[i] = result[i] - lower[k][i] * result[k]
        return [result, _tip_motion(section, motion, result).packed()]

    @kernel("motion {0.n}", (FORCE, "frame", "n"), (FORCE,))
    def motion(self, root: Any, section: Any, qdd: Any) -> list[list[Any]]:
        """(acceleration of the root, section, accelerations of the coordinates) -> that of the section."""
        info = Section.of(section, self.n)
        return [_tip_motion(info, Force.of(root), [qdd[j] for j in range(self.n)]).packed()]

    @kernel("load {0.kind.fingerprint}", ("kind.terms_size", "frame", FORCE, "n", FORCE), (FORCE, "n"))
    def load(self, terms: Any, tip: Any, root: Any, qdd: Any, force: Any) -> list[list[Any]]:
        """(terms, section at the tip, acceleration of the root, qdd, force on the tip) -> (force on the root, on q).

        Forces of inertia only, without springs and dampers.
        """
        n, section, motion = self.n, Section.of(tip, self.n), Force.of(root)
        link = LinkTerms.of(terms, n) if self.kind.own_terms else LinkTerms.nothing(n)
        push = Force.of(force)
        along = []
        for i in range(n):
            own = [link.mass[max(i, j)][min(i, j)] * qdd[j] for j in range(n)]
            parts = [*own, link.coupling[i].dot(motion), link.bias_q[i], section.columns[i].dot(push)]
            along.append(v.total(parts))
        root_force = link.base.times(motion) + link.bias + push.force_at(section.position)
        for j in range(n):
            root_force = root_force + link.coupling[j].scaled(qdd[j])
        return [root_force.packed(), along]

    @kernel("pose section {0.n}", (POSE, 3, "frame", "n"), (POSE, POSE))
    def pose(self, pose: Any, rate: Any, section: Any, qd: Any) -> list[list[Any]]:
        """(pose and rate of the root, section, qd) -> (pose of the section, the same in the link's axes)."""
        info, world = Section.of(section, self.n), v.tri(pose)
        moved = v.cross(v.vec(rate), info.position)
        for j in range(self.n):
            moved = v.add(moved, v.scale(qd[j], info.columns[j].linear))
        place = v.add(v.vec(pose, 9), v.matvec(world, info.position))
        velocity = v.add(v.vec(pose, 12), v.matvec(world, moved))
        turned = v.matmul(world, info.rotation)
        return [v.flat(turned, place, velocity), v.flat(world, place, velocity)]

    @kernel("elastic {0.kind.fingerprint}", ("kind.stiffness_size", "kind.damping_size", "n", "n"), ("n", 1, 1))
    def elastic(self, stiffness: Any, damping: Any, q: Any, qd: Any) -> list[list[Any]]:
        """(stiffness, damping, q, qd) -> (spring and damper forces on the coordinates, energy [J], power lost [W])."""
        spring, damper, energy, loss = self.kind.elastic(stiffness, damping, q, qd)
        return [[s + d for s, d in zip(spring, damper, strict=True)], [energy], [loss]]

    @kernel("moment {0.kind.fingerprint}", ("kind.terms_size", POSE, 3), (3,))
    def moment(self, terms: Any, pose: Any, sum_: Any) -> list[list[Any]]:
        """(terms, pose of the root, sum) -> sum of mass times position [kg*m], in the world."""
        link = LinkTerms.of(terms, self.n)
        return [v.add(v.vec(sum_), v.scale(link.total, v.vec(pose, 9)), v.matvec(v.tri(pose), link.moment))]


def _tip_motion(section: Section, root: Force, qdd: list[Any]) -> Force:
    motion = root.motion_at(section.position) + section.bias
    for column, acceleration in zip(section.columns, qdd, strict=True):
        motion = motion + column.scaled(acceleration)
    return motion


def _add_tangents(mass: list[list[Any]], step: Any, stiffness: list[Row], damping: list[Row]) -> None:
    """Add h D + h^2 K to the lower triangle of M_qq."""
    for i, (k_row, d_row) in enumerate(zip(stiffness, damping, strict=True)):
        d_of = dict(d_row)
        for j, k in k_row:
            if j <= i:
                mass[i][j] = mass[i][j] + step * (d_of.get(j, 0.0) + step * k)
