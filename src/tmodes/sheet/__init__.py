"""The data sheet of any arm: what a person writes, checked once, and its way to a Chain."""

from tmodes.sheet.robot import ARM_FORMAT, MOST_JOINTS, Robot, RobotPair

__all__ = ["ARM_FORMAT", "MOST_JOINTS", "Robot", "RobotPair"]
