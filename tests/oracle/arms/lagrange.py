"""The Lagrangian of a chain and what follows from it by automatic differentiation; numbers in, numbers out.

M = Hessian of T in v; bias = d(dT/dv)/dq v - dT/dq + dV/dq; all arrays are of one state, in the oracle's own order
``coordinates`` (motors, joints, link coordinates), SI units.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from oracle.arms import energy
from oracle.arms.motion import Motion
from oracle.arms.rotation import vee
from tmodes.chain.chain import Chain
from tmodes.kinds.drives.registry import drive_kind

__all__ = ["Lagrangian"]

Array = NDArray[np.float64]


class Lagrangian:
    """Independent equations of motion of ``chain``."""

    def __init__(self, chain: Chain):
        self.chain, self.motion = chain, Motion(chain)
        self.coordinates = tuple(self.motion.coordinates)
        self._q = ca.vertcat(*self.motion.coordinates.values())
        self._v, self._a = ca.SX.sym("v", self.size), ca.SX.sym("a", self.size)

    @property
    def size(self) -> int:
        """Number of coordinates."""
        return len(self.coordinates)

    @property
    def driven(self) -> list[int]:
        """Rows on which the efforts act: a motor's own, or its joint's; in the order of the joints."""
        names = [
            f"{axis.name}.motor" if axis.drive == drive_kind("elastic") else axis.name
            for axis in self.chain.axes
            if axis.drive in {drive_kind("elastic"), drive_kind("effort")}
        ]
        return [self.coordinates.index(name) for name in names]

    def _function(self, inputs: list[Any], outputs: list[Any]) -> Any:
        return ca.Function("f", inputs, [ca.densify(out) for out in outputs])

    @cached_property
    def _kinetic(self) -> Any:
        return energy.kinetic(self.motion, self._q, self._v)

    @cached_property
    def _momenta(self) -> Any:
        return ca.gradient(self._kinetic, self._v)

    @cached_property
    def _mass_function(self) -> Any:
        return self._function([self._q, self._v], [self._momenta])

    @cached_property
    def _force_function(self) -> Any:
        fall = ca.gradient(energy.gravity(self.motion), self._q)
        spring = energy.elastic_gear(self.motion) + energy.elastic_link(self.motion)
        turn = ca.jtimes(self._momenta, self._q, self._v) - ca.gradient(self._kinetic, self._q)
        return self._function(
            [self._q, self._v], [turn, fall, ca.gradient(spring, self._q), energy.lost(self.motion, self._v)]
        )

    @cached_property
    def _point_function(self) -> Any:
        frames = self.motion.points()
        jacobians = [self._jacobian(frame) for frame in frames]
        return self._function(
            [self._q],
            [
                ca.horzcat(*[frame.place for frame in frames]),
                ca.horzcat(*[frame.axes for frame in frames]),
                ca.vertcat(*jacobians),
            ],
        )

    def _jacobian(self, frame: Any) -> Any:
        """(6, nq): linear and angular velocity in world axes per rate."""
        turning = ca.jacobian(ca.vec(frame.axes), self._q)
        rates = [vee(ca.reshape(turning[:, j], 3, 3) @ frame.axes.T) for j in range(self.size)]
        return ca.vertcat(ca.jacobian(frame.place, self._q), ca.horzcat(*rates))

    def mass_matrix(self, q: Array) -> Array:
        """M (nq, nq)."""
        return np.array(self._mass_function(q, np.eye(self.size)))

    def forces(self, q: Array, v: Array) -> tuple[Array, Array, Array, Array]:
        """Coriolis, gravity, elastic and damping forces (nq,) as they stand on the left of M a + ... = applied."""
        turn, fall, spring, damping = (np.array(part).ravel() for part in self._force_function(q, v))
        return turn, fall, spring, damping

    def points(self, q: Array) -> tuple[Array, Array, Array]:
        """Positions (points, 3), rotations (points, 3, 3) and Jacobians (points, 6, nq)."""
        places, axes, jacobians = (np.array(part) for part in self._point_function(q))
        number = places.shape[1]
        return (
            places.T,
            axes.reshape(3, number, 3).transpose(1, 0, 2),
            jacobians.reshape(number, 6, self.size),
        )

    def applied(self, q: Array, wrenches: Array | None) -> Array:
        """Generalized forces (nq,) of wrenches (points, 6) by the surroundings on the points."""
        if wrenches is None:
            return np.zeros(self.size)
        return np.asarray(np.einsum("pic,pi->c", self.points(q)[2], np.asarray(wrenches, float)), np.float64)

    def inverse_dynamics(self, q: Array, v: Array, a: Array, wrenches: Array | None = None) -> Array:
        """M a + bias + elastic + damping - wrenches (nq,)."""
        accelerating = np.array(self._mass_function(q, a)).ravel()
        return accelerating + sum(self.forces(q, v)) - self.applied(q, wrenches)

    def forward_dynamics(
        self, q: Array, v: Array, effort: Array, wrenches: Array | None = None, step: float = 0.0
    ) -> Array:
        """Accelerations (nq,); with a step h (linear springs and dampers) (M + h D + h^2 K) a = forces at q + h v."""
        right = np.zeros(self.size)
        right[self.driven] = effort
        right -= self.inverse_dynamics(q, v, np.zeros(self.size), wrenches)
        matrix = self.mass_matrix(q)
        if step:
            stiffness, damping = self.linear_parts(q, v)
            right = right - step * stiffness @ v
            matrix = matrix + step * damping + step**2 * stiffness
        return np.asarray(np.linalg.solve(matrix, right), np.float64)

    def linear_parts(self, q: Array, v: Array) -> tuple[Array, Array]:
        """Stiffness and damping matrices (nq, nq) of springs and dampers alone."""
        spring = energy.elastic_gear(self.motion) + energy.elastic_link(self.motion)
        parts = [ca.hessian(spring, self._q)[0], ca.jacobian(energy.lost(self.motion, self._v), self._v)]
        stiffness, damping = self._function([self._q, self._v], parts)(q, v)
        return np.array(stiffness), np.array(damping)

    def linearize(self, q: Array, v: Array) -> tuple[Array, Array, Array]:
        """M, D, K (nq, nq): derivatives of the inverse dynamics by a, v and q at a = 0."""
        turn = ca.jtimes(self._momenta, self._q, self._v) - ca.gradient(self._kinetic, self._q)
        potential = energy.gravity(self.motion) + energy.elastic_gear(self.motion) + energy.elastic_link(self.motion)
        total = turn + ca.gradient(potential, self._q) + energy.lost(self.motion, self._v)
        function = self._function([self._q, self._v], [ca.jacobian(total, self._v), ca.jacobian(total, self._q)])
        damping, stiffness = (np.array(part) for part in function(q, v))
        return self.mass_matrix(q), damping, stiffness

    def energies(self, q: Array, v: Array) -> dict[str, float]:
        """Energies [J]: kinetic, gravity, elastic_gear, elastic_link."""
        parts = {
            "kinetic": self._kinetic,
            "gravity": energy.gravity(self.motion),
            "elastic_gear": energy.elastic_gear(self.motion),
            "elastic_link": energy.elastic_link(self.motion),
        }
        values = self._function([self._q, self._v], list(parts.values()))(q, v)
        return {name: float(value) for name, value in zip(parts, values, strict=True)}

    def momentum(self, q: Array, v: Array) -> tuple[Array, Array]:
        """Linear and angular momentum (3,) about the world's origin."""
        both = self._function([self._q, self._v], list(energy.momentum(self.motion, self._q, self._v)))(q, v)
        return np.array(both[0]).ravel(), np.array(both[1]).ravel()
