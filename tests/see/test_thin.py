"""Fewer samples for a picture: no extreme is lost, and there are few enough."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmodes.report.pack import MOST_FRAMES, MOST_POINTS, scene_frames, thinned


@given(count=st.integers(1, 3000), width=st.integers(1, 8), seed=st.integers(0, 10**6), most=st.integers(20, 900))
def test_the_extremes_of_every_curve_and_both_ends_are_kept(count: int, width: int, seed: int, most: int) -> None:
    curves = np.random.default_rng(seed).normal(size=(count, width))
    kept = thinned(curves, most)
    assert np.array_equal(curves[kept].max(axis=0), curves.max(axis=0))
    assert np.array_equal(curves[kept].min(axis=0), curves.min(axis=0))
    assert (kept[0], kept[-1]) == (0, count - 1)
    assert np.all(np.diff(kept) > 0)


def test_every_stretch_keeps_its_own_extremes() -> None:
    """The envelope of a fast vibration, seen through windows of a hundredth of the run, is that of all samples."""
    time = np.linspace(0, 60, 60001)
    curves = np.stack([np.sin(400 * time) * np.exp(-time / 20), np.cos(171 * time)], axis=1)
    kept = thinned(curves)
    assert len(kept) <= MOST_POINTS + 2
    for start in np.linspace(0, 59, 40):
        part, few = ((times >= start) & (times < start + 0.6) for times in (time, time[kept]))
        assert curves[kept][few].max(axis=0) == pytest.approx(curves[part].max(axis=0), rel=1e-3)


def test_a_short_run_is_kept_whole() -> None:
    assert np.array_equal(thinned(np.zeros((MOST_POINTS, 3))), np.arange(MOST_POINTS))


@pytest.mark.parametrize(("duration", "samples", "wanted"), [(2.0, 2001, 400), (60.0, 60001, 3000), (1e-3, 11, 11)])
def test_frames_are_even_in_time_and_bounded(duration: float, samples: int, wanted: int) -> None:
    times = np.linspace(0, duration, samples)
    kept = scene_frames(times)
    assert len(kept) == pytest.approx(wanted, abs=1)
    assert (kept[0], kept[-1]) == (0, samples - 1)
    gaps = np.diff(times[kept])
    assert gaps.max() - gaps.min() <= 2.001 * duration / (samples - 1)


def test_frames_of_large_robots_are_fewer() -> None:
    times = np.linspace(0, 60, 60001)
    assert 2 < len(scene_frames(times, 60 * 21 * 3)) < MOST_FRAMES / 5
    assert len(scene_frames(np.zeros(1))) == 1
