"""Implicit methods: Rodas5P, extrapolated linearly implicit Euler steps, and the implicit midpoint rule."""

from __future__ import annotations

from tmodes.integrate.method import EULER, IMPLICIT, JACOBIAN, Integrator

__all__ = ["EXTRAPOLATION", "MIDPOINT", "MOST_STATES", "ROSENBROCK"]

MOST_STATES = 300
"""Largest state whose Jacobian is kept in the memory of the loop."""

ROSENBROCK = Integrator(
    name="rosenbrock", description="implicit with the exact Jacobian, to check others", order=5, asks=JACOBIAN, looks=6
)


EXTRAPOLATION = Integrator(
    name="extrapolation",
    description="implicit, for stiff links and gears",
    order=6,
    asks=EULER,
    looks=8,
    replayed=True,
    # Motions that a tolerance of 1e-9 can see cost much; its rows are summed with weights of some thousands.
    tolerances={"relative_tolerance": 1e-7, "absolute_tolerance": 1e-9},
    least_tolerance=1e-10,
)


MIDPOINT = Integrator(
    name="midpoint",
    description="implicit, fixed step, keeps energy in long runs",
    order=2,
    adaptive=False,
    asks=IMPLICIT,
)
