"""Extrapolated linearly implicit Euler steps.

E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, section IV.9.
"""

from __future__ import annotations

from tmodes.integrate.method import EULER, Integrator

__all__ = ["EXTRAPOLATION"]

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
