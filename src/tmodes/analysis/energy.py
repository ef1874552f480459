"""The energy monitor: what came in, less what went out, must be what is there."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["balance", "largest_flow"]


def balance(energy: ArrayLike, work: ArrayLike) -> NDArray[np.float64]:
    """Residual of the balance [J] at each sample: (E - E0) - motor's work + all losses.

    ``energy`` (n, kinds) and ``work`` (n, kinds), the motor's work first.
    """
    total, work = np.sum(energy, axis=1), np.asarray(work)
    return total - total[0] - work[:, 0] + work[:, 1:].sum(axis=1)


def largest_flow(energy: ArrayLike, work: ArrayLike) -> float:
    """The energy moved [J]: the largest change of any kind of energy, or work of any kind, within the run."""
    energy = np.asarray(energy)
    return float(max(np.abs(energy - energy[0]).max(), np.abs(work).max()))
