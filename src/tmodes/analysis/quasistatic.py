"""Bernoulli's solution of a run, split as the paper does: y(x, t) = X(x) (T_st(t) + T_to(t)), for any arm.

The stationary part T_st is what the present forces would hold statically: gravity, given wrenches, and the inertia of
the gross motion, in which motors (and joints without an elastic gear) move as they do and no deflection moves. The
oscillatory part T_to is the rest. At rest T_st is the sag.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.model.model import Model

__all__ = [
    "Split", "deflections", "elastic_names", "gear_inputs", "gross_motion", "held_shape", "loose_gears",
    "split_motion", "sprung",
]  # fmt: skip

Array = NDArray[np.float64]

_STEP = 1e-6
"""Step of the differences that make the tangent [rad]: Newton's method only needs it about right."""

_SMALL = 1e-11
"""Change of a coordinate [rad, m] at which it is found."""

_LONGEST = 0.5
"""Longest change in one step [rad]."""

_MOST_STEPS = 40

_STALE = 0.1
"""Ratio of two changes above which the tangent is made again."""

_ROWS = 40_000
"""Samples times directions that are worked on at once."""


@dataclass(frozen=True, eq=False)
class Split:
    """``stationary`` and ``oscillatory`` (n, m) of the m elastic coordinates ``names`` at n samples [rad, m].

    ``held`` (n,): False where the robot could not hold its loads statically; there the stationary part is that of the
    robot as it is linear about its present shape.
    """

    names: tuple[str, ...]
    stationary: Array
    oscillatory: Array
    held: NDArray[np.bool_]


def elastic_names(model: Model) -> tuple[str, ...]:
    """``joint.gear`` of each elastic gear, ``joint.spring`` of a joint on its spring alone; the links' coordinates."""
    gears = [axis.axis.element for axis in model.parts.axes if axis.axis.element]
    return (*gears, *(model.coordinates[k] for k in model.deformations))


def deflections(model: Model, q: ArrayLike) -> Array:
    """Elastic coordinates (n, m) of states q (n, nq): gear output less gear input, and the links' coordinates."""
    q = np.atleast_2d(np.asarray(q, dtype=float))
    return np.concatenate([q[:, sprung(model)] - gear_inputs(model, q, rest=True), q[:, model.deformations]], axis=1)


def split_motion(
    model: Model, q: ArrayLike, v: ArrayLike, a: ArrayLike, *, wrenches: ArrayLike | None = None,
    base: ArrayLike | None = None,
) -> Split:  # fmt: skip
    """T_st and T_to of every elastic coordinate at n samples of coordinates, rates and accelerations (n, nq)."""
    q = np.atleast_2d(np.asarray(q, dtype=float))
    shape, held = held_shape(model, q, v, a, wrenches=wrenches, base=base)
    still = deflections(model, shape)
    return Split(elastic_names(model), still, deflections(model, q) - still, held)


def held_shape(
    model: Model, q: ArrayLike, v: ArrayLike = 0.0, a: ArrayLike = 0.0, *, wrenches: ArrayLike | None = None,
    base: ArrayLike | None = None,
) -> tuple[Array, NDArray[np.bool_]]:  # fmt: skip
    """Coordinates (n, nq) in which the present forces are held statically, motors as they are; and whether they are.

    Newton's method for all samples at once, from the present shape; a tangent serves as long as it converges quickly.
    """
    q = np.atleast_2d(np.asarray(q, dtype=float))
    rates, gains = (gross_motion(model, np.broadcast_to(np.asarray(x, dtype=float), q.shape)) for x in (v, a))
    free = np.array([*sprung(model), *model.deformations], dtype=int)
    if not len(free):
        return q.copy(), np.ones(len(q), dtype=bool)
    size = max(1, _ROWS // len(free))
    points = len(model.parts.points)
    pushed = None if wrenches is None else np.broadcast_to(np.reshape(wrenches, (-1, points, 6)), (len(q), points, 6))
    bases = None if base is None else np.broadcast_to(np.reshape(base, (-1, 24)), (len(q), 24))
    found, held = q.copy(), np.zeros(len(q), dtype=bool)
    for start in range(0, len(q), size):
        rows = slice(start, start + size)
        loads = _Loads(
            model, free, rates[rows], gains[rows], *(None if x is None else x[rows] for x in (pushed, bases))
        )
        found[rows], held[rows] = _solved(loads, q[rows])
    return found, held


def sprung(model: Model) -> list[int]:
    """Coordinates of the joints behind an elastic gear, or on a spring alone, in the order of the nodes."""
    return [axis.angle for axis in model.parts.axes if axis.axis.element]


def loose_gears(model: Model, q: ArrayLike) -> dict[str, float]:
    """The gears whose teeth are apart in a pose (nq,), by their joints' coordinates; half of the play [rad, m] of each.

    Their springs and dampers do not act there.
    """
    axes = [axis.axis for axis in model.parts.axes if axis.axis.element]
    found = zip(sprung(model), axes, deflections(model, q)[0], strict=False)
    gears = [(joint, axis.joint.gear if axis.drive.has_gear else None, deflection) for joint, axis, deflection in found]
    return {
        model.coordinates[joint]: gear.backlash
        for joint, gear, deflection in gears
        if gear and gear.backlash > 0 and abs(deflection) <= gear.backlash
    }


def gear_inputs(model: Model, values: Array, *, rest: bool = False) -> Array:
    """Gear inputs of these joints (n, gears) from motor angles (or their rates).

    Of locked motors and of springs without a drive: where they are relaxed with ``rest``, else 0.
    """
    couplings = np.eye(len(model.motors)) if model.chain.couplings is None else np.asarray(model.chain.couplings)
    motors, column = values[:, model.motors] @ couplings.T, 0
    columns = []
    for axis in model.parts.axes:
        if axis.motor >= 0:
            columns.append(motors[:, column])
            column += 1
        elif axis.axis.element:
            columns.append(np.full(len(values), axis.axis.rest if rest else 0.0))
    return np.stack(columns, axis=1) if columns else np.zeros((len(values), 0))


def gross_motion(model: Model, values: Array) -> Array:
    """Rates, or accelerations, of the gross motion: no deflection moves."""
    inputs = gear_inputs(model, values)
    gross = np.array(values, dtype=inputs.dtype)
    gross[:, sprung(model)] = inputs
    gross[:, model.deformations] = 0.0
    return gross


@dataclass(frozen=True, eq=False)
class _Loads:
    """What is to be held at each sample."""

    model: Model
    free: NDArray[np.intp]
    rates: Array
    gains: Array
    wrenches: Array | None
    base: Array | None

    def unbalanced(self, q: Array, rows: NDArray[np.intp]) -> Array:
        """Forces along the free coordinates that nothing holds, of some samples."""
        pushed, base = (None if x is None else x[rows] for x in (self.wrenches, self.base))
        forces = self.model.inverse_dynamics(q, self.rates[rows], self.gains[rows], wrenches=pushed, base=base)
        return forces[:, self.free]

    def tangent(self, q: Array, rows: NDArray[np.intp]) -> Array:
        """Derivative of those forces by the free coordinates, (rows, free, free)."""
        m = len(self.free)
        many, which = np.repeat(q, m, axis=0), np.repeat(rows, m)
        moved = many.copy()
        moved[np.arange(len(many)), np.tile(self.free, len(q))] += _STEP
        here = np.repeat(self.unbalanced(q, rows), m, axis=0)
        return ((self.unbalanced(moved, which) - here) / _STEP).reshape(len(q), m, m).transpose(0, 2, 1)


def _solved(loads: _Loads, start: Array) -> tuple[Array, NDArray[np.bool_]]:
    q, open_rows = start.copy(), np.arange(len(start))
    compliance = _inverse(loads.tangent(q, open_rows))
    linear = start[:, loads.free] - _times(compliance, loads.unbalanced(q, open_rows))
    before = np.full(len(q), np.inf)
    for _ in range(_MOST_STEPS):
        change = -_times(compliance[open_rows], loads.unbalanced(q[open_rows], open_rows))
        size = np.abs(change).max(axis=1)
        change *= np.minimum(1.0, _LONGEST / np.maximum(size, _LONGEST))[:, None]
        q[open_rows[:, None], loads.free] += change
        slow = (size > _STALE * before[open_rows]) & (size >= _SMALL)
        before[open_rows] = size
        if slow.any():
            stale = open_rows[slow]
            compliance[stale] = _inverse(loads.tangent(q[stale], stale))
        open_rows = open_rows[~(size < _SMALL)]
        if not len(open_rows):
            break
    q[open_rows[:, None], loads.free] = linear[open_rows]
    held = np.ones(len(q), dtype=bool)
    held[open_rows] = False
    return q, held


def _inverse(matrices: Array) -> Array:
    """Inverses, of singular matrices (a gear within its play) the pseudo-inverse."""
    try:
        return np.asarray(np.linalg.inv(matrices), dtype=float)
    except np.linalg.LinAlgError:
        return np.asarray(np.linalg.pinv(np.nan_to_num(matrices)), dtype=float)


def _times(matrices: Array, vectors: Array) -> Array:
    return (matrices @ vectors[..., None])[..., 0]
