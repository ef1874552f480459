"""The data sheet of any robot: what a person writes, checked once, and its way to a Chain."""

from tmodes.sheet.robot import MOST_JOINTS, SHEET_FORMAT, Robot, RobotPair

__all__ = ["MOST_JOINTS", "SHEET_FORMAT", "Robot", "RobotPair"]
