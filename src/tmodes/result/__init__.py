"""The result of a run: its series and lines with units, and what is asked of it."""

from tmodes.result.result import Result, assemble_result

__all__ = ["Result", "assemble_result"]
