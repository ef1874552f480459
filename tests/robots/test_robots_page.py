"""The page of the published robots names every sheet, shape and material, with the numbers that are in use."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

import pytest

from tmodes.kinds.links.material import LIBRARY
from tmodes.kinds.links.section import SHAPES

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "robots.md").read_text(encoding="utf-8")
ROWS = {cells[0].strip(" `"): cells for line in PAGE.splitlines() if (cells := line.strip("| ").split(" | "))}


@pytest.mark.parametrize("name", LIBRARY)
def test_material_row_is_the_library(name):
    material = LIBRARY[name]
    numbers = [material.young / 1e9, material.shear / 1e9, material.density, (material.yield_strength or 0) / 1e6]
    assert [float(cell) for cell in ROWS[name][1:5]] == pytest.approx(numbers, rel=1e-12)
    assert ROWS[name][5].split(":")[0].split(";")[0] in material.source


def test_every_sheet_is_on_the_page():
    folder = resources.files("tmodes.robots")
    sheets = [entry.name for entry in folder.iterdir() if entry.name.endswith(".yaml")]
    assert len(sheets) == 11
    assert [sheet for sheet in sheets if f"/{sheet})" not in PAGE] == []


def test_every_shape_and_its_keys_are_on_the_page():
    for shape, sheet in SHAPES.items():
        assert f"`{shape}`" in PAGE
        assert [key for key in sheet.model_fields if key != "shape" and f"`{key}`" not in PAGE] == []
