"""Lagrange's equations from energies, by exact differentiation: nobody writes an entry of H by hand."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca

from tmodes.equations.lagrange.energy import Energies

__all__ = ["EquationTerms", "equation_terms"]


@dataclass(frozen=True)
class EquationTerms:
    """Terms of H phi'' + h + f_elastic + f_damping = Q: H (6, 6) [kg*m^2], the others (6,) [N*m]."""

    mass_matrix: Any
    bias: Any
    elastic: Any
    damping: Any

    @property
    def internal(self) -> Any:
        """All rows but the inertia: h + f_elastic + f_damping, shape (6,) [N*m]."""
        return self.bias + self.elastic + self.damping


def equation_terms(energy: Energies, phi: Any, phid: Any) -> EquationTerms:
    """d/dt (dT/dphi') - dT/dphi + dV/dphi + dPhi/dphi' , sorted by what causes it; gravity is in the bias.

    Eq. (34) [corrected]: the row of q; the print repeats Hel1,1 for Hel1,2 and Hel1,3. {test_rows_are_lagrange}
    Eq. (35) [derived]: the row of delta. {test_rows_are_lagrange}
    Eq. (36) [derived]: the row of gamma, with + 1/2 eps12 - eps11 + sigma. {test_rows_are_lagrange}
    Eq. (37) [derived]: the row of vt, with eps11 - 1/2 eps12: the -1/2 follows from the energies. {test_half_coupling}
    Eq. (38) [derived]: the row of e. {test_rows_are_lagrange}
    Slip (34): Hel1,1 is repeated where Hel1,2 and Hel1,3 belong {test_slip_34_repeated_entry}
    Slip (18)-(19): with lm, le varying, the energies have geometric terms in rows vt and e that the print
    lacks {test_slip_18_geometric_terms}
    """
    momentum = ca.gradient(energy.kinetic, phid)
    inertial = ca.jtimes(momentum, phi, phid) - ca.gradient(energy.kinetic, phi)
    rayleigh = energy.rayleigh_gear + energy.rayleigh_link
    elastic = energy.elastic_gear + energy.elastic_link
    return EquationTerms(
        mass_matrix=ca.jacobian(momentum, phid),
        bias=inertial + ca.gradient(energy.gravity, phi),
        elastic=_gradient(elastic, phi),
        damping=_gradient(rayleigh, phid),
    )


def _gradient(expression: Any, variables: Any) -> Any:
    """Gradient that also takes the constant zero of an arm whose elements are all rigid."""
    return ca.gradient(ca.SX(expression), variables)
