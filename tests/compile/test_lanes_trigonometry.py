"""Sine and cosine of four lanes at once: right to the last place, and bit for bit those of one double."""

from __future__ import annotations

import casadi as ca
import mpmath
import numpy as np
import pytest

from tmodes.compile.ir import kernels
from tmodes.kinds.kernel.schedule import Kernel, Schedule

TURN = Kernel("test turn", (1,), (2,), lambda x: [[ca.sin(x[0]), ca.cos(x[0])]])


def turned(x, arithmetic: str):
    """Sine and cosine of samples, by one schedule of one kernel."""
    schedule = Schedule(0)
    schedule.output("both", *schedule.call(TURN, schedule.input("x", 1)))
    width = 4 if arithmetic == "lanes" else 1
    samples, out = np.ascontiguousarray(x, dtype=float), np.empty((len(x), 2))
    none, workspace = np.zeros(1), np.zeros(width * schedule.workspace)
    run = kernels.schedule_function("turn", schedule, arithmetic)["run"]
    run(len(x) // width, 0, *(array.ctypes.data for array in (none, workspace, samples, out)))
    return out


@pytest.fixture(scope="module")
def angles():
    rng = np.random.default_rng(11)
    turns = np.pi / 2 * rng.integers(-500000, 500000, 200)
    edges = [0.0, -0.0, 5e-324, 1e-300, 1e-8, -1e-8, 2.0**19 * np.pi / 2, -(2.0**19) * np.pi / 2, 1e15, -1e22, 1e300]
    near = np.nextafter(2.0**19 * np.pi / 2, 0)
    return np.concatenate([rng.uniform(-7, 7, 1000), rng.uniform(-8e5, 8e5, 400), turns, [*edges, near]])


def test_lanes_are_right_to_one_place(angles):
    found = turned(angles, "lanes")
    mpmath.mp.prec = 1200
    for column, true in enumerate((mpmath.sin, mpmath.cos)):
        exact = [true(mpmath.mpf(value)) for value in angles]
        places = [
            abs(float((mpmath.mpf(value) - right) / mpmath.mpf(np.spacing(abs(float(right))))))
            for value, right in zip(found[:, column], exact, strict=True)
        ]
        assert max(places) <= 1.0, (true.__name__, angles[int(np.argmax(places))], max(places))


def test_lanes_equal_single_numbers_to_the_bit(angles):
    """In every order, so that far lanes stand next to near ones; the sign of zero counts too."""
    mixed = np.random.default_rng(5).permutation(np.concatenate([angles, 10.0 ** np.arange(-8, 36)]))
    mixed = mixed[: len(mixed) // 4 * 4]
    assert turned(mixed, "lanes").tobytes() == turned(mixed, "double").tobytes()


def test_what_is_no_number_spoils_its_own_lane_alone():
    x = np.array([0.3, np.nan, np.inf, -0.7])
    found = turned(x, "lanes")
    assert np.isnan(found[1:3]).all()
    assert found[[0, 3]].tobytes() == turned(x[[0, 3]], "double").tobytes()
