"""The DC motor: electric power in, torque on the gear's input out. All quantities after the reducer."""

from __future__ import annotations

from typing import Any

from tmodes.kinds.schema.quantity import DataSheet, dissipation, positive

__all__ = ["Motor"]


class Motor(DataSheet):
    """A DC motor with its reducer, every quantity referred to the output side of the reducer (S = 1).

    The methods take numbers or symbols, voltage [V] and speed theta' [rad/s], so the same lines serve the equations
    and a hand calculation.
    """

    resistance: float = positive("ohm", "R", "armature resistance", plausible=(1e-3, 1e3))
    back_emf_constant: float = positive("V*s/rad", "CE", "back electromotive force constant, after the reducer")
    torque_constant: float = positive("N*m/A", "CM", "torque constant, after the reducer")
    inertia: float = positive("kg*m^2", "I", "rotor inertia, reflected after the reducer", plausible=(1e-6, 1e4))
    friction: float = dissipation("N*m*s/rad", "Bm", "viscous friction of the motor, after the reducer")

    def current(self, voltage: Any, speed: Any) -> Any:
        """Armature current [A].

        Eq. (39) [stated]: u = R i + CE theta', so i = (u - CE theta')/R. {test_motor_row_is_in_newton_metres}
        """
        return (voltage - self.back_emf_constant * speed) / self.resistance

    def torque(self, voltage: Any, speed: Any) -> Any:
        """Electromagnetic torque CM i after the reducer [N*m]: what the motor brings in."""
        return self.torque_constant * self.current(voltage, speed)

    def kinetic(self, speed: Any) -> Any:
        """Kinetic energy of the rotor [J]."""
        return self.inertia * speed**2 / 2

    def friction_loss(self, speed: Any) -> Any:
        """Power lost in the motor's friction [W], never negative."""
        return self.friction * speed**2
