"""The free joint: nothing drives or holds it."""

from __future__ import annotations

from typing import Any

from tmodes.kinds.drives.contract import DRIVES, Angles, DriveKind, DriveLaw, Elastic, Forward

__all__ = ["Free"]


@DRIVES.register
class Free(DriveKind):
    """Friction of the joint alone."""

    name = "free"
    summary = "nothing but friction of the joint"

    def forward(self, law: DriveLaw, at: Angles, effort: Any, held: Any, step: Any) -> Forward:
        """Friction of the joint."""
        del effort, held
        joint, joint_slope = law.joint_friction(at.joint_rate)
        return Forward(-joint, step * joint_slope)

    def elastic(self, law: DriveLaw, at: Angles) -> Elastic:
        """Friction of the joint."""
        joint, _ = law.joint_friction(at.joint_rate)
        return Elastic(joint, lost_in_friction=joint * at.joint_rate)
