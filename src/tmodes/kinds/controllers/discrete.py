"""Sampled systems whose inputs are held."""

from __future__ import annotations

from typing import Any

import numpy as np

__all__ = ["zero_order_hold"]


def zero_order_hold(A: Any, B: Any, period: float) -> tuple[Any, Any]:
    """The sampled system x_k+1 = Ad x_k + Bd u_k of inputs that are held over a ``period`` [s]."""
    from scipy.linalg import expm

    n, m = B.shape
    whole = np.zeros((n + m, n + m))
    whole[:n, :n], whole[:n, n:] = A, B
    found = expm(whole * period)
    return found[:n, :n], found[:n, n:]
