"""Real processes of a study: the command itself, a scheduler of Dask and its workers; all end with the test."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from command import COMMAND, started
from patience import until

__all__ = ["Cluster", "blocks_in", "cluster", "command", "ended", "reached"]


def command(*arguments: object, cwd: Path | None = None) -> subprocess.Popen[str]:
    """The command ``tmodes``, started."""
    return started([*COMMAND, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=cwd)


def ended(process: subprocess.Popen[str]) -> tuple[int, str, str]:
    """Its exit code, output and errors, once it has ended."""
    out, err = process.communicate()
    return process.returncode, out, err


def reached(process: subprocess.Popen[str], folder: Path, blocks: int) -> None:
    """Wait until so many blocks are stored, by a process that runs still."""
    until(lambda: process.poll() is not None or blocks_in(folder) >= blocks, f"{blocks} blocks")
    assert process.poll() is None, ended(process)


def blocks_in(folder: Path) -> int:
    """How many blocks are stored."""
    return len([*(folder / "blocks").glob("*.block")])


class Cluster:
    """A scheduler on loopback; workers that are started and killed one by one."""

    def __init__(self, folder: Path, *options: str) -> None:
        self.folder, self.options = folder, options
        self._file = folder / "scheduler.json"
        self.processes: list[subprocess.Popen[bytes]] = []
        self._start(
            "scheduler", "--scheduler-file", self._file, "--host", self._host(), "--port", "0", "--no-dashboard"
        )
        info = until(self._info, "the scheduler")
        self.address = str(info["address"])

    def _host(self) -> str:
        return "tls://127.0.0.1" if self.options else "tcp://127.0.0.1"

    def _info(self) -> Any:
        try:
            return json.loads(self._file.read_text())
        except (OSError, ValueError):
            return None

    def _start(self, what: str, *arguments: object) -> subprocess.Popen[bytes]:
        line = [sys.executable, "-m", "distributed.cli.dask_" + what, *map(str, arguments), *self.options]
        log = (self.folder / f"{what}-{len(self.processes)}.log").open("wb")
        with log:
            self.processes.append(subprocess.Popen(line, stdout=log, stderr=log, cwd=self.folder))
        return self.processes[-1]

    def worker(self) -> subprocess.Popen[bytes]:
        """Start a worker of one thread, without a nanny: killed, it stays so."""
        own = self.folder / f"worker-{len(self.processes)}"
        options = "--nthreads", "1", "--no-nanny", "--no-dashboard", "--local-directory", own
        return self._start("worker", self.address, *options)

    def end(self) -> None:
        """Kill all that run."""
        for process in self.processes:
            process.kill()
            process.wait()


@contextmanager
def cluster(folder: Path, workers: int, *options: str) -> Iterator[Cluster]:
    """A scheduler with so many workers."""
    found = Cluster(folder, *options)
    try:
        for _ in range(workers):
            found.worker()
        yield found
    finally:
        found.end()
