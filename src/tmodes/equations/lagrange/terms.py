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
    """d/dt (dT/dq') - dT/dq + dV/dq + dPhi/dq', sorted by what causes it."""
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
