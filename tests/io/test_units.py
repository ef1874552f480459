"""Numbers with units are converted at the border of the file, and nothing else is."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tmodes.io.units import EVERYDAY, NotANumber, library_factor, number


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("600 mm", "m", 0.6),
        ("700 mm", "m", 0.7),
        ("0.1mm", "m", 1e-4),
        ("1e5", "m", 1e5),
        (" -.5 ", "rad", -0.5),
        ("45 deg", "rad", math.pi / 4),
        ("45°", "rad", math.pi / 4),
        ("82 N*m/deg", "N*m/rad", 82 * 180 / math.pi),
        ("2 N*m/(deg/s)", "N*m*s/rad", 360 / math.pi),
        ("0.316 V/rpm", "V*s/rad", 0.316 * 30 / math.pi),
        ("5 kg cm^2", "kg*m^2", 5e-4),
        ("5 kg·m²", "kg*m^2", 5.0),
        ("3 N*mm**2", "N*m^2", 3e-6),
        ("2 g/mm", "kg/m", 2.0),
        ("9.81 m s^-2", "m/s^2", 9.81),
        ("200 GPa", "Pa", 2e11),
        ("20 percent", "-", 0.2),
        ("5 mΩ", "ohm", 5e-3),
        ("Infinity", "N*m/rad", math.inf),
        (".inf", "N*m/rad", math.inf),
        ("-.inf", "N*m/rad", -math.inf),
        (7, "m", 7.0),
    ],
)
def test_right_number(text: object, unit: str, value: float) -> None:
    assert number(text, unit) == pytest.approx(value, rel=1e-15, abs=0)


def test_a_decimal_prefix_costs_no_digit() -> None:
    assert [number(f"{count} mm", "m") for count in range(1, 1000)] == [count / 1000 for count in range(1, 1000)]


@pytest.mark.parametrize(
    ("value", "unit", "got", "hint"),
    [
        ("heavy", "kg", "the text 'heavy'", "a number in kg"),
        ("1,5", "m", "the text '1,5'", "a decimal point instead of the comma: 1.5"),
        ("1,5 mm", "m", "the text '1,5 mm'", "a decimal point instead of the comma: 1.5 mm"),
        ("5 kg", "m", "the unit 'kg' of '5 kg', which is of another dimension", "in m"),
        ("5 m", "-", "the unit 'm' of '5 m', which is of another dimension", "without a unit"),
        ("5 foo", "m", "the unit 'foo' of '5 foo', which is unknown", "in m"),
        ("200 N*m/rad/rad", "N*m/rad", "'N*m/rad/rad' of '200 N*m/rad/rad', which is of the same angle", "in N*m/rad"),
        ("2 Nm/rad^2", "N*m/rad", "which is of the same angle", "in N*m/rad"),
        ("2 deg*rad/s", "rad/s", "which is of the same angle", "in rad/s"),
        ("5 dB", "-", "the unit 'dB' of '5 dB', which is not a plain factor", "without a unit"),
        ("1e400", "m", "which no double can hold", "sensible size"),
        ("1e-400", "m", "which no double can hold", "sensible size"),
        ("1e308 km", "m", "which no double can hold", "sensible size"),
        (True, "m", "true", "true and false are not numbers"),
        (None, "m", "nothing", "after the colon"),
        ([1.0], "m", "a list of 1", "one number in m"),
        ({}, "m", "a group of 0 keys", "one number in m"),
        (math.nan, "m", ".nan", "a finite number"),
        (10**400, "m", "a whole number of about 400 digits", "a smaller number"),
        ("nan", "m", "the text 'nan'", "a number in m"),
        ("9**9**9**9", "m", "the text", "a number in m"),
        ("9 m**9**9", "m", "the text", "a number in m"),
        ("9 m**99", "m", "the text", "a number in m"),
        ("1 __import__('os')", "m", "the text", "a number in m"),
        ("1 m" + "*m" * 60, "m", "the text", "a number in m"),
        ("1" * 100, "m", "the text", "a number in m"),
        ("1_000", "m", "the text", "a number in m"),
        ("0x1F", "m", "the text", "a number in m"),
    ],
)
def test_wrong_number(value: object, unit: str, got: str, hint: str) -> None:
    with pytest.raises(NotANumber) as caught:
        number(value, unit)
    assert got in caught.value.got
    assert hint in caught.value.hint


@settings(max_examples=200)
@given(st.floats(allow_nan=False, allow_infinity=False))
def test_text_of_a_number_is_that_number(value: float) -> None:
    assert number(repr(value), "m") == value
    assert number(value, "m") == value


@settings(max_examples=200)
@given(st.from_regex(r"[-+]?[0-9.]{1,4}[eE0-9]{0,3} ?[a-zA-Zµ°*/^()0-9 .-]{0,12}", fullmatch=True))
def test_any_text_is_a_number_or_refused(text: str) -> None:
    try:
        assert not math.isnan(number(text, "m"))
    except NotANumber as error:
        hint = error.hint
        assert hint


@pytest.mark.parametrize(("unit", "text"), [(unit, text) for unit, known in EVERYDAY.items() for text in known])
def test_everyday_factors_are_those_of_the_unit_library(unit: str, text: str) -> None:
    assert EVERYDAY[unit][text] == library_factor(text, unit)
    assert number(f"3 {text}", unit) == pytest.approx(3 * EVERYDAY[unit][text], rel=1e-15)
