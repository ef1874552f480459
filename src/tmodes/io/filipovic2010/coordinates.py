"""The 2010 robot's coordinates q, delta, gamma, vt, e, theta as a constant map of those of its joint and its link."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

__all__ = ["COORDINATES", "to_robot"]

COORDINATES = ("q", "delta", "gamma", "vt", "e", "theta")
"""Names of the paper's coordinates, in its order."""

_ROWS = {
    "q": {"joint": 1.0, "link.azimuth1": 1.0},
    "delta": {"link.azimuth1": 0.5, "link.azimuth2": 1.0},
    "gamma": {"joint": 1.0},
    "vt": {"link.elevation1": 1.0},
    "e": {"link.elevation1": 0.5, "link.elevation2": 1.0},
    "theta": {"joint.motor": 1.0},
}
"""Each of the paper's coordinates as a sum of the robot's."""


def to_robot(names: Sequence[str]) -> NDArray[np.float64]:
    """Matrix from the paper's coordinates to the robot's ``names``, shape (n, 6).

    Where an element is rigid, its coordinates are not among the ``names``: the others are those of the nearest state.
    """
    there = np.array([[_ROWS[own].get(name, 0.0) for name in names] for own in COORDINATES])
    return np.linalg.pinv(there)
