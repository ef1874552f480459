"""ArmModel: the boundary type of a general arm. Functions of numbers, native underneath; built from a Chain."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.chain import Chain
from tmodes.equations.arm.elastic import elastic_forces
from tmodes.equations.arm.forward import forward_dynamics
from tmodes.equations.arm.inertia import inertia_forces
from tmodes.equations.arm.parts import Parts
from tmodes.evaluator import Rows, derivatives, evaluate

__all__ = ["ArmModel", "PointMotion"]

Array = NDArray[np.float64]

_ROW = 24
"""Numbers of the base: acceleration less gravity (6), rate (3), pose (15)."""

_POINT = 24
"""Numbers told of a point: pose (15), rate (3), acceleration (6)."""


class PointMotion(NamedTuple):
    """Motion of the named points in world axes: shapes (n, points, 3), rotation (n, points, 3, 3) [SI]."""

    position: Array
    rotation: Array
    velocity: Array
    rate: Array
    acceleration: Array
    angular_acceleration: Array


@dataclass(frozen=True, eq=False)
class ArmModel:
    """The native code of one chain's structure, with its numbers.

    Arrays: q and v (n, nq) or (nq,), in the order of ``coordinates``: motors, joints, links. SI units, radians.
    ``wrenches`` (n, points, 6): force then moment by the surroundings on each named point, world axes.
    """

    chain: Chain

    @cached_property
    def parts(self) -> Parts:
        """The chain as kernels and numbers."""
        return Parts(self.chain)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names: ``joint.motor`` of each elastic drive, joints, then ``link.kind`` of each link."""
        return tuple(self.parts.names)

    @property
    def nq(self) -> int:
        """Number of coordinates."""
        return self.parts.size

    @property
    def motors(self) -> NDArray[np.intp]:
        """Indices of the motor angles."""
        return np.array(self.parts.motors, dtype=int)

    @property
    def joints(self) -> NDArray[np.intp]:
        """Indices of the joints."""
        return np.array(self.parts.joints, dtype=int)

    @property
    def deformations(self) -> NDArray[np.intp]:
        """Indices of the links' coordinates."""
        return np.arange(self.parts.joints.stop, self.nq)

    @property
    def efforts(self) -> tuple[str, ...]:
        """Joints whose effort (or motor torque) is an input, in the order of ``effort``."""
        return tuple(self.parts.efforts)

    @property
    def parameters(self) -> Array:
        """The numbers of the chain, as the compiled code reads them."""
        return self.parts.numbers.vector

    def forward_dynamics(
        self,
        q: ArrayLike,
        v: ArrayLike,
        effort: ArrayLike = 0.0,
        *,
        given: ArrayLike = 0.0,
        wrenches: ArrayLike | None = None,
        base: ArrayLike | None = None,
        step: float = 0.0,
    ) -> Array:
        """Accelerations of all coordinates, shape of q [SI].

        ``effort`` (n, efforts): joint effort, or motor torque after the reducer; ``given`` (n, prescribed joints):
        their accelerations; ``step`` h: those of a linearly implicit Euler step of h [s].
        """
        parts = self.parts
        schedule = self._schedule("forward", loaded=wrenches is not None)
        rows = Rows(q, v, parts.size)
        blocks = {
            "effort": rows.of(effort, len(parts.efforts)), "given": rows.of(given, len(parts.given)),
            "step": rows.of(step, 1), **self._common(rows, base, wrenches),
        }  # fmt: skip
        return rows.shaped(evaluate(self.parameters, schedule, blocks, rows.count)["a"])

    def inverse_dynamics(
        self,
        q: ArrayLike,
        v: ArrayLike,
        a: ArrayLike,
        *,
        wrenches: ArrayLike | None = None,
        base: ArrayLike | None = None,
    ) -> Array:
        """Generalized forces that must be applied along all coordinates, shape of q [N*m, N]."""
        rows = Rows(q, v, self.nq)
        return rows.shaped(self._inertial(rows, a, base, wrenches)["forces"] + self._elastic(rows)["forces"])

    def mass_matrix(self, q: ArrayLike) -> Array:
        """M(q), shape (n, nq, nq) or (nq, nq) [SI]."""
        rows = Rows(q, np.zeros_like(np.asarray(q, dtype=float)), self.nq)
        n = self.nq
        many = Rows(np.repeat(rows.q, n, axis=0), np.zeros((rows.count * n, n)), n)
        units = np.tile(np.eye(n), (rows.count, 1))
        columns = self._inertial(many, units, self._base(gravity=False), None)["forces"]
        matrix = columns.reshape(rows.count, n, n)
        matrix = (matrix + matrix.transpose(0, 2, 1)) / 2
        return matrix[0] if rows.single else matrix

    def bias(self, q: ArrayLike, v: ArrayLike, *, base: ArrayLike | None = None) -> Array:
        """Coriolis, centrifugal and gravity forces h(q, v), shape of q."""
        rows = Rows(q, v, self.nq)
        return rows.shaped(self._inertial(rows, 0.0, base, None)["forces"])

    def gravity_forces(self, q: ArrayLike) -> Array:
        """Forces of gravity g(q), shape of q."""
        return self.bias(q, np.zeros_like(np.asarray(q, dtype=float)))

    def elastic_forces(self, q: ArrayLike, v: ArrayLike) -> Array:
        """Forces of springs, dampers and friction, as they stand on the left side, shape of q."""
        rows = Rows(q, v, self.nq)
        return rows.shaped(self._elastic(rows)["forces"])

    def energies(self, q: ArrayLike, v: ArrayLike) -> dict[str, Array]:
        """Energies [J] of shape (n,): kinetic, gravity (zero at the world's origin), elastic_gear, elastic_link."""
        rows = Rows(q, v, self.nq)
        still = Rows(rows.q, np.zeros_like(rows.v), self.nq)
        momentum = self._inertial(still, rows.v, self._base(gravity=False), None)
        elastic = self._elastic(rows)["energies"].reshape(rows.count, -1, 2)
        found = {
            "kinetic": (momentum["forces"] * rows.v).sum(axis=1) / 2,
            "gravity": -momentum["moment"] @ np.asarray(self.chain.gravity, dtype=float),
            "elastic_gear": elastic[:, :, 0].sum(axis=1),
            "elastic_link": elastic[:, :, 1].sum(axis=1),
        }
        return {name: value[0] if rows.single else value for name, value in found.items()}

    def losses(self, q: ArrayLike, v: ArrayLike) -> dict[str, Array]:
        """Power lost [W], shape (n,): gear_damping, friction, link_damping."""
        rows = Rows(q, v, self.nq)
        lost = self._elastic(rows)["losses"].reshape(rows.count, -1, 3).sum(axis=1)
        names = ("gear_damping", "friction", "link_damping")
        return {name: lost[0, k] if rows.single else lost[:, k] for k, name in enumerate(names)}

    def power_lost(self, q: ArrayLike, v: ArrayLike) -> Array:
        """All power lost in dampers and friction [W], shape (n,)."""
        return np.sum([*self.losses(q, v).values()], axis=0)

    def momentum(self, q: ArrayLike, v: ArrayLike) -> tuple[Array, Array]:
        """Linear momentum [kg*m/s] and angular momentum about the world's origin [kg*m^2/s], world axes, (n, 3)."""
        rows = Rows(q, v, self.nq)
        still = Rows(rows.q, np.zeros_like(rows.v), self.nq)
        told = self._inertial(still, rows.v, self._base(gravity=False), None)["base_force"]
        placed = self.chain.base
        linear, about_base = told[:, 3:] @ placed.rotation.T, told[:, :3] @ placed.rotation.T
        angular = about_base + np.cross(placed.position, linear)
        return (linear[0], angular[0]) if rows.single else (linear, angular)

    def points(
        self, q: ArrayLike, v: ArrayLike = 0.0, a: ArrayLike = 0.0, *, base: ArrayLike | None = None
    ) -> PointMotion:
        """Motion of the named points; the acceleration is that of the coordinates ``a`` without gravity."""
        rows = Rows(q, v, self.nq)
        base = self._base(gravity=False) if base is None else base
        told = self._inertial(rows, a, base, None)["points"].reshape(rows.count, -1, _POINT)
        shape = told.shape[:2]
        parts = (told[..., 9:12], told[..., :9].reshape(*shape, 3, 3), told[..., 12:15], told[..., 15:18],
                 told[..., 18:21], told[..., 21:24])  # fmt: skip
        return PointMotion(*(part[0] for part in parts)) if rows.single else PointMotion(*parts)

    def pose(self, q: ArrayLike) -> tuple[Array, Array]:
        """Positions (n, points, 3) [m] and rotations (n, points, 3, 3) of the named points in the world."""
        motion = self.points(q)
        return motion.position, motion.rotation

    def jacobian(self, q: ArrayLike) -> Array:
        """(n, points, 6, nq): linear then angular velocity of the named points per rate, world axes."""
        rows = Rows(q, 0.0, self.nq)
        n = self.nq
        many = np.repeat(rows.q, n, axis=0)
        motion = self.points(many, 0.0, np.tile(np.eye(n), (rows.count, 1)))
        both = np.concatenate([motion.acceleration, motion.angular_acceleration], axis=-1)
        jacobian = both.reshape(rows.count, n, -1, 6).transpose(0, 2, 3, 1)
        return jacobian[0] if rows.single else jacobian

    def linearised(
        self,
        q: ArrayLike,
        v: ArrayLike | None = None,
        a: ArrayLike | None = None,
        *,
        wrenches: ArrayLike | None = None,
        base: ArrayLike | None = None,
    ) -> tuple[Array, Array, Array]:
        """M, D, K (nq, nq) about one state q (nq,), with exact derivatives: M a' + D v' + K q' = applied forces'.

        K and D hold what the rates ``v``, the accelerations ``a`` and dead wrenches contribute.
        """  # fmt: skip
        n = self.nq
        q = np.asarray(q, dtype=float).reshape(n)
        state = [q, np.zeros(n) if v is None else np.asarray(v, dtype=float).reshape(n)]
        acceleration = np.zeros(n) if a is None else np.asarray(a, dtype=float).reshape(n)
        sides = []
        for side in range(2):
            directions = {
                "q": np.eye(n) if side == 0 else np.zeros((n, n)),
                "v": np.eye(n) if side else np.zeros((n, n)),
            }
            rows = Rows(np.tile(state[0], (n, 1)), np.tile(state[1], (n, 1)), n)
            schedule = self._schedule("inertia", loaded=wrenches is not None)
            blocks = {"a": rows.of(acceleration, n), **self._common(rows, base, wrenches)}
            slopes = derivatives(self.parameters, schedule, blocks, directions, n)["forces"]
            elastic = derivatives(
                self.parameters, self._schedule("elastic"), self._common(rows, None, None), directions, n
            )
            sides.append((slopes + elastic["forces"]).T)
        return self.mass_matrix(q), sides[1], sides[0]

    def _inertial(
        self, rows: Rows, a: ArrayLike, base: ArrayLike | None, wrenches: ArrayLike | None
    ) -> dict[str, Array]:
        schedule = self._schedule("inertia", loaded=wrenches is not None)
        acceleration = rows.of(a, self.nq)
        blocks = {"a": acceleration, **self._common(rows, base, wrenches)}
        found = evaluate(self.parameters, schedule, blocks, rows.count)
        return found | {"forces": found["forces"] + acceleration * self.rotor_inertias}

    @cached_property
    def rotor_inertias(self) -> Array:
        """Inertia of the rotors along each coordinate, a diagonal of the mass matrix."""
        rotors = np.zeros(self.nq)
        for part in self.parts.nodes:
            motor = part.node.joint.motor
            if motor and part.angle >= 0 and part.drive:
                rotors[part.motor if part.motor >= 0 else part.angle] += motor.inertia if part.effort >= 0 else 0.0
        return rotors

    def _elastic(self, rows: Rows) -> dict[str, Array]:
        return evaluate(self.parameters, self._schedule("elastic"), self._common(rows, None, None), rows.count)

    def _base(self, *, gravity: bool = True) -> Array:
        """The base at rest."""
        placed = self.chain.base
        pull = placed.rotation.T @ np.asarray(self.chain.gravity, dtype=float) if gravity else np.zeros(3)
        return np.concatenate([np.zeros(3), -pull, np.zeros(3), placed.rotation.ravel(), placed.position, np.zeros(3)])

    def _common(self, rows: Rows, base: ArrayLike | None, wrenches: ArrayLike | None) -> dict[str, Array]:
        blocks = {"q": rows.q, "v": rows.v, "base": rows.of(self._base() if base is None else base, _ROW)}
        if wrenches is not None:
            size = 6 * len(self.parts.points)
            blocks["wrenches"] = rows.of(np.asarray(wrenches, dtype=float).reshape(-1, size), size)
        return blocks

    def _schedule(self, name: str, *, loaded: bool = False) -> Any:
        label = f"_schedule_{name}{'_loaded' * loaded}"
        if label not in self.__dict__:
            make = {"forward": forward_dynamics, "inertia": inertia_forces}.get(name)
            self.__dict__[label] = make(self.parts, loaded=loaded) if make else elastic_forces(self.parts)
        return self.__dict__[label]
