"""The integrators by name: those of tmodes, and those that a user registers."""

from __future__ import annotations

from tmodes.errors import InputError
from tmodes.integrate.dop853 import DOP853
from tmodes.integrate.dormand_prince import DORMAND_PRINCE
from tmodes.integrate.extrapolation import EXTRAPOLATION
from tmodes.integrate.method import Integrator
from tmodes.integrate.midpoint import MIDPOINT
from tmodes.integrate.rk4 import RK4
from tmodes.integrate.rosenbrock import ROSENBROCK

__all__ = ["AUTO", "integrator", "integrators", "register", "unregister"]

AUTO = "auto"
"""The method that the stiffness chooses."""

_BUILT_IN = (DORMAND_PRINCE, DOP853, RK4, EXTRAPOLATION, MIDPOINT, ROSENBROCK)
_REGISTERED: dict[str, Integrator] = {one.name: one for one in _BUILT_IN}


def integrators() -> dict[str, Integrator]:
    """All of them, by name."""
    return dict(_REGISTERED)


def integrator(name: str) -> Integrator:
    """The integrator of a name; KeyError for one that is not registered."""
    return _REGISTERED[name]


def register(one: Integrator) -> Integrator:
    """Make an integrator of your own known, so that sheets and commands of this process can name it.

    Raises :class:`tmodes.errors.InputError` for a name that is taken, and for a method without a tableau.
    """
    if one.name in (*_REGISTERED, AUTO):
        raise InputError("integrator.name", repr(one.name), "a name that is not taken", "choose another name")
    if one.tableau is None:
        raise InputError("integrator.tableau", "None", "the tableau of an explicit Runge-Kutta method", "give it one")
    _REGISTERED[one.name] = one
    return one


def unregister(name: str) -> None:
    """Forget an integrator that was registered; those of tmodes stay."""
    if name not in {one.name for one in _BUILT_IN}:
        _REGISTERED.pop(name, None)
