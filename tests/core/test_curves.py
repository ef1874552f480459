"""Smooth functions that are no powers: curves between the ends of a variable, found by probing, exact to rounding."""

from __future__ import annotations

import numpy as np
import pytest

from tmodes.model.fitting import fitted
from tmodes.model.forms import Range, Unfit

WALL, LOAD, ANGLE = Range(1e-3, 1e-3, 20e-3), Range(2.0, 2.0, 6.0), Range(-1.0, -1.0, 2.0)
OUTER = 0.09


def tube(wall: float, load: float, angle: float) -> list[float]:
    """Area, stiffness, compliance, Cowper's coefficient of a tube; a product with a load, what is added; a rotation."""
    inner = OUTER - 2 * wall
    stiffness = np.pi / 64 * (OUTER**4 - inner**4)
    ratio = inner / OUTER
    cowper = 6 * 1.3 * (1 + ratio**2) ** 2 / ((7 + 6 * 0.3) * (1 + ratio**2) ** 2 + (20 + 12 * 0.3) * ratio**2)
    area = np.pi / 4 * (OUTER**2 - inner**2)
    return [area, stiffness, 1 / stiffness, cowper * area, load * stiffness, load + area, np.cos(angle), 7.0, load]


def vector(ranges: tuple[Range, ...]):
    return lambda values: np.array(tube(*(values.get(k, one.start) for k, one in enumerate(ranges))))


def test_sections_and_rotations_are_exact_to_rounding() -> None:
    ranges = WALL, LOAD, ANGLE
    form = fitted(vector(ranges), ranges, np.random.default_rng(0), curves=True)
    draw = np.random.default_rng(1)
    drawn = {k: np.array([one.drawn(draw) for _ in range(200)]) for k, one in enumerate(ranges)}
    true = np.array([tube(*point) for point in zip(*drawn.values(), strict=True)])
    assert form.at(drawn) == pytest.approx(true, rel=1e-12, abs=1e-15)


def test_what_changes_alike_shares_one_curve() -> None:
    """The stiffness, and its product with the load."""
    form = fitted(vector((WALL, LOAD, ANGLE)), (WALL, LOAD, ANGLE), np.random.default_rng(0), curves=True)
    curves = [{p for _, powers in form.sums[entry] for k, p in powers if k == 0} for entry in (1, 4)]
    assert curves[0] == curves[1]
    assert len(curves[0]) == 1


@pytest.mark.parametrize("function", [abs, lambda x: max(x, 0.1), lambda x: 1 / (1 + 1e4 * x**2)])
def test_what_is_not_smooth_enough_is_reported(function) -> None:
    with pytest.raises(Unfit, match="no power"):
        fitted(lambda v: np.array([function(v.get(0, -1.0))]), (ANGLE,), np.random.default_rng(0), curves=True)


def test_two_that_act_together_in_another_way_are_reported() -> None:
    """Thickness and diameter of a tube: the random points show it."""

    def stiffness(values):
        wall, outer = values.get(0, 1e-3), values.get(1, 0.05)
        return np.array([outer**4 - (outer - 2 * wall) ** 4])

    ranges = Range(1e-3, 1e-3, 5e-3), Range(0.05, 0.05, 0.1)
    with pytest.raises(Unfit, match="together"):
        fitted(stiffness, ranges, np.random.default_rng(0), curves=True)
