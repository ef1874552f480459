"""Controllers that compute with the robot as known: gravity compensation, computed torque, feedback linearisation.

All command efforts, and see positions and rates of motors and joints; the model has rigid links.
"""

from __future__ import annotations

from typing import Any, ClassVar, Literal

from pydantic import Field

from tmodes.kinds.controllers.contract import CONTROLLERS, Controller, Measured
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel import vectors
from tmodes.kinds.schema.quantity import not_negative, positive

__all__ = ["AllDrives", "ComputedTorque", "FeedbackLinearisation", "GravityPD"]


@CONTROLLERS.register
class GravityPD(Controller):
    """PD of the motor with gravity compensation; its setpoint is the joint's angle behind the gear.

    u = Kp (th_d - th) + Kv (q_d' - th') + g(q_d), th_d = q_d + g(q_d)/k: motors are put where their gears sag. With
    ``online`` g is of the angles th - g/k, which follow the motor. Stable where Kp and k are large enough (P. Tomei, A
    simple PD controller for robots with elastic joints, IEEE Trans. Autom. Control 36, 1991).
    """

    sees_all: ClassVar[bool] = True
    needs_joint: ClassVar[bool] = True
    needs_model: ClassVar[bool] = True
    commands_effort: ClassVar[bool] = True

    type: Literal["gravity_pd"] = Field(description="kind of controller")
    position_gain: float = not_negative("gain", "Kp", "position gain")
    velocity_gain: float = not_negative("gain*s", "Kv", "velocity gain")
    online: bool = Field(default=False, description="gravity of the angles where the motors are, not of the setpoints")

    def numbers(self) -> tuple[float, ...]:
        """Kp, Kv."""
        return self.position_gain, self.velocity_gain

    def command(self, p: Any, m: Measured, x: list[Any]) -> Any:
        """As above."""
        del x
        own = m.drives.index(m.joint)
        wanted = [m.setpoint(joint)[0] for joint in m.drives]
        holding = m.model.gravity(wanted)
        sag = [_sag(load, k) for load, k in zip(holding, m.model.stiffness, strict=True)]
        aim, load = m.wanted + sag[own], holding[own]
        if self.online:
            seen = [th - each for th, each in zip(m.motors()[0], sag, strict=True)]
            load = m.model.gravity(seen)[own]
        return p[0] * (aim - m.position) + p[1] * (m.wanted_rate - m.velocity) + load

    @property
    def structure(self) -> str:
        """Which gravity is part of the code."""
        return f"{super().structure}{' online' * self.online}"


def _sag(load: Any, stiffness: Any) -> Any:
    """How far a gear is wound by a load; nothing where it is rigid."""
    return f.if_else(stiffness > 0, load / f.if_else(stiffness > 0, stiffness, 1.0), 0.0)


class AllDrives(Controller):
    """Of all drives at once: written in the section `control`."""

    sees_all: ClassVar[bool] = True
    needs_drives: ClassVar[bool] = True
    needs_model: ClassVar[bool] = True
    commands_effort: ClassVar[bool] = True

    sample_time: float | None = positive(
        "s", "T", "time between samples; none: at every instant", default=None, plausible=(1e-5, 1.0)
    )

    @property
    def period(self) -> float | None:
        """T [s]."""
        return self.sample_time

    def chosen(self, m: Measured, efforts: list[Any]) -> list[Any]:
        """Those of the drives that it commands."""
        return [efforts[m.drives.index(joint)] for joint in m.commands]

    def references(self, m: Measured) -> list[list[Any]]:
        """Setpoints of all drives, their rates and accelerations."""
        each = [m.setpoint(joint) for joint in m.drives]
        return [[one[k] for one in each] for k in range(3)]


@CONTROLLERS.register
class ComputedTorque(AllDrives):
    """u = M(q) (r'' + Kv (r' - q') + Kp (r - q)) + c(q, q') + g(q) + b q', of the motors' angles.

    J. Y. S. Luh, M. W. Walker, R. P. C. Paul, Resolved-acceleration control of mechanical manipulators, IEEE Trans.
    Autom. Control 25, 1980.
    """

    type: Literal["computed_torque"] = Field(description="kind of controller")
    position_gain: float = not_negative("1/s^2", "Kp", "stiffness over inertia, the square of a rate")
    velocity_gain: float = not_negative("1/s", "Kv", "damping over inertia; 2 sqrt(Kp) is critical")

    def numbers(self) -> tuple[float, ...]:
        """Kp, Kv."""
        return self.position_gain, self.velocity_gain

    def command(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """As above, with rotors."""
        del x
        (q, v), (r, rate, push) = m.motors(), self.references(m)
        a = [push[k] + p[1] * (rate[k] - v[k]) + p[0] * (r[k] - q[k]) for k in range(len(q))]
        torque = m.model.torque(q, v, a)
        rows = zip(torque, m.model.inertia, m.model.viscous, a, v, strict=True)
        return self.chosen(m, [load + inertia * acc + b * turns for load, inertia, b, acc, turns in rows])


@CONTROLLERS.register
class FeedbackLinearisation(AllDrives):
    """Elastic joints made four integrators: q'''' = s, with all poles of the error at ``pole``.

    Of states q, q', th, th' and a rigid model of the links: a = q'' and q''' from the gears' torques, then
    u = J th'' + k (th - q) + b th' for the q'''' that is wanted (M. W. Spong, ASME J. Dyn. Sys. Meas. Control 109,
    1987). Setpoints are the joints' angles; their third and fourth derivatives are taken from the signals.
    """

    setpoint_orders: ClassVar[int] = 5
    needs_gears: ClassVar[bool] = True
    tuned: ClassVar[tuple[str, ...]] = ("pole",)

    type: Literal["feedback_linearisation"] = Field(description="kind of controller")
    pole: float = positive("1/s", "l", "where the four poles of each joint's error are, to the left", at_most=1e5)

    def numbers(self) -> tuple[float, ...]:
        """The pole."""
        return (self.pole,)

    def command(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """As above."""
        del x
        (q, v), (th, thd), model, n = m.joints(), m.motors(), m.model, len(m.drives)
        wound = [model.stiffness[k] * (th[k] - q[k]) for k in range(n)]
        moved = [model.stiffness[k] * (thd[k] - v[k]) for k in range(n)]
        a = model.acceleration(q, v, wound)
        jerk = model.jerk(q, v, a, moved)
        references, rate = [m.setpoint(joint) for joint in m.drives], p[0]
        gains = 4 * rate, 6 * rate * rate, 4 * rate**3, rate**4
        s = [
            vectors.total([r[4], *(k * far for k, far in zip(gains, fars, strict=True))])
            for r, *fars in (
                (r, r[3] - jerk[k], r[2] - a[k], r[1] - v[k], r[0] - q[k]) for k, r in enumerate(references)
            )
        ]
        _, _, second = model.torque_rates(q, v, a, jerk, s)
        rows = zip(model.inertia, model.viscous, model.stiffness, a, second, wound, thd, strict=True)
        return self.chosen(
            m, [inertia * (acc + tau / k) + load + b * turns for inertia, b, k, acc, tau, load, turns in rows]
        )
