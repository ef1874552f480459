"""Kernels that balance a system's rows: forces on points, attached masses, and the accelerations that follow.

All rows are those of the energies' own coordinates (own = C z) unless told otherwise.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from tmodes.equations.lagrange.kernels import LEVER, SystemKernels, entries, unpacked
from tmodes.equations.recursion.hinge import POSE
from tmodes.kinds.kernel.kernel import Kernel
from tmodes.kinds.kernel.spatial import FORCE, INERTIA, Inertia

__all__ = ["Solver", "attached_kernel", "push_rows_kernel", "world_axes_kernel"]


def push_rows_kernel(own: int) -> Kernel:
    """(lever, wrench on the point in world axes, sum of rows) -> sum with the generalized forces of the wrench."""

    def build(lever: Any, wrench: Any, sum_: Any) -> list[list[Any]]:
        rows = _lever(lever, own) @ ca.SX(wrench)
        return [[sum_[k] + rows[k] for k in range(own)]]

    return Kernel(f"lagrange push {own}", (LEVER * own, FORCE, own), (own,), build)


def attached_kernel(own: int) -> Kernel:
    """(lever, Jacobian's lever, drift less gravity, inertia, its bias) -> (matrix (own, own), rows).

    Of an inertia about a point, in world axes, that moves with it; ``drift``: the point's acceleration where the
    coordinates have none.
    """

    def build(lever: Any, jacobian: Any, drift: Any, inertia: Any, bias: Any) -> list[list[Any]]:
        info = Inertia.of(inertia)
        blocks = [[info.linear, _transposed(info.coupling)], [info.coupling, info.angular]]
        whole = ca.vertcat(*(ca.horzcat(*map(_matrix, row)) for row in blocks))
        force = ca.vertcat(*(bias[3 + k] for k in range(3)), *(bias[k] for k in range(3)))
        to_rows, motion = _lever(lever, own), _lever(jacobian, own)
        matrix = to_rows @ whole @ motion.T
        return [entries(matrix.T), entries(to_rows @ (whole @ ca.SX(drift) + force))]

    sizes = (LEVER * own, LEVER * own, FORCE, INERTIA, FORCE)
    return Kernel(f"lagrange attached {own}", sizes, (own * own, own), build)


def world_axes_kernel() -> Kernel:
    """(pose) -> the same place and velocity, in world axes."""

    def build(pose: Any) -> list[list[Any]]:
        axes = [1.0 if i == j else 0.0 for i in range(3) for j in range(3)]
        return [[*axes, *(pose[k] for k in range(9, POSE))]]

    return Kernel("lagrange world axes", (POSE,), (POSE,), build)


def _lever(values: Any, own: int) -> Any:
    return ca.reshape(ca.vertcat(*(values[k] for k in range(LEVER * own))), LEVER, own).T


def _matrix(rows: Any) -> Any:
    return ca.vertcat(*(ca.horzcat(*row) for row in rows))


def _transposed(rows: Any) -> Any:
    return [[rows[j][i] for j in range(3)] for i in range(3)]


@dataclass(frozen=True, eq=False)
class Solver:
    """Accelerations of the bodies: ``joints`` of their coordinates are joints, those in ``held`` are prescribed.

    ``attached``: a matrix of its own is added; it is symmetric unless the system carries forces by a map of its own.
    """

    kernels: SystemKernels
    joints: int
    held: tuple[int, ...]
    attached: bool

    def kernel(self) -> Kernel:
        """(mass, bias, spring forces, h D + h^2 K, pushes, efforts, own inertias[, attached, its rows]) -> z''.

        The effort of a held joint is its acceleration.
        """
        k = self.kernels

        def build(mass: Any, bias: Any, force: Any, added: Any, push: Any, *blocks: Any) -> list[list[Any]]:
            efforts, inertias = blocks[: self.joints], blocks[self.joints : 2 * self.joints]
            matrix, right = self._balance(mass, bias, force, added, push, blocks[2 * self.joints :])
            along = [block[0] for block in efforts] + [0.0] * (k.bodies - self.joints)
            more = [block[0] for block in inertias] + [0.0] * (k.bodies - self.joints)
            solve = self._solve_own if self._whole else self._solve_reduced
            return [entries(solve(matrix, right, along, more))]

        sizes = (k.triangle, k.own, k.own, k.triangle, k.own, *(1,) * (2 * self.joints))
        sizes += (k.own * k.own, k.own) if self.attached else ()
        return Kernel(f"lagrange solve {self._key}", sizes, (k.bodies,), build)

    def residual(self) -> Kernel:
        """(mass, bias, spring forces, h D + h^2 K, pushes, z''[, attached, its rows]) -> force needed along z."""
        k = self.kernels

        def build(mass: Any, bias: Any, force: Any, added: Any, push: Any, a: Any, *more: Any) -> list[list[Any]]:
            matrix, right = self._balance(mass, bias, force, added, push, more)
            columns = ca.sparsify(ca.DM(k.columns))
            return [entries(columns.T @ (matrix @ (columns @ ca.SX(a)) - right))]

        sizes = (k.triangle, k.own, k.own, k.triangle, k.own, k.bodies)
        sizes += (k.own * k.own, k.own) if self.attached else ()
        return Kernel(f"lagrange residual {self._key}", sizes, (k.bodies,), build)

    @property
    def _key(self) -> str:
        mapped = " mapped" * (self.kernels.system.contact_map is not None)
        return f"{self.kernels.columns.tolist()} {self.joints} {self.held}{' attached' * self.attached}{mapped}"

    @property
    def _whole(self) -> bool:
        """Whether the energies' own coordinates are all free, so that their rows are solved as they stand."""
        return not self.held and self.kernels.own == self.kernels.bodies

    def _balance(self, mass: Any, bias: Any, force: Any, added: Any, push: Any, more: Any) -> tuple[Any, Any]:
        k = self.kernels
        matrix = unpacked(mass, k.own) + unpacked(added, k.own)
        right = ca.vertcat(*(push[i] - bias[i] - force[i] for i in range(k.own)))
        if self.attached:
            square, rows = more
            matrix += ca.reshape(ca.vertcat(*(square[i] for i in range(k.own**2))), k.own, k.own).T
            right -= ca.vertcat(*(rows[i] for i in range(k.own)))
        return matrix, right

    def _solve_own(self, matrix: Any, right: Any, along: list[Any], more: list[Any]) -> Any:
        back = np.linalg.inv(self.kernels.columns)
        rows = ca.sparsify(ca.DM(back.T))
        matrix = matrix + rows @ ca.diag(ca.vertcat(*map(ca.SX, more))) @ rows.T
        right = right + rows @ ca.vertcat(*map(ca.SX, along))
        return rows.T @ self._solved(matrix, right)

    def _solve_reduced(self, matrix: Any, right: Any, along: list[Any], more: list[Any]) -> Any:
        columns = ca.sparsify(ca.DM(self.kernels.columns))
        matrix = columns.T @ matrix @ columns + ca.diag(ca.vertcat(*map(ca.SX, more)))
        right = columns.T @ right
        free = [i for i in range(self.kernels.bodies) if i not in self.held]
        found = ca.SX.zeros(self.kernels.bodies)
        for i in self.held:
            found[i] = along[i]
        rest = right + ca.vertcat(*(0.0 if i in self.held else along[i] for i in range(len(along)))) - matrix @ found
        if free:
            found[free] = self._solved(matrix[free, free], rest[free])
        return found

    def _solved(self, matrix: Any, right: Any) -> Any:
        mapped = self.attached and self.kernels.system.contact_map is not None
        return _solve_lu(matrix, right) if mapped else _solve_ldl(matrix, right)


def _solve_ldl(matrix: Any, right: Any) -> Any:
    """Solve a symmetric positive definite system by LDL^T, unrolled; zeros of the matrix cost nothing."""
    size = matrix.shape[0]
    lower = [[ca.SX(0)] * size for _ in range(size)]
    diagonal: list[Any] = []
    for j in range(size):
        diagonal.append(matrix[j, j] - sum(lower[j][k] ** 2 * diagonal[k] for k in range(j)))
        for i in range(j + 1, size):
            rest = sum(lower[i][k] * lower[j][k] * diagonal[k] for k in range(j))
            lower[i][j] = (matrix[i, j] - rest) / diagonal[j]
    rows: list[Any] = []
    for i in range(size):
        rows.append(right[i] - sum(lower[i][k] * rows[k] for k in range(i)))
    rows = [row / d for row, d in zip(rows, diagonal, strict=True)]
    for i in reversed(range(size)):
        rows[i] = rows[i] - sum(lower[k][i] * rows[k] for k in range(i + 1, size))
    return ca.vertcat(*rows)


def _solve_lu(matrix: Any, right: Any) -> Any:
    """Solve a system by elimination without exchange of rows, unrolled: a definite matrix and a mass on one point."""
    size = matrix.shape[0]
    a = [[matrix[i, j] for j in range(size)] for i in range(size)]
    b = [right[i] for i in range(size)]
    for k in range(size):
        for i in range(k + 1, size):
            factor = a[i][k] / a[k][k]
            a[i] = [a[i][j] - factor * a[k][j] if j > k else ca.SX(0) for j in range(size)]
            b[i] = b[i] - factor * b[k]
    for i in reversed(range(size)):
        b[i] = (b[i] - sum(a[i][j] * b[j] for j in range(i + 1, size))) / a[i][i]
    return ca.vertcat(*b)
