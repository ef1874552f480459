"""Kernels of a revolute joint between rigid links whose frames stand on their axes: turns about one axis at a time.

Rows and columns that are zero are exact zeros and fold away: behind a joint without inertia of its own nothing of the
articulated inertia is left along its axis. Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 7; the screws
are those of McMillan and Orin (1995), see :mod:`tmodes.equations.recursion.framing`.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from tmodes.equations.recursion.framing import STRAIGHT, ScrewWay
from tmodes.equations.recursion.hinge import POSE
from tmodes.equations.recursion.link_kernels import BODY
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import cos, sin
from tmodes.kinds.kernel.schedule import Kernel, kernel
from tmodes.kinds.kernel.spatial import FORCE, INERTIA, Force, Inertia, body_bias, body_inertia

__all__ = ["HINGE", "SCREW", "TURN", "Screw", "Spin", "rates_kernel", "screw_numbers", "turn_kernel"]


@dataclass(frozen=True)
class Spin:
    """Rotation about ``axis`` (0, 1 or 2) by an angle of which cosine, sine, sin^2 and sin cos are given.

    A vector given in the turned axes is ``vector`` in those before; ``back`` goes the other way.
    """

    axis: int
    cosine: Any
    sine: Any
    square: Any
    product: Any

    @classmethod
    def of(cls, axis: int, cosine: Any, sine: Any) -> Spin:
        """From cosine and sine alone."""
        return cls(axis, cosine, sine, sine * sine, sine * cosine)

    @property
    def _plane(self) -> tuple[int, int]:
        return (self.axis + 1) % 3, (self.axis + 2) % 3

    def vector(self, a: v.Vector) -> v.Vector:
        """R a."""
        (i, j), turned = self._plane, list(a)
        turned[i], turned[j] = self.cosine * a[i] - self.sine * a[j], self.sine * a[i] + self.cosine * a[j]
        return turned

    def back(self, a: v.Vector) -> v.Vector:
        """R^T a."""
        (i, j), turned = self._plane, list(a)
        turned[i], turned[j] = self.cosine * a[i] + self.sine * a[j], self.cosine * a[j] - self.sine * a[i]
        return turned

    def back_onto(self, a: v.Vector, sum_: v.Vector) -> v.Vector:
        """R^T a + sum: the sum is taken in at the beginning, and nothing waits for it."""
        (i, j), turned = self._plane, v.add(a, sum_)
        turned[i] = self.sine * a[j] + (self.cosine * a[i] + sum_[i])
        turned[j] = self.cosine * a[j] - (self.sine * a[i] - sum_[j])
        return turned

    def force(self, a: Force) -> Force:
        """Both vectors turned."""
        return Force(self.vector(a.angular), self.vector(a.linear))

    def force_back(self, a: Force) -> Force:
        """Both vectors turned back."""
        return Force(self.back(a.angular), self.back(a.linear))

    def matrix(self, a: v.Matrix, *, is_symmetric: bool = False) -> v.Matrix:
        """R A R^T with the double angle: what leaves one entry of the diagonal enters the other."""
        (i, j), k = self._plane, self.axis
        turned = [list(row) for row in a]
        across, both = a[i][i] - a[j][j], a[i][j] + a[j][i]
        passed = self.square * across + self.product * both
        mixed = self.product * across - self.square * both
        turned[i][i], turned[j][j] = a[i][i] - passed, a[j][j] + passed
        turned[i][j], turned[j][i] = a[i][j] + mixed, a[j][i] + mixed
        turned[i][k] = self.cosine * a[i][k] - self.sine * a[j][k]
        turned[j][k] = self.sine * a[i][k] + self.cosine * a[j][k]
        if is_symmetric:
            turned[k][i], turned[k][j] = turned[i][k], turned[j][k]
        else:
            turned[k][i] = self.cosine * a[k][i] - self.sine * a[k][j]
            turned[k][j] = self.sine * a[k][i] + self.cosine * a[k][j]
        return turned

    def inertia(self, a: Inertia) -> Inertia:
        """All blocks turned."""
        return Inertia(
            self.matrix(a.angular, is_symmetric=True), self.matrix(a.coupling), self.matrix(a.linear, is_symmetric=True)
        )


TURN = 2
"""Cosine and sine of a joint's angle and phase."""

SCREW = 12
"""Numbers of a way: cos, sin, sin^2, sin cos of alpha and of beta, lever (3), along."""

HINGE = TURN + 5
"""Turn, and the bias acceleration of the root in the joint's own axes: angular about x and y, linear."""


@dataclass(frozen=True)
class Screw:
    """The kernels of one kind of way: which of its parts there are.

    ``driven``: the motion is given; ``free``: for certain the joint has no inertia of its own (rotor, implicit spring).
    """

    tilted: bool
    turned: bool
    lever: tuple[bool, bool, bool]
    along: bool
    driven: bool = False
    free: bool = False

    @classmethod
    def of(cls, way: ScrewWay, *, driven: bool) -> Screw:
        """The kind of a way."""
        x, y, z = (bool(part) for part in way.lever)
        return cls(way.alpha != STRAIGHT, way.beta != STRAIGHT, (x, y, z), bool(way.along), driven)

    def as_free(self) -> Screw:
        """The same without inertia of its own."""
        return replace(self, free=not self.driven)

    @property
    def key(self) -> str:
        """The structure in words."""
        lever = "".join(name for name, there in zip("xyz", self.lever, strict=True) if there)
        flags = {"tilted": self.tilted, "turned": self.turned, "along": self.along, "driven": self.driven}
        info = " ".join(name for name, there in (flags | {"free": self.free}).items() if there)
        return f"screw {info} {lever}"

    @property
    def held(self) -> int:
        """What the way out keeps: U/(S.U + own inertia) (free: 1 about z, left out), and the free acceleration."""
        return FORCE if self.free else FORCE + 1

    def way(self, numbers: Any) -> list[tuple[Spin | None, v.Vector | None]]:
        """Steps from the parent to the joint's own axes: a turn, then a shift in the turned axes."""
        lever = [numbers[8 + i] if there else 0.0 for i, there in enumerate(self.lever)]
        beta = Spin(2, *(numbers[4 + i] for i in range(4))) if self.turned else None
        alpha = Spin(0, *(numbers[i] for i in range(4))) if self.tilted else None
        shift = [0.0, 0.0, numbers[11]] if self.along else None
        return [(beta, lever if any(self.lever) else None), (alpha, shift)]

    def _motion_to_joint(self, way: list[Any], motion: Force, drift: Force) -> Force:
        """The acceleration of the parent's tip at the joint, in its own axes, and the drift.

        The turn about x and the shift along x change places, so that no turn waits for a shift: with the root's
        acceleration this is the longest chain of the way out.
        """
        (beta, lever), (alpha, along) = way
        motion = beta.force_back(motion) if beta else motion
        x, *across = lever or v.zero()
        motion = motion.motion_at([0.0, *across]) if any(self.lever[1:]) else motion
        z = along[2] if along else 0.0
        early = [drift.linear[0], drift.linear[1] - motion.angular[0] * z, drift.linear[2]]
        angular = alpha.back(motion.angular) if alpha else motion.angular
        linear = alpha.back_onto(motion.linear, early) if alpha else v.add(motion.linear, early)
        late = [angular[1] * z, angular[2] * x, -angular[1] * x]
        return Force(v.add(angular, drift.angular), v.add(linear, late))

    def _force_to_parent(self, way: list[Any], force: Force) -> Force:
        for spin, shift in reversed(way):
            force = force.force_at(shift) if shift else force
            force = spin.force(force) if spin else force
        return force

    def _inertia_to_parent(self, way: list[Any], inertia: Inertia) -> Inertia:
        for spin, shift in reversed(way):
            inertia = inertia.at(shift) if shift else inertia
            inertia = spin.inertia(inertia) if spin else inertia
        return inertia

    def _passed(self, inertia: Any, bias: Any, hinge: Any, effort: Any, own: Any) -> tuple[Inertia, Force, list[Any]]:
        """Articulated inertia and bias force that the joint passes on, in its own axes, and what is held.

        The turn about the axis leaves the axis as it is: it comes first, while the divisor's inverse is on its way.
        """
        turn, drift = _turn(hinge), _drift(hinge)
        whole, push = turn.inertia(Inertia.of(inertia)), turn.force(Force.of(bias))
        if self.driven:
            drift.angular[2] = effort[0]
            return whole, push + whole.times(drift), [0.0] * self.held
        column = Force([row[2] for row in whole.angular], list(whole.coupling[2]))
        free_effort, inverse = effort[0] - push.angular[2], 1 / (column.angular[2] + (0.0 if self.free else own[0]))
        share = column.scaled(inverse)
        if self.free:
            share.angular[2] = 1.0
        passed = whole.less([column], [share])
        if self.free:
            _clear(passed)
        push = push + passed.times(drift) + share.scaled(free_effort)
        if self.free:
            push.angular[2] = effort[0]
        kept = share.packed()
        return passed, push, [*(kept[:2] + kept[3:] if self.free else kept), inverse * free_effort]

    def outward(self, *, onto_body: bool = False) -> Kernel:
        """Articulated inertia and bias force of the link's root, added to those of the parent's tip.

        (I, p, hinge, way, effort, own inertia, sum of I, sum of p) -> (I, p, held). The effort of a driven joint is
        its acceleration. ``onto_body``: in place of the sum of I the parent's body, which is all that it is.
        """

        def build(inertia: Any, bias: Any, hinge: Any, numbers: Any, effort: Any, own: Any, *sums: Any) -> Any:
            passed, push, kept = self._passed(inertia, bias, hinge, effort, own)
            way, (there, pull) = self.way(numbers), _sums(*sums, onto_body=onto_body)
            moved = self._inertia_to_parent(way, passed) + there
            return [moved.packed(), (self._force_to_parent(way, push) + pull).packed(), kept]

        sums = (BODY if onto_body else INERTIA, FORCE)
        inputs = (INERTIA, FORCE, HINGE, SCREW, 1, 1, *sums)
        return Kernel(
            f"outward{' onto body' * onto_body} {self.key}", inputs, (INERTIA, FORCE, self.held), build, plain=True
        )

    @kernel("hold {0.key}", (INERTIA, FORCE, HINGE, SCREW, 1, 1), ("held",), plain=True)
    def hold(self, inertia: Any, bias: Any, hinge: Any, _: Any, effort: Any, own: Any) -> list[list[Any]]:
        """(I, p, hinge, way, effort, own inertia) -> held: where nobody asks for what is passed to the base."""
        return [self._passed(inertia, bias, hinge, effort, own)[2]]

    @kernel("onward {0.key}", (FORCE, HINGE, SCREW, "held", 1), (FORCE, 1), plain=True)
    def onward(self, parent: Any, hinge: Any, numbers: Any, held: Any, given: Any) -> list[list[Any]]:
        """(acceleration of the parent's tip, hinge, way, held, a given one) -> (that of the root, the joint's)."""
        root = self._motion_to_joint(self.way(numbers), Force.of(parent), _drift(hinge))
        before, acceleration = root.angular[2], given[0]
        if self.driven:
            root.angular[2] = before + acceleration
        else:
            after = self._after(root, held)
            acceleration = after - before if self.free else after
            root.angular[2] = after if self.free else before + after
        return [_turn(hinge).force_back(root).packed(), [acceleration]]

    def _after(self, root: Force, held: Any) -> Any:
        """What is held of the free acceleration and of that of the root: two sums side by side, the turning first."""
        *turning, x, y, z = (held[k] for k in range(self.held - 1))
        first = held[self.held - 1]
        for share, part in zip(turning, root.angular, strict=False):
            first = first - share * part
        return (first - z * root.linear[2]) - (x * root.linear[0] + y * root.linear[1])

    @kernel("load {0.key}", (FORCE, HINGE, SCREW, FORCE), (FORCE, 1), plain=True)
    def load(self, force: Any, hinge: Any, numbers: Any, sum_: Any) -> list[list[Any]]:
        """(force at the link's root, hinge, way, sum at the parent's tip) -> (sum, effort along the joint)."""
        push = _turn(hinge).force(Force.of(force))
        info = self._force_to_parent(self.way(numbers), push) + Force.of(sum_)
        return [info.packed(), [force[2]]]

    @kernel("pose {0.key}", (POSE, 3, HINGE, SCREW, 1), (POSE,), plain=True)
    def pose(self, pose: Any, rate: Any, hinge: Any, numbers: Any, _: Any) -> list[list[Any]]:
        """(pose and rate of the parent's tip, in the parent's axes, hinge, way, speed) -> pose of the link's root."""
        rows, arm = v.tri(pose), v.zero()
        for spin, shift in reversed(self.way(numbers)):
            arm = v.add(arm, shift) if shift else arm
            arm = spin.vector(arm) if spin else arm
        place = v.add(v.vec(pose, 9), v.matvec(rows, arm))
        velocity = v.add(v.vec(pose, 12), v.matvec(rows, v.cross(v.vec(rate), arm)))
        for spin in (*(step[0] for step in self.way(numbers)), _turn(hinge)):
            rows = [spin.back(row) for row in rows] if spin else rows
        return [v.flat(rows, place, velocity)]


def turn_kernel(count: int) -> Kernel:
    """(angles, cosine and sine of each phase) -> cosine and sine of each angle and its phase, one after the other."""

    def build(angles: Any, phases: Any) -> list[list[Any]]:
        info: list[Any] = []
        for i in range(count):
            c, s, phase_c, phase_s = cos(angles[i]), sin(angles[i]), phases[2 * i], phases[2 * i + 1]
            info += [phase_c * c - phase_s * s, phase_s * c + phase_c * s]
        return [info]

    return Kernel(f"turn {count}", (count, TURN * count), (TURN * count,), build)


def screw_numbers(way: ScrewWay) -> list[float]:
    """The numbers of a way, packed."""
    info: list[float] = []
    for c, s in (way.alpha, way.beta):
        info += [c, s, s * s, s * c]
    return [*info, *way.lever, way.along]


def _turn(hinge: Any) -> Spin:
    return Spin.of(2, hinge[0], hinge[1])


def _drift(hinge: Any) -> Force:
    return Force([hinge[2], hinge[3], 0.0], v.vec(hinge, 4))


def _clear(inertia: Inertia) -> None:
    """Nothing is left along the axis: exactly, and so it is stated."""
    inertia.coupling[2] = v.zero()
    for i in range(3):
        inertia.angular[i][2] = inertia.angular[2][i] = 0.0


def _sums(inertia: Any, push: Any, *, onto_body: bool) -> tuple[Inertia, Force]:
    if onto_body:
        return body_inertia(inertia[0], v.vec(inertia, 1), v.symmetric(inertia, 4)), Force.of(push)
    return Inertia.of(inertia), Force.of(push)


def rates_kernel(screw: Screw, *, with_body: bool) -> Kernel:
    """(way, rate of the parent, turn, speed) -> (hinge, rate of the root).

    ``with_body``: and the link's body -> and its bias force.
    """

    def build(numbers: Any, parent_rate: Any, turn: Any, speed: Any, *body: Any) -> list[list[Any]]:
        w, linear, before = v.vec(parent_rate), v.zero(), v.zero()
        for spin, shift in screw.way(numbers):
            before = w
            if spin:
                w, linear = spin.back(w), spin.back(linear)
            if shift:
                linear = v.add(linear, v.cross(w, v.cross(w, shift)))
        drift = [w[1] * speed[0], -w[0] * speed[0], *linear]
        rate = _tilted(numbers, before, turn, speed[0]) if screw.tilted else _straight(w, turn, speed[0])
        forces = [body_bias(v.vec(each, 1), v.symmetric(each, 4), rate).packed() for each in body]
        return [[turn[0], turn[1], *drift], rate, *forces]

    key = f"inward{' with body' * with_body} {screw.key}"
    if with_body:
        return Kernel(key, (SCREW, 3, TURN, 1, BODY), (HINGE, 3, FORCE), build, plain=True)
    return Kernel(key, (SCREW, 3, TURN, 1), (HINGE, 3), build, plain=True)


def _straight(w: v.Vector, turn: Any, speed: Any) -> v.Vector:
    """The rate in the link's axes, from that in the joint's."""
    x, y, z = Spin.of(2, turn[0], turn[1]).back(w)
    return [x, y, z + speed]


def _tilted(numbers: Any, w: v.Vector, turn: Any, speed: Any) -> v.Vector:
    """The same from the rate before alpha, by both turns at once: what the next joint waits for is shorter."""
    (c, s), (tilt_c, tilt_s) = (turn[0], turn[1]), (numbers[0], numbers[1])
    return [
        (s * tilt_c) * w[1] + (c * w[0] + (s * tilt_s) * w[2]),
        (c * tilt_c) * w[1] - (s * w[0] - (c * tilt_s) * w[2]),
        (tilt_c * w[2] + speed) - tilt_s * w[1],
    ]
