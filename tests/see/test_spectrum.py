"""The spectrum: amplitudes that are amplitudes, on the plateau, with marks that can be read."""

from __future__ import annotations

import json
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.text import Text

from see.runs import result_of
from tmodes.plot import spectrum
from tmodes.plot.facts import spectral_part
from tmodes.plot.figures.spectrum import keep_apart
from tmodes.plot.spectra import amplitude_spectrum
from tmodes.result import Result

TIME = np.arange(1201) * 1e-3


def peak(curve: Any, low: float, high: float) -> tuple[float, float]:
    """Place and height of the highest point of a curve between two frequencies."""
    frequency, amplitude = curve
    inside = (frequency > low) & (frequency < high)
    index = np.argmax(amplitude[inside])
    return frequency[inside][index], amplitude[inside][index]


def test_a_sine_shows_its_frequency_and_its_amplitude() -> None:
    values = 3.0 + 5.0 * TIME + 0.2 * np.sin(2 * np.pi * 20.0 * TIME) + 1e-4 * np.sin(2 * np.pi * 90.0 * TIME)
    frequency, amplitude = amplitude_spectrum(values, 1e-3)
    assert peak((frequency, amplitude), 10, 30) == pytest.approx((20.0, 0.2), rel=5e-3)
    assert peak((frequency, amplitude), 80, 100) == pytest.approx((90.0, 1e-4), rel=2e-2)
    assert frequency[-1] == pytest.approx(500.0, rel=1e-3)


def test_marks_are_labelled_and_do_not_overlap() -> None:
    """Those within the axis, and only of modes that oscillate with a peak."""
    crowd = [
        {"frequency_Hz": f, "damped_frequency_Hz": f, "damping_ratio": ratio, "element": "mode 1, horizontal"}
        for f, ratio in ((0.4, 0.01), (0.42, 0.01), (0.5, 0.01), (0.9, 0.01), (178.0, 0.01), (0.7, 1.0))
    ]
    data = result_of("pendulum").data.assign_attrs(end_frequencies=json.dumps({"actual": crowd}))
    panel: Any = spectrum(Result(data))[0]
    panel.figure.draw_without_rendering()
    labels = [text for text in panel.texts if "Hz" in text.get_text()]
    assert [label.get_text().split("\n")[0] for label in labels] == ["0.4 Hz", "0.42 Hz", "0.5 Hz", "0.9 Hz"]
    assert all(label.get_text().endswith(" Hz\nmode 1\nhorizontal") for label in labels)
    boxes = [Text.get_window_extent(label) for label in labels]
    assert all(left.x1 < right.x0 for left, right in pairwise(boxes))
    assert panel._left_title.get_window_extent().y0 > max(box.y1 for box in boxes)


def test_the_spectrum_is_of_the_time_after_the_move_or_of_constant_rate() -> None:
    """Where a run ends with its move, of the longest part in which no setpoint accelerates; else of the whole run."""
    swinging = result_of("swinging").data
    assert float(spectral_part(swinging, 32)["time"][0]) > 0.2
    time = swinging["time"].values
    ramp = np.clip(time - 0.1, 0.0, 0.2)[:, None] * np.ones((1, 2))
    coasting = swinging.assign(wanted=(("time", "drive"), ramp)).assign_attrs(move_end="0.4")
    part = spectral_part(coasting, 32)["time"].values
    assert (part[0], part[-1]) == (pytest.approx(0.104), pytest.approx(0.296))
    assert len(spectral_part(coasting, 80)["time"]) == len(time)


@given(st.lists(st.floats(0.05, 0.95), max_size=9))
def test_labels_keep_apart_and_inside(wanted: list[float]) -> None:
    wanted = sorted(wanted)
    places = keep_apart(wanted, 0.1, 0.05, 0.95)
    assert all(np.diff(places) > 0.1 - 1e-9)
    assert all((places > 0.05 - 1e-9) & (places < 0.95 + 1e-9))
    if all(np.diff(wanted) >= 0.1):
        np.testing.assert_allclose(places, wanted, atol=1e-9)
