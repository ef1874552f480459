"""Dormand and Prince's method of order 8(5,3) with dense output of order 7: :mod:`tmodes.integrate.dop853_table`."""

from __future__ import annotations

from tmodes.integrate.method import Integrator

__all__ = ["DOP853"]

DOP853 = Integrator(
    name="dop853",
    description="explicit, order 8, for rtol below 1e-8",
    order=8,
    reach=6.1,
    looks=8,
    replayed=True,
)
