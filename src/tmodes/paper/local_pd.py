"""Local control: each motor corrects its own position and speed, by voltage."""

from __future__ import annotations

from typing import Any

from tmodes.kinds.schema.quantity import DataSheet, not_negative

__all__ = ["LocalPD"]


class LocalPD(DataSheet):
    """Proportional-derivative control of the motor angle."""

    position_gain: float = not_negative("V/rad", "Klp", "position gain")
    velocity_gain: float = not_negative("V*s/rad", "Klv", "velocity gain")

    def command(self, wanted: Any, wanted_rate: Any, measured: Any, measured_rate: Any) -> Any:
        """Motor voltage [V] from wanted and measured motor angles [rad] and their rates [rad/s].

        Eq. (41) [stated]: u = Klp (theta_o - theta) + Klv (theta_o' - theta'). {test_local_pd}
        """
        return self.position_gain * (wanted - measured) + self.velocity_gain * (wanted_rate - measured_rate)
