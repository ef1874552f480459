"""The sources of the pages keep the rules of the house: short files, short lines, each telling what it is."""

from __future__ import annotations

from pathlib import Path

import pytest

SOURCES = Path(__file__).resolve().parents[2] / "web" / "src"
FILES = sorted(SOURCES.rglob("*.ts"))
LONGEST_FILE = 250
LONGEST_LINE = 120
OWED = {
    "charts/chart.ts": 10, "charts/charts.ts": 3, "charts/legend.ts": 3, "charts/plot.ts": 6,
    "charts/series.ts": 1, "charts/spectrum.ts": 1, "contract.ts": 3, "dom.ts": 1, "live/arm_rest.ts": 7,
    "live/arm_run.ts": 12, "live/arm_scene.ts": 5, "live/engine.ts": 6, "live/engine_run.ts": 10,
    "live/facts.ts": 4, "live/kept.ts": 1, "live/live.ts": 1, "live/model.ts": 4, "live/robot_facts.ts": 2,
    "live/robot_line.ts": 1, "live/robot_run.ts": 11, "live/robot_static.ts": 2, "live/series.ts": 2,
    "live/sheet.ts": 2, "live/worker.ts": 1, "page.ts": 7, "panels/facts.ts": 5, "panels/line.ts": 10,
    "panels/modes.ts": 6, "studio/api.ts": 1, "studio/field.ts": 10, "studio/files.ts": 9, "studio/form.ts": 18,
    "studio/messages.ts": 4, "studio/runner.ts": 2, "studio/schema.ts": 9, "studio/shown.ts": 4,
    "studio/sliders.ts": 3, "studio.ts": 4,
}  # fmt: skip
"""Files with lines that are longer yet, and how many at most: the number only shrinks, other files have none."""


def test_there_are_sources() -> None:
    assert len(FILES) > 60
    assert {SOURCES / name for name in OWED} <= set(FILES)


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.relative_to(SOURCES).as_posix())
def test_files_and_lines_are_short(file: Path) -> None:
    lines = file.read_text(encoding="utf-8").splitlines()
    long = [f"{k + 1}: {line}" for k, line in enumerate(lines) if len(line) > LONGEST_LINE]
    assert len(lines) <= LONGEST_FILE
    assert len(long) <= OWED.get(file.relative_to(SOURCES).as_posix(), 0), long
    assert lines[0].startswith("// ")
