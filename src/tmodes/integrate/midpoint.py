"""The implicit midpoint rule at fixed step: symplectic, of order 2."""

from __future__ import annotations

from tmodes.integrate.method import IMPLICIT, Integrator

__all__ = ["MIDPOINT"]

MIDPOINT = Integrator(
    name="midpoint",
    description="implicit, fixed step, keeps energy in long runs",
    order=2,
    adaptive=False,
    asks=IMPLICIT,
)
