"""The classical Runge-Kutta method of order 4 at fixed step; between steps the cubic Hermite polynomial."""

from __future__ import annotations

from tmodes.integrate.method import Integrator, Tableau

__all__ = ["RK4"]

RK4 = Integrator(
    name="rk4",
    description="fixed integration.step, to repeat the work of others",
    order=4,
    adaptive=False,
    tableau=Tableau(
        a=((), (1 / 2,), (0.0, 1 / 2), (0.0, 0.0, 1.0), (1 / 6, 1 / 3, 1 / 3, 1 / 6)), c=(0.0, 0.5, 0.5, 1.0, 1.0)
    ),
    reach=2.78,
    replayed=True,
)
