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

from result.synthetic import synthetic_result
from tmodes.errors import InputError
from tmodes.plot.frequency_marks import keep_apart
from tmodes.plot.paper.vibration import amplitude_spectrum, spectrum
from tmodes.result.record import PaperResult

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


def test_the_figure_shows_vibration_within_vibration() -> None:
    angles, acceleration = spectrum(synthetic_result())
    slow, fast = (peak(angles.lines[0].get_data(), *band) for band in ((3, 7), (18, 23)))
    assert slow[0] == pytest.approx(4.94, abs=0.15)
    assert fast[0] == pytest.approx(20.2, abs=0.15)
    assert angles.get_yscale() == acceleration.get_yscale() == "log"
    assert angles.get_xlim() == (0, 60)
    quick, quiet = (peak(acceleration.lines[0].get_data(), *band)[1] for band in ((18, 23), (4, 7)))
    assert quick / quiet > 3 * fast[1] / slow[1]


def test_bounds_and_range_can_be_chosen() -> None:
    panel = spectrum(synthetic_result(), bounds=(0.25, 0.5), highest=1e4)[0]
    assert panel.get_title(loc="left") == "a) Horizontal bending angles, 0.5 to 1 s"
    assert panel.get_xlim() == (0, pytest.approx(500.0))
    with pytest.raises(InputError, match="needs 32 samples between 50 % and 51 % of the move; this run has 21"):
        spectrum(synthetic_result(), bounds=(0.5, 0.51))


def test_marks_are_labelled_and_do_not_overlap() -> None:
    result = synthetic_result()
    crowd = [
        {"frequency_Hz": f, "damped_frequency_Hz": f, "damping_ratio": 0.01, "element": "mode 1, horizontal"}
        for f in (4.9, 5.0, 5.3, 6, 58)
    ]
    crowd.append(
        {"frequency_Hz": 178, "damped_frequency_Hz": 178.0, "damping_ratio": 0.01, "element": "beyond the axis"}
    )
    crowd.append(
        {"frequency_Hz": 40, "damped_frequency_Hz": 40.0, "damping_ratio": 1.0, "element": "too damped to ring"}
    )
    data = result.data.assign_attrs(frequencies=json.dumps({"controlled": crowd}))
    panel: Any = spectrum(PaperResult(data))[0]
    panel.figure.draw_without_rendering()
    labels = [text for text in panel.texts if "Hz" in text.get_text()]
    assert [label.get_text().split("\n")[0] for label in labels] == ["4.9 Hz", "5 Hz", "5.3 Hz", "6 Hz", "58 Hz"]
    assert all(label.get_text().endswith(" Hz\nmode 1\nhorizontal") for label in labels)
    boxes = [Text.get_window_extent(label) for label in labels]
    assert all(left.x1 < right.x0 for left, right in pairwise(boxes))
    assert panel._left_title.get_window_extent().y0 > max(box.y1 for box in boxes)
    assert [line.get_xdata()[0] for line in panel.lines[2:]] == [4.9, 5.0, 5.3, 6, 58]


def test_a_motion_without_vibration_draws() -> None:
    result = synthetic_result()
    still = result.data.assign(deformation=result.data["deformation"] * 0, v=result.data["v"] * 0)
    panel: Any = spectrum(PaperResult(still))[0]
    panel.figure.draw_without_rendering()


@given(st.lists(st.floats(0.05, 0.95), max_size=9))
def test_labels_keep_apart_and_inside(wanted: list[float]) -> None:
    wanted = sorted(wanted)
    places = keep_apart(wanted, 0.1, 0.05, 0.95)
    assert all(np.diff(places) > 0.1 - 1e-9)
    assert all((places > 0.05 - 1e-9) & (places < 0.95 + 1e-9))
    if all(np.diff(wanted) >= 0.1):
        np.testing.assert_allclose(places, wanted, atol=1e-9)
