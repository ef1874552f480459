"""The result of an arm's run: its series and lines with units, and what they say."""

from tmodes.result.result import Result, assemble_result, load_result

__all__ = ["Result", "assemble_result", "load_result"]
