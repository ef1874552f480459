"""Model: the boundary type. A handful of functions of numbers, native underneath; equations above, runs below."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.compile.ir import kernels
from tmodes.equations.lagrange.coordinates import basis, deformation_basis, free_columns, free_deformations
from tmodes.equations.lagrange.layout import COORDINATES, EVALUATED, LINE, OBSERVED, STATE_SIZE
from tmodes.errors import SimulationError
from tmodes.integrate.settings import Integration
from tmodes.paper.mechanism import Drive, Mechanism, Parameters
from tmodes.paper.model_loops import PaperLoops, rate_of
from tmodes.paper.sampling import rows, sampled, split, total
from tmodes.simulation.batch.result import BatchRun
from tmodes.simulation.batch.simulate import How, Schedules, simulate_lanes

__all__ = ["PaperModel"]

Array = NDArray[np.float64]

_NUMBERS = 26
"""Numbers of a robot that are inputs of the equations."""

_NEWTON_STEPS = 30


@dataclass(frozen=True)
class PaperModel:
    """The native code of one mechanism, for every set of parameters; each group is made at its first use.

    Arrays are C-ordered doubles; n is a number of samples.
    """

    mechanism: Mechanism

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the coordinates, in the order of a state."""
        return COORDINATES

    def evaluate(self, phi: ArrayLike, phid: ArrayLike, voltage: ArrayLike, parameters: Parameters) -> dict[str, Array]:
        """All terms of the equations at n states: phi (n, 6) [rad], phid (n, 6) [rad/s], voltage (n,) [V].

        Returns arrays of shape (n, …) by the names of :data:`tmodes.equations.lagrange.layout.EVALUATED`.
        """
        inputs = [rows(phi, 6), rows(phid, 6), rows(voltage, 1)]
        out = sampled(self._evaluation["evaluation"], parameters, inputs, total(EVALUATED))
        return split(out, {name: int(np.prod(shape)) for name, shape in EVALUATED.items()}, dict(EVALUATED))

    def rate(self, time: ArrayLike, state: ArrayLike, row: ArrayLike, parameters: Parameters) -> Array:
        """Derivative of the state by time, shape (n, 17) [the state's units over s].

        ``time`` (n,) [s]; ``state`` (n, 17): coordinates [rad], rates [rad/s] and works [J]; ``row`` (n, degree + 2) of
        the reference, as :meth:`tmodes.kinds.signals.schedule.Schedule.rows_at` gives it.
        """
        return sampled(self._observation["rate"], parameters, self._instants(time, state, row), STATE_SIZE)

    def observe(self, time: ArrayLike, state: ArrayLike, row: ArrayLike, parameters: Parameters) -> dict[str, Array]:
        """What a result shows at n instants, by the names of :data:`tmodes.equations.lagrange.layout.OBSERVED`.

        The arguments are those of :meth:`rate`.
        """
        size = sum(OBSERVED.values())
        out = sampled(self._observation["observe"], parameters, self._instants(time, state, row), size)
        return split(out, OBSERVED)

    def line(self, motion: ArrayLike, stations: ArrayLike, parameters: Parameters) -> dict[str, Array]:
        """The elastic line of both modes at given stations s in 0..1.

        ``motion`` (n, 21): coordinates, rates, accelerations [rad, s], tip force (3) [N]. Returns arrays of shape
        (n, modes, stations, …) by the names of :data:`tmodes.equations.lagrange.layout.LINE`.
        """
        motion, stations = rows(motion, 21), np.asarray(stations, dtype=float)
        count, points = len(motion), len(stations)
        inputs = [np.tile(stations, count), np.repeat(motion, points, axis=0)]
        size = sum(LINE.values())
        modes = [sampled(self._line[f"line{mode}"], parameters, inputs, size) for mode in (1, 2)]
        return split(np.stack([mode.reshape(count, points, size) for mode in modes], axis=1), LINE)

    def quasistatic(self, gross: ArrayLike, near: ArrayLike, parameters: Parameters) -> tuple[Array, NDArray[np.bool_]]:
        """Deformations that the current forces would hold statically, shape (n, 5) [rad], and where they were found.

        ``gross`` (n, 6): theta, theta', theta'' [rad, s], tip force [N]; ``near`` (n, 5) [rad]: the deformations of the
        moment, from which Newton's method starts. Where it does not settle, its first step is given: the answer of the
        arm as it is linear about its present shape.
        """
        return self._static_root("quasistatic", rows(gross, 6), rows(near, 5), parameters)

    def rest(self, theta: float, parameters: Parameters) -> Array:
        """State of rest at a motor angle [rad], shape (17,).

        Gravity and the touched environment are in balance with the arm. Raises :class:`SimulationError` where there is
        no equilibrium.
        """
        angles, found = self._static_root("rest", rows(theta, 1), np.zeros((1, 5)), parameters)
        if not found.all():
            raise SimulationError(
                f"static deflection: got no equilibrium within {_NEWTON_STEPS} Newton steps; expected a link that "
                "carries its own load. Raise gear.stiffness or the bending_stiffness of the modes, or lower "
                "payload.mass, gravity or environment.preload"
            )
        state = np.zeros(STATE_SIZE)
        state[:6] = theta * basis()[:, 0] + deformation_basis() @ angles[0]
        return state

    def _static_root(
        self, name: str, loads: Array, near: Array, parameters: Parameters
    ) -> tuple[Array, NDArray[np.bool_]]:
        """Roots of a static residual, each sample by Newton's method from ``near``; and which of them were found."""
        free = free_deformations(self.mechanism.rigid)
        angles: Array = near.copy()
        found = np.zeros(len(loads), dtype=bool)
        angles[:, [k for k in range(5) if k not in free]] = 0.0
        first, before = angles, np.full(len(loads), np.inf)
        for step in range(_NEWTON_STEPS):
            change = self._newton_step(name, angles, loads, free, parameters)
            angles = np.where(found[:, None], angles, angles - change)
            first = angles.copy() if step == 0 else first
            size, scale = np.abs(change).max(axis=1), np.abs(angles).max(axis=1)
            # Next to a stiff surface rounding alone moves the arm: then steps end to shrink well below what matters.
            found |= (size <= 1e-14 + 1e-12 * scale) | ((size <= 1e-9 * scale) & (size >= before / 2))
            before = size
            if found.all():
                break
        found &= np.abs(angles).max(axis=1) < np.pi
        return np.where(found[:, None], angles, first), found

    def _newton_step(self, name: str, angles: Array, loads: Array, free: list[int], parameters: Parameters) -> Array:
        out = sampled(self._statics[name], parameters, [angles, loads], 30)
        matrix = out[:, 5:].reshape(-1, 5, 5).transpose(0, 2, 1)[:, free][:, :, free]
        good = np.isfinite(matrix).all(axis=(1, 2)) & np.isfinite(out[:, :5]).all(axis=1)
        change = np.zeros_like(angles)
        if free and good.any():
            change[np.ix_(np.flatnonzero(good), np.array(free))] = _solve_each(matrix[good], out[good, :5][:, free])
        change[~good] = 1.0  # lost: never taken for found
        return change

    def check_mass_matrix(self, state: ArrayLike, parameters: Parameters) -> None:
        """Raise :class:`SimulationError`, naming the coordinate, where the mass matrix is singular at a state."""
        mass = self.linearised(np.asarray(state)[:6], parameters)[0]
        directions = free_columns(self.mechanism.rigid, self.mechanism.drive is Drive.PRESCRIBED)
        if not directions.size:
            return
        reduced = directions.T @ (mass + mass.T) / 2 @ directions
        scale = np.sqrt(np.abs(np.diagonal(reduced)))
        scale[scale == 0] = 1.0
        values, vectors = np.linalg.eigh(reduced / np.outer(scale, scale))
        if values[0] > 1e-13 * values[-1]:
            return
        name = COORDINATES[int(np.argmax(np.abs(directions @ (vectors[:, 0] / scale))))]
        raise SimulationError(
            f"mass matrix: singular in coordinate {name} (condition number above 1e13); expected a positive definite "
            "matrix. Give the parts that move with it a mass (mass_per_length, payload.mass, payload.inertia)"
        )

    def linearised(self, phi: ArrayLike, parameters: Parameters) -> tuple[Array, Array, Array]:
        """M [kg*m^2], D [N*m*s/rad], K [N*m/rad], each (6, 6), about rest at phi (6,) [rad].

        Without current in the motor and without control.
        """
        out = sampled(self._linear["linear"], parameters, [rows(phi, 6)], 108)
        mass, damping, stiffness = out.reshape(3, 6, 6)
        return mass, damping, stiffness

    def _instants(self, time: ArrayLike, state: ArrayLike, row: ArrayLike) -> list[Array]:
        return [rows(time, 1), rows(state, STATE_SIZE), rows(row, self.mechanism.reference_degree + 2)]

    @cached_property
    def loops(self) -> Any:
        """The native time loops, by the names of :class:`tmodes.integrate.settings.Method`."""
        return PaperLoops(self.mechanism)

    @property
    def lane_loops(self) -> Any:
        """The native time loops over robots side by side."""
        return self.loops.lanes

    @property
    def batch_widths(self) -> dict[str, int]:
        """Numbers that compiled code reads of each lane of a batch."""
        widths = _NUMBERS, STATE_SIZE, self.mechanism.reference_degree + 2
        return dict(zip(("parameters", "states", "schedules"), widths, strict=True))

    def simulate_batch(
        self, parameters: ArrayLike, schedules: Schedules, states: ArrayLike, settings: Integration, **how: Unpack[How]
    ) -> BatchRun:
        """Many robots of this structure at once, as :func:`tmodes.simulation.batch.simulate.simulate_lanes` reports."""
        return simulate_lanes(self, parameters, schedules, states, settings, **how)

    @cached_property
    def _observation(self) -> Any:
        def make() -> dict[str, Any]:
            from tmodes.equations.lagrange.closed_loop import closed_loop, observe_function

            return {"observe": observe_function(closed_loop(self.mechanism)), "rate": rate_of(self.mechanism)}

        return kernels.sample_functions("observation", self.mechanism.key, make, {"observe": 3, "rate": 3})

    @cached_property
    def _line(self) -> Any:
        def make() -> dict[str, Any]:
            from tmodes.equations.lagrange.beam import line_function

            return {f"line{mode}": line_function(mode, self.mechanism) for mode in (1, 2)}

        return kernels.sample_functions("line", self.mechanism.arm_key, make, {"line1": 2, "line2": 2})

    @cached_property
    def _statics(self) -> Any:
        def make() -> dict[str, Any]:
            from tmodes.equations.lagrange.statics import quasistatic_function, rest_function

            return {"quasistatic": quasistatic_function(self.mechanism), "rest": rest_function(self.mechanism)}

        return kernels.sample_functions("statics", self.mechanism.arm_key, make, {"quasistatic": 2, "rest": 2})

    @cached_property
    def _evaluation(self) -> Any:
        def make() -> dict[str, Any]:
            from tmodes.equations.lagrange.evaluation import evaluation_function

            return {"evaluation": evaluation_function(replace(self.mechanism, drive=Drive.VOLTAGE))}

        return kernels.sample_functions("evaluation", self.mechanism.arm_key, make, {"evaluation": 3})

    @cached_property
    def _linear(self) -> Any:
        def make() -> dict[str, Any]:
            from tmodes.equations.lagrange.linear import linear_function

            return {"linear": linear_function(self.mechanism)}

        return kernels.sample_functions("linear", self.mechanism.arm_key, make, {"linear": 1})


def _solve_each(matrices: Array, right: Array) -> NDArray[Any]:
    """Solutions of many small systems; of singular ones those of least norm."""
    try:
        return np.linalg.solve(matrices, right[..., None])[..., 0]
    except np.linalg.LinAlgError:
        return (np.linalg.pinv(matrices) @ right[..., None])[..., 0]
