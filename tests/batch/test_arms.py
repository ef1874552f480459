"""Batches of arms: schedules of kernels in lanes, contacts met by each lane for itself, and methods without lanes."""

from __future__ import annotations

import numpy as np
import pytest

from arm.run.sheets import ZERO, arm, pendulum, torque
from tmodes.compile.loops.gate import SHORTEST
from tmodes.simulation.batch.simulate import simulate_lanes
from tmodes.simulation.start import run_setup
from tmodes.simulation.trajectory import integrate

SHORT = {"duration": 0.3, "output_step": 0.013, "relative_tolerance": 1e-9, "absolute_tolerance": 1e-11}


def settings(regime, **changes):
    info = {"method": "dormand_prince", **changes}
    return regime.arm.integration.model_copy(update=info)


def spread(regime, lanes, share=0.05):
    """Numbers of arms a little off those of a regime."""
    vector = regime.model.numbers
    return vector * (1 + share * np.random.default_rng(3).uniform(-1, 1, size=(lanes, len(vector))))


@pytest.fixture(scope="module")
def swing():
    """An elastic pendulum under a constant torque."""
    return run_setup(pendulum({"inertia": 0.3}, {"stiffness": 100.0}, torque(2.0), integration=SHORT))


@pytest.fixture(scope="module")
def bounce():
    """A block that meets a wall which only pushes."""
    wall = {"shape": {"type": "plane", "position": [0.1, 0, 0], "normal": [-1, 0, 0]}, "law": "unilateral",
            "stiffness": 2000.0, "damping": 3.0}  # fmt: skip
    return run_setup(arm(
        gravity=0.0, contact=wall, integration=SHORT,
        joints=[{"name": "slide", "type": "prismatic", "parent": "base", "child": "block", "axis": [1, 0, 0]}],
        links=[{"name": "block", "bodies": [{"name": "mass", "mass": 0.5, "center": [0, 0, 0]}]}],
        drives=[{"joint": "slide", "command": "effort", "signal": ZERO}],
        initial={"state": "zero", "rates": {"slide": 1.0}},
    ))  # fmt: skip


@pytest.mark.parametrize("method", ["dormand_prince", "rk4"])
def test_each_lane_is_the_run_by_itself(swing, method):
    model, chosen = swing.model, settings(swing, method=method, step=1e-3)
    many = spread(swing, 6)
    batch = simulate_lanes(model, many, swing.planned.schedule, swing.start, chosen, threads=2)
    for lane, numbers in enumerate(many):
        single = integrate(model, numbers, swing.planned.schedule, swing.start, chosen)
        assert np.abs(batch.states[lane] - single.states).max() < 1e-12 * np.abs(single.states).max()
    part = simulate_lanes(model, many[[5, 0]], swing.planned.schedule, swing.start, chosen, threads=1)
    assert part.states.tobytes() == batch.states[[5, 0]].tobytes()


def test_each_lane_meets_its_own_wall(bounce):
    """Steps are cut onto the onset of each lane's own contact, at times of its own."""
    model, chosen = bounce.model, settings(bounce)
    speeds = np.array([0.5, 0.9, 1.3, 2.0, 3.0])
    starts = np.tile(bounce.start, (5, 1))
    starts[:, model.layout.v] = speeds[:, None]
    batch = simulate_lanes(model, model.numbers, bounce.planned.schedule, starts, chosen)
    for lane, start in enumerate(starts):
        single = integrate(model, model.numbers, bounce.planned.schedule, start, chosen)
        # An onset is met within SHORTEST: the states may differ by what they change in that time, and no more.
        fastest = np.abs(model.rate(single.times, single.states, bounce.planned.schedule.rows_at(single.times))).max()
        assert np.abs(batch.states[lane] - single.states).max() < SHORTEST * fastest
        # How often a step is halved onto the onset may differ by rounding; it is halved many times in each run.
        assert batch.statistics["rejected"][lane] == pytest.approx(single.statistics["rejected"], abs=3)
        assert batch.statistics["rejected"][lane] > 20
    part = simulate_lanes(model, model.numbers, bounce.planned.schedule, starts[[3, 1]], chosen)
    assert part.states.tobytes() == batch.states[[3, 1]].tobytes()


def test_pieces_are_not_seen_where_there_is_a_contact(bounce, monkeypatch):
    """The gate is kept between calls, so that a neighbour cannot move where a lane looks at it."""
    model, chosen = bounce.model, settings(bounce)
    given = (model.numbers, bounce.planned.schedule, bounce.start, chosen)
    whole = simulate_lanes(model, *given)
    monkeypatch.setattr("tmodes.simulation.batch.workers._FIRST_PIECE", 1)
    monkeypatch.setattr("tmodes.simulation.batch.workers._PIECE_SECONDS", 0.0)
    assert simulate_lanes(model, *given).states.tobytes() == whole.states.tobytes()


@pytest.mark.parametrize("threads", [1, 2])
def test_stiff_arms_run_one_by_one(swing, threads):
    """The implicit method has no lanes: each arm is the run by itself, bit by bit, and a bad one disturbs none."""
    model, chosen = swing.model, settings(swing, method="extrapolation", max_steps=4000)
    many = spread(swing, 4)
    many[2] = np.nan
    batch = simulate_lanes(model, many, swing.planned.schedule, swing.start, chosen, threads=threads)
    assert [status == "finished" for status in batch.status] == [True, True, False, True]
    for lane in (0, 1, 3):
        single = integrate(model, many[lane], swing.planned.schedule, swing.start, chosen)
        assert batch.states[lane].tobytes() == single.states.tobytes()


def test_a_lane_that_chatters_ends_by_itself(bounce, monkeypatch):
    """A contact that changes too often: reported as in a run by itself; the others continue."""
    monkeypatch.setattr("tmodes.simulation.native_run.MOST_EVENTS", 1)
    monkeypatch.setattr("tmodes.simulation.native_run.EVENT_TIME", 10.0)
    model, chosen = bounce.model, settings(bounce)
    starts = np.tile(bounce.start, (3, 1))
    starts[:, model.layout.v] = np.array([-1.0, 1.0, -2.0])[
        :, None
    ]  # only the second one meets the wall, and leaves it
    batch = simulate_lanes(model, model.numbers, bounce.planned.schedule, starts, chosen)
    single = integrate(model, model.numbers, bounce.planned.schedule, starts[1], chosen)
    assert batch.status == ("finished", single.status, "finished") == ("finished", "chattering", "finished")
    assert batch.counts[1] == len(single.times) < len(batch.times)
    assert "more than 1 times" in batch.message[1]
    others = simulate_lanes(model, model.numbers, bounce.planned.schedule, starts[[0, 2]], chosen)
    assert batch.states[[0, 2]].tobytes() == others.states.tobytes()
