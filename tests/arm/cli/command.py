"""The command as a user runs it."""

from __future__ import annotations

import subprocess
import sys

__all__ = ["tmodes"]


def tmodes(*arguments: object, code: int = 0) -> subprocess.CompletedProcess[str]:
    """Run the command; a traceback is never right."""
    line = [sys.executable, "-m", "tmodes.cli.entry", *map(str, arguments)]
    done = subprocess.run(line, capture_output=True, text=True, check=False)
    assert "Traceback" not in done.stderr
    assert done.returncode == code, done.stderr
    return done
