"""Composite control by singular perturbation: a law of the rigid robot, and damping of what the gears add."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from tmodes.kinds.controllers.contract import CONTROLLERS, Measured
from tmodes.kinds.controllers.model_based import AllDrives
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.schema.quantity import not_negative

__all__ = ["SingularPerturbation"]


@CONTROLLERS.register
class SingularPerturbation(AllDrives):
    """u = (M + J) a + c + g + b q' + 2 D sqrt(k J) (q' - th'), a = r'' + Kv (r' - q') + Kp (r - q), of the joints.

    Slow: computed torque of the robot as if its gears were rigid; fast: a damper on what winds the gears, with the
    ratio D to the rotor on its gear. Its error falls as 1/sqrt(k), the rate of the gears, which must be fast against
    sqrt(Kp): the corrections of an integral manifold are left out (M. W. Spong, Modeling and control of elastic joint
    robots, ASME J. Dyn. Sys. Meas. Control 109, 1987; P. Kokotovic, H. K. Khalil, J. O'Reilly, Singular Perturbation
    Methods in Control, 1986).
    """

    type: Literal["singular_perturbation"] = Field(description="kind of controller")
    position_gain: float = not_negative("1/s^2", "Kp", "stiffness over inertia, the square of a rate")
    velocity_gain: float = not_negative("1/s", "Kv", "damping over inertia; 2 sqrt(Kp) is critical")
    fast_damping: float = not_negative("1", "D", "damping ratio of rotors on their gears", default=0.7, at_most=10.0)

    def numbers(self) -> tuple[Any, ...]:
        """Kp, Kv, D."""
        return self.position_gain, self.velocity_gain, self.fast_damping

    def command(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """As above."""
        del x
        (q, v), (_, thd), (r, rate, push) = m.joints(), m.motors(), self.references(m)
        a = [push[k] + p[1] * (rate[k] - v[k]) + p[0] * (r[k] - q[k]) for k in range(len(q))]
        rows = zip(m.model.torque(q, v, a), m.model.inertia, m.model.viscous, m.model.stiffness, a, v, thd, strict=True)
        return self.chosen(
            m,
            [
                load + inertia * acc + b * turns + 2 * p[2] * f.sqrt(k * inertia) * (turns - motor)
                for load, inertia, b, k, acc, turns, motor in rows
            ],
        )
