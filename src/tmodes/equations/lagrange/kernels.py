"""Kernels of a system's equations: inertia, weight, springs, points, and the solution for the accelerations.

``z`` are the bodies' coordinates in a robot's order (joints, then links), ``own`` those of the energies: own = C z with
a constant C. Symmetric matrices (n, n) are packed row by row from the diagonal on.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from tmodes.equations.lagrange.system import ORIGIN, System
from tmodes.equations.recursion.hinge import POSE
from tmodes.kinds.kernel.schedule import Kernel

__all__ = ["LEVER", "SystemKernels", "entries", "packed", "unpacked"]

Array = NDArray[np.float64]

LEVER = 6
"""Columns of a lever: generalized forces of a unit force along x, y, z, and of a unit moment about x, y, z."""


def packed(matrix: Any) -> list[Any]:
    """The upper half of a symmetric matrix, row by row."""
    size = matrix.shape[0]
    return [matrix[i, j] for i in range(size) for j in range(i, size)]


def unpacked(values: Any, size: int) -> Any:
    """The symmetric matrix of :func:`packed` values."""
    matrix, k = ca.SX(size, size), 0
    for i in range(size):
        for j in range(i, size):
            matrix[i, j] = matrix[j, i] = values[k]
            k += 1
    return matrix


def entries(expression: Any) -> list[Any]:
    """Entries of a column."""
    column = ca.vec(expression)
    return [column[k] for k in range(column.numel())]


@dataclass(frozen=True, eq=False)
class SystemKernels:
    """The kernels of a system on a robot whose coordinates are ``columns`` (n, bodies) times the energies' own."""

    system: System
    columns: Array

    @property
    def own(self) -> int:
        """Coordinates of the energies."""
        return len(self.columns)

    @property
    def bodies(self) -> int:
        """Coordinates of the robot's joints and links."""
        return self.columns.shape[1]

    @property
    def triangle(self) -> int:
        """Numbers of a packed matrix."""
        return self.own * (self.own + 1) // 2

    @property
    def parameters(self) -> int:
        """Numbers of parameters."""
        return len(self.system.parameter_names)

    @cached_property
    def key(self) -> str:
        """The structure in words."""
        return f"{self.system.key} {self.columns.tolist()}"

    def terms(self) -> Kernel:
        """(z, z', parameters, base's acceleration less gravity, gravity's unit) -> (mass matrix, bias forces).

        ``bias``: Coriolis, centrifugal and other forces, and the weight, as much of it as the base's row holds.
        """

        def of(e: Any, base: Any, unit: Any) -> list[list[Any]]:
            share = -ca.dot(base, unit)
            bias = e.terms.inertial + share * e.terms.gravity - e.forces
            return [packed(e.terms.mass_matrix), entries(bias)]

        return self._of_state("terms", of, (3, 3), (self.triangle, self.own))

    def soft(self) -> Kernel:
        """(z, z', parameters, step h) -> (forces of springs and dampers, h D + h^2 K); at the start of a step."""

        def of(e: Any, h: Any) -> list[list[Any]]:
            added = h * e.terms.swing + h * h * e.terms.stiffness
            return [entries(e.terms.elastic + e.terms.damping), packed(added)]

        return self._of_state("soft", of, (1,), (self.own, self.triangle))

    def elastic(self) -> Kernel:
        """(z, z', parameters) -> (forces of springs and dampers along z, elastic energy, power lost)."""

        def of(e: Any) -> list[list[Any]]:
            forces = self._columns.T @ (e.terms.elastic + e.terms.damping)
            return [entries(forces), [e.energies.elastic], [2 * e.energies.dissipation]]

        return self._of_state("elastic", of, (), (self.bodies, 1, 1))

    def weight(self) -> Kernel:
        """(z, z', parameters, gravity's unit) -> sum of mass times position, along gravity."""
        return self._of_state("weight", lambda e, unit: [entries(-e.energies.gravity * unit)], (3,), (3,))

    def pose(self, name: str | None) -> Kernel:
        """(z, z', parameters) -> (pose and velocity of a point, its rate in world axes)."""

        def of(e: Any) -> list[list[Any]]:
            position, rotation = self._point(e, name)
            velocity, turn = ca.jtimes(position, e.q, e.v), ca.SX.zeros(3)
            if rotation is not None:
                turn = _turning(rotation, e.q) @ e.v
            axes = ca.SX.eye(3) if rotation is None else rotation
            return [[*entries(axes.T), *entries(position), *entries(velocity)], entries(turn)]

        return self._of_state(f"pose {name}", of, (), (POSE, 3))

    def segment(self, start: str, end: str) -> Kernel:
        """(z, z', parameters) -> (axes of the world (9), positions of two points): a line between them."""

        def of(e: Any) -> list[list[Any]]:
            ends = [self._point(e, None if name == ORIGIN else name)[0] for name in (start, end)]
            return [[*entries(ca.SX.eye(3)), *entries(ca.vertcat(*ends))]]

        return self._of_state(f"segment {start} {end}", of, (), (15,))

    def acceleration(self, name: str | None) -> Kernel:
        """(z, z', parameters, base's acceleration less gravity, z'') -> [linear; angular] of a point, less gravity."""

        def of(e: Any, base: Any, a: Any) -> list[list[Any]]:
            position, rotation = self._point(e, name)
            own = self._columns @ a
            velocity, turn = ca.jtimes(position, e.q, e.v), ca.SX.zeros(3)
            linear = ca.jtimes(velocity, e.q, e.v) + ca.jtimes(position, e.q, own) + base
            if rotation is not None:
                lever = _turning(rotation, e.q)
                turn = lever @ own + ca.jtimes(lever @ e.v, e.q, e.v)
            return [[*entries(linear), *entries(turn)]]

        return self._of_state(f"acceleration {name}", of, (3, self.bodies), (6,))

    def drift(self, name: str | None) -> Kernel:
        """The same of a point whose coordinates have no acceleration: (z, z', parameters, base's) -> (6)."""
        moving = self.acceleration(name)

        def build(z: Any, rates: Any, p: Any, base: Any) -> Any:
            return moving.build(z, rates, p, base, ca.SX.zeros(self.bodies))

        return Kernel(f"still {moving.key}", moving.inputs[:-1], moving.outputs, build)

    def lever(self, name: str | None, *, mapped: bool) -> Kernel:
        """(z, z', parameters) -> generalized forces (own, 6), row by row, of unit forces and moments on a point.

        ``mapped``: by the system's own map, where it has one.

        Eq. (44) [corrected]: the tip's Jacobian; the print exchanges lm and le and lacks the derivatives of x and y by
        vt and e. {test_slip_44_jacobian}
        Slip (44): lm and le exchanged, derivatives of x, y by vt and e missing {test_slip_44_jacobian}
        Slip (34)-(38): a force at the tip reaches each row by its own column of Je, where the print writes the planes'
        rows {test_every_row_needs_its_column_of_the_jacobian}
        """

        def of(e: Any) -> list[list[Any]]:
            position, rotation = self._point(e, name)
            jacobian = ca.jacobian(position, e.q).T
            if mapped and e.map is not None and name == next(iter(e.points)):
                jacobian = e.map
            turning = ca.SX.zeros(self.own, 3) if rotation is None else _turning(rotation, e.q).T
            return [entries(ca.horzcat(jacobian, turning).T)]

        return self._of_state(f"lever {name}{' mapped' * mapped}", of, (), (LEVER * self.own,))

    @cached_property
    def _columns(self) -> Any:
        return ca.sparsify(ca.DM(self.columns))

    def _point(self, e: Any, name: str | None) -> tuple[Any, Any]:
        return (ca.SX.zeros(3), None) if name is None else e.points[name]

    def _of_state(
        self, label: str, of: Callable[..., list[list[Any]]], more: tuple[int, ...], outputs: tuple[int, ...]
    ) -> Kernel:
        """A kernel of (z, z', parameters, more...), from the system's expressions at its own coordinates."""

        def build(z: Any, rates: Any, p: Any, *blocks: Any) -> list[list[Any]]:
            e = self.system.expressions
            symbols = [ca.SX.sym(f"m{k}", size) for k, size in enumerate(more)]
            results = [ca.vertcat(*map(ca.SX, part)) for part in of(e, *symbols)]
            function = ca.Function("of_state", [e.q, e.v, e.p, *symbols], results, {"cse": True})
            found = function.call([self._columns @ z, self._columns @ rates, p, *blocks])
            return [entries(part) for part in found]

        sizes = (self.bodies, self.bodies, self.parameters, *more)
        return Kernel(f"lagrange {label} {self.key}", sizes, outputs, build)


def _turning(rotation: Any, q: Any) -> Any:
    """Angular velocity per rate (3, n), in world axes: the vector of dR/dq R^T."""
    columns = []
    for k in range(q.numel()):
        slope = ca.reshape(ca.jacobian(ca.vec(rotation), q[k]), 3, 3) @ rotation.T
        columns.append(ca.vertcat(slope[2, 1], slope[0, 2], slope[1, 0]))
    return ca.horzcat(*columns)
