"""Variables that are entangled: surfaces over a few of them, found by probing, exact to rounding, or refused."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tmodes.model import entangled
from tmodes.model.fitting import fitted
from tmodes.model.forms import Form, Range, Unfit
from tmodes.model.surfaces import SmoothSurface

OUTER, WALL, LOAD = Range(0.03, 0.03, 0.05), Range(1e-3, 1e-3, 4e-3), Range(2.0, 2.0, 6.0)
ENOUGH = 400

Function = Callable[..., list[float]]


def area(outer: float, wall: float) -> float:
    return math.pi * wall * (outer - wall)


def stiffness(outer: float, wall: float) -> float:
    return math.pi / 64 * (outer**4 - (outer - 2 * wall) ** 4)


def shear(outer: float, wall: float) -> float:
    """Cowper's coefficient of a tube."""
    ratio = 1 - 2 * wall / outer
    return 7.8 * (1 + ratio**2) ** 2 / (8.8 * (1 + ratio**2) ** 2 + 23.6 * ratio**2)


def tube(outer: float, wall: float, load: float) -> list[float]:
    """Numbers of a tube by themselves, as roots, added to others, and multiplied by others."""
    own, bending = area(outer, wall), stiffness(outer, wall)
    return [
        own, -math.sqrt(own), bending, 70e9 * bending, load * bending, load + own, load * (own + 3.0),
        shear(outer, wall) * own, own * 0.4 + bending, 7.0, load, outer, 1 / (load * own),
    ]  # fmt: skip


def counted(function: Function, ranges: tuple[Range, ...]) -> tuple[Callable[[Mapping[int, float]], np.ndarray], list]:
    """The vector at points, and a list of these."""
    points: list[Mapping[int, float]] = []

    def at(values: Mapping[int, float]) -> np.ndarray:
        points.append(values)
        return np.array(function(*(values.get(k, one.start) for k, one in enumerate(ranges))))

    return at, points


def form_of(function: Function, ranges: tuple[Range, ...], most: int = ENOUGH) -> Form:
    at, _ = counted(function, ranges)
    return fitted(at, ranges, np.random.default_rng(0), curves=True, most=most)


def compare(form: Form, function: Function, ranges: tuple[Range, ...], rel: float = 1e-12) -> None:
    """At 200 random points at once."""
    draw = np.random.default_rng(1)
    drawn = {k: np.array([one.drawn(draw) for _ in range(200)]) for k, one in enumerate(ranges)}
    true = np.array([function(*point) for point in zip(*drawn.values(), strict=True)])
    assert form.at(drawn) == pytest.approx(true, rel=rel, abs=0.0)


def test_diameter_and_wall_of_a_tube_with_a_load() -> None:
    compare(form_of(tube, (OUTER, WALL, LOAD)), tube, (OUTER, WALL, LOAD))


def test_numbers_of_one_point_and_of_many() -> None:
    form, draw = form_of(tube, (OUTER, WALL, LOAD)), np.random.default_rng(2)
    many = {k: np.array([one.drawn(draw) for _ in range(9)]) for k, one in enumerate((OUTER, WALL, LOAD))}
    each = [form.at({k: float(values[place]) for k, values in many.items()}) for place in range(9)]
    assert form.at(many) == pytest.approx(np.array(each), rel=1e-14)
    mixed = form.at({0: 0.04, 1: many[1]})
    assert mixed[3] == pytest.approx(form.at({0: 0.04, 1: float(many[1][3])}), rel=1e-14)


def test_a_part_of_the_numbers() -> None:
    form, at = form_of(tube, (OUTER, WALL, LOAD)), {0: 0.044, 1: 2.2e-3, 2: 3.0}
    assert form.part(1, 5).at(at).tolist() == form.at(at)[1:5].tolist()
    assert form.acting(1, 2) == {0, 1}
    assert form.acting(4, 5) == {0, 1, 2}


def test_what_changes_alike_shares_one_surface_and_all_share_the_points() -> None:
    """A root of an area is its square, which is a polynomial."""
    ranges = OUTER, WALL, LOAD
    at, points = counted(tube, ranges)
    form = fitted(at, ranges, np.random.default_rng(0), curves=True, most=ENOUGH)
    surfaces = {
        e: {p for _, powers in form.sums[e] for _, p in powers if isinstance(p, SmoothSurface)} for e in (1, 2, 3, 4)
    }
    assert surfaces[2] == surfaces[3] == surfaces[4]
    assert len(surfaces[2]) == 1
    assert form.roots == {1: -1.0}
    at, again = counted(lambda *given: tube(*given) * 2, ranges)
    fitted(at, ranges, np.random.default_rng(0), curves=True, most=ENOUGH)
    assert len(points) == len(again)


def two(outer: float, wall: float, other_outer: float, other_wall: float, load: float) -> list[float]:
    first, second = area(outer, wall), area(other_outer, other_wall)
    return [
        first, second, first + second + load, load * (first + 2 * second), first * second, math.sqrt(second),
        stiffness(outer, wall), stiffness(other_outer, other_wall), load * first * stiffness(other_outer, other_wall),
    ]  # fmt: skip


def test_two_pairs() -> None:
    """Each number by itself, sums over all five variables, and products of both."""
    ranges = OUTER, WALL, Range(0.02, 0.02, 0.03), Range(5e-4, 5e-4, 2e-3), LOAD
    compare(form_of(two, ranges), two, ranges)


def box(width: float, height: float, wall: float) -> list[float]:
    across, up = width - 2 * wall, height - 2 * wall
    return [width * height - across * up, (width * height**3 - across * up**3) / 12, width * height]


def test_three_dimensions_of_a_hollow_box() -> None:
    ranges = Range(0.02, 0.02, 0.05), Range(0.01, 0.01, 0.04), Range(1e-3, 1e-3, 2e-3)
    form = form_of(box, ranges)
    compare(form, box, ranges)
    assert form.acting(0, 1) == {0, 1, 2}


def test_no_more_vectors_than_allowed() -> None:
    """Where the grid would take more of them, none of its points is evaluated."""
    ranges = OUTER, WALL
    at, points = counted(lambda outer, wall: tube(outer, wall, 2.0), ranges)
    with pytest.raises(Unfit, match="together"):
        fitted(at, ranges, np.random.default_rng(0), curves=True, most=40)
    refused = len(points)
    points.clear()
    fitted(at, ranges, np.random.default_rng(0), curves=True, most=ENOUGH)
    assert refused + 40 < len(points) <= refused + ENOUGH + 3


def large_and_small(outer: float, wall: float) -> list[float]:
    return [2e7 * outer, stiffness(outer, wall), 2e7 * area(outer, wall)]


def test_small_numbers_among_large_ones() -> None:
    """The rounding of the neighbours of a number does not hide that it is entangled."""
    compare(form_of(large_and_small, (OUTER, WALL)), large_and_small, (OUTER, WALL))


def disturbed(size: float, waves: float) -> Function:
    """A stiffness with something that is seen only where both variables have moved."""

    def function(outer: float, wall: float) -> list[float]:
        x, y = (outer - OUTER.start) / 0.02, (wall - WALL.start) / 3e-3
        more = math.cos(waves * (x + y)) if waves else abs(x - y)
        return [stiffness(outer, wall) * (1 + size * x * y * more)]

    return function


@settings(max_examples=30, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(size=st.floats(-9, 0).map(lambda power: 10**power), waves=st.floats(0.0, 60.0))
def test_either_right_or_refused(size: float, waves: float) -> None:
    """Smooth or not, by few waves or many."""
    function = disturbed(size, waves)
    try:
        form = form_of(function, (OUTER, WALL))
    except Unfit:
        return
    compare(form, function, (OUTER, WALL), rel=2e-11)


def test_what_is_smooth_on_the_edges_alone_is_refused_and_what_is_smooth_is_not() -> None:
    with pytest.raises(Unfit, match="together"):
        form_of(disturbed(1e-6, 0.0), (OUTER, WALL))
    compare(form_of(disturbed(1e-6, 2.0), (OUTER, WALL)), disturbed(1e-6, 2.0), (OUTER, WALL), rel=2e-12)


@settings(max_examples=30, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(first=st.integers(0, 4), second=st.integers(0, 4), size=st.floats(-9, 0).map(lambda power: 10**power))
def test_a_wrong_surface_is_detected(monkeypatch, first: int, second: int, size: float) -> None:
    """One of the coefficients of the stiffness is wrong by a billionth or more of its share, next to larger numbers."""

    class Wrong(SmoothSurface):
        def at(self, values):
            error = np.zeros_like(self.coefficients)
            error[first, second] = size * (np.abs(self.coefficients[3, 1]) > 1e-6)  # an area is linear in the diameter
            return SmoothSurface(self.variables, self.spans, self.coefficients + error).at(values)

    with monkeypatch.context() as patch:
        patch.setattr(entangled, "SmoothSurface", Wrong)
        with pytest.raises(Unfit, match="together"):
            form_of(large_and_small, (OUTER, WALL))


def test_too_low_a_degree_is_detected(monkeypatch) -> None:
    """By the random points, where the last coefficients are not looked at."""
    monkeypatch.setattr(entangled, "_MORE", -1)
    monkeypatch.setattr(entangled, "_TAIL", np.inf)
    with pytest.raises(Unfit, match="together"):
        form_of(lambda *given: [stiffness(*given)], (OUTER, WALL))
