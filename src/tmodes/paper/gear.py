"""The elastic gear: a torsion spring and damper between the motor (theta) and the link's root (gamma)."""

from __future__ import annotations

from typing import Any

from tmodes.kinds.schema.quantity import DataSheet, dissipation, positive

__all__ = ["ElasticGear"]


class ElasticGear(DataSheet):
    """A gear that twists by xi = gamma - theta. ``stiffness: .inf`` makes it rigid, by wish."""

    stiffness: float = positive(
        "N*m/rad", "Cxi", "torsional stiffness of the gear, after the reducer", rigid=True, plausible=(1.0, 1e9)
    )
    damping: float = dissipation("N*m*s/rad", "Bxi", "torsional damping of the gear, after the reducer")

    def stored(self, deflection: Any) -> Any:
        """Elastic energy [J] at a deflection xi [rad].

        Eq. (24) [stated]: Epel_xi = 1/2 Cxi xi^2, with xi = gamma - theta. {test_elastic_energy_terms}
        """
        return self.stiffness * deflection**2 / 2

    def dissipated(self, rate: Any) -> Any:
        """Rayleigh function [W], half of the power lost, at a rate xi' [rad/s].

        Eq. (25) [stated]: Phi_xi = 1/2 Bxi xi'^2. {test_rayleigh_terms}
        """
        return self.damping * rate**2 / 2

    def torque(self, deflection: Any, rate: Any) -> Any:
        """Gear torque sigma = Cxi xi + Bxi xi' [N*m], by the gear on the motor (and, negative, on the link)."""
        return self.stiffness * deflection + self.damping * rate
