"""Wrong studies: all that is wrong at once, with its line, and the name that was probably meant."""

from __future__ import annotations

import pytest

from study.core.studies import study
from tmodes.errors import InputError, InputErrors, TmodesError
from tmodes.study.optimize import optimize
from tmodes.study.optimize.goals import refuse_contradictions
from tmodes.study.read import read_study
from tmodes.study.sensitivity import sensitivity

STUDY = """\
format: 1
kind: study
name: wrong
robot: spong1987
set: {integration.duration: 0.05}
parameters:
  k: {path: joints.joint.gear.stiffness, distribution: {type: uniform, low: 60, high: 140}}
plan: {type: monte_carlo, runs: 4}
quantities:
  y: {series: tip.x, reduce: max}
"""

READ = {
    "plan": (
        ("{type: monte_carlo, runs: 4}", "{type: grid, levels: 0, levels_of: {kk: 3}, points: {zz: [1]}}"),
        ["wrong.yaml:8: unknown key `plan.levels_of.kk`. Did you mean `k`?", "unknown key `plan.points.zz`",
         "plan.levels must be a whole number from 1"],
    ),
    "plan and quantity": (
        ("monte_carlo, runs: 4}\nquantities:\n  y:", "grid, levels_of: {a: 1}}\nquantities:\n  y: {serie: x}\n  z:"),
        ["wrong.yaml:8: unknown key `plan.levels_of.a`",
         "wrong.yaml:10: unknown key `quantities.y.serie`. Did you mean `series`?"],
    ),
    "kind of plan": (("monte_carlo", "latin_hypercub"), ["wrong.yaml:8: plan.type", "Did you mean `latin_hypercube`?"]),
    "distribution": (("uniform", "unifrom"), ["wrong.yaml:7:", "Did you mean `uniform`?"]),
    "rule": (("reduce: max", "reduce: mx"), ["wrong.yaml:10: quantities.y.reduce", "Did you mean `max`?"]),
    "percentile": (("reduce: max", "reduce: percentle:99"), ["Did you mean `percentile:99`?"]),
    "nothing varies": (
        (", distribution: {type: uniform, low: 60, high: 140}", ""),
        ["parameters.k must be varied by one of distribution, choices and catalogue"],
    ),
    "column": (("  y:", "  errors:"), ["wrong.yaml:10:", "a column of the table"]),
    "label": (("  y:", "  label:"), ["wrong.yaml:10:", "got the name 'label', a column of the table"]),
    "no quantity": (
        ("quantities:\n  y: {series: tip.x, reduce: max}", "quantities: {}"),
        ["wrong.yaml:9: quantities must be at least one quantity, got none; write one: `peak:"],
    ),
    "no parameter": (
        ("parameters:\n  k: {path: joints.joint.gear.stiffness, distribution: {type: uniform, low: 60, high: 140}}",
         "parameters: {}"),
        ["wrong.yaml:6: parameters must be at least one parameter, got none"],
    ),
    "own key": (
        ("series: tip.x, reduce: max", "expression: 'k +'"),
        ["wrong.yaml:10: quantities.y.expression must be a formula of k, y"],
    ),
    "percent": (("reduce: max", "reduce: 'percentile:200'"), ["Did you mean `percentile:95`?"]),
    "no point": (
        ("{type: monte_carlo, runs: 4}", "{type: grid, points: {k: []}}"),
        ["wrong.yaml:8: plan.points.k must be one value or more, got an empty list"],
    ),
    "chosen twice": (
        ("plan:", "optimize: {objectives: [{minimize: y}], design: [k, k]}\nplan:"),
        ["wrong.yaml:8: optimize.design.1 must be each parameter once, got 'k', given twice"],
    ),
    "no row": (
        ("{type: uniform, low: 60, high: 140}", "{type: empirical, file: header.csv}"),
        ["wrong.yaml:7: parameters.k.distribution.file must be a file with rows, got 'header.csv', a header"],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", list(READ))
def test_a_file_that_is_wrong(name, tmp_path):
    (old, new), messages = READ[name]
    assert old in STUDY
    file = tmp_path / "wrong.yaml"
    file.write_text(STUDY.replace(old, new), encoding="utf-8")
    (tmp_path / "header.csv").write_text("k\n", encoding="utf-8")
    with pytest.raises(InputErrors) as wrong:
        read_study(file)
    for message in messages:
        assert message in str(wrong.value)
    if name == "nothing varies":
        assert "left out" not in str(wrong.value)


RUN = {
    "unit": ("reduce: max", "reduce: max, unit: kg", "quantities.y.unit must be a unit of m, got the unit 'kg'"),
}


@pytest.mark.parametrize("name", list(RUN))
def test_what_only_the_robot_knows_has_its_line_too(name, tmp_path):
    """In a study, and by another plan in a sensitivity."""
    old, new, message = RUN[name]
    file = tmp_path / "wrong.yaml"
    file.write_text(STUDY.replace(old, new), encoding="utf-8")
    asked = read_study(file)
    for run in (lambda: asked.evaluate(0, asked.design().values), lambda: sensitivity(asked, "morris", samples=4)):
        with pytest.raises(InputError) as wrong:
            run()
        assert "wrong.yaml:10: " in str(wrong.value)
        assert message in str(wrong.value)


@pytest.mark.parametrize("limits", [
    ["y <= 1 mm", "y >= 2 mm"], ["y < 1 m", "1000 mm <= y"], ["2 <= y <= 1"], ["x*y <= 1", "x*y > 1"],
    ["y >= 1", "y <= 5", "y >= 6"],
])  # fmt: skip
def test_limits_that_exclude_each_other_are_refused(limits):
    with pytest.raises(InputError, match="which exclude each other"):
        refuse_contradictions(limits)


@pytest.mark.parametrize("limits", [
    ["y <= 2 mm", "y >= 2 mm"], ["y <= 1 m", "y >= 2 mm"], ["y <= 1", "z >= 2"], ["y <= 1 kg", "y >= 2 m"],
    ["y <= 1", "y <= 2"], ["1 <= y <= 2", "1.5 <= y <= 3"],
])  # fmt: skip
def test_limits_that_fit_pass(limits):
    refuse_contradictions(limits)


def test_contradictions_are_refused_before_anything_runs(monkeypatch):
    asked = study(optimize={"objectives": [{"minimize": "y"}], "limits": ["y <= 1", "y >= 2"]})
    monkeypatch.setattr(type(asked), "evaluate", lambda *_, **__: pytest.fail("it runs"))
    with pytest.raises(InputError, match="`y >= 2` and `y <= 1`, which exclude each other"):
        optimize(asked)


def test_methods_that_are_misspelt_have_their_nearest():
    asked = study(optimize={"objectives": [{"minimize": "y"}]})
    with pytest.raises(TmodesError, match="Did you mean `sobol`"):
        sensitivity(asked, "sobl")
    with pytest.raises(TmodesError, match="Did you mean `nsga2`"):
        optimize(asked, "nsga")
