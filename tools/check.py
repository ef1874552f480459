"""One command each for what a change must pass: ``python tools/check.py lint|format|types|imports|docs|test|bench``.

``all`` is every check but the benchmarks. Exit code 0 when everything passed.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path

__all__ = ["CHECKS", "main"]

ROOT = Path(__file__).resolve().parents[1]
PYTHON = sys.executable
FOLDERS = ("src", "tools", "tests", "benchmarks")

CHECKS: dict[str, tuple[tuple[str, ...], ...]] = {
    "lint": ((PYTHON, "-m", "ruff", "check", *FOLDERS),),
    "format": ((PYTHON, "-m", "ruff", "format", "--check", *FOLDERS),),
    "types": ((PYTHON, "-m", "basedpyright", "--pythonpath", PYTHON, "--threads", str(os.cpu_count() or 1)),),
    "imports": ((str(Path(PYTHON).with_name("lint-imports")),),),
    "docs": tuple(
        (PYTHON, f"tools/{tool}.py", "--check")
        for tool in ("equations_doc", "notation_doc", "robot_schema", "performance_doc", "errors_doc", "links")
    ),
    "test": ((PYTHON, "-m", "pytest", "--quiet"),),
    "bench": ((PYTHON, "-m", "pytest", "--quiet", "--benchmark-enable", "--benchmark-only", "benchmarks", "tests"),),
}


def main(wanted: list[str]) -> int:
    """Run the wanted checks, all of them even when one fails; returns the exit code."""
    names = [name for name in CHECKS if name != "bench"] if wanted == ["all"] else wanted
    unknown = [name for name in names if name not in CHECKS]
    if unknown or not names:
        print(f"which check? got {unknown or 'none'}; expected {', '.join(CHECKS)} or all", file=sys.stderr)
        return 2
    failed = [name for name in names if not passes(name)]
    print(f"failed: {', '.join(failed)}" if failed else f"passed: {', '.join(names)}")
    return 1 if failed else 0


def passes(name: str) -> bool:
    """Run the commands of one check, each to its end."""
    print(f"== {name}", flush=True)
    start = time.monotonic()
    codes = [subprocess.run(command, cwd=ROOT, check=False).returncode for command in CHECKS[name]]
    print(f"== {name}: {'failed' if any(codes) else 'passed'} in {time.monotonic() - start:.1f} s", flush=True)
    return not any(codes)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
