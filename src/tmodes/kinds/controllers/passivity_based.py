"""Passivity-based tracking of elastic joints: what the gears store is left to them, damping is put on the links."""

from __future__ import annotations

from typing import Any, ClassVar, Literal

from pydantic import Field

from tmodes.kinds.controllers.contract import CONTROLLERS, Measured
from tmodes.kinds.controllers.model_based import AllDrives
from tmodes.kinds.schema.quantity import not_negative

__all__ = ["PassivityBased"]


@CONTROLLERS.register
class PassivityBased(AllDrives):
    """u = J (r'' + n''/k) + b th' + n - J (Kp h + Kv h'), h = th - r - n/k, n = M (r'' - D e') + C r' + g, e = q - r.

    Then M e'' + (C + D M) e' = k (h - e) and J h'' + J Kv h' + J Kp h = k (e - h): the robot itself with its gears,
    about the motion, with dampers on links and motors. The energy e' M e'/2 + h' J h'/2 + (h - e) k (h - e)/2 +
    h J Kp h/2 falls by D e' M e' + h' J Kv h' and never grows (M. Keppler, D. Lakatos, C. Ott, A. Albu-Schaeffer,
    Elastic structure preserving (ESP) control for compliantly actuated robots, IEEE Trans. Robotics 34, 2018; after
    R. Ortega, A. Loria, P. J. Nicklasson, H. Sira-Ramirez, Passivity-based Control of Euler-Lagrange Systems, 1998).
    C is that of Christoffel's symbols; q'' and q''' are those of the gears' torques, so that n'' needs no derivative of
    a measurement. Setpoints are the joints' angles, with four derivatives.
    """

    setpoint_orders: ClassVar[int] = 5
    needs_gears: ClassVar[bool] = True

    type: Literal["passivity_based"] = Field(description="kind of controller")
    damping: float = not_negative("1/s", "D", "damping over inertia, of the links")
    position_gain: float = not_negative("1/s^2", "Kp", "stiffness over inertia, of the motors")
    velocity_gain: float = not_negative("1/s", "Kv", "damping over inertia, of the motors")

    def numbers(self) -> tuple[Any, ...]:
        """D, Kp, Kv."""
        return self.damping, self.position_gain, self.velocity_gain

    def command(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """As above."""
        del x
        (q, v), (th, thd), model, count = m.joints(), m.motors(), m.model, range(len(m.drives))
        wound = [model.stiffness[k] * (th[k] - q[k]) for k in count]
        a = model.acceleration(q, v, wound)
        jerk = model.jerk(q, v, a, [model.stiffness[k] * (thd[k] - v[k]) for k in count])
        r = [[m.setpoint(joint)[order] for joint in m.drives] for order in range(self.setpoint_orders)]

        def wanted(q: list[Any], r: list[Any]) -> list[Any]:
            push = [r[2][k] - p[0] * (q[1][k] - r[1][k]) for k in count]
            return model.torque_along(q[0], q[1], r[1], push)

        n, rate, second = model.time_derivatives(wanted, [q, v, a, jerk], r)
        found = []
        for k in count:
            stiffness, inertia = model.stiffness[k], model.inertia[k]
            far = th[k] - r[0][k] - n[k] / stiffness
            moves = thd[k] - r[1][k] - rate[k] / stiffness
            turn = r[2][k] + second[k] / stiffness - p[1] * far - p[2] * moves
            found.append(inertia * turn + model.viscous[k] * thd[k] + n[k])
        return self.chosen(m, found)
