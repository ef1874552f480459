"""Rows of an extrapolation tableau in lanes: who takes which step, and the weights of their ends."""

from __future__ import annotations

import numpy as np
import pytest

from tmodes.compile.loops.extrapolation_rows import (
    LANES,
    limit_weights,
    passes_of,
    schedule_of,
    spread_weights,
    steady_weights,
)


@pytest.mark.parametrize("rows", range(1, 10))
def test_every_step_is_taken_once_and_in_order(rows: int) -> None:
    steps = schedule_of(rows)
    assert {(s.row, s.step) for s in steps} == {(row, step) for row in range(1, rows + 1) for step in range(row)}
    assert len({(s.at, s.lane) for s in steps}) == len(steps)
    for row in range(1, rows + 1):
        own = [s for s in steps if s.row == row]
        assert len({s.lane for s in own}) == 1
        assert [s.at - own[0].at for s in own] == list(range(row))


def test_lanes_have_hardly_a_hole() -> None:
    assert [passes_of(rows) for rows in range(1, 10)] == [1, 2, 3, 4, 5, 6, 7, 9, 12]
    assert passes_of(8) * LANES == len(schedule_of(8))


def growth(weights: dict[int, float], w: np.ndarray) -> np.ndarray:
    """What one step of length 1 makes of a vibration of frequency w, by the rows' own closed form."""
    return np.sum([weight * (1 - 1j * w / row) ** -row for row, weight in weights.items()], axis=0)


def order(weights: dict[int, float]) -> float:
    """Fitted slope of the error of a step over its length, less one."""
    lengths = np.array([0.2, 0.4])
    errors = np.abs(growth(weights, lengths) - np.exp(1j * lengths))
    return float(np.log(errors[1] / errors[0]) / np.log(2.0)) - 1.0


def test_orders_of_the_combinations() -> None:
    assert order(steady_weights()) == pytest.approx(6.0, abs=0.15)
    assert order(steady_weights(5)) == pytest.approx(3.0, abs=0.25)
    assert order(limit_weights(6)) == pytest.approx(6.0, abs=0.15)
    assert order(limit_weights(6, 2)) == pytest.approx(5.0, abs=0.15)


def test_no_vibration_grows() -> None:
    """By more than a thousandth in a step, and fast ones die; the limit itself lets one grow ten times as much."""
    w = np.linspace(0.01, 20.0, 20_000)
    assert np.abs(growth(steady_weights(), w)).max() < 1.0011
    assert np.abs(growth(limit_weights(8), w)).max() > 1.012
    assert np.abs(growth(steady_weights(), w[w > 6.0])).max() < 0.9
    assert np.abs(growth(steady_weights(), np.array([1e4]))).max() < 0.05
    assert np.abs(growth(steady_weights(5), w)).max() < 1.0001
    assert np.abs(growth(limit_weights(5), w)).max() > 1.007
    assert np.abs(growth(steady_weights(5), np.array([1e4]))).max() < 0.05


def test_weights_stand_where_the_steps_end() -> None:
    spread = spread_weights({(0, 0): 2.0, (8, 8): 3.0, (1, 1): 5.0}, 8)
    places = {(s.row, s.step): (s.at + 1, s.lane) for s in schedule_of(8)}
    assert spread.shape == (10, 4)
    assert spread[0, 0] == 2.0
    assert spread[places[8, 7]] == 3.0
    assert spread[places[1, 0]] == 5.0
    assert np.count_nonzero(spread) == 3
