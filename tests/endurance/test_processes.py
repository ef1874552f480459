"""The cache among processes: many that compile the same robot at once, and writers that are killed."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from patience import LONG
from tmodes.compile import cache
from tmodes.compile.cache import entries, trim

from .scale import often

pytestmark = pytest.mark.nightly

COMPILE = """
import sys
import numpy as np
from benchmarks.engines.rigid import RigidChain
from tmodes.model.model import Model
sys.stdin.readline()
print(Model(RigidChain(2).chain()).forward_dynamics([0.1, 0.2], [0.3, 0.4]).tobytes().hex())
"""


def started(code: str, place: Path, *arguments: str) -> subprocess.Popen[str]:
    pipe, environment = subprocess.PIPE, os.environ | {"TMODES_CACHE": str(place)}
    command = [sys.executable, "-c", code, *arguments]
    return subprocess.Popen(command, env=environment, text=True, stdin=pipe, stdout=pipe, stderr=pipe)


def compiled_by(processes: int, place: Path) -> set[str]:
    """What so many processes print that begin at the same time."""
    running = [started(COMPILE, place) for _ in range(processes)]
    info = [one.communicate("go\n", timeout=LONG) for one in running]
    assert [one.returncode for one in running] == [0] * processes, info
    return {out for out, _ in info}


@pytest.mark.slow
def test_processes_that_compile_the_same_robot_at_once(tmp_path: Path) -> None:
    """One entry per key, the same bytes as one process alone makes, nothing left over, and the same accelerations."""
    alone, together = tmp_path / "alone", tmp_path / "together"
    for _ in range(often(1, 20)):
        assert compiled_by(1, alone) == compiled_by(8, together)
        files = {file.name: file.read_bytes()[cache._START :] for file in together.glob("*.o")}
        assert files == {file.name: file.read_bytes()[cache._START :] for file in alone.glob("*.o")}
        assert files
        for file in together.glob("*.o"):
            file.unlink()


KILLED = """
import os, signal, sys
from pathlib import Path
from tmodes.compile import cache
from tmodes.io import atomic

point = sys.argv[1]

def die(*_):
    os.kill(os.getpid(), signal.SIGKILL)

def half(path, content):
    with path.open("wb") as file:
        file.write(content[: len(content) // 2])
    die()

def renamed(path, target, name=Path.replace):
    name(path, target)
    die()

if point == "half written":
    Path.write_bytes = half
elif point == "not renamed":
    Path.replace = die
else:
    Path.replace = renamed
cache.save("key", bytes(range(256)) * 4096)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="there is no SIGKILL")
@pytest.mark.parametrize("point", ["half written", "not renamed", "renamed"])
def test_writer_killed_at_the_worst_moment(point: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What stands is whole or absent; the next start writes and reads; what was left over goes."""
    place = tmp_path / "cache"
    monkeypatch.setenv("TMODES_CACHE", str(place))
    binary = bytes(range(256)) * 4096
    for _ in range(often(1, 25)):
        one = started(KILLED, place, point)
        one.communicate(timeout=LONG)
        assert one.returncode == -9
        assert cache.load("key") == (binary if point == "renamed" else None)
        cache.save("key", binary)
        assert cache.load("key") == binary
        trim(place, cache.MAX_BYTES)
        assert [file.name for file in place.iterdir() if file.name != "secret"] == [
            entry.file.name for entry in entries(place)
        ]
        next(entries(place)).file.unlink()


WRITING = """
from tmodes.compile import cache
print("ready", flush=True)
number = 0
while True:
    cache.save(f"key {number % 7}", bytes([number % 7]) * 300_000)
    number += 1
"""


@pytest.mark.skipif(sys.platform == "win32", reason="there is no SIGKILL")
def test_writer_killed_at_any_moment(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whenever the blow falls, every entry that is there is whole."""
    place = tmp_path / "cache"
    monkeypatch.setenv("TMODES_CACHE", str(place))
    for number in range(often(5, 100)):
        one = started(WRITING, place)
        assert one.stdout is not None
        assert one.stdout.readline() == "ready\n"
        with pytest.raises(subprocess.TimeoutExpired):
            one.wait(0.0007 * (number % 50 + 1))
        one.kill()
        one.communicate(timeout=LONG)
        found = {key: cache.load(f"key {key}") for key in range(7)}
        assert all(binary in (None, bytes([key]) * 300_000) for key, binary in found.items())
        whole = sum(binary is not None for binary in found.values())
        assert len(list(entries(place))) == whole
    trim(place, cache.MAX_BYTES)
    assert {file.suffix for file in place.iterdir() if file.name != "secret"} <= {".o"}
