"""Task: consecutive cases that are computed at once, here or elsewhere."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["Task"]


@dataclass(frozen=True, eq=False)
class Task:
    """Consecutive cases: ``values`` (m, d) of which the first has the number ``first``, and which quantities of them.

    ``keep``: the cases among them whose whole motion is kept.
    """

    first: int
    values: NDArray[np.float64]
    quantities: tuple[str, ...]
    keep: tuple[int, ...] = ()
