"""The direct drive: an effort on the joint; a motor behind a rigid gear adds its inertia and friction."""

from __future__ import annotations

from typing import Any

from tmodes.kinds.drives.contract import DRIVES, Angles, DriveKind, DriveLaw, Elastic, Forward

__all__ = ["Effort"]


@DRIVES.register
class Effort(DriveKind):
    """The joint's effort is given."""

    name = "effort"
    summary = "effort on the joint, motor behind a rigid gear"
    takes_effort = True

    def forward(self, law: DriveLaw, at: Angles, effort: Any, held: Any, step: Any) -> Forward:
        """Effort less friction of joint and motor."""
        joint, joint_slope = law.joint_friction(at.joint_rate)
        motor, motor_slope = law.motor_friction(at.joint_rate)
        return Forward(effort - joint - motor, law.inertia + step * (joint_slope + motor_slope) + held)

    def elastic(self, law: DriveLaw, at: Angles) -> Elastic:
        """Friction alone."""
        joint, _ = law.joint_friction(at.joint_rate)
        motor, _ = law.motor_friction(at.joint_rate)
        return Elastic(joint + motor, lost_in_friction=(joint + motor) * at.joint_rate)
