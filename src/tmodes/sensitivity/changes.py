"""How the numbers of a run change with the quantities of its data sheet."""

from __future__ import annotations

from tmodes.paper.sheet import PaperRobot
from tmodes.sensitivity.changes_motion import RunChanges
from tmodes.sensitivity.changes_paper import RobotChanges
from tmodes.sensitivity.differences import Change
from tmodes.sensitivity.lowering import Lowered
from tmodes.sheet import Robot

__all__ = ["Change", "Changes"]


class Changes:
    """Derivatives of a run's numbers by quantities of its sheet, those of the robot as known."""

    def __init__(self, sheet: Robot | PaperRobot, here: Lowered) -> None:
        self._of = RobotChanges(sheet, here) if isinstance(sheet, PaperRobot) else RunChanges(sheet, here)

    def along(self, path: str) -> Change:
        """By one quantity.

        Raises :class:`tmodes.errors.InputError` for a path at which no number other than 0 stands (in signals 0 will
        do), and for one that changes more than numbers: the structure, or the times of the signals.
        """
        return self._of.along(path)
