"""The house keeps its rules: it speaks only of itself, and its files are short."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

from mutants import FAULTS

ROOT = Path(__file__).resolve().parents[2]
LONGEST = 450
"""Lines of a source file."""

# Written in two halves, so that this file does not hold them itself.
FORBIDDEN = tuple(
    a + b
    for a, b in [
        ("pypi", ".org"),
        ("files.python", "hosted"),
        ("extra-index", "-url"),
        ("/wor", "k/"),
        ("/tm", "p/w"),
        ("/home", "/"),
        ("/roo", "t/"),
        ("--find", "-links"),
    ]
)


def texts() -> list[Path]:
    """Text files that are, or would be, part of the repository."""
    listed = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "-z"]
    done = subprocess.run(listed, cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        pytest.skip("not a git checkout")
    files = (ROOT / name for name in done.stdout.split("\0") if name)
    return [file for file in files if file.is_file() and b"\0" not in file.read_bytes()[:8000]]


def test_it_speaks_only_of_itself() -> None:
    files = texts()
    assert len(files) > 30
    found = [
        f"{file.relative_to(ROOT)}: {word}"
        for file in files
        for word in FORBIDDEN
        if word in file.read_text(encoding="utf-8")
    ]
    assert found == []


def test_constraints_hold_versions_only() -> None:
    lines = (ROOT / "constraints.txt").read_text(encoding="utf-8").splitlines()
    assert len(lines) > 20
    assert [line for line in lines if "==" not in line or "/" in line or "@" in line] == []


CLOCKS = re.compile(
    r"\b(sleep|monotonic|perf_counter|process_time|thread_time|wait_for_timeout|setTimeout)(_ns)?\("
    r"|\btime\.time\(|\btimeout=[\d.]+|\.(wait|join)\([\d.]+\)"
)


def test_tests_wait_for_states() -> None:
    """No test but ``patience`` sleeps, reads a clock, or knows how long something takes: a busy machine is slower."""
    found = [
        f"{file.name}: {one.group()}"
        for file in (ROOT / "tests").rglob("*.py")
        if file.name != "patience.py"
        for one in CLOCKS.finditer(file.read_text(encoding="utf-8"))
    ]
    assert found == []


def test_no_lock_file_that_records_addresses() -> None:
    assert [name for name in ("uv.lock", "pylock.toml", "poetry.lock") if (ROOT / name).exists()] == []


def test_source_files_are_short() -> None:
    lengths = {file: len(file.read_text(encoding="utf-8").splitlines()) for file in (ROOT / "src").rglob("*.py")}
    assert len(lengths) > 20
    long = {str(file.relative_to(ROOT)): lines for file, lines in lengths.items() if lines > LONGEST}
    assert long == {}


def test_every_source_file_reports_what_it_is() -> None:
    silent = [
        str(file.relative_to(ROOT))
        for file in (ROOT / "src").rglob("*.py")
        if (text := file.read_text(encoding="utf-8")).strip() and not text.startswith('"""')
    ]
    assert silent == []


def test_the_faults_of_the_mutation_check_fit_their_files() -> None:
    """Each changes one place of the program as it is now, and names tests that are there."""
    for fault in FAULTS:
        text = (ROOT / "src" / "tmodes" / fault.file).read_text(encoding="utf-8")
        assert text.count(fault.old) == 1, fault
        assert all((ROOT / test).exists() for test in fault.tests.split()), fault
