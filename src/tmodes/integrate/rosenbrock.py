"""Rodas5P, a Rosenbrock method of order 5(4) with the exact Jacobian: G. Steinebach, BIT Numer. Math. 63 (2023) 27."""

from __future__ import annotations

from tmodes.integrate.method import JACOBIAN, Integrator

__all__ = ["MOST_STATES", "ROSENBROCK"]

MOST_STATES = 300
"""Largest state whose Jacobian is kept in the memory of the loop."""

ROSENBROCK = Integrator(
    name="rosenbrock", description="implicit with the exact Jacobian, to check others", order=5, asks=JACOBIAN, looks=6
)
