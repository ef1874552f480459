"""What every trapezoidal move keeps: it ends where it should, is continuous with its rate, and lasts as it says."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmodes.kinds.signals.trapezoid import Trapezoid

moves = st.builds(
    Trapezoid,
    type=st.just("trapezoid"),
    start=st.floats(-10, 10),
    end=st.floats(-10, 10),
    duration=st.floats(0.01, 100),
    ramp_fraction=st.one_of(st.just(0.5), st.floats(0.01, 0.5)),
)


@given(moves)
def test_from_rest_to_rest(move):
    """Start, end, and no speed at either."""
    motion = move.schedule(move.duration)
    assert motion.duration == pytest.approx(move.duration)
    size = 1 + abs(move.start) + abs(move.end)
    assert motion.at([0.0, move.duration]) == pytest.approx([move.start, move.end], abs=1e-12 * size)
    assert motion.at([0.0, move.duration], 1) == pytest.approx([0, 0], abs=1e-11 * size / move.duration)


@given(moves)
def test_continuous_with_its_rate(move):
    """No jump of angle or speed at a knot, and the speed is the derivative of the angle."""
    motion, size = move.schedule(move.duration), 1 + abs(move.start) + abs(move.end)
    for left, right, knot in zip(motion.coefficients[:-1], motion.coefficients[1:], motion.knots[1:-1], strict=True):
        tau = knot - motion.knots[:-1][list(motion.knots[1:]).index(knot)]
        powers = tau ** np.arange(3)
        assert left @ powers == pytest.approx(right[0], abs=1e-11 * size)
        assert left[1] + 2 * left[2] * tau == pytest.approx(right[1], abs=1e-10 * size / move.duration)
    inside = np.linspace(0, move.duration, 41)[1:-1]
    inside = inside[np.abs(inside[:, None] - motion.knots).min(axis=1) > 1e-3 * move.duration]
    step = 1e-5 * move.duration
    slope = (motion.at(inside + step) - motion.at(inside - step)) / (2 * step)
    assert motion.at(inside, 1) == pytest.approx(slope, abs=1e-8 * size / move.duration)


@given(moves, st.floats(0.1, 3.0))
def test_cut_or_held(move, share):
    """A schedule up to another time is the same within the move, and holds the last value beyond."""
    motion, end = move.schedule(move.duration), share * move.duration
    other = move.schedule(end)
    assert other.knots[-1] == end
    assert (np.diff(other.knots) > 0).all()
    times = np.linspace(0, end, 50)
    wanted = np.where(times < move.duration, motion.at(times), motion.at(move.duration))
    assert other.at(times) == pytest.approx(wanted, abs=1e-10 * (1 + abs(move.start) + abs(move.end)))


@given(moves)
def test_rows_are_what_compiled_code_reads(move):
    """Each row: start of the piece, then its coefficients."""
    motion = move.schedule(move.duration)
    times = np.linspace(0, move.duration, 7)
    rows = motion.rows_at(times)
    tau = times - rows[:, 0]
    value = rows[:, 1] + rows[:, 2] * tau + rows[:, 3] * tau**2
    assert value == pytest.approx(motion.at(times), abs=1e-12 * (1 + abs(move.start) + abs(move.end)))
