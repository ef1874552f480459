"""Signals: values and derivatives against closed forms, knots on every jump, formulas by a closed grammar."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import TypeAdapter, ValidationError
from scipy.interpolate import CubicSpline

from patience import bounded
from tmodes.errors import InputError, InputErrors
from tmodes.kinds.signals.formula import FormulaError, parse_formula
from tmodes.kinds.signals.registry import Signal, merge
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.robots.load import load

READ = TypeAdapter(Signal)


def schedule(until: float = 2.0, **signal) -> SignalPieces:
    return READ.validate_python(signal).schedule(until)


def formula(text: str, until: float = 2.0) -> SignalPieces:
    return schedule(until, type="expression", formula=text)


TIMES = np.linspace(0, 2, 4001)


def check(found: SignalPieces, exact, rate=None, tolerance=1e-12) -> None:
    """Against functions of time, over the largest of their values."""
    values = exact(TIMES)
    np.testing.assert_allclose(found.at(TIMES), values, atol=tolerance * np.abs(values).max(), rtol=0)
    assert (found.knots[0], found.knots[-1]) == (0.0, 2.0)
    assert (np.diff(found.knots) > 0).all()
    if rate is not None:
        rates = rate(TIMES)
        np.testing.assert_allclose(found.at(TIMES, 1), rates, atol=1e-9 * np.abs(rates).max(), rtol=0)


def test_constant() -> None:
    check(schedule(type="constant", value=3.0), lambda t: 3 + 0 * t)


def test_a_step_has_its_knot_on_the_jump() -> None:
    found = schedule(type="step", start=1.0, end=5.0, time=0.7)
    assert found.knots.tolist() == [0.0, 0.7, 2.0]
    assert found.at([0.0, np.nextafter(0.7, 0), 0.7, 2.0]).tolist() == [1, 1, 5, 5]


@pytest.mark.parametrize(("when", "value"), [(0.0, 5.0), (2.0, 1.0), (9.0, 1.0)])
def test_a_step_at_an_end(when: float, value: float) -> None:
    assert schedule(type="step", start=1.0, end=5.0, time=when).at([0.0, 1.9]).tolist() == [value, value]


def test_quintic_by_its_closed_form() -> None:
    def exact(t):
        x = np.clip((t - 0.25) / 1.2, 0, 1)
        return 0.5 + 1.5 * (10 * x**3 - 15 * x**4 + 6 * x**5)

    def rate(t):
        x = np.clip((t - 0.25) / 1.2, 0, 1)
        return 1.5 / 1.2 * 30 * x**2 * (1 - x) ** 2

    found = schedule(type="quintic", start=0.5, end=2.0, duration=1.2, delay=0.25)
    check(found, exact, rate)
    assert found.at(np.array([0.25, 1.45]), 2) == pytest.approx(0, abs=1e-11)


def test_trapezoid_by_its_closed_form() -> None:
    """Speed of the trapezoid, integrated exactly: 1/(T - ramp) at most."""
    top, ramp = 2.0 / (1.5 - 0.3), 0.3

    def rate(t):
        x = t - 0.1
        return top * np.clip(np.minimum(x, 1.5 - x) / ramp, 0, 1)

    found = schedule(type="trapezoid", start=-1.0, end=1.0, duration=1.5, ramp_fraction=0.2, delay=0.1)
    np.testing.assert_allclose(found.at(TIMES, 1), rate(TIMES), atol=1e-12)
    assert found.at([0.0, 0.1, 0.85, 1.6, 2.0]) == pytest.approx([-1, -1, 0, 1, 1], abs=1e-14)
    assert found.knots == pytest.approx([0, 0.1, 0.4, 1.3, 1.6, 2.0])


def test_a_move_is_cut_at_the_end_of_the_run() -> None:
    found = schedule(1.0, type="quintic", start=0.0, end=1.0, duration=2.0)
    assert found.knots[-1] == 1.0
    assert found.at(1.0) == pytest.approx(0.5)


@pytest.mark.parametrize("hertz", [0.01, 1.0, 37.0, 1000.0])
def test_sine_to_twelve_digits(hertz: float) -> None:
    omega = 2 * np.pi * hertz
    found = schedule(type="sine", amplitude=2.0, frequency=hertz, phase=0.3, offset=-1.0)
    values = found.at(TIMES)
    noise = 4e-16 * omega * 2 * 2
    np.testing.assert_allclose(values, -1 + 2 * np.sin(omega * TIMES + 0.3), atol=2e-12 + noise)
    np.testing.assert_allclose(found.at(TIMES, 1), 2 * omega * np.cos(omega * TIMES + 0.3), atol=1e-9 * omega)


def test_a_linear_table_jumps_where_a_time_stands_twice() -> None:
    found = schedule(type="table", times=[0.5, 1.0, 1.0, 1.5], values=[1, 2, 4, 3], interpolation="linear")
    assert found.knots.tolist() == [0, 0.5, 1.0, 1.5, 2.0]
    assert found.at([0.0, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0]).tolist() == [1, 1, 1.5, 4, 3.5, 3, 3]


def test_a_table_that_jumps_at_its_ends() -> None:
    found = schedule(type="table", times=[0.5, 0.5, 1.0, 1.0], values=[1, 2, 3, 7], interpolation="linear")
    assert found.at([0.0, 0.4, 0.5, 0.75, 1.0, 1.9]).tolist() == [1, 1, 2, 2.5, 7, 7]
    first = schedule(type="table", times=[0, 0, 1], values=[5, 1, 2], interpolation="linear")
    assert first.at([0.0, 0.5]).tolist() == [1, 1.5]


def test_a_cubic_table_is_the_spline_that_starts_and_ends_at_rest() -> None:
    times, values = [0.2, 0.5, 1.1, 1.4], [1.0, 3.0, -2.0, 0.5]
    found = schedule(type="table", times=times, values=values, interpolation="cubic")
    spline = CubicSpline(times, values, bc_type="clamped")
    inside = np.linspace(0.2, 1.4, 101)
    np.testing.assert_allclose(found.at(inside), spline(inside), atol=1e-13)
    np.testing.assert_allclose(found.at(inside[:-1], 1), spline(inside[:-1], 1), atol=1e-12)
    assert found.at([0.0, 2.0]).tolist() == [1.0, 0.5]


@pytest.mark.parametrize(
    ("times", "values", "how"),
    [
        ([0, 1], [1, 2, 3], "linear"),
        ([0, 2, 1], [1, 2, 3], "linear"),
        ([0, 1, 1, 1], [1, 2, 3, 4], "linear"),
        ([0, 1, 1], [1, 2, 3], "cubic"),
        ([-1, 1], [1, 2], "linear"),
        ([0], [1], "linear"),
        ([0, math.nan], [1, 2], "linear"),
        ([0, 1], [1, 2], "quadratic"),
        (list(range(10_001)), [0] * 10_001, "linear"),
    ],
)
def test_tables_that_are_none(times, values, how: str) -> None:
    with pytest.raises(ValidationError):
        READ.validate_python({"type": "table", "times": times, "values": values, "interpolation": how})


EXPRESSIONS = [
    ("0.2*sin(2*pi*t)*exp(-t)", lambda t: 0.2 * np.sin(2 * np.pi * t) * np.exp(-t)),
    ("-(t - 1)**3 + +2", lambda t: 2 - (t - 1) ** 3),
    ("1/(1 + 100*(t - 0.7)**2)", lambda t: 1 / (1 + 100 * (t - 0.7) ** 2)),
    ("abs(sin(7*t))", lambda t: np.abs(np.sin(7 * t))),
    ("tanh(50*(t - 1.2345))", lambda t: np.tanh(50 * (t - 1.2345))),
    ("3", lambda t: 3 + 0 * t),
    ("(1 + t)**-0.5", lambda t: (1 + t) ** -0.5),
    ("atan(t) + log(1 + t) + sqrt(1 + t) + cosh(t) + cos(t)*sinh(t)/tan(1 + t/10)", None),
    ("asin(t/3) + acos(t/3)", lambda t: np.pi / 2 + 0 * t),
]


@pytest.mark.parametrize(("text", "exact"), EXPRESSIONS)
def test_expressions_to_twelve_digits(text: str, exact) -> None:
    def spelt(t):
        return np.arctan(t) + np.log1p(t) + np.sqrt(1 + t) + np.cosh(t) + np.cos(t) * np.sinh(t) / np.tan(1 + t / 10)

    found = formula(text)
    assert found.degree == 7
    check(found, exact or spelt, tolerance=3e-12)


PIECES = [
    ("where(t < 0.7, 1, -2)", lambda t: np.where(t < 0.7, 1.0, -2.0)),
    ("sign(t - 0.7)*t", lambda t: np.where(t < 0.7, -t, t)),
    ("min(t, 0.5, 1 - t)", lambda t: np.minimum(np.minimum(t, 0.5), 1 - t)),
    ("max(sin(10*t), 0, cos(10*t))", lambda t: np.maximum(np.maximum(np.sin(10 * t), 0), np.cos(10 * t))),
    ("piecewise(t < 0.3, 0, t < 1, (t - 0.3)**2, 0.49)",
     lambda t: np.where(t < 0.3, 0.0, np.where(t < 1, (t - 0.3) ** 2, 0.49))),
    ("where(0.2 < t <= 0.21 or not t < 1.9 and t > 1, exp(t), 0)",
     lambda t: np.where(((t >= 0.2) & (t < 0.21)) | (t >= 1.9), np.exp(t), 0)),
    ("where(abs(t - 0.50001) < 1e-6, 1, t)", lambda t: np.where(np.abs(t - 0.50001) < 1e-6, 1, t)),
    ("where(t > 1, log(t - 0.5), 0)", lambda t: np.where(t >= 1, np.log(np.maximum(t, 1) - 0.5), 0)),
    ("sign(sin(30*t + 1)) + abs(cos(9*t))", lambda t: np.sign(np.sin(30 * t + 1)) + np.abs(np.cos(9 * t))),
]  # fmt: skip


@pytest.mark.parametrize(("text", "exact"), PIECES)
def test_pieces_with_a_knot_where_they_switch(text: str, exact) -> None:
    """On both sides of every switch the value and the rate are those of the pieces, at it those of the later one."""
    found = formula(text)
    check(found, exact, tolerance=3e-12)
    times = np.setdiff1d(np.concatenate([found.knots - 1e-7, found.knots + 1e-7]), [0, 2])
    times = times[(times > 1e-3) & (times < 2 - 1e-3)]
    np.testing.assert_allclose(found.at(times), exact(times), rtol=0, atol=3e-12 * np.abs(exact(TIMES)).max())
    slopes = (exact(times + 1e-8) - exact(times - 1e-8)) / 2e-8
    np.testing.assert_allclose(found.at(times, 1), slopes, rtol=1e-5, atol=1e-5)


@given(
    edges=st.lists(st.floats(0.01, 1.99), min_size=1, max_size=4, unique=True),
    values=st.lists(st.integers(-3, 3), min_size=5, max_size=5),
)
@settings(max_examples=30, deadline=None)
def test_random_pieces(edges: list[float], values: list[int]) -> None:
    edges = sorted(edges)
    cases = ", ".join(f"t < {edge!r}, {value} + t" for edge, value in zip(edges, values, strict=False))
    found = formula(f"piecewise({cases}, {values[-1]})")
    place = np.searchsorted(edges, TIMES, side="right")
    chosen = np.array([*values[: len(edges)], values[-1]])[place]
    np.testing.assert_allclose(found.at(TIMES), chosen + TIMES * (place < len(edges)), atol=1e-11)


@pytest.mark.parametrize(("speed", "acceleration"), [(0.5, 2.0), (4.0, 2.0), (1.0, 1e6)])
@pytest.mark.parametrize("end", [1.3, -0.4, 0.2])
def test_trapezoid_by_speed_and_acceleration(speed: float, acceleration: float, end: float) -> None:
    """It is at its speed, or where the way is too short for that accelerates to its middle."""
    found = schedule(4.0, type="trapezoid", start=0.2, end=end, speed=speed, acceleration=acceleration, delay=0.1)
    way, times = abs(end - 0.2), np.linspace(0, 4, 40001)
    top = min(speed, np.sqrt(way * acceleration))
    assert (found.at(0.0), found.at(4.0)) == (pytest.approx(0.2), pytest.approx(end))
    assert np.abs(found.at(times, 1)).max() == pytest.approx(top, rel=1e-3)
    assert np.abs(found.at(times, 2)).max() == pytest.approx(acceleration if way else 0.0, rel=1e-9)
    if way:
        assert found.knots[-2] == pytest.approx(0.1 + way / top + top / acceleration)


@pytest.mark.parametrize(
    "given",
    [{}, {"speed": 1.0}, {"duration": 1.0, "speed": 1.0}, {"duration": 1.0, "ramp_fraction": 0.2, "acceleration": 1.0}],
)
def test_a_trapezoid_by_half_of_each_is_refused(given: dict) -> None:
    with pytest.raises(ValidationError):
        READ.validate_python({"type": "trapezoid", "start": 0.0, "end": 1.0, **given})


def test_a_square_root_at_its_branch_point() -> None:
    """The slope is infinite at 0, so the first, smallest piece is not exact; everywhere else it is."""
    found = formula("sqrt(t)")
    np.testing.assert_allclose(found.at(TIMES[1:]), np.sqrt(TIMES[1:]), atol=3e-12)
    assert found.at(0.0) == pytest.approx(0, abs=1e-6)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("1/(t - 1)", "no finite value at t = 1 s"),
        ("abs(t - 0.3)/(t - 0.3)*2 + 1", ""),
        ("tan(3*t)", "jump"),
        ("log(t - 5)", "no finite value at t = 0 s"),
        ("sin(1e9*t)", "pieces"),
        ("exp(exp(exp(9*t)))", "no finite value"),
        ("0/0", "no finite value"),
        ("9**20*9**20*9**20*9**20*9**20*9**20*9**20*9**20*9**20*9**20*9**20*9**20*9**20*9**20*9**20*9**20*9**20", ""),
    ],
)
def test_functions_that_no_run_can_follow(text: str, words: str) -> None:
    with bounded(10):
        with pytest.raises(InputError) as caught:
            formula(text)
        assert words in str(caught.value)


ATTACKS = [
    "__import__('os').system('id')",
    "().__class__.__bases__[0]",
    "t.__class__",
    "sin.__globals__",
    "lambda: 0",
    "[t for t in t]",
    "9**9**9",
    "2**t",
    "2**(2**2)",
    "t**1e9",
    "t**True",
    "t**-(-99)",
    "exec(t)",
    "eval(t)",
    "open(t)",
    "sin(t, t)",
    "sin(*t)",
    "sin(x=t)",
    "sin",
    "t(t)",
    "pi(t)",
    "x",
    "t if t else t",
    "t < 1",
    "t and t",
    "not t",
    "~t",
    "t % 2",
    "t // 2",
    "t @ t",
    "t ^ 2",
    "t; t",
    "t = 1",
    "(t := 1)",
    "t\nt",
    "1j",
    "True",
    "'a'",
    "f'{t}'",
    "b'a'",
    "...",
    "None",
    "2t",
    "1 2",
    "",
    " ",
    "(" * 300,
    "-" * 400 + "t",
    "t+" * 240 + "t",
    "9" * 400,
    "9" * 501,
    "1e999",
    "1or 2",
    "t\x00",
    "\u0074\u0301",
    "\uff54",
    "sin(sin(" * 20 + "t" + "))" * 20,
]


@pytest.mark.parametrize("text", ATTACKS)
def test_attacks_on_the_grammar(text: str) -> None:
    with bounded(0.5), pytest.raises(FormulaError):
        parse_formula(text)


@settings(max_examples=300)
@given(st.text(alphabet="t0123456789.+-*/() sincoexplgqrabhd_piJ'[],:=<>%^@", max_size=40))
def test_any_text_is_a_formula_or_an_error_of_ours(text: str) -> None:
    try:
        values = parse_formula(text)(TIMES[:5])
    except FormulaError:
        return
    assert values.shape == (5,)


def test_merged_signals_are_what_they_were() -> None:
    parts = [
        schedule(type="sine", amplitude=1.0, frequency=3.0),
        schedule(1.5, type="quintic", start=0.0, end=1.0, duration=0.7, delay=0.1),
        schedule(type="step", start=1.0, end=2.0, time=0.7),
        schedule(type="table", times=[0.1, 0.8], values=[0, 1], interpolation="linear"),
    ]
    found = merge(parts)
    assert found.coefficients.shape == (len(found.knots) - 1, 4, 8)
    for derivative in range(3):
        table = found.at(TIMES, derivative)
        for column, part in enumerate(parts):
            exact = part.at(np.minimum(TIMES, part.knots[-1]), derivative)
            size = max(1.0, float(np.abs(exact).max()))
            np.testing.assert_allclose(table[:, column], exact, atol=1e-10 * size)
    assert set(np.round(parts[2].knots, 12)) <= set(np.round(found.knots, 12))


def test_the_jump_of_a_merged_step_stays_on_its_knot() -> None:
    found = merge(
        [schedule(type="step", start=0.0, end=1.0, time=0.7), schedule(type="sine", amplitude=1, frequency=9)]
    )
    assert found.at([np.nextafter(0.7, 0), 0.7])[:, 0].tolist() == [0, 1]


def test_knots_that_differ_by_round_off_are_one() -> None:
    parts = [schedule(type="step", start=0.0, end=1.0, time=when) for when in (0.1 + 0.2, 0.3)]
    found = merge(parts)
    assert len(found.knots) == 3
    assert found.at([0.29, 0.31]).tolist() == [[0, 0], [1, 1]]


def test_nothing_merged() -> None:
    assert merge([]).at(np.array([0.0, 0.5])).shape == (2, 0)


def test_a_table_without_any_duration_is_refused() -> None:
    """A jump and nothing else has no course to follow."""
    table = {"type": "table", "times": [0.5, 0.5], "values": [1, 2], "interpolation": "linear"}
    with pytest.raises(InputErrors, match="a last time after the first"):
        load("spong1987").with_({"drives.0.signal": table})
