"""Indices against another library, of cases that fail, of quantities that do not vary; what is refused."""

from __future__ import annotations

import json
import warnings
from pathlib import Path

import numpy as np
import pytest

from study.sensitivity.cases import CASES, uniform
from study.sensitivity.cases import study as study_of
from tmodes.errors import InputError, InputErrors, SimulationError
from tmodes.study.plans import PLANS
from tmodes.study.sensitivity import sensitivity
from tmodes.study.sensitivity.indices import sobol_indices
from tmodes.study.sensitivity.run import with_plan

ISHIGAMI = study_of(CASES["ishigami"].formula, CASES["ishigami"].inputs)


def test_estimates_are_those_of_salib_from_the_same_cases() -> None:
    analyze = pytest.importorskip("SALib.analyze.sobol")
    design = with_plan(ISHIGAMI, {"type": "saltelli", "samples": 512, "second_order": True}).design()
    y = ISHIGAMI.evaluate(0, design.values).quantities["y"]
    names = list(ISHIGAMI.names)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        problem = {"num_vars": 3, "names": names, "bounds": [[-np.pi, np.pi]] * 3}
        theirs = analyze.analyze(problem, y, calc_second_order=True, seed=0)
    ours = sobol_indices(y.reshape(512, -1), 16, second_order=True)
    assert ours is not None
    # Theirs takes half of the cases for each index where there are more for pairs, and another mean.
    np.testing.assert_allclose(ours.values["first"], theirs["S1"], atol=0.05)
    np.testing.assert_allclose(ours.values["total"], theirs["ST"], atol=0.05)
    np.testing.assert_allclose(ours.values["second"][0, 2], theirs["S2"][0, 2], atol=0.06)
    plain = np.delete(y.reshape(512, -1), [4, 5, 6], axis=1)
    ours = sobol_indices(plain, 16)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        theirs = analyze.analyze(problem, plain.ravel(), calc_second_order=False, seed=0)
    assert ours is not None
    np.testing.assert_allclose(ours.values["total"], theirs["ST"], rtol=1e-10)
    np.testing.assert_allclose(ours.values["first"], theirs["S1"], atol=2e-3)


def test_effects_are_those_of_salib_from_the_same_cases() -> None:
    analyze = pytest.importorskip("SALib.analyze.morris")
    asked = study_of("2*a + b*b*c", dict.fromkeys("abc", uniform(0.0, 1.0)))
    design = with_plan(asked, {"type": "morris", "trajectories": 40, "seed": 3}).design()
    found = sensitivity(asked, "morris", samples=40, seed=3)
    shares = (design.values - 0.005) / 0.99
    problem = {"num_vars": 3, "names": list("abc"), "bounds": [[0.0, 1.0]] * 3}
    y = asked.evaluate(0, design.values).quantities["y"]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        theirs = analyze.analyze(problem, shares, y / 0.99, num_levels=4, seed=0)
    np.testing.assert_allclose(found.indices["size"][0], np.asarray(theirs["mu_star"]), rtol=1e-10)
    np.testing.assert_allclose(found.indices["spread"][0], np.asarray(theirs["sigma"]), rtol=1e-10, atol=1e-12)


def test_a_linear_function_has_effects_without_spread() -> None:
    found = sensitivity(study_of("3*a - b", {"a": uniform(0.0, 2.0), "b": uniform(-1.0, 3.0)}), "morris")
    np.testing.assert_allclose(found.indices["effect"], [[6.0, -4.0]], rtol=1e-12)
    np.testing.assert_allclose(found.indices["size"], [[6.0, 4.0]], rtol=1e-12)
    np.testing.assert_allclose(found.indices["spread"], 0.0, atol=1e-12)
    assert found.ranked("y") == ("a", "b")


def test_intervals_of_effects_hold() -> None:
    # On four levels each effect of b*b is b + b', of all starts two sizes, equally likely.
    asked = study_of("b*b", {"b": uniform(0.0, 1.0), "c": uniform(0.0, 1.0)})
    levels = 0.005 + 0.99 * np.arange(4) / 3
    exact = np.mean([levels[0] + levels[2], levels[1] + levels[3]])
    ends = np.array([sensitivity(asked, "morris", seed=k).intervals["size"][0, 0] for k in range(100)])
    assert 90 <= ((ends[:, 0] <= exact) & (exact <= ends[:, 1])).sum() <= 99


@pytest.mark.parametrize("kind", ["saltelli", "morris"])
def test_the_first_cases_of_a_longer_plan_are_those_of_a_shorter(kind: str) -> None:
    count = "samples" if kind == "saltelli" else "trajectories"
    short, long = (with_plan(ISHIGAMI, {"type": kind, count: many}) for many in (128, 256))
    assert short.cases == len(short.design().values)
    np.testing.assert_array_equal(long.design().values[: short.cases], short.design().values)
    assert json.dumps(dict(short.design().info))


def test_cases_that_fail_are_left_out_and_what_they_may_change_is_said() -> None:
    asked = study_of("a + 2*b + 0*log(a - 0.01)", {"a": uniform(0.0, 1.0), "b": uniform(0.0, 1.0)})
    found = sensitivity(asked)
    assert 0 < found.failed[0] < 0.05 * found.cases
    assert 0 < found.shift[0] < 0.2
    np.testing.assert_allclose(found.first[0], [0.2, 0.8], atol=0.05)


def test_the_answer_is_which_parameter_decides() -> None:
    """Shares of the variance of a + 2 b: 20 and 80 %; equal ones are not ranked as if they were sure."""
    both = {"a": uniform(0.0, 1.0), "b": uniform(0.0, 1.0)}
    found = sensitivity(study_of("a + 2*b", both))
    low, high = 100 * found.intervals["total"][0, 1]
    share = (
        f"{100 * found.total[0, 1]:.0f} % of the variance ({low:.0f} to {min(high, 100.0):.0f} % at 95 % confidence)"
    )
    assert found.answers["y"] == f"b decides y: {share}, a {100 * found.total[0, 0]:.0f} %."
    assert found.sentence == found.info()["sentence"] == next(iter(found.tables())) == found.answers["y"]
    assert "seems to matter most" in sensitivity(study_of("a + b", both), samples=64).sentence
    alone = sensitivity(study_of("(a - 0.5)**2", {"a": uniform(0.0, 1.0)}), samples=64).sentence
    assert "interactions" not in alone  # a share that is missing of one parameter is the sampling's error
    assert "come from interactions" in sensitivity(study_of("(a - 0.5)*(b - 0.5)", both)).sentence
    swing = sensitivity(study_of("a + 2*b", both), "morris", samples=8).sentence
    assert swing.startswith("b matters most for y: 2 over its range")


def test_more_than_a_few_cases_that_fail_are_refused_with_their_reason() -> None:
    asked = study_of("log(a - 0.3) + b", {"a": uniform(0.0, 1.0), "b": uniform(0.0, 1.0)})
    with pytest.raises(SimulationError, match=r"have no value, more than 5%.*no finite value"):
        sensitivity(asked)


def test_a_quantity_that_does_not_vary_has_no_indices() -> None:
    asked = study_of("a + b", {"a": uniform(0.0, 1.0), "b": uniform(0.0, 1.0)},
                     quantities={"y": {"expression": "a + b"}, "z": {"expression": "5 + 0*a"}})  # fmt: skip
    found = sensitivity(asked)
    assert found.notes == {"z": "it does not vary"}
    assert np.isnan(found.total[1]).all()
    assert json.dumps(found.info(), allow_nan=False)


def test_correlated_parameters_are_refused() -> None:
    asked = study_of("a + b", {"a": uniform(0.0, 1.0), "b": uniform(0.0, 1.0)},
                     correlations=[{"between": ["a", "b"], "value": 0.3}])  # fmt: skip
    with pytest.raises(InputError, match=r"0\.3 between a and b; indices need parameters that vary by themselves"):
        sensitivity(asked)


@pytest.mark.parametrize(
    ("method", "more", "words"),
    [
        ("sobol", {"samples": 1000}, "power of two.*take 1024"),
        ("sobol", {"samples": 4}, "samples"),
        ("fast", {}, "sobol or morris"),
        ("morris", {"second_order": True}, "second-order"),
    ],
)
def test_what_is_no_method_or_number_of_samples_is_refused(method: str, more: dict[str, int], words: str) -> None:
    with pytest.raises((InputError, InputErrors), match=f"(?s){words}"):
        sensitivity(ISHIGAMI, method, **more)  # pyright: ignore[reportArgumentType]


def test_choices_have_indices_too() -> None:
    choices = [{"name": name, "set": {}} for name in "abc"]
    asked = study_of("k + x", {"x": uniform(0.0, 1.0)},
                     parameters={"k": {"choices": choices}, "x": {"distribution": uniform(0.0, 1.0)}})  # fmt: skip
    found = sensitivity(asked)
    np.testing.assert_allclose(found.first[0], np.array([2 / 3, 1 / 12]) / (2 / 3 + 1 / 12), atol=0.02)


def test_a_folder_resumes_and_gives_the_same(tmp_path: Path) -> None:
    pytest.importorskip("pyarrow")
    alone = sensitivity(ISHIGAMI, samples=128)
    stored = sensitivity(ISHIGAMI, samples=128, out=tmp_path / "study")
    np.testing.assert_array_equal(stored.total, alone.total)
    more = sensitivity(ISHIGAMI, samples=256, out=tmp_path / "study")
    np.testing.assert_array_equal(more.total, sensitivity(ISHIGAMI, samples=256).total)


def test_the_plans_are_registered() -> None:
    assert {"saltelli", "morris"} <= set(PLANS)
