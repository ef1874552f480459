"""The elastic drive: a motor with its own coordinate behind an elastic gear.

Motor row, the sign of the gear torque turned against the paper's: I th'' = u - friction - tg, tg = C(xi) + B xi',
xi = th - ga; the rotor's gyroscopic coupling with the links is dropped (Spong, "Modeling and control
of elastic joint robots", ASME J. Dyn. Sys. 109, 1987, assumption A2).
"""

from __future__ import annotations

from typing import Any

from tmodes.kinds.drives.contract import DRIVES, Angles, DriveKind, DriveLaw, Elastic, Forward

__all__ = ["ElasticDrive"]


@DRIVES.register
class ElasticDrive(DriveKind):
    """The motor's effort is given."""

    name = "elastic"
    summary = "motor behind an elastic gear"
    has_motor = takes_effort = has_gear = True

    def forward(self, law: DriveLaw, at: Angles, effort: Any, held: Any, step: Any) -> Forward:
        """The motor is eliminated: its row adds to the joint's effort and inertia in an implicit step.

        Eq. (39) [corrected]: CM i = I theta'' + Bm theta' - sigma with u = R i + CE theta' put in; in the print this
        row is in volts where the others are in N*m. {test_motor_row_is_in_newton_metres}
        Slip (40): the motor's row is in volts, the others in N*m {test_motor_row_is_in_newton_metres}
        """
        joint, joint_slope = law.joint_friction(at.joint_rate)
        gear = law.gear(*self.wound(law, at))
        added = step * gear.damping + step * step * gear.stiffness
        motor, motor_slope = law.motor_friction(at.motor_rate)
        share = 1 / (law.inertia + step * motor_slope + held + added)
        rest = effort - gear.torque - motor
        own = added - added * added * share + step * joint_slope
        return Forward(gear.torque - joint + added * share * rest, own, (rest, added, share))

    def elastic(self, law: DriveLaw, at: Angles) -> Elastic:
        """Spring and damper of the gear, friction of joint and motor.

        Eq. (25) [stated]: Phi_xi = 1/2 Bxi xi'^2, half of the power lost. {test_rayleigh_terms}
        """
        joint, _ = law.joint_friction(at.joint_rate)
        gear = law.gear(*self.wound(law, at))
        motor, _ = law.motor_friction(at.motor_rate)
        lost = joint * at.joint_rate + motor * at.motor_rate
        energy = law.stored(at.motor - at.joint)
        return Elastic(joint - gear.torque, gear.torque + motor, energy, gear.lost, lost)
