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
        gear = law.gear(*self.wound(law, at))
        added = step * gear.damping + step * step * gear.stiffness
        return Forward(gear.torque - joint, added + step * joint_slope)

    def elastic(self, law: DriveLaw, at: Angles) -> Elastic:
        """Spring and damper, friction of the joint."""
        joint, _ = law.joint_friction(at.joint_rate)
        gear = law.gear(*self.wound(law, at))
        lost = joint * at.joint_rate
        return Elastic(joint - gear.torque, gear.torque, law.stored(law.rest - at.joint), gear.lost, lost)
