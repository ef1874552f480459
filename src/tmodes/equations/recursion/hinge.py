"""Kernels of a joint: into it (rates), out of it (articulated inertia, forces), and on (accelerations).

The joint frame stands in its parent's tip frame; ``hinge`` is what one pass gives the next: E (9) from the parent's
axes to the link's, the joint's place from the parent's tip (3), and the bias acceleration of the link's root (6). The
axes of a bending parent are those of its root, so that inertias are turned once on their way and not twice.
Featherstone, Rigid Body Dynamics Algorithms (2008), chapter 7, with classical accelerations.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass, replace
from typing import Any

from tmodes.kinds.joints.contract import JointKind
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import cos, sin
from tmodes.kinds.kernel.schedule import kernel
from tmodes.kinds.kernel.spatial import FORCE, INERTIA, Force, Inertia

__all__ = ["HELD", "HINGE", "PLACEMENT", "POSE", "Hinge", "JointKernels", "combined"]

PLACEMENT = 12
"""Numbers of a placement: rotation (9) row by row, position (3)."""

HINGE = 18
"""Numbers of ``hinge``."""

HELD = 8
"""What the way out keeps for the way on: U = I S (6), 1/(S.U + own inertia), and the free effort."""

POSE = 15
"""Numbers of a pose in the world: rotation (9), position (3), velocity of the origin (3)."""


Passed = tuple[Inertia, Force, list[Any]]
"""Articulated inertia and bias force that a joint passes on, in link axes, and what is held."""


class JointKernels(ABC):
    """What the kernels of all joints have in common.

    ``axis`` are the numbers of a joint's axis, or the columns of its motion; a given coordinate's effort is its
    acceleration.
    """

    kind: JointKind

    @property
    def moves(self) -> bool:
        """Whether the joint has a coordinate."""
        return self.kind.moves

    @property
    def size(self) -> int:
        """Number of coordinates; 1 of a joint that does not move."""
        return max(1, self.kind.size)

    @property
    @abstractmethod
    def span(self) -> int:
        """Numbers of ``axis``."""

    @property
    @abstractmethod
    def held(self) -> int:
        """Numbers that the way out keeps for the way on."""

    def _arm(self, packed: Any, start: int) -> v.Vector:
        """From the parent's tip to the joint."""
        return v.vec(packed, start)

    @abstractmethod
    def _screws(self, axis: Any) -> list[Force]:
        """S: the motions that the joint allows, as [angular; linear] in link axes."""

    @abstractmethod
    def _passed(self, inertia: Any, bias: Any, hinge: Any, axis: Any, effort: Any, own: Any) -> Passed: ...

    @kernel(
        "outward {0.key}", (INERTIA, FORCE, HINGE, "span", "size", "size", INERTIA, FORCE), (INERTIA, FORCE, "held")
    )
    def outward(
        self, inertia: Any, bias: Any, hinge: Any, axis: Any, effort: Any, own: Any, inertia_sum: Any, bias_sum: Any
    ) -> list[list[Any]]:
        """Articulated inertia and bias force of the link's root, added to those of the parent's tip.

        (I, p, hinge, axis, efforts, own inertias, sum of I, sum of p) -> (I, p, held).
        """
        passed, push, kept = self._passed(inertia, bias, hinge, axis, effort, own)
        back, arm = v.transpose(v.tri(hinge)), self._arm(hinge, 9)
        moved = passed.turned(back).at(arm) + Inertia.of(inertia_sum)
        return [moved.packed(), (push.turned(back).force_at(arm) + Force.of(bias_sum)).packed(), kept]

    @kernel("hold {0.key}", (INERTIA, FORCE, HINGE, "span", "size", "size"), ("held",))
    def hold(self, *blocks: Any) -> list[list[Any]]:
        """(I, p, hinge, axis, efforts, own inertias) -> held: where nobody asks for what is passed to the base."""
        return [self._passed(*blocks)[2]]

    @kernel("load {0.key}", (FORCE, HINGE, "span", FORCE), (FORCE, "size"))
    def load(self, force: Any, hinge: Any, axis: Any, sum_: Any) -> list[list[Any]]:
        """(force at the link's root, hinge, axis, sum at the parent's tip) -> (sum, efforts along the joint)."""
        push, turned = Force.of(force), v.tri(hinge)
        info = push.turned(v.transpose(turned)).force_at(self._arm(hinge, 9)) + Force.of(sum_)
        return [info.packed(), [screw.dot(push) for screw in self._screws(axis)] or [0.0]]

    @kernel("pose {0.key}", (POSE, 3, HINGE, "span", "size"), (POSE,))
    def pose(self, pose: Any, rate: Any, hinge: Any, axis: Any, rates: Any) -> list[list[Any]]:
        """(pose and rate of the parent's tip, in the parent's axes, hinge, axis, q') -> pose of the link's root."""
        world, back, arm = v.tri(pose), v.transpose(v.tri(hinge)), self._arm(hinge, 9)
        slip = combined(self._screws(axis), rates).linear
        moved = v.add(v.cross(v.vec(rate), arm), v.matvec(back, slip))
        place = v.add(v.vec(pose, 9), v.matvec(world, arm))
        velocity = v.add(v.vec(pose, 12), v.matvec(world, moved))
        return [v.flat(v.matmul(world, back), place, velocity)]


def combined(columns: list[Force], factors: Any) -> Force:
    """Sum of columns, each times a factor."""
    total = Force.zero()
    for k, column in enumerate(columns):
        total = total + column.scaled(factors[k])
    return total


@dataclass(frozen=True)
class Hinge(JointKernels):
    """The kernels of a joint that turns about its axis, slides along it, or does not move.

    ``axis`` is 0, 1 or 2 where the joint moves along or about an axis of its frame, else None: the axis is data.
    ``aside``: the joint stands aside of its parent's tip; ``on_section``: the parent bends, its tip frame is turned.
    """

    kind: JointKind
    axis: int | None = 2
    driven: bool = False
    aside: bool = True
    on_section: bool = False

    @property
    def span(self) -> int:
        """A direction."""
        return 3

    @property
    def held(self) -> int:
        """As :data:`HELD` says."""
        return HELD

    @property
    def key(self) -> str:
        """The structure in words."""
        axis = "data" if self.axis is None else "xyz"[self.axis]
        flags = f"{' driven' * self.driven}{' aside' * self.aside}{' on section' * self.on_section}"
        return f"{self.kind.key} {axis}{flags}" if self.moves else f"fixed{flags}"

    def as_driven(self) -> Hinge:
        """The same joint with its motion given."""
        return replace(self, driven=self.moves)

    def _direction(self, axis: Any) -> v.Vector:
        return v.vec(axis) if self.axis is None else v.unit(self.axis)

    def _arm(self, packed: Any, start: int) -> v.Vector:
        """Nothing where the joint stands on the tip."""
        return v.vec(packed, start) if self.aside or self.kind.slides else v.zero()

    def _screws(self, axis: Any) -> list[Force]:
        e = self._direction(axis)
        return [Force(e, v.zero()) if self.kind.turns else Force(v.zero(), e)] if self.moves else []

    @kernel("inward {0.key}", (PLACEMENT, 9, 3, 3, 1, 1), (HINGE, 3))
    def inward(self, placement: Any, tip: Any, axis: Any, parent_rate: Any, angle: Any, speed: Any) -> list[list[Any]]:
        """(placement, rotation of the parent's tip, axis, its rate, angle, speed) -> (hinge, rate of the root)."""
        frame, place, w = v.tri(placement), self._arm(placement, 9), v.vec(parent_rate)
        if self.on_section:
            frame, place = v.matmul(v.tri(tip), frame), v.matvec(v.tri(tip), place)
        e, extra, arm = self._direction(axis), v.zero(), place
        to_parent = frame
        if self.kind.turns:
            to_parent = v.matmul(frame, _about(self.axis, e, angle[0]))
        elif self.kind.slides:
            along = v.matvec(frame, e)
            arm = v.add(place, v.scale(angle[0], along))
            extra = v.scale(2 * speed[0], v.cross(w, along))
        turned = v.transpose(to_parent)
        carried = v.matvec(turned, w)
        linear = v.matvec(turned, v.add(v.cross(w, v.cross(w, arm)), extra))
        rate, angular = carried, v.zero()
        if self.kind.turns:
            own = v.scale(speed[0], e)
            rate, angular = v.add(carried, own), v.cross(carried, own)
        return [v.flat(turned, arm, angular, linear), rate]

    def _passed(self, inertia: Any, bias: Any, hinge: Any, axis: Any, effort: Any, own: Any) -> Passed:
        whole = Inertia.of(inertia)
        push = Force.of(bias) + whole.times(Force.of(hinge, 12))
        if not self.moves:
            return whole, push, [0.0] * HELD
        (s,) = self._screws(axis)
        if self.driven:
            return whole, push + whole.times(s.scaled(effort[0])), [0.0] * HELD
        u = whole.times(s)
        share = 1 / (s.dot(u) + own[0])
        free = effort[0] - s.dot(push)
        return whole.less([u], [u.scaled(share)]), push + u.scaled(share * free), [*u.packed(), share, free]

    @kernel("onward {0.key}", (FORCE, HINGE, 3, HELD, 1), (FORCE, 1))
    def onward(self, parent: Any, hinge: Any, axis: Any, held: Any, given: Any) -> list[list[Any]]:
        """(acceleration of the parent's tip, hinge, axis, held, a given one) -> (that of the root, the joint's)."""
        turned, drift = v.tri(hinge), Force.of(hinge, 12)
        carried = Force.of(parent).motion_at(self._arm(hinge, 9)).turned(turned)
        acceleration = given[0]
        if self.moves and not self.driven:
            acceleration = held[6] * (held[7] - Force.of(held).dot(carried))
        root = carried + drift
        for screw in self._screws(axis):
            root = root + screw.scaled(acceleration)
        return [root.packed(), [acceleration]]


def _about(axis: int | None, e: v.Vector, angle: Any) -> v.Matrix:
    """Rotation by an angle about an axis of the frame, or about any unit vector (Rodrigues)."""
    c, s = cos(angle), sin(angle)
    return v.rodrigues(e, c, s) if axis is None else v.about(axis, c, s)
