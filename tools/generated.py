"""What the tools that write a file share: write it, or with ``--check`` say whether the one that stands is the same."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

__all__ = ["ROOT", "main"]

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT))
"""Where benchmarks are found, too."""


def main(target: Path, text: str, tool: str, problems: Sequence[str] = ()) -> int:
    """Write ``text`` to ``target``, or check it; returns the exit code."""
    checking = "--check" in sys.argv[1:]
    problems = list(problems)
    if checking and (not target.is_file() or target.read_text(encoding="utf-8") != text):
        problems.append(f"{target.relative_to(ROOT)} is not up to date: run python tools/{tool}.py")
    if not checking:
        target.write_text(text, encoding="utf-8")
    for line in problems:
        print(line, file=sys.stderr)
    return 1 if problems and checking else 0
