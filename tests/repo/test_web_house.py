"""The sources of the pages keep the rules of the house: short files, short lines, each saying what it is."""

from __future__ import annotations

from pathlib import Path

import pytest

SOURCES = Path(__file__).resolve().parents[2] / "web" / "src"
FILES = sorted(SOURCES.rglob("*.ts"))
LONGEST_FILE = 250
LONGEST_LINE = 120


def test_there_are_sources() -> None:
    assert len(FILES) > 60


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.relative_to(SOURCES).as_posix())
def test_files_and_lines_are_short(file: Path) -> None:
    lines = file.read_text(encoding="utf-8").splitlines()
    long = [f"{k + 1}: {line}" for k, line in enumerate(lines) if len(line) > LONGEST_LINE]
    assert len(lines) <= LONGEST_FILE
    assert not long
    assert lines[0].startswith("// ")
