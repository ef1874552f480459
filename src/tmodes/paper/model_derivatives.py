"""Derivatives of the rates of the 2010 robot, and of its rest."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.equations.lagrange.coordinates import basis, deformation_basis, free_deformations
from tmodes.equations.lagrange.layout import STATE_SIZE
from tmodes.kinds.kernel.kernel import Kernel
from tmodes.kinds.kernel.schedule import Schedule, Slot
from tmodes.model.derivatives import Differentiated
from tmodes.paper.mechanism import Mechanism, Parameters
from tmodes.paper.model_schedules import rate_schedule

__all__ = ["rate_jvp", "rate_vjp", "rest_change"]

Array = NDArray[np.float64]


def rest_change(mechanism: Mechanism, parameters: Parameters, theta: float, state: Array) -> tuple[Array, Array]:
    """How the rest at a motor angle moves: derivatives of its coordinates by the angle, (6,), and by the parameters.

    ``state``: that of ``PaperModel.rest``; by the parameters (6, parameters). From the residual r
    of the equations of rest: their root moves by -(dr/dx)^-1 dr/dp.
    """
    free = free_deformations(mechanism.rigid)
    unit, shapes = basis()[:, 0], deformation_basis()
    angles = np.linalg.lstsq(shapes, state[:6] - theta * unit, rcond=None)[0]
    blocks = {"angles": angles[None], "theta": np.array([[theta]])}
    of = _rest(mechanism)
    found = [of.back(parameters.vector, blocks, {"residual": row[None]}, (*blocks, "parameters")) for row in np.eye(5)]
    matrix = np.concatenate([one["angles"] for one in found])[np.ix_(free, free)]
    by_theta = -np.linalg.solve(matrix, np.concatenate([one["theta"] for one in found])[free])[:, 0]
    by_numbers = -np.linalg.solve(matrix, np.stack([one["parameters"] for one in found])[free])
    return unit + shapes[:, free] @ by_theta, shapes[:, free] @ by_numbers


@cache
def _rest(mechanism: Mechanism) -> Differentiated:
    """(angles, theta) -> ``residual`` (5,) of the forces at rest."""
    from tmodes.equations.lagrange.statics import rest_function

    function = rest_function(mechanism)
    schedule = Schedule(function.nnz_in(2))
    sizes = (5, 1, schedule.parameters)
    kernel = Kernel(f"at rest {mechanism.arm_key}", sizes, (5,), lambda *blocks: [[function.call([*blocks])[0][:5]]])
    inputs = [schedule.input(name, size) for name, size in zip(("angles", "theta"), sizes, strict=False)]
    schedule.output("residual", *schedule.call(kernel, *inputs, Slot("parameters", 0, schedule.parameters)))
    return Differentiated(schedule)


def rate_jvp(
    mechanism: Mechanism,
    parameters: Parameters,
    instants: Mapping[str, ArrayLike],
    directions: Mapping[str, ArrayLike],
) -> Array:
    """Derivative of the rates (n, 17) along one direction of ``time``, ``state``, ``row`` at each of n instants.

    ``instants``: time (n,), state (n, 17), row (n, degree + 2); directions in the same shapes; one of ``parameters``
    (parameters,) holds at all instants.
    """
    blocks, along = _blocks(instants), {name: value for name, value in directions.items() if name != "parameters"}
    change = directions.get("parameters")
    change = None if change is None else np.asarray(change, dtype=float)
    return _differentiated(mechanism).along(parameters.vector, blocks, _blocks(along), change=change)["rate"]


def rate_vjp(
    mechanism: Mechanism,
    parameters: Parameters,
    instants: Mapping[str, ArrayLike],
    weights: ArrayLike,
    by: Sequence[str] = ("state", "parameters"),
) -> dict[str, Array]:
    """Derivatives of sum(weights * rates), weights (n, 17), by the inputs named; by ``parameters`` over all instants.

    The inputs are those of :func:`rate_jvp`.
    """
    blocks, seeds = _blocks(instants), {"rate": np.asarray(weights, dtype=float).reshape(-1, STATE_SIZE)}
    return _differentiated(mechanism).back(parameters.vector, blocks, seeds, by)


@cache
def _differentiated(mechanism: Mechanism) -> Differentiated:
    return Differentiated(rate_schedule(mechanism))


def _blocks(given: Mapping[str, ArrayLike]) -> dict[str, Array]:
    arrays = {name: np.asarray(value, dtype=float) for name, value in given.items()}
    return {name: array.reshape(len(array), -1) for name, array in arrays.items()}
