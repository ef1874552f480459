"""Schedules at many samples: packs named blocks into rows, calls the native code, and parts what comes back."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.compile.ir import kernels

__all__ = ["Rows", "derivatives", "evaluate"]

Array = NDArray[np.float64]
Blocks = dict[str, Array]


def evaluate(parameters: Array, schedule: Any, blocks: Blocks, count: int) -> Blocks:
    """Outputs of a schedule at ``count`` samples by name, each (count, numbers); ``blocks`` are its inputs by name."""
    library = kernels.schedule_function("arm", schedule, "double")
    packed = np.ascontiguousarray(np.concatenate([blocks[name] for name in schedule.inputs], axis=1))
    out, workspace = np.empty((count, schedule.output_size)), np.zeros(schedule.workspace)
    library["run"](count, 0, *(array.ctypes.data for array in (parameters, workspace, packed, out)))
    return _split(out, schedule)


def derivatives(parameters: Array, schedule: Any, blocks: Blocks, directions: Blocks, count: int) -> Blocks:
    """Exact derivatives of the outputs at ``count`` samples, each along its own direction of the inputs named."""
    library = kernels.schedule_function("arm", schedule, "derivative")
    values = np.concatenate([blocks[name] for name in schedule.inputs], axis=1)
    slopes = [directions.get(name, np.zeros_like(blocks[name])) for name in schedule.inputs]
    packed = np.ascontiguousarray(np.stack([values, np.concatenate(slopes, axis=1)], axis=1))
    out, workspace = np.empty((count, 2, schedule.output_size)), np.zeros(2 * schedule.workspace)
    library["run"](count, 0, *(array.ctypes.data for array in (parameters, workspace, packed, out)))
    return _split(np.ascontiguousarray(out[:, 1]), schedule)


class Rows:
    """States as rows, one or many."""

    def __init__(self, q: ArrayLike, v: ArrayLike, size: int) -> None:
        given = np.asarray(q, dtype=float)
        self.single = given.ndim == 1
        rows = np.atleast_2d(given)
        self.count = rows.size // size if size else len(rows)  # an arm in which nothing moves has states too
        self.q = rows.reshape(self.count, size)
        self.v = self.of(v, size)

    def of(self, values: ArrayLike, width: int) -> Array:
        """Values as rows of ``width`` numbers, one for each state."""
        return np.broadcast_to(np.asarray(values, dtype=float), (self.count, width))

    def shaped(self, values: Array) -> Array:
        """Rows as the states were given."""
        return values[0] if self.single else values


def _split(out: Array, schedule: Any) -> dict[str, Array]:
    parts: dict[str, Array] = {}
    start = 0
    for name, slots in schedule.outputs.items():
        size = sum(slot.size for slot in slots)
        parts[name] = out[:, start : start + size]
        start += size
    return parts
