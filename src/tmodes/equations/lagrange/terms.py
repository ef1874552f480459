"""Lagrange's equations from energies, by exact differentiation: nobody writes an entry of H by hand."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca

__all__ = ["Energies", "EquationTerms", "equation_terms"]


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

    @property
    def bias(self) -> Any:
        """Inertia without accelerations, and weight, shape (n,)."""
        return self.inertial + self.gravity

    @property
    def internal(self) -> Any:
        """All rows but the inertia of accelerations, shape (n,)."""
        return self.bias + self.elastic + self.damping


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
