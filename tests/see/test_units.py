"""Readable units."""

from __future__ import annotations

import numpy as np
import pytest

from tmodes.io.printed import changed_by
from tmodes.plot.panels import pretty, readable


@pytest.mark.parametrize(
    ("unit", "values", "name", "factor"),
    [
        ("m", [-4.1e-3, 2e-3], "mm", 1e3),
        ("m", [0.9], "m", 1.0),
        ("m", [2e4], "m", 1.0),
        ("m", [8e-5], "µm", 1e6),
        ("rad", [0.0115], "mrad", 1e3),
        ("rad", [3e5], "rad", 1.0),
        ("N", [-4.98], "N", 1.0),
        ("N", [52e3], "kN", 1e-3),
        ("N m", [6.9], "N·m", 1.0),
        ("rad/s^2", [0.002], "mrad/s²", 1e3),
        ("J", [0.0], "J", 1.0),
        ("J", [1e-20], "J", 1.0),
        ("rad", [3e-10], "nrad", 1e9),
        ("s", [], "s", 1.0),
    ],
)
def test_the_largest_value_reads_well(unit: str, values: list[float], name: str, factor: float) -> None:
    chosen = readable(unit, np.array(values))
    assert (chosen.name, chosen.factor) == (name, factor)
    np.testing.assert_allclose(chosen.of(values), np.array(values) * factor)


def test_the_largest_of_several() -> None:
    assert readable("m", [1e-5], [0.5]).name == "m"


@pytest.mark.parametrize(
    ("unit", "written"),
    [("N*m/rad", "N·m/rad"), ("N m", "N·m"), ("kg*m^2", "kg·m²"), ("ohm", "Ω"), ("-", "–"), ("1", "–"), ("", "–")],
)
def test_units_are_written_as_in_books(unit: str, written: str) -> None:
    assert pretty(unit) == written


@pytest.mark.parametrize(
    ("value", "first", "words"),
    [(143.0, 1.0, "×143"), (66.0, 100.0, "−34 %"), (2.0, 1.0, "×2"), (1.5, 1.0, "+50 %"), (-3.0, -2.0, "+50 %"),
     (1e-3, 1.0, "÷1000"), (0.5, 0.0, "from 0"), (0.0, 0.5, "to 0"), (1e-3, 1e-17, "from nearly 0"), (1.0, 1.0, ""),
     (1.0, -1.0, "")],
)  # fmt: skip
def test_a_change_has_a_meaning(value: float, first: float, words: str) -> None:
    """Factors instead of percentages of many digits; nothing where there is no ratio."""
    assert changed_by(value, first) == words
