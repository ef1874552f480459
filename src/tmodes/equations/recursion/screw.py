"""Kernels of a revolute joint between rigid links whose frames stand on their axes: turns about one axis at a time.

Rows and columns that are zero are exact zeros and fold away: behind a joint without inertia of its own nothing of the
articulated inertia is left along its axis. Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 7; the screws
are those of McMillan and Orin (1995), see :mod:`tmodes.equations.recursion.framing`.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from tmodes.equations.recursion.body_kernels import BODY
from tmodes.equations.recursion.framing import STRAIGHT, ScrewWay
from tmodes.equations.recursion.hinge import POSE
from tmodes.equations.recursion.spin import Spin
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import cos, sin
from tmodes.kinds.kernel.schedule import Kernel, kernel
from tmodes.kinds.kernel.spatial import FORCE, INERTIA, Force, Inertia, body_inertia

__all__ = ["HINGE", "SCREW", "TURN", "Screw", "screw_numbers", "turn_kernel"]

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
