"""The search for the least worst case against published optima and closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from tmodes.study.optimize.gradient import Terms, descend_worst

Array = NDArray[np.float64]
_SIDE = 3.0


def charalambous_bandler(x: Array) -> tuple[Array, Array]:
    """Three functions (3,) and their slopes (3, 2)."""
    a, b = x
    values = np.array([a**2 + b**4, (2 - a) ** 2 + (2 - b) ** 2, 2 * np.exp(b - a)])
    return values, np.array([[2 * a, 4 * b**3], [2 * a - 4, 2 * b - 4], [-values[2], values[2]]])


def test_the_least_of_three_functions_is_the_published_one() -> None:
    """CB2: C. Charalambous, A. R. Conn, SIAM J. Numer. Anal. 15, 1978: 1.9522245 at (1.139037, 0.899557)."""
    tried = []

    def cases(shares: Array) -> Array:
        tried.append(shares)
        return charalambous_bandler(_SIDE * shares)[0][None]

    def of(shares: Array, case: int) -> Terms:
        values, slopes = charalambous_bandler(_SIDE * shares)
        return Terms(float(values[case]), _SIDE * slopes[case], np.zeros(0), np.zeros((0, 2)))

    found = _SIDE * descend_worst(cases, of, np.array([2.0, 0.1]) / _SIDE, precision=1e-10)
    assert charalambous_bandler(found)[0].max() == pytest.approx(1.9522245, abs=2e-6)
    assert found == pytest.approx([1.139037, 0.899557], abs=2e-3)
    assert len(tried) < 100


def test_a_limit_is_kept_and_cases_that_fail_are_left() -> None:
    """Least max(x, y) on x + y >= 1, where nothing runs below x = 0.3: (1/2, 1/2)."""

    def cases(s: Array) -> Array:
        if s[0] < 0.3:
            return np.full((2, 2), np.nan)
        return np.array([[s[0], s[1]], [1 - s.sum()] * 2])

    def of(s: Array, case: int) -> Terms:
        return Terms(float(s[case]), np.eye(2)[case], np.array([1 - s.sum()]), -np.ones((1, 2)))

    found = descend_worst(cases, of, np.array([0.9, 0.8]), precision=1e-9)
    assert found == pytest.approx([0.5, 0.5], abs=1e-6)
    assert found.sum() >= 1.0


def test_a_start_that_fails_is_where_it_ends() -> None:
    start = np.array([0.4])
    nowhere = Terms(np.nan, np.zeros(1), np.zeros(0), np.zeros((0, 1)))
    assert descend_worst(lambda s: np.full((1, 3), np.nan), lambda s, case: nowhere, start, precision=1e-3) is start
