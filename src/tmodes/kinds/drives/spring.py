"""The spring: an elastic gear whose motor is locked."""

from __future__ import annotations

from typing import Any

from tmodes.kinds.drives.contract import DRIVES, Angles, DriveKind, DriveLaw, Elastic, Forward

__all__ = ["Spring"]


@DRIVES.register
class Spring(DriveKind):
    """The joint swings about where the motor is locked."""

    name = "spring"
    summary = "elastic gear with a locked motor"
    has_gear = True

    def forward(self, law: DriveLaw, at: Angles, effort: Any, held: Any, step: Any) -> Forward:
        """Spring and damper less friction of the joint."""
        del effort, held
        joint, joint_slope = law.joint_friction(at.joint_rate)
        torque, stiffness = law.spring(law.rest - at.joint)
        torque = torque + law.damping * (0.0 - at.joint_rate)
        added = step * law.damping + step * step * stiffness
        return Forward(torque - joint, added + step * joint_slope)

    def elastic(self, law: DriveLaw, at: Angles) -> Elastic:
        """Spring and damper, friction of the joint."""
        joint, _ = law.joint_friction(at.joint_rate)
        torque, _ = law.spring(law.rest - at.joint)
        rate = 0.0 - at.joint_rate
        torque = torque + law.damping * rate
        lost = joint * at.joint_rate
        return Elastic(joint - torque, torque, law.stored(law.rest - at.joint), law.damping * rate * rate, lost)
