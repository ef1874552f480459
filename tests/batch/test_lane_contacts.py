"""Contacts in batches: each lane meets its own, at its own times, and may end by itself."""

from __future__ import annotations

import numpy as np
import pytest

from lane_runs import simulate_lanes
from simulation.sheets import ZERO, arm
from tmodes.compile.loops.gate import SHORTEST
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.problem import problem_of
from tmodes.simulation.solve import solve

SHORT = {"duration": 0.3, "output_step": 0.013, "relative_tolerance": 1e-9, "absolute_tolerance": 1e-11}


def settings(setup, **changes):
    info = {"method": "dormand_prince", "step": 1e-3, **changes}
    return setup.robot.integration.model_copy(update=info)


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
def test_each_lane_meets_its_own_wall(bounce, method):
    """Steps are cut onto the onset of each lane's own contact, at times of its own."""
    model, chosen = bounce.model, settings(bounce, method=method)
    speeds = np.array([0.5, 0.9, 1.3, 2.0, 3.0])
    starts = np.tile(bounce.start, (5, 1))
    starts[:, model.layout.v] = speeds[:, None]
    batch = simulate_lanes(model, model.numbers, bounce.planned.schedule, starts, chosen)
    for lane, start in enumerate(starts):
        single = solve(problem_of(model, model.numbers, bounce.planned.schedule, start, chosen))
        # An onset is met within SHORTEST: the states may differ by what they change in that time, and no more.
        fastest = np.abs(model.rate(single.times, single.states, bounce.planned.schedule.rows_at(single.times))).max()
        assert np.abs(batch.states[lane] - single.states).max() < SHORTEST * fastest
        # How often a step is halved onto an onset may differ by rounding, by one or two at each of several onsets.
        assert batch.statistics["rejected"][lane] == pytest.approx(single.statistics["rejected"], rel=0.1, abs=3)
        assert batch.statistics["rejected"][lane] > 20
    part = simulate_lanes(model, model.numbers, bounce.planned.schedule, starts[[3, 1]], chosen)
    assert part.states.tobytes() == batch.states[[3, 1]].tobytes()


def test_pieces_are_not_seen_where_there_is_a_contact(bounce, monkeypatch):
    """The gate is kept between calls, so that a neighbour cannot move where a lane looks at it."""
    model, chosen = bounce.model, settings(bounce)
    given = (model.numbers, bounce.planned.schedule, bounce.start, chosen)
    whole = simulate_lanes(model, *given)
    monkeypatch.setattr("tmodes.simulation.native_run._FIRST_PIECE", 1)
    monkeypatch.setattr("tmodes.simulation.native_run._PIECE_SECONDS", 0.0)
    assert simulate_lanes(model, *given).states.tobytes() == whole.states.tobytes()


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
    single = solve(problem_of(model, model.numbers, bounce.planned.schedule, starts[1], chosen))
    assert batch.status == ("finished", single.status, "finished") == ("finished", "chattering", "finished")
    assert batch.counts[1] == len(single.times) < len(batch.times)
    assert "more than 1 times" in batch.message[1]
    others = simulate_lanes(model, model.numbers, bounce.planned.schedule, starts[[0, 2]], chosen)
    assert batch.states[[0, 2]].tobytes() == others.states.tobytes()
