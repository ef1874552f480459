"""The clock of the benchmark: processor time, which other programs on the machine trouble least."""

from __future__ import annotations

import sys
import time

__all__ = ["now"]

now = time.perf_counter if sys.platform == "win32" else time.process_time
"""Seconds of this process on processors, all its threads together; on Windows, where that is coarse, by the wall.

Only contenders that work on several cores at once are timed by the wall everywhere.
"""
