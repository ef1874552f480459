"""What looks like a wrong unit in a data sheet."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tmodes.sheet import Robot

__all__ = ["notices_about"]


def notices_about(sheet: Robot) -> list[str]:
    """Sentences on numbers that look like a wrong unit, and on what was corrected when the sheet was read."""
    from tmodes.io.sheet_plausible import arm_notices, implausible_arm

    return [*implausible_arm(sheet), *arm_notices(sheet)]
