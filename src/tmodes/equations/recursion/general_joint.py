"""Kernels of a joint of any kind, with any number of coordinates; the counterpart of the kernels along one axis.

``columns`` (6 for each coordinate) are those of the motion subspace, in link axes; the way in finds them, the others
take them in place of an axis. The coordinates that are not given are eliminated together: their small matrix is
factored as L diag(d) L^T. See :mod:`tmodes.equations.recursion.hinge` for ``hinge`` and the frames.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from tmodes.equations.recursion.hinge import HINGE, PLACEMENT, JointKernels, Passed, combined
from tmodes.kinds.joints.contract import JointKind
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import kernel
from tmodes.kinds.kernel.spatial import FORCE, Force, Inertia, factor, forward_substitution

__all__ = ["GeneralJoint", "held_numbers"]


@dataclass(frozen=True)
class GeneralJoint(JointKernels):
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
        own = combined(columns, speeds)
        drift = self.kind.bias(angles, speeds, values) + Force(
            v.cross(carried, own.angular),
            v.add(v.matvec(turned, v.cross(w, v.cross(w, arm))), v.scale(2, v.cross(carried, own.linear))),
        )
        packed = [entry for column in columns for entry in column.packed()]
        return [v.flat(turned, arm, drift.packed()), v.add(carried, own.angular), packed]

    def _screws(self, axis: Any) -> list[Force]:
        return [Force.of(axis, FORCE * k) for k in range(self.size)]

    def _passed(self, inertia: Any, bias: Any, hinge: Any, axis: Any, effort: Any, own: Any) -> Passed:
        whole, free, columns = Inertia.of(inertia), self.free, self._screws(axis)
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
        root = carried + Force.of(hinge, 12) + combined(self._screws(columns), found)
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


def held_numbers(free: int) -> int:
    """Numbers that the way out keeps of so many free coordinates; at least one."""
    return max(1, FORCE * free + free * (free - 1) // 2 + free)
