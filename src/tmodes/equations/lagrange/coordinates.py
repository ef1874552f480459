"""The six generalized coordinates and the bending angles that hide in them.

phi = [q, delta, gamma, vt, e, theta] [rad]; the deformations are [xi, th11q, th12d, th11m, th12e] [rad].
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.equations.lagrange.layout import DEFORMATIONS

__all__ = [
    "Deformations",
    "basis",
    "deformation_basis",
    "deformations",
    "free_columns",
    "free_deformations",
]


class Deformations(NamedTuple):
    """The five elastic angles, numbers or symbols."""

    th11q: Any
    th12d: Any
    th11m: Any
    th12e: Any
    xi: Any


def deformations(phi: Any) -> Deformations:
    """Elastic angles from the coordinates; the same map takes rates to rates.

    Eq. (5) [stated]: q = gamma + th11q, gamma = theta + xi, delta = omega_q + th12d, e = omega_m + th12e,
    solved for the angles with omega = th/2 of (6) and (7). {test_deformation_angles}
    """
    q, delta, gamma, vt, e, theta = (phi[k] for k in range(6))
    th11q = q - gamma
    return Deformations(th11q, delta - th11q / 2, vt, e - vt / 2, gamma - theta)


_INDEPENDENT = {"theta": 0, "xi": 1, "th11q": 2, "th12d": 3, "th11m": 4, "th12e": 5}
_RIGID = {"gear": ("xi",), "mode1": ("th11q", "th11m"), "mode2": ("th12d", "th12e")}


def basis() -> NDArray[np.float64]:
    """Constant map A, shape (6, 6): phi = A [theta, xi, th11q, th12d, th11m, th12e], the inverse of (5)."""
    return np.array(
        [
            [1, 1, 1, 0, 0, 0],
            [0, 0, 0.5, 1, 0, 0],
            [1, 1, 0, 0, 0, 0],
            [0, 0, 0, 0, 1, 0],
            [0, 0, 0, 0, 0.5, 1],
            [1, 0, 0, 0, 0, 0],
        ]
    )


def deformation_basis() -> NDArray[np.float64]:
    """Columns of the basis that belong to the deformations, in the order of DEFORMATIONS, shape (6, 5)."""
    return basis()[:, [_INDEPENDENT[angle] for angle in DEFORMATIONS]]


def free_deformations(rigid: frozenset[str]) -> list[int]:
    """Indices of the deformations that no rigid element holds at zero."""
    held = {angle for element in rigid for angle in _RIGID[element]}
    return [k for k, angle in enumerate(DEFORMATIONS) if angle not in held]


def free_columns(rigid: frozenset[str], prescribed: bool) -> NDArray[np.float64]:
    """Directions P, shape (6, free): phi'' = P z'' (+ the motor's part when its motion is prescribed).

    Where nothing is rigid the coordinates themselves are the directions, which keeps the mass matrix sparse.
    """
    if not rigid:
        return np.eye(6)[:, : 5 if prescribed else 6]
    dropped = {_INDEPENDENT[angle] for element in rigid for angle in _RIGID[element]}
    if prescribed:
        dropped.add(_INDEPENDENT["theta"])
    return basis()[:, [k for k in range(6) if k not in dropped]]
