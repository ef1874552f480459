"""Kernels that balance a system's rows: forces on points, contact, and the accelerations that follow.

All rows are those of the energies' own coordinates (own = C z) unless stated otherwise.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from tmodes.equations.lagrange.kernels import LEVER, SystemKernels, entries, unpacked
from tmodes.kinds.kernel.schedule import Kernel, kernel
from tmodes.kinds.kernel.spatial import FORCE

__all__ = ["Solver", "push_rows_kernel"]


def push_rows_kernel(own: int) -> Kernel:
    """(lever, wrench on the point in world axes, sum of rows) -> sum with the generalized forces of the wrench."""

    def build(lever: Any, wrench: Any, sum_: Any) -> list[list[Any]]:
        rows = _lever(lever, own) @ ca.SX(wrench)
        return [[sum_[k] + rows[k] for k in range(own)]]

    return Kernel(f"lagrange push {own}", (LEVER * own, FORCE, own), (own,), build)


def _lever(values: Any, own: int) -> Any:
    return ca.reshape(ca.vertcat(*(values[k] for k in range(LEVER * own))), LEVER, own).T


@dataclass(frozen=True, eq=False)
class Solver:
    """Accelerations of the bodies: ``joints`` of their coordinates are joints, those in ``held`` are prescribed.

    ``touched``: a point is in contact; its normal force is found together with the accelerations.

    Eq. (40) [derived]: H phi'' + h + f_elastic + f_damping + J^T F = Q. {test_samples}
    """

    kernels: SystemKernels
    joints: int
    held: tuple[int, ...]
    touched: bool

    def solution(self) -> Kernel:
        """(mass, bias, spring forces, h D + h^2 K, pushes, efforts, own inertias[, contact]) -> z''[, contact, pushes].

        The effort of a held joint is its acceleration. Contact: lever of its force, lever of its motion, drift, and the
        blocks of :meth:`tmodes.equations.loop.contact_kernels.Touch.affine`, rates of the bodies; of it come normal
        force, fold and power, and the pushes with its own among them.
        """
        k = self.kernels

        def build(mass: Any, bias: Any, force: Any, added: Any, push: Any, *blocks: Any) -> list[list[Any]]:
            efforts, inertias = blocks[: self.joints], blocks[self.joints : 2 * self.joints]
            along = [block[0] for block in efforts] + [0.0] * (k.bodies - self.joints)
            more = [block[0] for block in inertias] + [0.0] * (k.bodies - self.joints)
            matrix, right = self._balance(mass, bias, force, added, push)
            contact = _ContactRows(k, *blocks[2 * self.joints :]) if self.touched else None
            right -= contact.friction if contact else 0.0
            solve = self._solve_own if self._whole else self._solve_reduced
            freely = solve(matrix, right, along, more)
            if contact is None:
                return [entries(freely)]
            pull = contact.pull(self._columns @ freely)
            rows = contact.rows(pull)
            pushed = solve(matrix, rows, [0.0] * k.bodies, more)
            fold = 1 + contact.mass * ca.dot(contact.row, self._columns @ pushed)
            normal = pull / fold
            whole = rows * normal + contact.friction
            power = ca.dot(whole, self._columns @ contact.rates)
            pushes = [push[i] - whole[i] for i in range(k.own)]
            return [entries(freely - pushed * normal), [normal, fold, power], pushes]

        sizes = (k.triangle, k.own, k.own, k.triangle, k.own, *(1,) * (2 * self.joints))
        sizes += (LEVER * k.own, LEVER * k.own, FORCE, 3, 3, 3, 6, k.bodies) if self.touched else ()
        outputs = (k.bodies, 3, k.own) if self.touched else (k.bodies,)
        return Kernel(f"lagrange solve {self._key}", sizes, outputs, build)

    @kernel(
        "lagrange residual {0._key}",
        ("kernels.triangle", "kernels.own", "kernels.own", "kernels.triangle", "kernels.own", "kernels.bodies"),
        ("kernels.bodies",),
    )
    def residual(self, mass: Any, bias: Any, force: Any, added: Any, push: Any, a: Any) -> list[list[Any]]:
        """(mass, bias, spring forces, h D + h^2 K, pushes, z'') -> force needed along z."""
        matrix, right = self._balance(mass, bias, force, added, push)
        return [entries(self._columns.T @ (matrix @ (self._columns @ ca.SX(a)) - right))]

    @property
    def _key(self) -> str:
        return f"{self.kernels.columns.tolist()} {self.joints} {self.held}{' touched' * self.touched}"

    @property
    def _columns(self) -> Any:
        return ca.sparsify(ca.DM(self.kernels.columns))

    @property
    def _whole(self) -> bool:
        """Whether the energies' own coordinates are all free, so that their rows are solved as they stand."""
        return not self.held and self.kernels.own == self.kernels.bodies

    def _balance(self, mass: Any, bias: Any, force: Any, added: Any, push: Any) -> tuple[Any, Any]:
        k = self.kernels
        matrix = unpacked(mass, k.own) + unpacked(added, k.own)
        return matrix, ca.vertcat(*(push[i] - bias[i] - force[i] for i in range(k.own)))

    def _solve_own(self, matrix: Any, right: Any, along: list[Any], more: list[Any]) -> Any:
        back = np.linalg.inv(self.kernels.columns)
        rows = ca.sparsify(ca.DM(back.T))
        matrix = matrix + rows @ ca.diag(ca.vertcat(*map(ca.SX, more))) @ rows.T
        right = right + rows @ ca.vertcat(*map(ca.SX, along))
        return rows.T @ _solve_ldl(matrix, right)

    def _solve_reduced(self, matrix: Any, right: Any, along: list[Any], more: list[Any]) -> Any:
        columns = self._columns
        matrix = columns.T @ matrix @ columns + ca.diag(ca.vertcat(*map(ca.SX, more)))
        free = [i for i in range(self.kernels.bodies) if i not in self.held]
        found = ca.SX.zeros(self.kernels.bodies)
        for i in self.held:
            found[i] = along[i]
        loads = ca.vertcat(*(0.0 if i in self.held else along[i] for i in range(len(along))))
        rest = columns.T @ right + loads - matrix @ found
        if free:
            found[free] = _solve_ldl(matrix[free, free], rest[free])
        return found


class _ContactRows:
    """A contact in the rows of the energies' own coordinates; N = mass (row . a) + at_rest is its normal force."""

    def __init__(self, kernels: SystemKernels, *blocks: Any) -> None:
        lever, motion, drift, direction, law, friction, rubs, rates = blocks
        to_rows, jacobian = (_lever(block, kernels.own)[:, :3] for block in (lever, motion))
        self.direction = ca.SX(direction)
        self.mass, self.row = law[0], jacobian @ self.direction
        self.at_rest = law[1] + law[0] * (law[2] + sum(drift[k] * direction[k] for k in range(3)))
        self.friction, self._to_rows = to_rows @ ca.SX(friction), to_rows
        self._rubs = [ca.vertcat(*(rubs[3 * side + k] for k in range(3))) for side in (0, 1)]
        self.rates = ca.SX(rates)

    def pull(self, freely: Any) -> Any:
        """Normal force at accelerations."""
        return self.at_rest + self.mass * ca.dot(self.row, freely)

    def rows(self, pull: Any) -> Any:
        """Rows of one unit of normal force and its friction. Its own push does not turn the sign of the force."""
        first, second = self._rubs
        same = not ca.SX(ca.simplify(first - second)).nnz() or ca.is_equal(first, second, 12)
        rub = first if same else ca.if_else(pull >= 0, first, second)
        return self._to_rows @ (self.direction + rub)


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
