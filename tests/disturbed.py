"""Runs that are interrupted or killed in the middle, at moments that do not depend on the machine's speed."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from command import started
from patience import until

__all__ = ["running"]

_KEEP_OFTEN = """
from tmodes.io import checkpoint
checkpoint.RunJournal.__init__.__defaults__ = (0.05,)
from tmodes.cli.entry import start
start()
"""
"""The command, but for its journals: they keep the progress every twentieth of a second, not every two seconds."""


@contextmanager
def running(line: Sequence[object], out: Path, stage: str) -> Iterator[subprocess.Popen[str]]:
    """The command line, started, once the journal of a stage of its run has records; the caller ends it."""
    command = [sys.executable, "-c", _KEEP_OFTEN, *map(str, line), "--out", str(out)]
    with started(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as process:
        try:
            journal = out / f".checkpoint-{stage}"
            before = journal.stat().st_size if journal.exists() else 0

            def written() -> bool:
                assert process.poll() is None, f"ended before its journal was written: {process.communicate()}"
                return journal.exists() and journal.stat().st_size > before

            until(written, "the journal")
            yield process
        finally:
            process.kill()
