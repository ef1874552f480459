"""What is wrong in the sheet of an optimization is said before anything runs; nothing feasible says how far it is."""

from __future__ import annotations

from typing import Any

import pytest

from command import called
from study.optimize.forms import design_study
from study.optimize.tubes import EXAMPLES
from tmodes.errors import InputError
from tmodes.study.optimize import optimize
from tmodes.study.read import read_study, study_from_data

QUANTITIES = {"sag": {"expression": "a", "unit": "mm"}, "mass": {"expression": "b + 0*a", "unit": "kg"}, "n": "a*b"}
RANGES: dict[str, Any] = {"a": (1.0, 2.0), "b": (1.0, 3.0)}


@pytest.mark.parametrize(
    ("limit", "words"),
    [
        ("sga <= 1.5 mm", "unknown quantity `sga`. Did you mean `sag`?"),
        (
            "sag <= 1.5 kg",
            "must be a number in mm, the unit of sag, got the unit .kg. of '1.5 kg', which is of another",
        ),
        ("n <= 1.5 kg", "must be a number without a unit"),
        ("sag + n <= 1 mm", "give the formula a name and a `unit` under `quantities`"),
        ("sag", "must be a quantity, one of <= >= < >, and a number"),
        ("sag <= mass", "must be a quantity, one of <= >= < >, and a number"),
        ("sag <= .inf mm", "optimize.limits"),
        ("import os <= 1", "optimize.limits"),
        ("2 + 3 <= 6", "optimize.limits"),
    ],
)
def test_a_limit_that_is_none(limit: str, words: str) -> None:
    with pytest.raises(InputError, match=words):
        optimize(design_study(QUANTITIES, RANGES, [{"minimize": "mass"}], [limit]))


def test_limits_in_other_units_and_on_both_sides() -> None:
    found = optimize(design_study(QUANTITIES, RANGES, [{"minimize": "sag"}], ["0.0012 m <= sag <= 1.8 mm", "n > 2"]))
    assert found.best is not None
    assert found.best.values["a"] == pytest.approx(1.2, abs=1e-8)
    assert len(found.best.limits) == 3


@pytest.mark.parametrize(
    ("method", "more", "words"),
    [
        ("grid", {}, "a continuous range"),
        ("fast", {}, "auto, grid, gradient, compromise, cobyqa, tpe, nsga2"),
        ("auto", {"worst_case": 8}, "all parameters are chosen"),
        ("auto", {"objectives": [{"minimize": "masss"}]}, "Did you mean `mass`?"),
        ("tpe", {"objectives": [{"minimize": "mass"}, {"minimize": "sag"}]}, "2 objectives"),
    ],
)
def test_what_does_not_fit_the_study(method: str, more: dict[str, Any], words: str) -> None:
    given: dict[str, Any] = {"objectives": [{"minimize": "mass"}], **more}
    with pytest.raises(InputError, match=words):
        optimize(design_study(QUANTITIES, RANGES, **given), method)


def test_gradients_need_ranges() -> None:
    asked = design_study({"n": "a"}, {"a": ["one", "two"]}, [{"minimize": "n"}])
    for method in ("gradient", "cobyqa"):
        with pytest.raises(InputError, match="a choice among 2 entries"):
            optimize(asked, method)


def test_something_must_be_chosen() -> None:
    with pytest.raises(InputError, match="one choice"):
        optimize(design_study({"n": "a"}, {"a": ["one"]}, [{"minimize": "n"}]))


def test_a_study_without_objectives() -> None:
    asked = study_from_data({
        "format": 1, "kind": "study", "name": "none", "plan": {"type": "monte_carlo", "runs": 1},
        "parameters": {"a": {"distribution": {"type": "uniform", "low": 0.0, "high": 1.0}}},
        "quantities": {"y": {"expression": "a"}},
    })  # fmt: skip
    with pytest.raises(InputError, match="optimize is missing, expected objectives"):
        optimize(asked)


def test_nothing_feasible_gives_the_design_that_is_nearest() -> None:
    found = optimize(design_study(QUANTITIES, RANGES, [{"minimize": "mass"}], ["sag <= 0.5 mm"]))
    assert found.best is None
    assert found.nearest is not None
    assert found.nearest.values["a"] == pytest.approx(1.0, abs=1e-6)
    assert found.nearest.limits[0].margin == pytest.approx(-1.0, abs=1e-5)
    assert found.lost_to == {"sag <= 0.5 mm": found.designs}


def test_nothing_computed_gives_no_design() -> None:
    """Of designs that all fail none is nearest, and the answer is why they do."""
    failing = {"sag": {"expression": "log(-a)", "unit": "mm"}, "mass": {"expression": "b", "unit": "kg"}}
    found = optimize(design_study(failing, RANGES, [{"minimize": "mass"}], ["sag <= 1 mm"]), "tpe", trials=6)
    assert (found.best, found.nearest, found.designs, found.failed) == (None, None, 6, 6)
    assert found.sentence.startswith("None of the 6 designs finished: ")
    assert "nan" not in found.sentence


def test_the_command_shows_the_optimum_and_the_limits(tmp_path: Any) -> None:
    done = called("optimize", str(EXAMPLES / "lightest_rod.yaml"))
    assert done.returncode == 0
    assert "0.037143" in done.stdout
    assert "sag <= 1 mm is active; the objective changes by -1463 for each m of it" in done.stdout
    text = (EXAMPLES / "lightest_rod.yaml").read_text().replace("sag <= 1 mm", "sag <= 1 nm")
    (tmp_path / "hard.yaml").write_text(text)
    done = called("optimize", str(tmp_path / "hard.yaml"))
    assert done.returncode == 3
    assert "no design keeps all limits; the one that exceeds them least: diameter = 0.1" in done.stderr


def test_the_commands_give_json(tmp_path: Any) -> None:
    import json

    del tmp_path
    done = called("optimize", str(EXAMPLES / "lightest_rod.yaml"), "--json")
    assert json.loads(done.stdout)["best"]["design"]["diameter"] == pytest.approx(0.037143, abs=1e-6)
    done = called("sensitivity", str(EXAMPLES / "ishigami.yaml"), "--json", "--samples", "128")
    assert json.loads(done.stdout)["quantities"]["y"]["ranked"][0] == "x1"
    done = called("sensitivity", str(EXAMPLES / "elastic_arm.yaml"), "--samples", "128")
    assert "payload" in done.stdout
    assert "95 % confidence" not in done.stderr


def test_examples_are_read() -> None:
    for path in sorted(EXAMPLES.glob("*.yaml")):
        if "kind: study" in path.read_text():
            assert read_study(path).sheet.name
