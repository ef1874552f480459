"""A study's file is read with its units; everything that is wrong is reported together, each with its line."""

from __future__ import annotations

from typing import Any

import pytest

from study.core.studies import LUMPED, study, written
from tmodes.errors import InputError, InputErrors
from tmodes.robots.load import load
from tmodes.study.read import read_study

HEAD = "format: 1\nkind: study\nname: test\nrobot: filipovic2010\n"
GEAR = (
    "parameters:\n  gear: {path: gear.stiffness, relative: true, distribution: {type: uniform, low: 0.8, high: 1.2}}\n"
)
PLAN = "plan: {type: monte_carlo, runs: 4}\n"
PEAK = "quantities:\n  peak: {series: deviation, reduce: max, unit: mm}\n"


def refused(folder, *, head=HEAD, parameters=GEAR, plan=PLAN, quantities=PEAK, more="", **files):
    """The messages of a study that is wrong."""
    with pytest.raises((InputError, InputErrors)) as caught:
        written(folder, head + parameters + plan + quantities + more, **files)
    return str(caught.value).replace(str(folder), "")


def test_numbers_with_units_are_those_of_the_path(tmp_path):
    text = HEAD + PLAN + PEAK + (
        "parameters:\n  payload: {path: payload.mass, distribution: {type: normal, mean: 0.5 kg, deviation: 20 g}}\n"
        "  gear: {path: gear.stiffness, distribution: {type: truncated, low: 4 kN*m/rad,"
        " distribution: {type: normal, mean: 4.7 kN*m/rad, deviation: 500}}}\n"
        "  free: {unit: rad, distribution: {type: discrete, values: [10 deg, 0.5]}}\n"
    )  # fmt: skip
    one = written(tmp_path, text)
    parameters: Any = one.sheet.parameters
    payload, gear, free = (parameters[name] for name in ("payload", "gear", "free"))
    assert (payload.distribution.mean, payload.distribution.deviation) == (0.5, 0.02)
    assert (gear.distribution.low, gear.distribution.distribution.mean) == (4000.0, 4700.0)
    assert free.distribution.values == (pytest.approx(0.17453292519943295), 0.5)
    assert one.parameter_units == {"payload": "kg", "gear": "N*m/rad", "free": "rad"}
    assert one.space.nominal.tolist() == [0.5, 4700.0, pytest.approx(0.17453292519943295)]


def test_everything_that_is_wrong_is_reported_with_its_line(tmp_path):
    text = refused(
        tmp_path,
        parameters=(
            "parameters:\n  a: {path: gear.stifness, distribution: {type: uniform, low: 1, high: 2}}\n"
            "  b: {path: payload.mass, distribution: {type: normal, mean: 0.5 m, deviation: -1}}\n"
        ),
        quantities="quantities:\n  s: {summary: setling.time_s}\n",
        more="blok: 3\n",
    )
    lines = text.splitlines()
    assert lines[0] == "/study.yaml:6: parameters.a.path: unknown path 'gear.stifness'. Did you mean `gear.stiffness`?"
    assert lines[1].startswith("/study.yaml:7: parameters.b.distribution.mean must be a number [kg], got the unit 'm'")
    assert lines[2].startswith("/study.yaml:7: parameters.b.distribution.deviation must be a number greater than 0")
    assert lines[-1] == "/study.yaml:11: unknown key `blok`. Did you mean `block`?"


@pytest.mark.parametrize(
    ("distribution", "message"),
    [
        ("{type: normal, mean: .nan, deviation: 1}", "got .nan (not a number)"),
        ("{type: normal, mean: .inf, deviation: 1}", "got the infinite number .inf"),
        ("{type: normal, mean: 1, deviation: 0}", "greater than 0 [kg], got 0"),
        ("{type: uniform, low: 2, high: 2}", "high must be more than low, 2.0, got 2.0"),
        ("{type: triangular, low: 1, mode: 3, high: 2}", "mode must be from low to high"),
        ("{type: lognormal, median: 2, mean: 3}", "must be one of two pairs of numbers, got median and mean"),
        ("{type: lognormal, median: -2, sigma_log: 1}", "median must be a number greater than 0"),
        ("{type: empirical, values: []}", "either values or a file"),
        ("{type: empirical, values: [1, 1]}", "values that differ, got 1.0 alone"),
        ("{type: discrete, values: [2, 1]}", "values in rising order"),
        ("{type: discrete, values: [1, 2], weights: [1, 0]}", "weights.1 must be"),
        ("{type: truncated, low: 90, distribution: {type: normal, mean: 0, deviation: 1}}", "limits that leave"),
        ("{type: unifrm, low: 1, high: 2}", "Did you mean `uniform`?"),
        ("{type: uniform, low: 1, hi: 2}", "unknown key `parameters.a.distribution.hi`"),
    ],
)
def test_distributions_that_are_none(tmp_path, distribution, message):
    text = refused(tmp_path, parameters=f"parameters:\n  a: {{path: payload.mass, distribution: {distribution}}}\n")
    assert message in text
    assert "/study.yaml:6: " in text


@pytest.mark.parametrize(
    ("plan", "message"),
    [
        ("{type: monte_carlo, runs: 1000000000000}", "plan.runs must be a whole number from 1 to 2e+07"),
        ("{type: grid, levels: 100000}", "got 10,000,000,000 cases of 2 parameters"),
        ("{type: montecarlo, runs: 3}", "Did you mean `monte_carlo`?"),
        ("{type: grid, points: {gaer: [1]}}", "Did you mean `gear`?"),
        ("{type: list, rows: [{gaer: 1}]}", "unknown key `plan.rows.0.gaer`. Did you mean `gear`?"),
        ("{type: list, rows: [{payload: 3 m}]}", "plan.rows.0.payload must be a number [kg], got the unit 'm'"),
        ("{type: list, rows: []}", "either rows or a file, got neither"),
    ],
)
def test_plans_that_cannot_be(tmp_path, plan, message):
    payload = "  payload: {path: payload.mass, distribution: {type: uniform, low: 1, high: 2}}\n"
    assert message in refused(tmp_path, parameters=GEAR + payload, plan=f"plan: {plan}\n")


def test_a_grid_of_two_hundred_parameters_is_refused_with_its_size():
    many = {f"p{k}": {"distribution": {"type": "uniform", "low": 0.0, "high": 1.0}} for k in range(200)}
    with pytest.raises(InputErrors, match=r"got 6.22e\+139 cases of 200 parameters"):
        study(many, plan={"type": "grid"})


@pytest.mark.parametrize(
    ("parameters", "message"),
    [
        ("  a: {path: gear.stiffness}\n", "must be varied by one of distribution, choices and catalogue"),
        ("  a b: {distribution: {type: uniform, low: 1, high: 2}}\n", "letters, digits and _, a letter first"),
        ("  sin: {distribution: {type: uniform, low: 1, high: 2}}\n", "the name 'sin', a word of formulas"),
        ("  peak: {distribution: {type: uniform, low: 1, high: 2}}\n", "got the name 'peak', which a parameter has"),
        ("  a: {path: name, distribution: {type: uniform, low: 1, high: 2}}\n", "a path that holds no number"),
        ("  a: {path: 'real:gear.stiffness', relative: true, distribution: {type: uniform, low: 1, high: 2}}\n",
         "leave `relative` out"),
        ("  a: {path: payload.mass, unit: g, distribution: {type: uniform, low: 1, high: 2}}\n",
         "parameters.a.unit must be kg, that of the path, got 'g'"),
        ("  a: {choices: [{name: x, set: {gear.stiffness: 3 m}}]}\n", "got the unit 'm'"),
        ("  a: {choices: [{name: x, set: {}}, {name: x, set: {}}]}\n", "'x', given twice"),
        ("  a: {path: gear.stiffness, distribution: {type: uniform, low: 1, high: 2}}\n"
         "  b: {path: joints.0.gear.stiffness, distribution: {type: uniform, low: 1, high: 2}}\n",
         "got joints.joint.gear.stiffness, which `a` sets already"),
    ],
)  # fmt: skip
def test_parameters_that_cannot_be(tmp_path, parameters, message):
    assert message in refused(tmp_path, parameters=f"parameters:\n{parameters}")


@pytest.mark.parametrize(
    ("quantities", "message"),
    [
        ("  peak: {series: deviation, reduce: mx}\n", "Did you mean `max`?"),
        ("  a: {expression: gaer + 1}\n", "got the name 'gaer'. Did you mean `gear`?"),
        (
            "  a: {expression: b}\n  b: {expression: c}\n  c: {expression: a}\n",
            "got a circle: a needs b needs c needs a",
        ),
        ("  a: {expression: __import__('os')}\n", "must be numbers, gear"),
        ("  f: {function: score}\n", "unknown function 'score'"),
        ("  s: {summary: setling.time_s}\n", "Did you mean `settling`?"),
        (
            "  s: {unit: mm}\n",
            "quantities.s.type is missing, expected one of expression, function, series, static, summary",
        ),
    ],
)
def test_quantities_that_cannot_be(tmp_path, quantities, message):
    assert message in refused(tmp_path, quantities=f"quantities:\n{quantities}")


def test_what_needs_a_robot_says_so(tmp_path):
    text = refused(tmp_path, head="format: 1\nkind: study\nname: test\n")
    assert "parameters.gear.path must be left out without a robot" in text
    free = "parameters:\n  x: {distribution: {type: uniform, low: 1, high: 2}}\n"
    text = refused(tmp_path, head="format: 1\nkind: study\nname: test\n", parameters=free)
    assert "quantities.peak must be an expression of parameters, got a number of a robot, without one" in text


def test_other_heads(tmp_path):
    assert "format must be at most 1, got 2, newer" in refused(tmp_path, head=HEAD.replace("format: 1", "format: 2"))
    assert "kind must be study, got 'arm'" in refused(tmp_path, head=HEAD.replace("kind: study", "kind: arm"))
    assert "published are" in refused(tmp_path, head=HEAD.replace("filipovic2010", "filipovc2010"))
    assert "leads outside" in refused(tmp_path, head=HEAD.replace("filipovic2010", "../robot.yaml"))
    text = refused(tmp_path, more="set: {gear.stifness: 3}\n")
    assert "set.gear.stifness: unknown path 'gear.stifness'. Did you mean `gear.stiffness`?" in text
    assert "numbers from 0 to 3, got case 9 of 4" in refused(tmp_path, more="keep: {cases: [9]}\n")


def test_a_robot_in_the_folder_and_its_changes(tmp_path):
    text = (HEAD + PLAN).replace("filipovic2010", "arm.yaml") + (
        "set: {links.link.bodies.payload.mass: 2 kg}\nquantities: {sag: {static: sag}}\n"
        "parameters: {k: {path: joints.joint.gear.stiffness, distribution: {type: uniform, low: 1, high: 2}}}\n"
    )
    one = written(tmp_path, text, arm_yaml=LUMPED)
    assert one.robot is not None
    assert one.robot.link("link").bodies[0].mass == 2.0


def test_a_study_is_no_robot(tmp_path):
    written(tmp_path, HEAD + GEAR + PLAN + PEAK)
    with pytest.raises(InputError, match="kind must be arm, got 'study'"):
        load(tmp_path / "study.yaml")


def test_files_must_be_there_and_yaml(tmp_path):
    with pytest.raises(InputError, match="no such file"):
        read_study(tmp_path / "none.yaml")
