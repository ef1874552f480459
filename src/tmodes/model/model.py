"""Model: the boundary type of a robot. Functions of numbers, native underneath; built from a Chain."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.chain.chain import Chain
from tmodes.equations.recursion.parts import Parts
from tmodes.errors import InputError
from tmodes.io.arguments import numbers_of
from tmodes.io.printed import public_names, shortened
from tmodes.model.differentiated import DifferentiatedModel
from tmodes.model.passes import PointMotion
from tmodes.model.rows import one_row
from tmodes.sheet import Robot

__all__ = ["Model", "PointMotion"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False, init=False, repr=False)
class Model(DifferentiatedModel):
    """The native code of one chain's structure, with its numbers.

    Arrays: q and v (n, nq) or (nq,), in the order of ``coordinates``: motors, joints, links. SI units, radians.
    ``wrenches`` (n, points, 6): force then moment by the surroundings on each named point, world axes.

    >>> model = tmodes.Model(tmodes.load("spong1987"))
    >>> model
    Model of spong1987: 2 coordinates joint.motor, joint
    ...
    """

    def __init__(self, robot: Robot | Chain, *, trials: bool = False) -> None:
        lowered = getattr(robot, "chain", None)
        chain = lowered() if callable(lowered) else robot
        if not isinstance(chain, Chain):
            hint = "write tmodes.Model(robot)"
            raise InputError("robot", f"a {type(robot).__name__}", "a robot, or the chain of a robot", hint)
        super().__init__(chain, trials=trials)

    def __repr__(self) -> str:
        points = ", ".join(point.name for point in self.parts.points)
        return shortened([f"Model of {self.chain.name}: {self.nq} coordinates {', '.join(self.coordinates)}",
                          f"points: {points}", f"efforts: {', '.join(self.efforts) or 'none'}"], "")  # fmt: skip

    def __dir__(self) -> list[str]:
        inner = {"passes", "parts", "trials", "chain", "at_rest"}
        return [name for name in public_names(self) if name not in inner]

    def __reduce__(self) -> tuple[Any, ...]:
        """A copy, and what was pickled, is made of the chain again; compiled code is not copied."""
        return partial(type(self), trials=self.trials), (self.chain,)

    @property
    def parts(self) -> Parts:
        """The chain as kernels and numbers."""
        return self.passes.parts

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
        return self.passes.parameters

    @property
    def rotor_inertias(self) -> Array:
        """Inertia of the rotors along each coordinate, a diagonal of the mass matrix, shape (nq,)."""
        return self.passes.rotor_inertias

    def at_rest(self, *, gravity: float = 1.0) -> Array:
        """The row (24) of a base at rest: acceleration less gravity (6), rate (3), pose and velocity in the world.

        ``gravity``: share of it that pulls.

        >>> model.at_rest().shape
        (24,)
        """
        return self.passes.at_rest(gravity=float(numbers_of(gravity, "gravity", ((),))))

    def forward_dynamics(
        self,
        q: ArrayLike,
        v: ArrayLike,
        effort: ArrayLike = 0.0,
        *,
        given: ArrayLike = 0.0,
        wrenches: ArrayLike | None = None,
        base: ArrayLike | None = None,
        step: ArrayLike = 0.0,
    ) -> Array:
        """Accelerations of all coordinates, shape of q [SI].

        ``effort`` (n, efforts): joint effort, or motor torque after the reducer; ``given`` (n, prescribed joints):
        their accelerations; ``step`` h: those of a linearly implicit Euler step of h [s].

        >>> model.forward_dynamics([0.1, 0.1], [0, 0], effort=[1.0]).round(4)
        array([ 3.3333, -0.9784])
        """
        rows, parts = self._rows(q, v), self.parts
        inputs = {
            "effort": rows.of(effort, len(parts.efforts), "effort"),
            "given": rows.of(given, len(parts.given), "given"),
            "step": rows.of(step, 1, "step"),
        }
        return rows.shaped(self.passes.forward(rows, inputs, base, wrenches))

    def inverse_dynamics(
        self,
        q: ArrayLike,
        v: ArrayLike,
        a: ArrayLike,
        *,
        wrenches: ArrayLike | None = None,
        base: ArrayLike | None = None,
    ) -> Array:
        """Generalized forces that must be applied along all coordinates, shape of q [N*m, N].

        >>> model.inverse_dynamics([0.1, 0.1], [0, 0], [0, 0]).round(4)  # holds it against its weight
        array([0.    , 0.9784])
        """
        rows = self._rows(q, v)
        return rows.shaped(self.passes.inertia(rows, a, base, wrenches)["forces"] + self.passes.elastic(rows)["forces"])

    def mass_matrix(self, q: ArrayLike) -> Array:
        """M(q), shape (n, nq, nq) or (nq, nq) [SI].

        >>> model.mass_matrix([0, 0])
        array([[0.3, 0. ],
               [0. , 1. ]])
        """
        rows = self._rows(q, 0.0)
        n = self.nq
        many = self._rows(np.repeat(rows.q, n, axis=0), 0.0)
        units = np.tile(np.eye(n), (rows.count, 1))
        columns = self.passes.inertia(many, units, self.passes.at_rest(gravity=0.0), None)["forces"]
        matrix = columns.reshape(rows.count, n, n)
        matrix = (matrix + matrix.transpose(0, 2, 1)) / 2
        return matrix[0] if rows.single else matrix

    def bias(self, q: ArrayLike, v: ArrayLike, *, base: ArrayLike | None = None) -> Array:
        """Coriolis, centrifugal and gravity forces h(q, v), shape of q.

        >>> model.bias([0.1, 0.1], [1, 1]).round(4)
        array([0.    , 0.9784])
        """
        rows = self._rows(q, v)
        return rows.shaped(self.passes.inertia(rows, 0.0, base, None)["forces"])

    def gravity(self, q: ArrayLike) -> Array:
        """g(q), shape of q.

        >>> model.gravity([[0, 0], [0, 0.1]]).shape
        (2, 2)
        """
        return self.bias(q, 0.0)

    def elastic_forces(self, q: ArrayLike, v: ArrayLike) -> Array:
        """Forces of springs, dampers and friction, as they stand on the left side, shape of q.

        >>> model.elastic_forces([0.01, 0], [0, 0]).round(9)
        array([ 1., -1.])
        """
        rows = self._rows(q, v)
        return rows.shaped(self.passes.elastic(rows)["forces"])

    def energies(self, q: ArrayLike, v: ArrayLike) -> dict[str, Array]:
        """Energies [J] of shape (n,): kinetic, gravity (zero at the world's origin), elastic_gear, elastic_link.

        >>> {name: round(float(value), 6) for name, value in model.energies([0.01, 0], [0, 2]).items()}
        {'kinetic': 2.0, 'gravity': -9.8, 'elastic_gear': 0.005, 'elastic_link': 0.0}
        """
        rows = self._rows(q, v)
        still = self._rows(rows.q, 0.0)
        momentum = self.passes.inertia(still, rows.v, self.passes.at_rest(gravity=0.0), None)
        elastic = self.passes.elastic(rows)["energies"].reshape(rows.count, -1, 2)
        found = {
            "kinetic": (momentum["forces"] * rows.v).sum(axis=1) / 2,
            "gravity": -momentum["moment"] @ np.asarray(self.chain.gravity, dtype=float),
            "elastic_gear": elastic[:, :, 0].sum(axis=1),
            "elastic_link": elastic[:, :, 1].sum(axis=1),
        }
        return {name: value[0] if rows.single else value for name, value in found.items()}

    def losses(self, q: ArrayLike, v: ArrayLike) -> dict[str, Array]:
        """Power lost [W], shape (n,): gear_damping, friction, link_damping.

        >>> float(model.losses([0, 0], [1, 0])["friction"])
        0.0
        """
        rows = self._rows(q, v)
        lost = self.passes.elastic(rows)["losses"].reshape(rows.count, -1, 3).sum(axis=1)
        names = ("gear_damping", "friction", "link_damping")
        return {name: lost[0, k] if rows.single else lost[:, k] for k, name in enumerate(names)}

    def power_lost(self, q: ArrayLike, v: ArrayLike) -> Array:
        """All power lost [W], shape (n,).

        >>> float(model.power_lost([0, 0], [1, 0]))
        0.0
        """
        return np.sum([*self.losses(q, v).values()], axis=0)

    def momentum(self, q: ArrayLike, v: ArrayLike) -> tuple[Array, Array]:
        """Linear momentum [kg*m/s] and angular momentum about the world's origin [kg*m^2/s], world axes, (n, 3).

        >>> linear, angular = model.momentum([0, 0], [0, 1])
        >>> linear.shape, angular.shape
        ((3,), (3,))
        """
        rows = self._rows(q, v)
        still = self._rows(rows.q, 0.0)
        found = self.passes.inertia(still, rows.v, self.passes.at_rest(gravity=0.0), None)
        if "base_force" not in found:
            got, hint = f"the equations `{self.chain.equations}`", "take `equations: recursion`"
            raise InputError("momentum", got, "asked of equations that give the reaction of the base", hint)
        info = found["base_force"]
        placed = self.chain.base
        linear, about_base = info[:, 3:] @ placed.rotation.T, info[:, :3] @ placed.rotation.T
        angular = about_base + np.cross(placed.position, linear)
        return (linear[0], angular[0]) if rows.single else (linear, angular)

    def points(
        self, q: ArrayLike, v: ArrayLike = 0.0, a: ArrayLike = 0.0, *, base: ArrayLike | None = None
    ) -> PointMotion:
        """Motion of the named points; the acceleration is that of the coordinates ``a`` without gravity.

        >>> model.points([0, 0], [0, 1]).velocity.shape  # of one point, the tip
        (1, 3)
        """
        rows = self._rows(q, v)
        base = self.passes.at_rest(gravity=0.0) if base is None else base
        info = self.passes.inertia(rows, a, base, None)["points"]
        motion = PointMotion.of(info)
        return PointMotion(*(part[0] for part in motion)) if rows.single else motion

    def pose(self, q: ArrayLike) -> tuple[Array, Array]:
        """Positions (n, points, 3) [m] and rotations (n, points, 3, 3) of the named points in the world.

        >>> position, rotation = model.pose([0, 0])
        >>> position[0].round(9) + 0.0
        array([ 0.,  0., -1.])
        """
        motion = self.points(q)
        return motion.position, motion.rotation

    def jacobian(self, q: ArrayLike) -> Array:
        """(n, points, 6, nq): linear then angular velocity of the named points per rate, world axes.

        >>> model.jacobian([0, 0]).shape
        (1, 6, 2)
        """
        rows = self._rows(q, 0.0)
        n, points = self.nq, len(self.parts.points)
        both = np.zeros((0, points, 6))
        if n:
            motion = self.points(np.repeat(rows.q, n, axis=0), 0.0, np.tile(np.eye(n), (rows.count, 1)))
            both = np.concatenate([motion.acceleration, motion.angular_acceleration], axis=-1)
        jacobian = both.reshape(rows.count, n, points, 6).transpose(0, 2, 3, 1)
        return jacobian[0] if rows.single else jacobian

    def linearize(
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

        >>> mass, damping, stiffness = model.linearize([0, 0])
        >>> stiffness.round(9)
        array([[ 100. , -100. ],
               [-100. ,  109.8]])
        """
        state = self._state(q, 0.0 if v is None else v, base, wrenches)
        state["a"] = one_row("a", 0.0 if a is None else a, self.nq)
        mass, stiffness, damping = self._inverse(state, ("a", "q", "v"), loaded=wrenches is not None)
        return (mass + mass.T) / 2, damping, stiffness

    def stiffness(self, q: ArrayLike, *, wrenches: ArrayLike | None = None, base: ArrayLike | None = None) -> Array:
        """K (nq, nq) of :meth:`linearize` about rest in q (nq,), by itself.

        >>> model.stiffness([0, 0]).diagonal().round(9)
        array([100. , 109.8])
        """
        state = self._state(q, 0.0, base, wrenches)
        state["a"] = state["v"]
        return self._inverse(state, ("q",), loaded=wrenches is not None)[0]
