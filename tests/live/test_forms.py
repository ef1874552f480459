"""Numbers as exact functions of a few others: found by probing, checked against functions that are known."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
import pytest

from tmodes.model.fitting import fitted
from tmodes.model.forms import Range, Unfit

RANGES = (Range(2.0, 0.5, 8.0), Range(0.3, 0.1, 0.9), Range(0.0, 0.0, 20.0))

Function = Callable[[float, float, float], list[float]]


def evaluate(function: Function) -> Callable[[Mapping[int, float]], np.ndarray]:
    def at(values: Mapping[int, float]) -> np.ndarray:
        return np.array(function(*(values.get(k, one.start) for k, one in enumerate(RANGES))))

    return at


def generator() -> np.random.Generator:
    return np.random.default_rng(1)


def exact(x: float, y: float, z: float) -> list[float]:
    """Masses, moments of inertia, stiffness by damping time, a move's coefficients, a preload, and what is constant."""
    return [
        7.0,
        x,
        3 * x * y,
        5.0 + x * 0.25,
        x * y + 2 * y + 1,
        10 / x**3,
        -15 / x**4,
        6 / x**5,
        z + 1.5,
        y / x,
    ]


def test_products_and_polynomials_are_found() -> None:
    """Everywhere in the ranges, to rounding."""
    form, true = fitted(evaluate(exact), RANGES, generator()), evaluate(exact)
    draw = np.random.default_rng(2)
    for _ in range(50):
        values = {k: one.drawn(draw) for k, one in enumerate(RANGES)}
        assert form.at(values) == pytest.approx(true(values), rel=1e-13)


def test_many_values_at_once() -> None:
    form, draw = fitted(evaluate(exact), RANGES, generator()), np.random.default_rng(3)
    many = {k: np.array([one.drawn(draw) for _ in range(9)]) for k, one in enumerate(RANGES)}
    each = [form.at({k: float(values[place]) for k, values in many.items()}) for place in range(9)]
    assert form.at(many) == pytest.approx(np.array(each), rel=1e-14)


def test_unchanged_numbers_keep_all_their_bits() -> None:
    form = fitted(evaluate(exact), RANGES, generator())
    start = {k: one.start for k, one in enumerate(RANGES)}
    assert form.at(start).tobytes() == evaluate(exact)({}).tobytes()


@pytest.mark.parametrize("function", [np.sin, np.exp, lambda x: x / (1 + x)])
def test_what_has_no_such_form_is_reported(function: Callable[[float], float]) -> None:
    """The variable is named, not the others."""
    with pytest.raises(Unfit) as caught:
        fitted(evaluate(lambda x, y, z: [x, float(function(y)), z]), RANGES, generator())
    assert list(caught.value.reasons) == [1]


def test_a_product_of_powers_that_is_entangled_is_reported() -> None:
    """Each by itself is linear, both together are not: found by the random points alone."""
    with pytest.raises(Unfit):
        fitted(evaluate(lambda x, y, z: [x * y + max(0.0, (x - 2.0) * (y - 0.3)) ** 2]), RANGES[:2], generator())


def test_what_a_zero_hides_is_reported() -> None:
    """At the start the third variable is zero, so the first one does nothing: the random points show it."""
    with pytest.raises(Unfit):
        fitted(evaluate(lambda x, y, z: [z * x]), RANGES, generator())


def test_rounding_is_no_dependence() -> None:
    """A number that is zero but for rounding, next to large ones."""
    form = fitted(evaluate(lambda x, y, z: [1e3 * x, (x + 1e3) - x - 1e3, y]), RANGES, generator())
    assert 1 not in form.products
    assert 1 not in form.sums
