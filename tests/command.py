"""The command line in this process: what a user sees of a command, without a new interpreter for each."""

from __future__ import annotations

import io
import os
import signal
import subprocess
import sys
from collections.abc import Mapping, Sequence
from contextlib import chdir, nullcontext, redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from unittest.mock import patch

from tmodes.cli.main import main

__all__ = ["COMMAND", "Done", "called", "started", "tmodes"]

COMMAND = [sys.executable, "-m", "tmodes.cli.entry"]
"""The command in a process of its own, for what only that shows: signals, streams, environment."""


def started(line: Sequence[object], **more: Any) -> subprocess.Popen[str]:
    """A program that hears signals as in a terminal.

    A child inherits what its parent ignores: SIGINT in the background of a script, SIGHUP under `nohup`.
    """
    heard = None if os.name == "nt" else _hear
    return subprocess.Popen([*map(str, line)], text=True, preexec_fn=heard, **more)  # noqa: PLW1509 - no threads yet


def _hear() -> None:
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


@dataclass(frozen=True)
class Done:
    """How a command ended, and what it wrote."""

    returncode: int
    stdout: str
    stderr: str


def called(*arguments: object, cwd: Path | None = None) -> Done:
    """Run a command line, whatever its exit code."""
    out, err, code = _stream(), _stream(), 0
    here = chdir(cwd) if cwd else nullcontext()
    with patch.object(sys, "argv", ["tmodes", *map(str, arguments)]), redirect_stdout(out), redirect_stderr(err), here:
        try:
            main()
        except SystemExit as ended:
            code = ended.code if isinstance(ended.code, int) else 1
    return Done(code, _text(out), _text(err))


def _stream() -> io.TextIOWrapper:
    """A stream of UTF-8 as a terminal has."""
    return io.TextIOWrapper(io.BytesIO(), encoding="utf-8", newline="\n")


def _text(stream: io.TextIOWrapper) -> str:
    stream.flush()
    assert isinstance(stream.buffer, io.BytesIO)
    return stream.buffer.getvalue().decode()


def tmodes(
    *arguments: object, code: int = 0, cwd: Path | None = None, env: Mapping[str, str] | None = None
) -> Done | subprocess.CompletedProcess[str]:
    """Run a command line that ends with ``code``, with ``env`` as a program; a traceback is never right."""
    if env is None:
        done = called(*arguments, cwd=cwd)
    else:
        line = [*COMMAND, *map(str, arguments)]
        done = subprocess.run(line, capture_output=True, text=True, check=False, cwd=cwd, env=dict(env))
    assert "Traceback" not in done.stderr
    assert done.returncode == code, done.stderr
    return done
