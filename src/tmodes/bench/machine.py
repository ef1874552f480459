"""The machine and the programs that a benchmark ran with, named so that its numbers mean something later."""

from __future__ import annotations

import os
import platform
import sys
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from tmodes.bench.ours import cores

__all__ = ["described"]

_PACKAGES = ("casadi", "llvmlite", "numpy", "scipy", "pin", "mujoco", "exudyn")


def described() -> dict[str, object]:
    """Processor, cores, system, load, versions, and the date (UTC)."""
    import tmodes

    return {
        "date": datetime.now(UTC).strftime("%Y-%m-%d"),
        "processor": _processor(),
        "cores": cores(),
        "load": list(os.getloadavg()) if hasattr(os, "getloadavg") else [],
        "system": f"{platform.system()} {platform.machine()}",
        "python": sys.version.split()[0],
        "tmodes": tmodes.__version__,
        **{name: found for name in _PACKAGES if (found := _version(name))},
    }


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return ""


def _processor() -> str:
    """The name that the system gives it, with the name that LLVM gives its architecture."""
    from tmodes.compile.native import processor

    info = ""
    if sys.platform == "linux":
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace").splitlines()
        info = next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "")
    return f"{info or platform.processor() or platform.machine()} ({processor()})"
