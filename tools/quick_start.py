"""Prints a command of the README's quick start: ``python tools/quick_start.py 1`` (the run) or ``2`` (the tests).

So what is run by machines is what a reader is given, to the letter.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

__all__ = ["quick_start"]


def quick_start(readme: str) -> list[str]:
    """The command lines of the first fenced block under ``## Quick start``."""
    block = re.search(r"^## Quick start$.*?^```\w*\n(.*?)^```$", readme, re.MULTILINE | re.DOTALL)
    return block[1].splitlines() if block else []


if __name__ == "__main__":
    readme = Path(__file__).resolve().parents[1] / "README.md"
    print(quick_start(readme.read_text(encoding="utf-8"))[int(sys.argv[1]) - 1])
