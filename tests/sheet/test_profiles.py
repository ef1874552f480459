"""Profiles of motion: reference values, limits, continuity, and least time against a linear programme."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.interpolate import BPoly
from scipy.optimize import linprog

from tmodes.kinds.signals.registry import Signal

REFERENCES = json.loads((Path(__file__).parent / "data" / "shaping.json").read_text(encoding="utf-8"))
"""Reference values computed with closed forms to 40 digits, and checked by an independent optimiser."""

NUMBERS = st.floats(1e-3, 1e3)


def s_curve(way: float, speed: float, acceleration: float, jerk: float, start: float = 0.0) -> Any:
    limits = {"speed": speed, "acceleration": acceleration, "jerk": jerk}
    return Signal.of({"type": "s_curve", "start": start, "end": start + way, **limits})


def ends(signal: Signal) -> float:
    found = signal.move_ends()
    assert found is not None
    return found


def of_case(case: dict) -> Any:
    if "j" in case:
        return s_curve(case["D"], case["v"], case["a"], case["j"])
    if "v" in case:
        move = {"type": "trapezoid", "speed": case["v"], "acceleration": case["a"]}
        return Signal.of({"start": 0.0, "end": case["D"], **move})
    return Signal.of({"type": "septic", "start": 0.0, "end": case["D"], "duration": case["T"]})


@pytest.mark.parametrize("name", [name for name in REFERENCES if name[:2] in ("j4", "j5", "j6")])
def test_reference_values(name: str) -> None:
    case = REFERENCES[name]
    signal, times = of_case(case), np.array(case["times"])
    assert signal.move_ends() == pytest.approx(case["T"], abs=1e-9)
    if name.startswith("j4"):
        jerking, steady, cruise = signal.durations()
        found = [jerking, steady, jerking, cruise, jerking, steady, jerking]
        assert found == pytest.approx(case["durations"], abs=1e-9)
    pieces = signal.schedule(1.5 * case["T"])
    times = np.minimum(times, np.nextafter(case["T"], 0) - 1e-12)
    for order, word in enumerate(("position", "velocity", "acceleration", "jerk")):
        if word in case:
            assert pieces.at(times, order) == pytest.approx(np.array(case[word]), abs=1e-9), word


@given(st.floats(-1e3, 1e3), NUMBERS, NUMBERS, NUMBERS)
@example(0.0, 1.0, 1.0, 1.0)
@example(1.0, 1.0, 1.0, 1.0)  # v j = a^2: no phase of steady acceleration
@example(2.0, 1.0, 1.0, 1.0)  # nor one of steady speed
@example(1e-9, 1.0, 1.0, 1.0)
@example(-1e3, 1e3, 1e-3, 1e3)
@settings(max_examples=150, deadline=None)
def test_an_s_curve_keeps_its_limits_and_takes_the_least_time(way, speed, acceleration, jerk) -> None:
    start = 0.3 if abs(way) > 1e-6 else 0.0
    signal = s_curve(way, speed, acceleration, jerk, start)
    whole = ends(signal)
    pieces = signal.schedule(max(2 * whole, 1e-9))
    assert (np.diff(pieces.knots) > 0).all()
    assert pieces.at(pieces.knots[-1]) == pytest.approx(start + way, abs=1e-9 * (1 + abs(way)))
    for order, limit in enumerate((speed, acceleration, jerk), 1):
        inner = np.concatenate([pieces.knots, *(pieces.knots[:-1] + s * np.diff(pieces.knots) for s in (0.3, 0.7))])
        assert np.abs(pieces.at(inner, order)).max() <= limit * (1 + 1e-9)
    for order in (1, 2):  # smooth: the same from both sides of each knot
        inner = pieces.knots[1:-1]
        before, after = pieces.at(np.nextafter(inner, 0), order), pieces.at(inner, order)
        rounding = 1e-12 * whole * (acceleration, jerk)[order - 1]
        assert before == pytest.approx(after, abs=1e-9 * (speed, acceleration)[order - 1] + rounding)
    if abs(way) > 1e-30:
        trapezoid = of_case({"D": way, "v": speed, "a": acceleration, "T": 0})
        trapezoid = ends(trapezoid)
        assert whole >= trapezoid * (1 - 1e-12)  # without a limit of the jerk
        assert whole <= trapezoid + 2 * acceleration / jerk * (1 + 1e-9) + 1e-12
        faster = [ends(s_curve(way, *limits))
                  for limits in ((1.5 * speed, acceleration, jerk), (speed, acceleration, 1.5 * jerk))]  # fmt: skip
        assert max(faster) <= whole * (1 + 1e-12)


@pytest.mark.parametrize("limits", [(0.5, 1.0, 5.0), (1.2, 1.5, 10.0), (9.0, 9.0, 10.0), (0.5, 9.0, 5.0)])
def test_no_motion_within_the_limits_goes_farther_in_that_time(limits) -> None:
    """A linear programme over the jerk in 400 intervals: the farthest way from rest to rest in the time of 1."""
    whole, count = ends(s_curve(1.0, *limits)), 400
    h = whole / count
    later = np.tri(count, count)
    a = h * later
    v = h * (np.tri(count, count, -1) @ a) + h * a / 2
    x = (h * (np.tri(count, count, -1) @ v))[-1] + h * v[-1]
    rows = np.concatenate([v, -v, a, -a])
    most = np.repeat(limits[:2], 2 * count)
    found = linprog(-x, rows, most, np.stack([v[-1], a[-1]]), [0, 0], bounds=(-limits[2], limits[2]))
    assert -found.fun == pytest.approx(1.0, rel=2e-2)


@given(
    st.lists(st.floats(-10, 10), min_size=8, max_size=8), st.floats(0.05, 20), st.sampled_from(["quintic", "septic"])
)
@settings(max_examples=100, deadline=None)
def test_a_polynomial_has_the_derivatives_of_its_ends(ends, duration, kind) -> None:
    """As the Bernstein polynomial of SciPy through the same derivatives."""
    count = 3 if kind == "quintic" else 4
    names = ["", "_rate", "_acceleration", "_jerk"][:count]
    low, high = ends[:count], ends[4 : 4 + count]
    fields = dict(zip([f"start{name}" for name in names], low, strict=True))
    fields |= dict(zip([f"end{name}" for name in names], high, strict=True))
    pieces = Signal.of({"type": kind, "duration": duration, **fields}).schedule(duration)
    peer = BPoly.from_derivatives([0, duration], [low, high])
    times = np.linspace(0, duration, 41)
    scale = np.abs([value * duration**k for side in (low, high) for k, value in enumerate(side)]).max() + 1e-9
    for order in range(count):
        exact = peer.derivative(order)(times) if order else peer(times)
        assert np.abs(pieces.at(times, order) - exact).max() <= 1e-11 * 40**order * scale / duration**order


@given(st.floats(-10, 10), st.floats(-10, 10), st.floats(1e-3, 1e3))
@settings(max_examples=50, deadline=None)
def test_a_squared_sine(start, end, duration) -> None:
    pieces = Signal.of({"type": "sine_squared", "start": start, "end": end, "duration": duration}).schedule(
        2 * duration
    )
    x = np.linspace(0, 1, 333)
    way = end - start
    assert pieces.at(x * duration) == pytest.approx(start + way * (x - np.sin(2 * np.pi * x) / (2 * np.pi)), abs=1e-11)
    speed = 2 * way / duration * np.sin(np.pi * x) ** 2
    assert pieces.at(x * duration, 1) == pytest.approx(speed, abs=1e-8 * (abs(way) / duration + 1e-9))
