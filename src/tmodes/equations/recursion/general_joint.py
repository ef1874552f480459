"""Kernels of a joint of any kind, with any number of coordinates; the counterpart of the kernels along one axis.

``columns`` (6 for each coordinate) are those of the motion subspace, in link axes; the way in finds them, the others
take them in place of an axis. The coordinates that are not given are eliminated together: their small matrix is
factored as L diag(d) L^T. See :mod:`tmodes.equations.recursion.hinge` for ``hinge`` and the frames.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from tmodes.equations.recursion.hinge import HINGE, PLACEMENT, POSE
from tmodes.kinds.joints.contract import JointKind
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.kernel import kernel
from tmodes.kinds.kernel.spatial import FORCE, INERTIA, Force, Inertia, factor, forward_substitution

__all__ = ["GeneralJoint", "held_numbers"]

_PASSED = (INERTIA, FORCE, HINGE, "span", "size", "size")
"""Inputs of what the joint passes on: I, p, hinge, columns, efforts, own inertias."""


@dataclass(frozen=True)
class GeneralJoint:
    """The kernels of one kind of joint.

    ``numbers``: of its axis and parameters; ``driven``: whether the motion of each coordinate is given; ``aside`` and
    ``on_section`` as in :class:`tmodes.equations.recursion.hinge.Hinge`.
    """

    kind: JointKind
    numbers: int
    driven: tuple[bool, ...]
    aside: bool = True
    on_section: bool = False

    @property
    def moves(self) -> bool:
        """Whether the joint has a coordinate."""
        return self.kind.moves

    @property
    def size(self) -> int:
        """Number of coordinates."""
        return self.kind.size

    @property
    def span(self) -> int:
        """Numbers of all columns."""
        return FORCE * self.size

    @property
    def free(self) -> list[int]:
        """The coordinates that are not given."""
        return [k for k, is_given in enumerate(self.driven) if not is_given]

    @property
    def held(self) -> int:
        """What the way out keeps: U D^-1 (6 each), the entries of L below its diagonal, and the free accelerations."""
        return held_numbers(len(self.free))

    @property
    def key(self) -> str:
        """The structure in words."""
        given = "".join("g" if each else "f" for each in self.driven)
        return f"{self.kind.key} {self.numbers} {given}{' aside' * self.aside}{' on section' * self.on_section}"

    def as_driven(self) -> GeneralJoint:
        """The same joint with its motion given."""
        return replace(self, driven=(True,) * self.size)

    @kernel("inward {0.key}", (PLACEMENT, 9, "numbers", 3, "size", "size"), (HINGE, 3, "span"))
    def inward(self, placement: Any, tip: Any, numbers: Any, parent_rate: Any, q: Any, rates: Any) -> list[list[Any]]:
        """(placement, rotation of the parent's tip, numbers, its rate, q, q') -> (hinge, rate of the root, columns)."""
        frame, place, w = v.tri(placement), v.vec(placement, 9), v.vec(parent_rate)
        if self.on_section:
            frame, place = v.matmul(v.tri(tip), frame), v.matvec(v.tri(tip), place)
        values = [numbers[i] for i in range(self.numbers)]
        angles, speeds = ([block[k] for k in range(self.size)] for block in (q, rates))
        rotation, position = self.kind.place(angles, values)
        columns = self.kind.subspace(angles, values)
        turned = v.transpose(v.matmul(frame, rotation))
        arm, carried = v.add(place, v.matvec(frame, position)), v.matvec(turned, w)
        own = _combined(columns, speeds)
        drift = self.kind.bias(angles, speeds, values) + Force(
            v.cross(carried, own.angular),
            v.add(v.matvec(turned, v.cross(w, v.cross(w, arm))), v.scale(2, v.cross(carried, own.linear))),
        )
        packed = [entry for column in columns for entry in column.packed()]
        return [v.flat(turned, arm, drift.packed()), v.add(carried, own.angular), packed]

    @kernel("outward {0.key}", (*_PASSED, INERTIA, FORCE), (INERTIA, FORCE, "held"))
    def outward(
        self, inertia: Any, bias: Any, hinge: Any, columns: Any, effort: Any, own: Any, inertia_sum: Any, bias_sum: Any
    ) -> list[list[Any]]:
        """Articulated inertia and bias force of the link's root, added to those of the parent's tip.

        (I, p, hinge, columns, efforts, own inertias, sum of I, sum of p) -> (I, p, held). The effort of a given
        coordinate is its acceleration.
        """
        passed, push, kept = self._passed(inertia, bias, hinge, self._columns(columns), effort, own)
        back, arm = v.transpose(v.tri(hinge)), v.vec(hinge, 9)
        moved = passed.turned(back).at(arm) + Inertia.of(inertia_sum)
        pushed = push.turned(back).force_at(arm) + Force.of(bias_sum)
        return [moved.packed(), pushed.packed(), kept]

    @kernel("hold {0.key}", _PASSED, ("held",))
    def hold(self, inertia: Any, bias: Any, hinge: Any, columns: Any, effort: Any, own: Any) -> list[list[Any]]:
        """(I, p, hinge, columns, efforts, own inertias) -> held: where nobody asks for what is passed to the base."""
        return [self._passed(inertia, bias, hinge, self._columns(columns), effort, own)[2]]

    def _columns(self, packed: Any) -> list[Force]:
        return [Force.of(packed, FORCE * k) for k in range(self.size)]

    def _passed(
        self, inertia: Any, bias: Any, hinge: Any, columns: list[Force], effort: Any, own: Any
    ) -> tuple[Inertia, Force, list[Any]]:
        """Articulated inertia and bias force that the joint passes on, in link axes, and what is held."""
        whole, free = Inertia.of(inertia), self.free
        given = [(columns[k], effort[k]) for k, is_given in enumerate(self.driven) if is_given]
        drift = Force.of(hinge, 12)
        for column, acceleration in given:
            drift = drift + column.scaled(acceleration)
        push = Force.of(bias) + whole.times(drift)
        if not free:
            return whole, push, [0.0] * self.held
        forces = [whole.times(columns[k]) for k in free]
        matrix = [[columns[k].dot(forces[j]) for j in range(i + 1)] for i, k in enumerate(free)]
        for i, k in enumerate(free):
            matrix[i][i] = matrix[i][i] + own[k]
        lower, share = factor(matrix)
        rows = [Force.of(row) for row in forward_substitution(lower, [force.packed() for force in forces])]
        efforts = forward_substitution(lower, [[effort[k] - columns[k].dot(push)] for k in free])
        divided = [row.scaled(part) for row, part in zip(rows, share, strict=True)]
        for row, (value,) in zip(divided, efforts, strict=True):
            push = push + row.scaled(value)
        kept = [entry for row in divided for entry in row.packed()] + [entry for row in lower for entry in row]
        kept += [part * value for part, (value,) in zip(share, efforts, strict=True)]
        return whole.less(rows, divided), push, kept

    @kernel("onward {0.key}", (FORCE, HINGE, "span", "held", "size"), (FORCE, "size"))
    def onward(self, parent: Any, hinge: Any, columns: Any, held: Any, given: Any) -> list[list[Any]]:
        """(acceleration of the parent's tip, hinge, columns, held, given ones) -> (that of the root, the joint's)."""
        carried = Force.of(parent).motion_at(v.vec(hinge, 9)).turned(v.tri(hinge))
        found = [given[k] for k in range(self.size)]
        for k, value in zip(self.free, self._solved(held, carried), strict=True):
            found[k] = value
        root = carried + Force.of(hinge, 12) + _combined(self._columns(columns), found)
        return [root.packed(), found]

    def _solved(self, held: Any, carried: Force) -> list[Any]:
        """Accelerations of the free coordinates: L^T a = D^-1 L^-1 (effort - U^T carried), from the last one back."""
        n = len(self.free)
        below, last = FORCE * n, FORCE * n + n * (n - 1) // 2
        found: list[Any] = [held[last + i] - Force.of(held, FORCE * i).dot(carried) for i in range(n)]
        for i in reversed(range(n)):
            for j in range(i + 1, n):
                found[i] = found[i] - held[below + j * (j - 1) // 2 + i] * found[j]
        return found

    @kernel("load {0.key}", (FORCE, HINGE, "span", FORCE), (FORCE, "size"))
    def load(self, force: Any, hinge: Any, columns: Any, sum_: Any) -> list[list[Any]]:
        """(force at the link's root, hinge, columns, sum at the parent's tip) -> (sum, efforts along the joint)."""
        push, turned = Force.of(force), v.tri(hinge)
        info = push.turned(v.transpose(turned)).force_at(v.vec(hinge, 9)) + Force.of(sum_)
        return [info.packed(), [column.dot(push) for column in self._columns(columns)]]

    @kernel("pose {0.key}", (POSE, 3, HINGE, "span", "size"), (POSE,))
    def pose(self, pose: Any, rate: Any, hinge: Any, columns: Any, rates: Any) -> list[list[Any]]:
        """(pose and rate of the parent's tip, in the parent's axes, hinge, columns, q') -> pose of the link's root."""
        world, back, arm = v.tri(pose), v.transpose(v.tri(hinge)), v.vec(hinge, 9)
        own = _combined(self._columns(columns), [rates[k] for k in range(self.size)])
        moved = v.add(v.cross(v.vec(rate), arm), v.matvec(back, own.linear))
        place = v.add(v.vec(pose, 9), v.matvec(world, arm))
        velocity = v.add(v.vec(pose, 12), v.matvec(world, moved))
        return [v.flat(v.matmul(world, back), place, velocity)]


def held_numbers(free: int) -> int:
    """Numbers that the way out keeps of so many free coordinates; at least one."""
    return max(1, FORCE * free + free * (free - 1) // 2 + free)


def _combined(columns: list[Force], factors: list[Any]) -> Force:
    total = Force.zero()
    for column, each in zip(columns, factors, strict=True):
        total = total + column.scaled(each)
    return total
