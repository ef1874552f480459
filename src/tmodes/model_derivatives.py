"""Derivatives of the rates of the 2010 robot: its equations, one function, as a schedule of two kernels."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.derivatives import Differentiated
from tmodes.equations.arm.kernel import Kernel
from tmodes.equations.arm.schedule import Schedule, Slot
from tmodes.equations.layout import STATE_SIZE
from tmodes.mechanism import Mechanism, Parameters

__all__ = ["rate_jvp", "rate_schedule", "rate_vjp"]

Array = NDArray[np.float64]


@cache
def rate_schedule(mechanism: Mechanism) -> Schedule:
    """(time, state, row) -> ``rate``, the derivative of the state; what follows from the parameters alone comes first.

    Parameters and inputs are those of :meth:`tmodes.model.Model.rate`.
    """
    from tmodes.compile.invariant import parted
    from tmodes.equations.closed_loop import closed_loop, rate_function

    function = rate_function(closed_loop(mechanism))
    held, rest = parted(function, invariant=3)
    sizes = (1, STATE_SIZE, mechanism.reference_degree + 2, function.nnz_in(3), held.nnz_out(0))
    key, schedule = mechanism.key, Schedule(sizes[3])
    inputs = [schedule.input(name, size) for name, size in zip(("time", "state", "row"), sizes, strict=False)]
    return _called(schedule, inputs, key, (held, rest), sizes)


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


def _called(schedule: Schedule, inputs: list[Any], key: str, functions: tuple[Any, Any], sizes: Any) -> Schedule:
    """The schedule with both functions called."""
    held, rest = functions
    first = Kernel(f"held {key}", (sizes[3],), (sizes[4],), lambda p: [[value] for value in held.call([p])])
    second = Kernel(
        f"rest {key}",
        (*sizes[:3], sizes[4]),
        (STATE_SIZE,),
        lambda *blocks: [[value] for value in rest.call([*blocks])],
    )
    (kept,) = schedule.call(first, Slot("parameters", 0, sizes[3]))
    schedule.output("rate", *schedule.call(second, *inputs, kept))
    return schedule
