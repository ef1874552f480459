"""The result of an arm's run: its series and lines with units, and what they say."""

from tmodes.result.result import ArmResult, assemble_arm, load_result

__all__ = ["ArmResult", "assemble_arm", "load_result"]
