"""Inverse kinematics of rates: which rates of the coordinates give the tip a wanted velocity."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["coordinate_rates"]


def coordinate_rates(jacobian: ArrayLike, tip_velocity: ArrayLike) -> NDArray[np.float64]:
    """Rates of the coordinates [rad/s], shape (6,), of least norm that move the tip as wanted, or nearest to it.

    ``jacobian`` (3, 6) [m], ``tip_velocity`` (3,) [m/s].

    Eq. (43) [corrected]: phi' = J^-1 ps' with the pseudo-inverse. {test_slip_43_pseudo_inverse}
    Slip (43): the matrix that the print inverts has rows and columns of zeros, it is singular
    {test_slip_43_pseudo_inverse}
    """
    return np.linalg.pinv(np.asarray(jacobian, dtype=float)) @ np.asarray(tip_velocity, dtype=float)
