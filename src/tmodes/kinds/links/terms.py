"""What the recursion needs of a bending link: inertia terms about its root, and frames of its sections."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.spatial import Force, Inertia, body_inertia

__all__ = ["FRAME", "LinkTerms", "Section", "frame_size"]

FRAME = 15
"""Numbers of a frame along a link: rotation (9), position (3) and angular velocity (3), all in link axes."""


def frame_size(coordinates: int) -> int:
    """Numbers of a section: its frame, the columns of its motion (6 each), and its bias acceleration (6)."""
    return FRAME + 6 * coordinates + 6


@dataclass
class Section:
    """A cross-section: where it is, and how it moves with the link's coordinates, in link axes.

    Acceleration of the section = that of the root carried along + sum of ``columns[j]`` qdd_j + ``bias``.
    """

    rotation: v.Matrix
    position: v.Vector
    rate: v.Vector
    columns: list[Force]
    bias: Force

    @classmethod
    def of(cls, packed: Any, size: int) -> Section:
        """From ``frame_size(size)`` numbers."""
        columns = [Force.of(packed, FRAME + 6 * j) for j in range(size)]
        bias = Force.of(packed, FRAME + 6 * size)
        return cls(v.tri(packed), v.vec(packed, 9), v.vec(packed, 12), columns, bias)

    def packed(self) -> list[Any]:
        """All numbers in order."""
        columns = [column.packed() for column in self.columns]
        return v.flat(self.rotation, self.position, self.rate, columns, self.bias.packed())


@dataclass
class LinkTerms:
    """[M_qq M_qb; M_bq M_bb] and the bias forces of a link without what hangs on it.

    ``mass``: rows of the lower triangle of M_qq; ``coupling[j]``: M_bq column of coordinate j; ``angular``, ``moment``
    (first mass moment) and ``total`` (mass) make M_bb.
    """

    mass: list[list[Any]]
    coupling: list[Force]
    angular: v.Matrix
    moment: v.Vector
    total: Any
    bias_q: list[Any]
    bias: Force

    @classmethod
    def of(cls, packed: Any, size: int) -> LinkTerms:
        """From ``terms_size`` numbers."""
        mass = [[packed[i * (i + 1) // 2 + j] for j in range(i + 1)] for i in range(size)]
        start = size * (size + 1) // 2
        coupling = [Force.of(packed, start + 6 * j) for j in range(size)]
        start += 6 * size
        angular, moment, total = v.symmetric(packed, start), v.vec(packed, start + 6), packed[start + 9]
        start += 10
        bias_q = [packed[start + j] for j in range(size)]
        return cls(mass, coupling, angular, moment, total, bias_q, Force.of(packed, start + size))

    @classmethod
    def nothing(cls, size: int) -> LinkTerms:
        """A link without mass of its own."""
        mass = [[0.0] * (i + 1) for i in range(size)]
        none = [v.zero() for _ in range(3)]
        return cls(mass, [Force.zero() for _ in range(size)], none, v.zero(), 0.0, [0.0] * size, Force.zero())

    def packed(self) -> list[Any]:
        """All numbers in order."""
        coupling = [column.packed() for column in self.coupling]
        base = (v.six(self.angular), self.moment, self.total)
        return v.flat(self.mass, coupling, *base, self.bias_q, self.bias.packed())

    @property
    def base(self) -> Inertia:
        """M_bb."""
        return body_inertia(self.total, self.moment, self.angular)

    def with_body(self, section: Section, inertia: Inertia, force: Force) -> LinkTerms:
        """The terms with a rigid body on a section: its inertia and bias force about it, in link axes."""
        mass, coupling, base, bias_q, bias = self.with_load(section, inertia, force)
        moment = [base.coupling[2][1], base.coupling[0][2], base.coupling[1][0]]
        return LinkTerms(mass, coupling, base.angular, moment, base.linear[0][0], bias_q, bias)

    def with_load(
        self, section: Section, inertia: Inertia, force: Force
    ) -> tuple[list[list[Any]], list[Force], Inertia, list[Any], Force]:
        """M_qq, M_bq, M_bb, p_q, p_b with what hangs on a section: its inertia and bias force, in link axes."""
        carried = [inertia.times(column) for column in section.columns]
        mass = [
            [self.mass[i][j] + section.columns[i].dot(carried[j]) for j in range(i + 1)] for i in range(len(carried))
        ]
        load = inertia.times(section.bias) + force
        bias_q = [p + column.dot(load) for p, column in zip(self.bias_q, section.columns, strict=True)]
        coupling = [own + more.force_at(section.position) for own, more in zip(self.coupling, carried, strict=True)]
        base = self.base + inertia.at(section.position)
        return mass, coupling, base, bias_q, self.bias + load.force_at(section.position)
