"""The integrators by name: those of tmodes, and those that a user registers (``INTEGRATORS.register``)."""

from __future__ import annotations

from tmodes.errors import InputError
from tmodes.integrate.dop853 import DOP853
from tmodes.integrate.dormand_prince import DORMAND_PRINCE
from tmodes.integrate.implicit import EXTRAPOLATION, MIDPOINT, ROSENBROCK
from tmodes.integrate.method import Integrator
from tmodes.integrate.rk4 import RK4
from tmodes.kinds.registry import Registry

__all__ = ["AUTO", "INTEGRATORS", "Integrator", "integrator", "integrators"]

AUTO = "auto"
"""The method that the stiffness chooses."""

_BUILT_IN = (DORMAND_PRINCE, DOP853, RK4, EXTRAPOLATION, MIDPOINT, ROSENBROCK)


def _has_tableau(one: Integrator) -> None:
    if one.tableau is None and one not in _BUILT_IN:
        raise InputError("integrator.tableau", "None", "the tableau of an explicit Runge-Kutta method", "give it one")


INTEGRATORS: Registry[Integrator] = Registry("integrator", Integrator, reserved=(AUTO,), check=_has_tableau)
"""Those of tmodes have loops of their own, or a tableau; one of a user is a tableau."""

for _one in _BUILT_IN:
    INTEGRATORS.register(_one)


def integrators() -> dict[str, Integrator]:
    """All of them, by name."""
    return {one.name: one for one in INTEGRATORS.members}


def integrator(name: str) -> Integrator:
    """The integrator of a name; raises :class:`tmodes.kinds.registry.UnknownKindError`."""
    return INTEGRATORS[name]
