"""The prescribed drive: the joint's motion is given, and what it takes follows."""

from __future__ import annotations

from typing import Any

from tmodes.kinds.drives.contract import DRIVES, Angles, DriveKind, DriveLaw, Elastic, Forward

__all__ = ["Prescribed"]


@DRIVES.register
class Prescribed(DriveKind):
    """The joint's acceleration is an input."""

    name = "prescribed"
    summary = "motion of the joint given"
    is_given = True

    def forward(self, law: DriveLaw, at: Angles, effort: Any, held: Any, step: Any) -> Forward:
        """The effort is the given acceleration."""
        del law, at, held, step
        return Forward(effort, 0.0)

    def elastic(self, law: DriveLaw, at: Angles) -> Elastic:
        """Nothing that the motion would feel."""
        del law, at
        return Elastic(0.0)
