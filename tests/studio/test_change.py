"""What of a page changes with a number: the same numbers as the whole page has, without what stays."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import tmodes.report.pack
from tmodes import load
from tmodes.report.pack import Coarse, TwoParts
from tmodes.studio.page import LONGEST_WORD, MOST_WORDS
from tmodes.studio.sheets import plain_sheet
from tmodes.studio.work import WorkAnswer, Workshop

PARTS = {"deformation_stationary", "deformation_oscillatory"}
FIXED = {"links", "joints", "meshes"}


@pytest.fixture
def packed(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """The data of each answer before it is packed."""
    found: list[Any] = []
    pack = tmodes.report.pack.pack

    def kept(page: Any) -> bytes:
        found.append(page)
        return pack(page)

    monkeypatch.setattr(tmodes.report.pack, "pack", kept)
    return found


def asked(workshop: Workshop, product: str, sheet: dict[str, Any], series: tuple[str, ...] = ()) -> WorkAnswer:
    return workshop.answer(product, sheet, lambda stage, share: None, None, series)


def places(values: Any) -> Any:
    """The numbers of an array of a scene as a page reads them."""
    if isinstance(values, TwoParts):
        return places(values.large) + places(values.small)
    return values.values if isinstance(values, Coarse) else np.asarray(values, dtype=float)


@pytest.mark.parametrize("name", ["filipovic2010", "flexarm1990"])
def test_a_change_has_the_numbers_of_the_page(name: str, packed: list[Any]) -> None:
    workshop, sheet = Workshop(), plain_sheet(load(name))
    whole = asked(workshop, "curves", sheet)
    change = asked(workshop, "change", sheet, tuple(packed[0]["series"]))
    assert change.info["structure"] == whole.info["structure"]
    assert len(change.content) < 0.9 * len(whole.content)
    page, own = packed
    assert set(page["series"]) - set(own["series"]) == PARTS
    for series, values in own["series"].items():
        np.testing.assert_array_equal(values, page["series"][series])
    (first,), (moved,) = page["runs"], own["runs"]
    assert moved["facts"] == first["facts"]
    assert set(moved["scene"]) == set(first["scene"]) - FIXED
    for key in ("line", "rigid", "reference", "roots"):
        if first["scene"][key] is not None:
            np.testing.assert_allclose(places(moved["scene"][key]), places(first["scene"][key]), rtol=0, atol=1e-9)


def test_another_structure_is_reported(packed: list[Any]) -> None:
    workshop = Workshop()
    known = asked(workshop, "curves", plain_sheet(load("spong1987"))).info["structure"]
    sheet = plain_sheet(load("spong1987").with_({"integration.duration": 0.5}))
    assert asked(workshop, "change", sheet).info["structure"] == known
    assert asked(workshop, "change", plain_sheet(load("filipovic2010"))).info["structure"] != known
    still = asked(workshop, "change", plain_sheet(load("spong1987").with_({"drives": []}))).info
    assert still["structure"] == "at rest"


def test_a_series_that_there_is_not_is_left_out(packed: list[Any]) -> None:
    asked(Workshop(), "change", plain_sheet(load("spong1987")), ("tip", "nothing"))
    assert set(packed[0]["series"]) == {"tip"}


def test_the_series_of_a_change_are_names(studio: Any) -> None:
    order = {"product": "change", "sheet": plain_sheet(load("spong1987")), "client": "change"}
    for series in (None, "tip", ["tip", 3], ["x" * (LONGEST_WORD + 1)], ["tip"] * (MOST_WORDS + 1)):
        assert "series" in str(studio.post("/api/jobs", json={**order, "series": series}, code=422))
    job = studio.post("/api/jobs", json={**order, "series": ["tip"]})
    assert job["product"] == "change"
