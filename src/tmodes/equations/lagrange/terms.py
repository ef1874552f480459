"""Symbols of a system by name, and Lagrange's equations from its energies, by exact differentiation."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca

__all__ = ["Energies", "EquationTerms", "Members", "equation_terms"]


class Members:
    """Symbols by name: ``q.cart``, ``q["cart"]``, or in order."""

    def __init__(self, names: Sequence[str], values: Any, of: str) -> None:
        self._values = {name: values[k] for k, name in enumerate(names)}
        self._of = of

    def __getitem__(self, name: str | int) -> Any:
        if isinstance(name, int):
            return [*self._values.values()][name]
        if name not in self._values:
            raise AttributeError(f"no {self._of} `{name}`; there are {', '.join(self._values)}")
        return self._values[name]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return self[name]

    def __iter__(self) -> Iterator[Any]:
        return iter(self._values.values())

    def __len__(self) -> int:
        return len(self._values)


@dataclass(frozen=True)
class Energies:
    """Kinetic and potential energies [J], and Rayleigh's function [W], of a system in its coordinates."""

    kinetic: Any
    gravity: Any
    elastic: Any
    dissipation: Any


@dataclass(frozen=True)
class EquationTerms:
    """Terms of H q'' + h + g + f_elastic + f_damping = Q: H (n, n) and forces (n,), h without gravity.

    ``stiffness`` and ``swing`` (n, n): derivatives of the elastic forces by q, and of the dampers' by q'.
    """

    mass_matrix: Any
    inertial: Any
    gravity: Any
    elastic: Any
    damping: Any
    stiffness: Any
    swing: Any


def equation_terms(energy: Energies, q: Any, v: Any) -> EquationTerms:
    """d/dt (dT/dq') - dT/dq + dV/dq + dPhi/dq', sorted by what causes it.

    Of the 2010 robot these are its rows but for the gear's torque sigma, which is its drive's:

    Eq. (34) [corrected]: the row of q; the print repeats Hel1,1 for Hel1,2 and Hel1,3. {test_rows_are_lagrange}
    Eq. (35) [derived]: the row of delta. {test_rows_are_lagrange}
    Eq. (36) [derived]: the row of gamma, with + 1/2 eps12 - eps11 + sigma. {test_rows_are_lagrange}
    Eq. (37) [derived]: the row of vt, with eps11 - 1/2 eps12: the -1/2 follows from the energies. {test_half_coupling}
    Eq. (38) [derived]: the row of e. {test_rows_are_lagrange}
    Slip (34): Hel1,1 is repeated where Hel1,2 and Hel1,3 belong {test_slip_34_repeated_entry}
    Slip (18)-(19): with lm, le varying, the energies have geometric terms in rows vt and e that the print
    lacks {test_slip_18_geometric_terms}
    """
    momentum = ca.gradient(energy.kinetic, v)
    stiffness, elastic = ca.hessian(energy.elastic, q)
    swing, damping = ca.hessian(energy.dissipation, v)
    return EquationTerms(
        mass_matrix=ca.jacobian(momentum, v),
        inertial=ca.jtimes(momentum, q, v) - ca.gradient(energy.kinetic, q),
        gravity=ca.gradient(energy.gravity, q),
        elastic=elastic,
        damping=damping,
        stiffness=stiffness,
        swing=swing,
    )
