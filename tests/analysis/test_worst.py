"""The largest of a series is where rounding does not decide."""

from __future__ import annotations

import numpy as np

from tmodes.analysis.worst import worst_place


def test_of_a_constant_series_it_is_the_first_whatever_rounding_adds() -> None:
    noise = 1 + 1e-12 * np.random.default_rng(3).standard_normal((50, 3))
    assert worst_place(noise) == (0, 0)
    assert worst_place(-noise[:, 0]) == (0,)


def test_a_larger_value_counts_from_the_ninth_digit_on_and_no_number_does_not() -> None:
    assert worst_place([0.0, 1.0, 1.0 + 5e-10, -1.0]) == (1,)
    assert worst_place([0.0, 1.0, -1.0 - 2e-9, np.nan]) == (2,)
    assert worst_place(np.zeros((2, 2))) == (0, 0)
