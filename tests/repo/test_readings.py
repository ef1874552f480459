"""The numbers by which docs/readings.md compares the readings are those of the program."""

from __future__ import annotations

from pathlib import Path

import pytest

from readings_doc import CASES, ROW, measured

PAGE = Path(__file__).resolve().parents[2] / "docs" / "readings.md"
ROWS = ROW.findall(PAGE.read_text(encoding="utf-8"))


def test_every_case_has_its_row() -> None:
    assert [(reading, float(payload), contact == "yes") for reading, payload, contact, *_ in ROWS] == list(CASES)


@pytest.mark.parametrize("row", ROWS, ids=lambda row: "-".join(row[:3]))
def test_row_is_what_the_program_gives(row: tuple[str, ...]) -> None:
    reading, payload, contact, *printed = row
    found = measured((reading, float(payload), contact == "yes"))
    assert found == pytest.approx([float(cell) for cell in printed], rel=2e-4), "run: python tools/readings_doc.py"
