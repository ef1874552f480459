"""What looks like a wrong unit in a data sheet of either kind."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tmodes.arm import Arm
    from tmodes.robot import Robot

__all__ = ["doubts_about"]


def doubts_about(sheet: Robot | Arm) -> list[str]:
    """Sentences on numbers that look like a wrong unit, and of an arm on what was put right in reading it."""
    from tmodes.arm import Arm
    from tmodes.io.arm_plausible import arm_notices, implausible_arm
    from tmodes.io.plausible import implausible

    return [*implausible_arm(sheet), *arm_notices(sheet)] if isinstance(sheet, Arm) else implausible(sheet)
