"""A long run of a large arm: its page stays small, and no peak is lost."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tmodes.plot.charts import Chart, Line, in_units
from tmodes.report.charts import chart_data
from tmodes.report.pack import (
    MOST_POINTS,
    Coarse,
    colour,
    displaced,
    embedded,
    kept,
    pack,
    quaternions,
    scene_frames,
    stations_shown,
)

SAMPLES, COORDINATES, LINKS, STATIONS = 60_000, 60, 6, 21
LARGEST = 15e6
"""Bytes of a page of such a run, as the issue of the report bounds them."""

REST = 3.5e6
"""Bytes of a page that no run changes, generously: program, figures, equations, sheet."""

Array = NDArray[np.float64]


@pytest.fixture(scope="module")
def times() -> Array:
    return np.linspace(0.0, 60.0, SAMPLES)


@pytest.fixture(scope="module")
def values(times: Array) -> Array:
    """Coordinates (n, 60) that swing slowly and ring fast, and each with one peak of a single sample."""
    generator = np.random.default_rng(3)
    found = np.zeros((SAMPLES, COORDINATES))
    for size, low, high in ((1.0, 0.2, 0.7), (0.05, 5.0, 20.0), (0.01, 40.0, 90.0)):
        rates, phases = generator.uniform(low, high, COORDINATES), generator.uniform(0, 6, COORDINATES)
        found += size * np.sin(2 * np.pi * rates * times[:, None] + phases)
    found[generator.integers(0, SAMPLES, COORDINATES), np.arange(COORDINATES)] += 3.0
    return 0.1 * found


@pytest.fixture(scope="module")
def charts(times: Array, values: Array) -> list[dict[str, Any]]:
    """Of six coordinates each, with their references, as an arm's page has them."""
    drafts = []
    for first in range(0, COORDINATES, 6):
        lines = [
            Line(f"q{k}", role, share * values[:, k], ("q", k))
            for k in range(first, first + 6)
            for role, share in (("real", 1.0), ("reference", 0.98))
        ]
        drafts.append(Chart(f"chart{first}", "Coordinates", "deformations", "rad", times, tuple(lines)))
    return [chart_data(chart) for chart in in_units([drafts])[0]]


def test_every_peak_of_every_curve_is_kept(values: Array, charts: list[dict[str, Any]]) -> None:
    for number, chart in enumerate(charts):
        assert chart["samples"] == SAMPLES
        assert len(chart["at"]) <= 1.1 * MOST_POINTS
        for k, curve in enumerate(chart["curves"]):
            true = (1.0, 0.98)[k % 2] * values[:, 6 * number + k // 2]
            drawn = curve["values"]
            assert isinstance(drawn, Coarse)
            assert (drawn.values.min(), drawn.values.max()) == pytest.approx((true.min(), true.max()), rel=1e-14)


def scene(times: Array, values: Array) -> dict[str, Any]:
    """Lines, roots and colours of six links that bend, at the frames and stations that a page shows."""
    at = scene_frames(times, LINKS * STATIONS * 3)
    s = np.linspace(0, 1, STATIONS)[stations_shown(STATIONS, len(at), LINKS)]
    angles = np.cumsum(values[at, :LINKS], axis=1)
    steps = np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=-1)
    roots = np.cumsum(steps, axis=1) - steps
    rigid = roots[:, :, None] + s[:, None] * steps[:, :, None]
    bent = 1e-2 * values[at, LINKS : 2 * LINKS, None, None] * (s**2)[:, None] * np.array([-1.0, 1.0, 0.5])
    turns = np.zeros((len(at), LINKS, 3, 3))
    turns[..., 0, 0] = turns[..., 1, 1] = np.cos(angles)
    turns[..., 1, 0], turns[..., 0, 1], turns[..., 2, 2] = np.sin(angles), -np.sin(angles), 1.0
    base = kept(rigid)
    size = np.linalg.norm(bent, axis=-1)
    return {
        "times": times[at], "line": displaced(rigid + bent, rigid, base), "rigid": base, "roots": quaternions(turns),
        "reference": displaced(rigid + 0.9 * bent, rigid, base),
        "colours": [colour(name, name, "m", size * k) for k, name in ((1, "moment"), (2, "strain"), (3, "stress"))],
    }  # fmt: skip


def test_its_page_stays_small(times: Array, values: Array, charts: list[dict[str, Any]]) -> None:
    """Charts twice over (rates next to coordinates), as much again of loads along the links, and the robot."""
    shown = scene(times, values)
    loads = [kept(np.stack([np.roll(shown["colours"][0]["values"].values, k, axis=0)] * 2, -1)) for k in range(4)]
    rates = [{**chart, "curves": [_steeper(curve) for curve in chart["curves"]]} for chart in charts]
    data = len(embedded(pack({"charts": charts + rates, "scene": shown, "line": loads})))
    assert 1e6 < data < LARGEST - REST


def _steeper(curve: dict[str, Any]) -> dict[str, Any]:
    return {**curve, "values": Coarse(np.gradient(curve["values"].values))}
