"""Cases that are prepared as arrays: the same numbers, methods and messages as case by case; else the ordinary way."""

from __future__ import annotations

import numpy as np
import pytest

import tmodes
from simulation.sheets import pendulum, torque
from tmodes.errors import InputErrors
from tmodes.simulation.vary import arrays, simulate

SHORT = {"integration.duration": 0.02, "integration.output_step": 2e-3}

ROBOTS = {
    "filipovic2010": {
        "real.gear.stiffness": (0.16, 0.24), "payload.mass": (0.45, 0.55), "reference.end": (0.5, 0.8),
        "link.modes.1.bending_stiffness": (12.0, 15.0), "environment.preload": (3.0, 6.0),
    },
    "spong1987": {"joints.joint.gear.stiffness": (60.0, 140.0), "gravity": (9.0, 10.0)},
    "deluca_siciliano1991": {
        "links.forearm.bodies.payload.mass": (0.05, 0.2), "links.forearm.beam.section.bending_stiffness.1": (0.5, 1.5),
    },
}  # fmt: skip


@pytest.fixture
def prepared_alone(monkeypatch):
    """The places of the cases that were prepared one by one."""
    alone, ordinary = [], simulate._lane
    monkeypatch.setattr(arrays, "_FEW", 2)
    monkeypatch.setattr(simulate, "_lane", lambda *given: (alone.append(given[-1]), ordinary(*given))[1])
    return alone


def one_by_one(monkeypatch, *given, **more):
    with monkeypatch.context() as patch:
        patch.setattr(arrays, "_FEW", 10**9)
        return tmodes.simulate_batch(*given, **more)


@pytest.mark.parametrize("name", list(ROBOTS))
def test_the_same_numbers_as_case_by_case(name, prepared_alone, monkeypatch):
    robot = tmodes.load(name).with_(SHORT)
    generator = np.random.default_rng(0)
    vary = {path: generator.uniform(*ends, 30) for path, ends in ROBOTS[name].items()}
    found = tmodes.simulate_batch(robot, vary, tips=True)
    assert len({*prepared_alone}) <= 1 + 2 * len(vary)
    some = [k for k in range(30) if k not in prepared_alone][:4]
    true = one_by_one(monkeypatch, robot, {path: values[some] for path, values in vary.items()}, tips=True)
    assert found.status == ("finished",) * 30
    assert found.statistics["steps"][some].tolist() == true.statistics["steps"].tolist()
    assert np.abs(found.states[some] - true.states).max() < 1e-11 * np.abs(true.states).max()
    assert found.tips is not None
    assert true.tips is not None
    assert np.abs(found.tips[some] - true.tips).max() < 1e-12 * np.abs(true.tips).max()


def swing(**changes):
    settings = {"duration": 0.05, "output_step": 0.01}
    return pendulum({"inertia": 0.3}, {"stiffness": 100.0}, torque(2.0), integration=settings).with_(changes)


def test_the_method_of_each_case(prepared_alone, monkeypatch):
    """Stiff ones by extrapolation, others not, also where the few that are prepared alone do not tell."""
    stiffness = {"joints.joint.gear.stiffness": np.geomspace(1e2, 1e12, 11)}
    found = simulate.prepared(swing(), stiffness)
    assert len(prepared_alone) < 5
    monkeypatch.setattr(arrays, "_FEW", 10**9)
    true = simulate.prepared(swing(), stiffness)
    methods = [
        {group.like.robot.integration.method: group.places.tolist() for group in groups}
        for groups in (found.groups, true.groups)
    ]
    assert methods[0] == methods[1]
    assert len(methods[0]) == 2


def test_starts_and_signals_of_each_case(prepared_alone, monkeypatch):
    vary = {"initial.coordinates.joint": np.linspace(0.1, 0.5, 9), "drives.0.signal.value": np.linspace(1.0, 2.0, 9)}
    found = tmodes.simulate_batch(swing(), vary)
    assert len(prepared_alone) < 5
    true = one_by_one(monkeypatch, swing(), vary)
    assert np.abs(found.states - true.states).max() < 1e-13


def test_structure_goes_case_by_case(prepared_alone, monkeypatch):
    """Seeds of noise."""
    vary = {"reference.noise.seed": np.arange(1.0, 8.0)}
    robot = tmodes.load("filipovic2010").with_(SHORT | {"reference.noise.deviation": 1e-4})
    found = tmodes.simulate_batch(robot, vary)
    assert sorted({*prepared_alone}) == list(range(7))
    assert found.states.tobytes() == one_by_one(monkeypatch, robot, vary).states.tobytes()


def test_rests_far_apart_are_found_from_their_neighbours(prepared_alone):
    """Masses over three decades; the lightest rests as its own sheet says."""
    robot, masses = tmodes.load("filipovic2010").with_(SHORT), np.geomspace(300.0, 0.1, 24)
    groups = simulate.prepared(robot, {"payload.mass": masses}).groups
    assert len({*prepared_alone}) == 2
    true = simulate.prepared(robot, {"payload.mass": masses[11:12]}).groups[0].starts
    assert np.abs(groups[0].starts[11] - true).max() < 1e-12


def test_zero_is_a_case_of_its_own(prepared_alone):
    """It may change the structure."""
    vary = {"joints.joint.gear.damping": [0.5, 0.4, 0.0, 0.3, 0.2, 0.1, 0.6]}
    found = tmodes.simulate_batch(swing(), vary)
    assert 2 in prepared_alone
    assert len({*prepared_alone}) < 7
    alone = tmodes.simulate_batch(swing(), {"joints.joint.gear.damping": [0.0]})
    assert found.states[2].tobytes() == alone.states[0].tobytes()


def test_the_first_wrong_case_is_named(prepared_alone, monkeypatch):
    """In its own words, without a look at all before it."""
    masses = np.random.default_rng(3).permutation(np.linspace(-0.05, 0.5, 400))
    robot = tmodes.load("filipovic2010").with_(SHORT)
    with pytest.raises(InputErrors) as found:
        simulate.prepared(robot, {"payload.mass": masses, "gravity": np.full(400, 9.8)})
    first = int(np.argmax(masses < 0))
    assert f"case {first}: payload.mass must be a number not less than 0 [kg], got {masses[first]}" in str(found.value)
    assert len({*prepared_alone}) < 20


def test_figures_in_place_of_samples(prepared_alone, monkeypatch):
    """Part after part in the same room; cases that cannot start are among them."""
    robot = tmodes.load("filipovic2010").with_(SHORT)
    vary = {"payload.mass": [*np.linspace(0.4, 0.6, 70), 0.0]}
    ordinary = simulate._lane
    monkeypatch.setattr(simulate, "_lane", lambda *given: "no rest" if given[-1] == 70 else ordinary(*given))

    def peak(part):
        return {"peak": np.abs(part.states[:, :, 1]).max(axis=1), "end": part.tips[:, -1, 2]}

    monkeypatch.setattr(simulate, "_ROOM", 60 * 11 * 19 * 8)
    found = tmodes.simulate_batch(robot, vary, tips=True, figures=peak)
    kept = tmodes.simulate_batch(robot, vary, tips=True)
    assert {*prepared_alone} == {0, 69}
    assert found.states.shape == (71, 0, kept.states.shape[2])
    assert found.status == kept.status == ("finished",) * 70 + ("failed",)
    assert found.statistics["steps"].tolist() == kept.statistics["steps"].tolist()
    for name, true in peak(kept).items():
        assert found.figures[name].tobytes() == true.tobytes()
