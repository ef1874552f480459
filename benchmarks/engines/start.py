"""What the first use of a robot costs, measured in a process of its own: compile, first call, reload, memory.

``python -m benchmarks.engines.start JOINTS`` prints it as JSON, with whatever cache ``TMODES_CACHE`` names.
"""

from __future__ import annotations

import json
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from benchmarks.engines.contender import now

__all__ = ["started"]

ROOT = Path(__file__).resolve().parents[2]

_STARTS = 3
"""Processes with an empty cache, and as many that find it full: of each the median is reported."""


def started(joints: int) -> dict[str, float]:
    """Times [s] and peak memory [bytes] of fresh processes with an empty cache, and of further ones that find it full.

    ``equations``: schedule and numbers of the chain; ``compile``: native code, emission included; ``first_call``: one
    state; ``reload``: native code from the cache; ``memory``: the largest of a first process, ``memory_before``: of
    which it had before.
    """
    with tempfile.TemporaryDirectory() as folder:
        caches = [Path(folder, f"cache{k}") for k in range(_STARTS)]
        first, later = ([_process(joints, cache) for cache in caches] for _ in ("empty", "full"))
        entries = list(caches[0].iterdir())
        size = sum(entry.stat().st_size for entry in entries)
    reload = statistics.median(one["compile"] for one in later)
    info = {name: statistics.median(one[name] for one in first) for name in first[0]}
    return info | {"reload": reload, "cache_entries": len(entries), "cache_bytes": size}


def _process(joints: int, cache: Path) -> dict[str, Any]:
    command = [sys.executable, "-m", "benchmarks.engines.start", str(joints)]
    environment = os.environ | {"TMODES_CACHE": str(cache)}
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def _here(joints: int) -> dict[str, float]:
    import numpy as np
    from benchmarks.engines.ours import Ours
    from benchmarks.engines.rigid import RigidChain

    import tmodes.compile.ir.block  # with what it imports: loading Python code is no compiling
    import tmodes.compile.native
    from tmodes.compile.cache import source_digest

    for once_a_process in (tmodes.compile.native.host, source_digest):
        once_a_process()
    before, marks = _peak(), [now()]
    ours = Ours(RigidChain(joints))
    marks.append(now())
    ours.library("double")
    marks.append(now())
    ours.model.forward_dynamics(np.zeros(joints), np.zeros(joints))
    marks.append(now())
    names = ("equations", "compile", "first_call")
    return dict(zip(names, np.diff(marks).tolist(), strict=True)) | {"memory": _peak(), "memory_before": before}


def _peak() -> float:
    """Largest memory of this process so far [bytes]; 0 where the system does not tell."""
    if sys.platform == "linux":  # not by getrusage: it also counts the process that started this one
        lines = Path("/proc/self/status").read_text(encoding="utf-8").splitlines()
        return next(1024.0 * int(line.split()[1]) for line in lines if line.startswith("VmHWM"))
    if sys.platform == "win32":
        return 0.0
    import resource

    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return float(peak if sys.platform == "darwin" else peak * 1024)


if __name__ == "__main__":
    print(json.dumps(_here(int(sys.argv[1]))))
