"""Cases reduced while they run: the numbers of the same cases run by themselves."""

from __future__ import annotations

import numpy as np
import pytest

import tmodes
from simulation.sheets import pendulum, torque
from tmodes.errors import InputError, InputErrors
from tmodes.simulation.outputs import robot_outputs
from tmodes.simulation.reductions import RULES, of_samples, with_slope
from tmodes.simulation.vary import arrays
from tmodes.simulation.vary.reduce import Reduction, reduced
from tmodes.simulation.vary.single_case import single_case
from tmodes.simulation.vary.tables import own_tip

HOWS = ("max", "min", "max_abs", "mean", "rms", "end", "range")

STIFF = ("acceleration", "power.", "base.")
"""Outputs in which the error of a deflection counts as many times as its spring is stiff."""

ROBOTS = {
    "filipovic2010": (
        {"integration.duration": 0.5, "integration.output_step": 0.013},
        {"real.gear.stiffness": [0.16, 0.2, 0.24, 0.21, 0.19], "payload.mass": [0.45, 0.5, 0.55, 0.52, 0.51]},
        "dormand_prince",
    ),
    "spong1987": (
        {"integration.duration": 1.0},
        {"joints.joint.gear.stiffness": [60.0, 80.0, 140.0, 120.0, 90.0]},
        "dormand_prince",
    ),
    "deluca_siciliano1991": (
        {"integration.duration": 1.0},
        {"links.forearm.bodies.payload.mass": [0.05, 0.07, 0.1, 0.2, 0.12]},
        "extrapolation",
    ),
}
"""Of each what is changed, what is varied, and the method that its stiffness asks for."""


@pytest.fixture(autouse=True)
def as_arrays(monkeypatch):
    """Also few cases are prepared as arrays."""
    monkeypatch.setattr(arrays, "_FEW", 2)


def numbers_alone(*given):
    """The numbers of a case that is run by itself."""
    return {one: values[0] for one, values in single_case(*given).values.items()}


def case_of(vary, k):
    return {path: float(values[k]) for path, values in vary.items()}


@pytest.mark.nightly("deluca")
@pytest.mark.parametrize("name", list(ROBOTS))
def test_all_series_as_by_itself(name):
    changes, vary, method = ROBOTS[name]
    robot = tmodes.load(name).with_(changes)
    names = list(robot_outputs(robot))
    folded = [Reduction(series, how) for series in names for how in HOWS]
    shares = [Reduction(series, "percentile:90") for series in names]
    found, written = reduced(robot, vary, folded), reduced(robot, vary, [*folded, *shares], threads=1)
    assert tuple(found.status) == tuple(written.status) == ("finished",) * 5
    assert {*found.method} == {method}
    own = own_tip(robot, 1)[0]
    for k in (0, 3):
        true = numbers_alone(robot, case_of(vary, k), [*folded, *shares], own)
        for one in [*folded, *shares]:
            size = max(abs(true[Reduction(one.series, "max")]), abs(true[Reduction(one.series, "min")]), 1e-5)
            stiff = 50 if any(part in one.series for part in STIFF) else 1
            assert written.values[one][k] == pytest.approx(true[one], abs=4e-6 * stiff * size), one
            if one in found.values:
                assert found.values[one][k] == pytest.approx(written.values[one][k], abs=1e-12 * size), one


def test_the_numbers_of_a_summary():
    changes, vary, _ = ROBOTS["filipovic2010"]
    robot = tmodes.load("filipovic2010").with_(changes)
    asked = {
        ("deviation", "max"): "m", ("deviation", "end"): "m", ("deviation", "time_of_max"): "s",
        ("tip_error", "max"): "m", ("deformation.joint.gear", "max_abs"): "rad", ("joint.effort", "max_abs"): "N*m",
        ("contact.force", "mean"): "N",
    }  # fmt: skip
    reductions = [Reduction(*each) for each in asked]
    found = reduced(robot, vary, reductions)
    summary = tmodes.run(robot.with_(case_of(vary, 1))).summary()
    true = [
        summary["deviation"]["max_m"], summary["deviation"]["end_m"], summary["deviation"]["time_of_max_s"],
        summary["tip_error"]["commanded"]["max_m"], summary["deformations"]["joint.gear"]["max"],
        summary["joints"]["joint"]["largest_effort"], summary["contact_force"]["mean_N"],
    ]  # fmt: skip
    assert [abs(found.values[one][1]) for one in reductions] == pytest.approx([abs(x) for x in true], rel=4e-6)
    assert [found.units[one] for one in reductions] == list(asked.values())


def test_one_nominal_run_where_none_differs():
    """The deviation is the same as with a nominal run for each case."""
    robot = tmodes.load("filipovic2010").with_({"integration.duration": 0.2, "integration.output_step": 0.01})
    stiffness, deviation = [0.16, 0.2, 0.24, 0.21, 0.19], [Reduction("deviation", "max")]
    one = reduced(robot, {"real.gear.stiffness": stiffness}, deviation)
    each = reduced(robot, {"real.gear.stiffness": stiffness, "payload.mass": [0.5] * 5}, deviation)
    assert one.values[deviation[0]] == pytest.approx(each.values[deviation[0]], rel=1e-9)
    assert np.ptp(one.values[deviation[0]]) > 1e-4


def swing(**changes):
    settings = {"duration": 0.05, "output_step": 0.01}
    return pendulum({"inertia": 0.3}, {"stiffness": 100.0}, torque(2.0), integration=settings).with_(changes)


def test_stiff_and_other_cases_mixed():
    vary = {"joints.joint.gear.stiffness": np.geomspace(1e2, 1e12, 11)}
    speed = Reduction("tip.speed", "max")
    found = reduced(swing(), vary, [speed])
    assert {*found.method} == {"dormand_prince", "extrapolation"}
    for k in (0, 4, 10):
        assert found.values[speed][k] == pytest.approx(numbers_alone(swing(), case_of(vary, k), [speed], None)[speed])


def test_parts_do_not_matter(monkeypatch):
    changes, vary, _ = ROBOTS["filipovic2010"]
    robot = tmodes.load("filipovic2010").with_(changes | {"integration.duration": 0.05})
    many = {path: np.linspace(min(values), max(values), 150) for path, values in vary.items()}
    asked = [Reduction("deviation", "rms"), Reduction("joint.effort", "max")]
    whole = reduced(robot, many, asked)
    monkeypatch.setattr("tmodes.simulation.batch.executor.Executor.room", 1)
    parts = reduced(robot, many, asked, threads=1)
    for one in asked:
        assert parts.values[one].tobytes() == whole.values[one].tobytes()
    assert parts.statistics["steps"].tolist() == whole.statistics["steps"].tolist()


def test_stations_alone():
    found = reduced(
        tmodes.load("filipovic2010"), {"gear.stiffness": [1e3, 2e3]}, [Reduction("link.1.moment.z@0.5", "max_abs")]
    )
    assert np.isfinite(next(iter(found.values.values()))).all()


def test_stop_conditions_end_cases_and_are_said():
    robot = swing(**{"integration.duration": 1.0, "integration.stop": ["abs(joint.position) > 0.3"]})
    asked = [Reduction("joint.position", "max_abs"), Reduction("energy.total", "range")]
    found = reduced(robot, {"drives.0.signal.value": [1e-3, 3.0]}, asked)
    assert tuple(found.status) == ("finished", "stopped_by_condition")
    assert "stop condition `abs(joint.position) > 0.3`" in found.message[1]
    assert found.values[asked[0]][1] == pytest.approx(0.3, abs=1e-9)
    assert np.isfinite(found.values[asked[1]]).all()


def test_energies_are_those_of_a_run():
    robot, energy = swing(), Reduction("energy.total", "end")
    found = reduced(robot, {"drives.0.signal.value": [1.0, 2.0]}, [energy, Reduction("tip.speed", "max")])
    data = tmodes.run(robot).data
    assert found.values[energy][1] == pytest.approx(float(data["energy"].sum("energy_kind")[-1]), rel=1e-9)


def test_wrong_cases_as_rows():
    robot = tmodes.load("filipovic2010").with_({"integration.duration": 0.02, "integration.output_step": 1e-3})
    masses = np.random.default_rng(3).permutation(np.linspace(-0.05, 0.5, 40))
    vary = {"payload.mass": masses, "real.gear.stiffness": np.full(40, 0.2)}
    asked = [Reduction("deviation", "max")]
    with pytest.raises(InputErrors, match=r"payload\.mass must be a number not less than 0"):
        reduced(robot, vary, asked)
    found = reduced(robot, vary, asked, wrong="row", kept=[0])
    bad = masses < 0
    assert [status == "refused" for status in found.status] == bad.tolist()
    assert "payload.mass must be a number not less than 0" in found.message[int(bad.argmax())]
    assert np.isnan(found.values[asked[0]]).tolist() == bad.tolist()


def test_some_motions_are_kept():
    robot = tmodes.load("filipovic2010").with_({"integration.duration": 0.05, "integration.output_step": 1e-3})
    found = reduced(robot, {"payload.mass": [0.4, 0.5, 0.6]}, [Reduction("tip.speed", "max")], kept=[2])
    true = tmodes.simulate_batch(robot, {"payload.mass": [0.6]}, tips=True)
    kept = found.kept[2]
    assert kept.names == true.coordinates
    assert true.tips is not None
    assert kept.states.tobytes() == true.states[0].tobytes()
    assert kept.tip.tobytes() == true.tips[0].tobytes()


def test_a_case_that_is_lost_has_no_numbers():
    robot = swing(**{"integration.max_steps": 100, "integration.duration": 5.0})
    found = reduced(robot, {"drives.0.signal.value": [0.0, 2.0]}, [Reduction("tip.speed", "max")])
    assert found.status[1] == "stopped"
    assert "max_steps" in found.message[1]
    assert np.isnan(found.values[Reduction("tip.speed", "max")][1])


@pytest.mark.parametrize(
    ("reductions", "words"),
    [
        ([], "at least one"),
        ([Reduction("tip.sped", "max")], "Did you mean `tip.speed`"),
        ([Reduction("tip.speed", "maximum")], "Did you mean `max`"),
        ([Reduction("tip.speed", "percentile:101")], "P from 0 to 100"),
        ([Reduction("tip.speed", "percentile:nan")], "P from 0 to 100"),
        ([Reduction("deviation", "max")], "there is no nominal run"),
    ],
)
def test_what_cannot_be_asked(reductions, words):
    with pytest.raises(InputError, match=words):
        reduced(swing(), {"drives.0.signal.value": [1.0, 2.0]}, reductions)


def test_kept_indices_must_exist():
    with pytest.raises(InputError, match="from 0 to 1"):
        reduced(swing(), {"drives.0.signal.value": [1.0, 2.0]}, [Reduction("tip.speed", "max")], kept=[2])


def test_a_series_settles_when_it_stays_in_its_band():
    times = np.linspace(0.0, 1.0, 11)
    values = np.array([np.exp(-5 * times), np.full(11, 2.0), np.where(times < 0.95, 1.0, 0.0)])
    found = of_samples(Reduction("tip.x", "settling:0.05"), values, times)
    assert found == pytest.approx([0.6, 0.0, 1.0])
    assert Reduction("tip.x", "settling:0.05").unit_of("m") == "s"


@pytest.mark.parametrize("how", [name for name, rule in RULES.items() if rule.slope])
def test_slopes_of_rules_are_those_of_differences(how):
    times, values = np.array([0.0, 0.1, 0.25, 0.3]), np.array([0.3, -1.0, 2.0, 0.7])
    value, slopes = with_slope(one := Reduction("tip.x", how), values, times)

    def at(changed):
        return of_samples(one, changed[None], times)[0]

    assert value == at(values)
    moved = [(at(values + step) - at(values - step)) / 2e-6 for step in 1e-6 * np.eye(4)]
    assert slopes == pytest.approx(moved, abs=1e-8)
