"""Cases are computed by the way that their quantities need; what goes wrong with one is a row with its reason."""

from __future__ import annotations

import signal
from typing import Any

import numpy as np
import pytest

import tmodes
from study.core.studies import short, study
from tmodes.errors import InputError
from tmodes.kinds.outside import use
from tmodes.study.quantities import function
from tmodes.study.rows import joined

SETTINGS = {"integration.duration": 0.1, "integration.output_step": 0.01}


def test_series_and_summary_of_a_case_are_those_of_its_run():
    quantities = {
        "peak": {"series": "deviation", "reduce": "max", "unit": "mm"},
        "same": {"summary": "deviation.max_m", "unit": "mm"},
    }
    rows = short(quantities).evaluate(0, np.array([[0.9]]))
    robot = tmodes.load("filipovic2010", SETTINGS)
    known = tmodes.run(robot.with_({"gear.stiffness": 0.9 * 4700.0})).summary()["deviation"]["max_m"] * 1e3
    assert rows.quantities["same"][0] == pytest.approx(known, rel=1e-12)
    assert rows.quantities["peak"][0] == pytest.approx(known, rel=1e-6)
    assert rows.units == {"peak": "mm", "same": "mm"}
    assert rows.method[0] == "dormand_prince"
    assert rows.seconds[0] > 0


def test_expressions_are_computed_in_the_order_of_what_they_need_in_given_units():
    quantities = {
        "c": {"expression": "b + 3*gear"},
        "b": {"expression": "2*a"},
        "a": {"series": "deviation", "reduce": "end", "unit": "mm"},
    }
    rows = short(quantities).evaluate(0, np.array([[0.9], [1.1]]))
    assert [*rows.quantities] == ["c", "b", "a"]
    np.testing.assert_allclose(rows.quantities["c"], 2 * rows.quantities["a"] + [2.7, 3.3], rtol=1e-14)


def test_a_study_without_a_robot():
    one = study(
        {name: {"distribution": {"type": "uniform", "low": -np.pi, "high": np.pi}} for name in ("x1", "x2", "x3")},
        {"y": {"expression": "sin(x1) + 7*sin(x2)**2 + 0.1*x3**4*sin(x1)"}},
        plan={"type": "sobol", "runs": 4096},
    )
    rows = one.evaluate(0, one.design().values)
    assert rows.quantities["y"].mean() == pytest.approx(3.5, abs=0.01)
    assert rows.quantities["y"].var() == pytest.approx(13.844587940719254, rel=0.01)  # closed form
    assert set(rows.status) == {"finished"}


def test_an_expression_without_a_value_is_the_reason_of_its_row():
    one = study(quantities={"y": {"expression": "log(x - 0.5)"}, "z": {"expression": "2*x"}})
    rows = one.evaluate(0, np.array([[0.25], [0.75]]))
    assert [*rows.status] == ["failed", "finished"]
    assert rows.reason[0] == "y: log(x - 0.5) has no finite value there"
    assert np.isnan(rows.quantities["y"][0])
    assert rows.quantities["z"].tolist() == [0.5, 1.5]
    assert rows.good.tolist() == [False, True]


def test_numbers_that_no_robot_has_are_rows_that_were_refused():
    mass = {"path": "payload.mass", "distribution": {"type": "uniform", "low": -1.0, "high": 1.0}}
    one = short({"peak": {"series": "deviation", "reduce": "max"}}, {"mass": mass})
    rows = one.evaluate(10, np.array([[0.5], [-0.5], [0.4]]))
    assert [*rows.status] == ["finished", "refused", "finished"]
    assert "payload.mass must be a number not less than 0" in rows.reason[1]
    assert np.isfinite(rows.quantities["peak"]).tolist() == [True, False, True]
    rows = one.evaluate(0, np.array([[-0.5], [-0.6]]))
    assert [*rows.status] == ["refused"] * 2
    assert np.isnan(rows.quantities["peak"]).all()


def test_choices_set_words_and_numbers_and_factors_act_on_what_they_set():
    choices = [
        {"name": "soft", "set": {"gear.stiffness": "4 kN*m/rad"}},
        {"name": "hard", "set": {"gear.stiffness": 5000.0}},
    ]
    parameters = {
        "size": {"choices": choices},
        "law": {"choices": [{"name": "new", "set": {"equations": "consistent"}},
                            {"name": "old", "set": {"equations": "printed"}}]},
        "share": {"path": "gear.stiffness", "relative": True,
                  "distribution": {"type": "uniform", "low": 0.5, "high": 2}},
    }  # fmt: skip
    one = short({"peak": {"series": "deviation", "reduce": "max"}}, parameters)
    rows = one.evaluate(0, np.array([[0.0, 0.0, 1.25], [1.0, 0.0, 1.0], [0.0, 1.0, 1.25]]))
    peak = rows.quantities["peak"]
    assert peak[0] == pytest.approx(peak[1], rel=1e-12)  # 4000 times 1.25 is 5000
    assert peak[0] != pytest.approx(peak[2], rel=1e-9)
    assert one.choice_names("size") == ("soft", "hard")


def test_all_of_several_numbers_and_factors_of_the_actual_robot():
    """A factor on all that stand at a path, and one on the actual over the nominal number."""
    parameters = {
        "both": {"path": "link.modes.*.bending_stiffness", "distribution": {"type": "uniform", "low": 0.5, "high": 2}},
        "real": {"path": "real:gear.stiffness", "distribution": {"type": "uniform", "low": 0.1, "high": 1}},
    }
    one = short({"peak": {"series": "deviation", "reduce": "max"}}, parameters)
    assert one.space.nominal.tolist() == [1.0, 0.2]
    rows = one.evaluate(0, np.array([[0.8, 0.5]]))
    robot = tmodes.load("filipovic2010", SETTINGS)
    changed = robot.with_({"link.modes.*.bending_stiffness": 0.8, "real:gear.stiffness": 0.5})
    known = tmodes.run(changed).summary()["deviation"]["max_m"]
    assert rows.quantities["peak"][0] == pytest.approx(known, rel=1e-6)


def test_settings_of_the_integration_may_vary():
    step = {"path": "integration.output_step", "distribution": {"type": "discrete", "values": [0.01, 0.02]}}
    rows = short({"peak": {"series": "deviation", "reduce": "max"}}, {"step": step}).evaluate(
        0, np.array([[0.01], [0.02], [0.01]])
    )
    assert set(rows.status) == {"finished"}
    assert rows.quantities["peak"][0] == rows.quantities["peak"][2] >= rows.quantities["peak"][1]


def test_motions_are_kept_of_the_cases_that_are_named():
    one = short(
        {"peak": {"series": "tip.z", "reduce": "max"}},
        keep={"cases": [7], "every": 3},
        plan={"type": "random", "runs": 8},
    )
    rows = one.evaluate(4, one.design().values[4:8])
    assert sorted(rows.kept) == [6, 7]
    motion = rows.kept[7]
    assert motion.tip[:, 2].max() == pytest.approx(rows.quantities["peak"][3], abs=1e-12)
    assert motion.states.shape[0] == len(motion.times) == 11
    assert motion.names[:2] == ("joint.motor", "joint")


def test_cases_in_parts_are_those_of_the_whole():
    one = short({"peak": {"series": "deviation", "reduce": "max"}}, plan={"type": "random", "runs": 6})
    values = one.design().values
    whole, parts = one.evaluate(0, values), joined([one.evaluate(0, values[:2]), one.evaluate(2, values[2:])])
    assert parts.case.tolist() == whole.case.tolist()
    assert [*parts.status] == [*whole.status]
    np.testing.assert_allclose(parts.quantities["peak"], whole.quantities["peak"], rtol=1e-9)


def lower(result: Any) -> float:
    """A function that fails for soft gears."""
    if result.actual.joints[0].gear.stiffness[0] < 900.0:
        raise ValueError("too soft")
    return float(result.motion["tip"].values[-1, 0])


FUNCTIONS = {
    "lower": lower,
    "list": lambda result: [1.0, 2.0],
    "words": lambda result: "high",
    "infinite": lambda result: np.inf,
    "changes": lambda result: result.data["tip"].values.fill(0.0),
}


def test_a_function_of_ones_own_and_its_exception():
    one = short({"a": {"function": "lower"}, "t": {"series": "tip.x", "reduce": "end"}}, functions=FUNCTIONS)
    rows = one.evaluate(0, np.array([[1.0], [0.9]]), threads=1)
    assert [*rows.status] == ["finished", "failed"]
    assert rows.reason[1] == "a: ValueError: too soft"
    assert rows.quantities["a"][0] == pytest.approx(rows.quantities["t"][0], abs=1e-9)
    assert np.isnan(rows.quantities["a"][1])


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("list", "must return one number, got an array of shape (2,)"),
        ("words", "must return one number, got `str`"),
        ("infinite", "must return a finite number, got inf"),
        ("changes", "ValueError: assignment destination is read-only"),
    ],
)
def test_a_function_that_gives_no_number(name, reason):
    rows = short({"a": {"function": name}}, functions=FUNCTIONS).evaluate(0, np.array([[1.0]]))
    assert rows.status[0] == "failed"
    assert reason in rows.reason[0]


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="needs a system with alarms")
def test_a_function_that_never_ends_is_stopped():
    def endless(result):
        while True:
            pass

    rows = short({"a": {"function": "f", "timeout": 0.2}}, functions={"f": endless}).evaluate(0, np.array([[1.0]]))
    assert rows.reason[0] == "a: TimeoutError: took longer than 0.2 s"


@pytest.mark.nightly
def test_results_are_computed_in_processes():
    """Functions that can be sent there, and those that are registered, run in processes of their own."""
    one = short({"a": {"function": "lower"}, "b": {"summary": "deviation.max_m"}}, functions={"lower": lower})
    values = np.array([[1.0], [0.9], [1.1]])
    together, alone = one.evaluate(0, values, threads=2), one.evaluate(0, values, threads=1)
    assert [*together.status] == [*alone.status] == ["finished", "failed", "finished"]
    for name in ("a", "b"):
        np.testing.assert_array_equal(together.quantities[name], alone.quantities[name])


def test_registered_functions(monkeypatch):
    monkeypatch.setattr(function, "REGISTERED", {})
    function.quantity("one")(lambda result: 1.0)
    rows = short({"a": {"function": "one"}}).evaluate(0, np.array([[1.0]]))
    assert rows.quantities["a"].tolist() == [1.0]


def test_functions_of_a_file_that_a_person_names(tmp_path, monkeypatch):
    """Other processes load the file too."""
    monkeypatch.setattr(function, "REGISTERED", {})
    file = tmp_path / "quantities_of_mine.py"
    file.write_text(
        "from tmodes.study.quantities.function import quantity\n\n\n@quantity('mine')\ndef mine(result):\n"
        "    return result.actual.joints[0].gear.stiffness[0]\n",
        encoding="utf-8",
    )
    use(str(file))
    rows = short({"a": {"function": "mine"}}).evaluate(0, np.array([[1.0], [0.9]]), threads=2)
    np.testing.assert_allclose(rows.quantities["a"], [940.0, 846.0], rtol=1e-12)  # a fifth of the nominal gear


def test_motions_are_kept_whatever_is_asked():
    one = short({"sag": {"static": "sag"}}, keep={"cases": [1]})
    rows = one.evaluate(0, np.array([[1.0], [0.9]]))
    assert [*rows.kept] == [1]
    alike = short({"sag": {"static": "sag"}}, {"law": {"choices": [{"name": "x", "set": {}}]}}, keep={"every": 1},
                  plan={"type": "list", "rows": [{}, {}]})  # fmt: skip
    rows = alike.evaluate(0, np.zeros((2, 1)))
    assert sorted(rows.kept) == [0, 1]
    assert rows.quantities["sag"][0] == rows.quantities["sag"][1]


@pytest.mark.parametrize(
    ("quantity", "message"),
    [
        ({"series": "deviation", "reduce": "max", "unit": "kg"}, "which is of another dimension"),
    ],
)
def test_what_is_wrong_with_the_study_itself_is_raised(quantity, message):
    with pytest.raises(InputError, match=message):
        short({"a": quantity}).evaluate(0, np.array([[1.0]]))


def test_values_of_another_shape_are_refused():
    with pytest.raises(InputError, match=r"rows of Study\.design"):
        study().evaluate(0, np.zeros((3, 2)))
