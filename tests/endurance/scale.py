"""How much is enough: a little at every change, all of it by night (`TMODES_ENDURANCE=1`, see .ci/nightly)."""

from __future__ import annotations

import gc
import os
import sys
from pathlib import Path

import pytest

__all__ = ["memory", "often"]


def often(by_day: int, by_night: int) -> int:
    """A number of repetitions."""
    return by_night if os.environ.get("TMODES_ENDURANCE") else by_day


def memory() -> float:
    """Memory of this process [MB]; the test is skipped where the system does not tell."""
    if sys.platform != "linux":
        pytest.skip("the memory of a process is read from /proc")
    gc.collect()
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("VmRSS")) / 1024
