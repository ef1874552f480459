"""A robot's equations as a module: bytes, and the time to make it, in a process that finds an empty cache.

python -m benchmarks.page_modules ROBOT METHOD    (seed, two links, stiff)
"""

from __future__ import annotations

import gzip
import json
import os
import subprocess
import sys
import tempfile
import time
from typing import Any, NamedTuple

__all__ = ["Module", "module_of"]


class Module(NamedTuple):
    """Bytes of the module, of it compressed, of that as text in a page; seconds to make it."""

    raw: int
    packed: int
    text: int
    seconds: float


def module_of(name: str, method: str) -> Module:
    """Of the robot's time loops by one method, measured in a process of its own."""
    with tempfile.TemporaryDirectory() as cache:
        info = [sys.executable, "-m", "benchmarks.page_modules", name, method]
        done = subprocess.run(
            info, env=os.environ | {"TMODES_CACHE": cache}, capture_output=True, text=True, check=True
        )
    return Module(*json.loads(done.stdout))


def _made(sheet: Any, method: str) -> bytes:
    """The module, as a report of this robot's run holds it; equations and emission included."""
    from tmodes.live.functions import ModelFunctions, live_module

    stations = tuple(k / 20 for k in range(21))
    return live_module(ModelFunctions(sheet.pair(), stations), [method], slopes=False).wasm


if __name__ == "__main__":
    from .page_robots import ROBOTS

    if len(sys.argv) != 3 or sys.argv[1] not in ROBOTS:
        sys.exit(f"{__doc__}\nROBOT is one of: {', '.join(ROBOTS)}")
    sheet = ROBOTS[sys.argv[1]][1]()
    began = time.perf_counter()
    wasm = _made(sheet, sys.argv[2])
    seconds = time.perf_counter() - began
    packed = len(gzip.compress(wasm, 9, mtime=0))
    print(json.dumps([len(wasm), packed, -(-packed // 3) * 4, seconds]))
