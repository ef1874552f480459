"""Native functions over many samples: arrays as they want them, and the parts of what they return."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.paper.mechanism import Parameters

__all__ = ["rows", "sampled", "split", "total"]

Array = NDArray[np.float64]


def rows(values: ArrayLike, width: int) -> Array:
    """Values as C-ordered doubles of shape (n, width)."""
    return np.ascontiguousarray(values, dtype=float).reshape(-1, width)


def total(shapes: dict[str, tuple[int, ...]]) -> int:
    """Numbers in arrays of these shapes."""
    return sum(int(np.prod(shape)) for shape in shapes.values())


def sampled(function: Any, parameters: Parameters, inputs: list[Array], width: int) -> Array:
    """Call a native function over samples; all arrays are C-ordered doubles, the output is (n, width)."""
    count = len(inputs[0])
    out = np.empty((count, width))
    function(count, parameters.vector.ctypes.data, *(array.ctypes.data for array in inputs), out.ctypes.data)
    return out


def split(out: Array, sizes: dict[str, int], shapes: dict[str, tuple[int, ...]] | None = None) -> dict[str, Array]:
    """Parts of the last axis by name; single numbers lose that axis."""
    parts: dict[str, Array] = {}
    start = 0
    for name, size in sizes.items():
        part = out[..., start : start + size]
        start += size
        shape = shapes[name] if shapes else (size,) if size > 1 else ()
        parts[name] = part.reshape(*out.shape[:-1], *shape)
    return parts
