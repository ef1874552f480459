"""Each method on problems whose optimum is known; worst cases; folders that resume."""

from __future__ import annotations

import itertools
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from study.optimize.forms import design_study
from study.optimize.tubes import EXAMPLES
from tmodes.study.optimize import optimize
from tmodes.study.optimize.space import design_space
from tmodes.study.optimize.summary import pareto_front
from tmodes.study.read import read_study
from tmodes.study.rows import Rows
from tmodes.study.study import Study


def test_a_rod_is_as_thick_as_its_sag_asks_for() -> None:
    found = optimize(read_study(EXAMPLES / "lightest_rod.yaml"))
    assert found.method == "gradient"
    assert found.best is not None
    np.testing.assert_allclose(found.best.values["diameter"], 0.037143040545948997, rtol=1e-6)
    np.testing.assert_allclose(found.best.objectives[0], 2.925556907258506, rtol=1e-6)
    np.testing.assert_allclose(found.prices["sag <= 1 mm"], -1462.778453629253, rtol=1e-4)
    assert found.best.limits[0].active
    assert json.dumps(found.info(), allow_nan=False)


def test_several_parameters_and_limits_along_gradients() -> None:
    # W. Hock, K. Schittkowski, Test Examples for Nonlinear Programming Codes (1981), problem 43 without its fourth
    # parameter's bound: f = -44 at (0, 1, 2, -1).
    found = optimize(design_study(
        {"f": "a**2 + b**2 + 2*c**2 + d**2 - 5*a - 5*b - 21*c + 7*d",
         "g1": "a**2 + b**2 + c**2 + d**2 + a - b + c - d", "g2": "a**2 + 2*b**2 + c**2 + 2*d**2 - a - d",
         "g3": "2*a**2 + b**2 + c**2 + 2*a - b - d"},
        dict.fromkeys("abcd", (-3.0, 3.0)), [{"minimize": "f"}], ["g1 <= 8", "10 >= g2", "g3 <= 5"],
    ))  # fmt: skip
    assert found.best is not None
    np.testing.assert_allclose([found.best.values[name] for name in "abcd"], [0.0, 1.0, 2.0, -1.0], atol=1e-5)
    np.testing.assert_allclose(found.best.objectives[0], -44.0, rtol=1e-8)
    np.testing.assert_allclose(found.prices["g3 <= 5"], -2.0, rtol=1e-4)


def test_quadratic_models_descend_without_slopes() -> None:
    """Problem 24 of the same book, f = -1 at (3, sqrt(3)), from the middle of the ranges."""
    asked = design_study({"f": "((a - 3)**2 - 9)*b**3/(27*3**0.5)", "one": "a/3**0.5 - b", "two": "a + 3**0.5*b"},
                         {"a": (0.0, 6.0), "b": (0.0, 4.0)}, [{"minimize": "f"}],
                         ["one >= 0", "0 <= two <= 6"])  # fmt: skip
    found = optimize(asked, "cobyqa")
    assert found.best
    np.testing.assert_allclose([found.best.values[name] for name in "ab"], [3.0, 3**0.5], rtol=2e-3)
    np.testing.assert_allclose(found.best.objectives[0], -1.0, rtol=2e-3)
    assert found.designs <= 200
    assert optimize(asked, "cobyqa", trials=20).designs <= 21


def test_ranges_of_a_logarithm() -> None:
    """Half of the way from 0.01 to 100 is 1; an optimum on the way is found along gradients of the logarithm."""
    ranges = {"a": {"distribution": {"type": "loguniform", "low": 0.01, "high": 100.0}}}
    asked = design_study({"f": "(log(a) - log(7))**2"}, ranges, [{"minimize": "f"}])
    space = design_space(asked, [])
    np.testing.assert_allclose(space.at(np.array([[0.0], [0.5], [1.0]])), [[0.01], [1.0], [100.0]])
    np.testing.assert_allclose(space.shares(np.array([[7.0]])), [[np.log(700) / np.log(1e4)]])
    np.testing.assert_allclose(space.slopes(np.array([0.5])), [np.log(1e4)])
    for method in ("gradient", "cobyqa"):
        best = optimize(asked, method).best
        assert best
        np.testing.assert_allclose(best.values["a"], 7.0, rtol=1e-3)


def test_what_is_maximized_and_has_no_limit() -> None:
    found = optimize(design_study({"f": "3 - (a - 0.3)**2 - 2*(b + 0.2)**2"}, dict.fromkeys("ab", (-1.0, 1.0)),
                                  [{"maximize": "f"}]))  # fmt: skip
    assert found.best is not None
    np.testing.assert_allclose([found.best.values[name] for name in "ab"], [0.3, -0.2], atol=1e-6)
    assert found.objectives == ("maximize f",)


def test_the_front_of_a_finite_space_is_exact() -> None:
    names = [f"n{k}" for k in range(12)]
    asked = design_study({"one": "a*a + b", "two": "(a - 8)**2 + (b - 5)**2"}, {"a": names, "b": names},
                         [{"minimize": "one"}, {"maximize": "-two"}], ["a + b >= 3"])  # fmt: skip
    found = optimize(asked)
    points = {(a, b): (a * a + b, (a - 8) ** 2 + (b - 5) ** 2) for a, b in itertools.product(range(12), repeat=2)}
    allowed = {key: value for key, value in points.items() if sum(key) >= 3}
    front = {
        key for key, (p, q) in allowed.items()
        if not any((r <= p and s <= q and (r < p or s < q)) for r, s in allowed.values())
    }  # fmt: skip
    assert {(int(one.values["a"]), int(one.values["b"])) for one in found.front} == front
    assert found.exact


def test_the_front_of_a_search_is_near_the_known_one() -> None:
    pytest.importorskip("optuna")
    # J. D. Schaffer, 1985: the front is a from 0 to 2.
    found = optimize(design_study({"one": "a**2", "two": "(a - 2)**2"}, {"a": (-10.0, 10.0)},
                                  [{"minimize": "one"}, {"minimize": "two"}]), trials=320)  # fmt: skip
    values = np.array([one.values["a"] for one in found.front])
    assert found.method == "nsga2"
    assert len(values) > 20
    assert values.min() > -0.1
    assert values.max() < 2.1
    assert np.ptp(values) > 1.5


def test_a_front_keeps_what_nothing_dominates() -> None:
    rows = np.array([[1.0, 5.0], [2.0, 2.0], [2.0, 2.0], [3.0, 1.0], [3.0, 3.0], [1.0, 6.0]])
    assert pareto_front(rows).tolist() == [0, 1, 2, 3]


def test_a_search_with_limits_is_near_the_optimum_and_the_same_each_time() -> None:
    pytest.importorskip("optuna")
    asked = design_study({"f": "(a - 1)**2 + (b - 2)**2", "g": "a + b"}, dict.fromkeys("ab", (-3.0, 3.0)),
                         [{"minimize": "f"}], ["g <= 1"])  # fmt: skip
    one, same, other = (optimize(asked, "tpe", trials=128, seed=seed) for seed in (0, 0, 1))
    assert one.best is not None
    assert one.best.objectives[0] < 2.1  # 2 at (0, 1)
    assert one.best.values["a"] + one.best.values["b"] <= 1.0
    assert one.info() == same.info()
    assert one.info() != other.info()


def test_the_worst_case_of_what_is_uncertain_counts() -> None:
    quantities = {"cost": "a", "load": "(1 + 0.1*z)/a"}
    ranges = {"a": (0.5, 4.0), "z": {"distribution": {"type": "uniform", "low": -1.0, "high": 1.0}}}

    def least(**more: float) -> float:
        asked = design_study(quantities, ranges, [{"minimize": "cost"}], ["load <= 1"], design=["a"], **more)
        best = optimize(asked).best
        assert best is not None
        return best.values["a"]

    np.testing.assert_allclose(least(), 1.0, rtol=1e-6)
    np.testing.assert_allclose(least(worst_case=100), 1.1, atol=2e-3)
    np.testing.assert_allclose(least(worst_case=100, percentile=50), 1.0, atol=5e-3)


def test_designs_that_fail_are_counted_and_avoided() -> None:
    found = optimize(design_study({"f": "log(k - 2.5) + 0*k"}, {"k": [*"abcdef"]}, [{"minimize": "f"}]))
    assert (found.designs, found.failed, found.feasible) == (6, 3, 3)
    assert found.best is not None
    assert found.best.choices == {"k": "d"}


def test_a_search_resumes_from_its_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("optuna")
    pytest.importorskip("pyarrow")
    from tmodes.study.result import load_study

    asked = design_study({"f": "(a - 1)**2"}, {"a": (-3.0, 3.0)}, [{"minimize": "f"}])
    alone = optimize(asked, "tpe", trials=80)
    optimize(asked, "tpe", trials=48, out=tmp_path / "f")
    computed = counted(monkeypatch)
    again = optimize(asked, "tpe", trials=80, out=tmp_path / "f")
    assert again.info() == alone.info()
    assert len(load_study(tmp_path / "f").rows) == 80
    assert sum(computed) == 32 + 1  # one for the units


def counted(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many cases are computed at a time, from now on."""
    counts: list[int] = []
    before = Study.evaluate

    def evaluate(self: Study, first: int, values: Any, *rest: Any, **more: Any) -> Rows:
        counts.append(len(values))
        return before(self, first, values, *rest, **more)

    monkeypatch.setattr(Study, "evaluate", evaluate)
    return counts
