"""Too little memory: the message says so, and nothing is half written."""

from __future__ import annotations

import errno
import subprocess
import sys
from pathlib import Path

import pyarrow as pa
import pytest

from command import COMMAND
from tmodes.cli import memory
from tmodes.cli.main import app
from tmodes.cli.memory import lacks_memory
from tmodes.result import Result


@pytest.mark.skipif(sys.platform != "linux", reason="limits memory as Linux does")
@pytest.mark.parametrize("kilobytes", [150_000, 300_000, 580_000])
def test_a_small_limit_is_reported(tmp_path: Path, kilobytes: int) -> None:
    """Before the libraries are loaded, which may die without a word."""
    line = f'ulimit -v {kilobytes}; exec "$@"'
    run = [
        *COMMAND,
        "run",
        "spong1987",
        "--duration",
        "0.02",
        "--no-report",
        "--no-live",
        "--out",
        str(tmp_path / "o"),
    ]
    done = subprocess.run(["sh", "-c", line, "sh", *run], capture_output=True, text=True, check=False)
    assert done.returncode == 3, done.stderr
    assert f"out of memory: this process may use {1.024e-3 * kilobytes:.0f} MB" in done.stderr
    assert "Traceback" not in done.stderr
    assert [path for path in tmp_path.rglob("*.tmp") if path.is_file()] == []
    for path in tmp_path.rglob("result.nc"):
        assert Result.load(path).status == "finished"


def raised(error: Exception, cause: Exception | None = None) -> Exception:
    error.__cause__ = cause
    return error


@pytest.mark.parametrize(
    ("error", "lacks"),
    [
        (MemoryError(), True),
        (OSError(errno.ENOMEM, "Cannot allocate memory"), True),
        (ImportError("libx.so: failed to map segment from shared object"), True),
        (RuntimeError("can't start new thread"), True),
        (pa.ArrowException("Unknown error: Failed to launch worker thread: not available"), True),
        (raised(ImportError("no C-extensions"), MemoryError()), True),
        (OSError(errno.ENOSPC, "No space left on device"), False),
        (ImportError("no module named x"), False),
        (ValueError("failed to map segment"), False),
    ],
    ids=str,
)
def test_errors_of_memory_are_known(error: Exception, lacks: bool) -> None:
    assert lacks_memory(error) == lacks


@pytest.mark.parametrize(("limit", "lacks"), [(8e8, True), (2e9, False)])
def test_a_module_that_is_missing_under_a_small_limit(
    monkeypatch: pytest.MonkeyPatch, limit: float, lacks: bool
) -> None:
    monkeypatch.setattr(memory, "limit", lambda: limit)
    assert lacks_memory(ImportError("No module named 'h5py', backend not available")) == lacks


@pytest.mark.parametrize("command", ["study", "sensitivity", "optimize"])
def test_a_study_wants_more(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, command: str) -> None:
    """Its libraries end the process without a word where theirs is too little; nothing of it is begun."""
    monkeypatch.setattr(memory, "limit", lambda: 7e8)
    with pytest.raises(MemoryError):
        app([command, str(tmp_path / "absent.yaml")], standalone_mode=False)
