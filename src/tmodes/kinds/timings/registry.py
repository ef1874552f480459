"""The timings that tmodes brings; ``@TIMINGS.register`` adds more."""

from __future__ import annotations

from tmodes.kinds.timings.contract import TIMINGS, JointCourse, Timing

__all__ = ["TIMINGS", "JointCourse", "Timing"]

TIMINGS.bring("tmodes.kinds.timings", {"toppra": "toppra", "jerk_limited": "jerk_limited"})
