"""What looks like a wrong unit in a data sheet of either kind."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tmodes.paper.sheet import PaperRobot
    from tmodes.sheet import Robot

__all__ = ["notices_about"]


def notices_about(sheet: PaperRobot | Robot) -> list[str]:
    """Sentences on numbers that look like a wrong unit, and of an arm on what was put right in reading it."""
    from tmodes.io.plausible import implausible
    from tmodes.io.sheet_plausible import arm_notices, implausible_arm
    from tmodes.sheet import Robot

    return [*implausible_arm(sheet), *arm_notices(sheet)] if isinstance(sheet, Robot) else implausible(sheet)
