"""A lane that cannot go on says when and where, keeps what it had, and disturbs no other lane."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from lane_runs import simulate_lanes
from tmodes.simulation.problem import problem_of
from tmodes.simulation.solve import solve


def spoilt(lot, lane, name, value):
    """The nine robots, one number of one lane changed."""
    many = lot.many.copy()
    many[lane, lot.place(name)] = value
    return replace(lot, many=many)


BAD = {
    "no number": ("payload.mass", np.nan),
    "infinite": ("environment.preload", np.inf),
    "runs away": ("controller.position_gain", -1e7),
    "stiff": ("gear.stiffness", 1e19),
}


@pytest.mark.parametrize("case", list(BAD))
@pytest.mark.parametrize("method", ["dormand_prince", "rk4"])
def test_a_bad_lane_spoils_no_other(lot, case, method):
    settings = lot.settings.model_copy(update={"method": method, "max_steps": 20_000})
    lot = replace(lot, settings=settings)
    good, bad = lot.run(), spoilt(lot, 5, *BAD[case]).run()
    others = [lane for lane in range(9) if lane != 5]
    assert bad.states[others].tobytes() == good.states[others].tobytes()
    assert bad.status[5] != "finished"
    assert " at t = " in bad.message[5]
    assert [bad.message[lane] for lane in others] == [good.message[lane] for lane in others]
    count = bad.counts[5]
    assert np.isfinite(bad.states[5, :count]).all()
    assert np.isnan(bad.states[5, count:]).all()


@pytest.mark.parametrize("case", ["no number", "runs away"])
def test_what_a_lane_says_is_what_the_run_by_itself_says(lot, case):
    many = spoilt(lot, 2, *BAD[case])
    batch = many.run()
    numbers = many.many[2]
    single = solve(problem_of(lot.model, numbers, lot.schedule, lot.start, lot.settings))
    assert (batch.status[2], batch.message[2]) == (single.status, single.message)
    assert "in coordinate" in batch.message[2]
    assert batch.counts[2] == len(single.times)


def test_limit_on_steps_holds_in_each_lane(lot):
    """Exactly, whatever the machine does; a lane that needs fewer steps is not ended."""
    steps = lot.run().statistics["steps"] + lot.run().statistics["rejected"]
    limit = int(np.sort(steps)[4])
    settings = lot.settings.model_copy(update={"max_steps": limit})
    limited = replace(lot, settings=settings).run()
    assert [status == "finished" for status in limited.status] == [int(count) <= limit for count in steps]
    ended = ~limited.finished
    assert (limited.statistics["steps"] + limited.statistics["rejected"])[ended].tolist() == [limit] * int(ended.sum())
    assert all("max_steps" in limited.message[lane] for lane in np.flatnonzero(ended))


def test_limit_on_time_keeps_what_was_done(lot):
    settings = lot.settings.model_copy(update={"max_wall_time": 1e-9})
    batch = replace(lot, settings=settings).run()
    assert set(batch.status) == {"stopped"}
    assert all("max_wall_time" in message for message in batch.message)
    assert batch.counts.tolist() == [1] * 9


def test_a_start_that_is_no_number_has_no_sample(lot):
    starts = np.tile(lot.start, (3, 1))
    starts[1, 2] = np.nan
    batch = simulate_lanes(lot.model, lot.many[:3], lot.schedule, starts, lot.settings)
    assert batch.counts[1] == 0
    assert batch.status[1] == "diverged"
    assert batch.states[[0, 2]].tobytes() == lot.run([0, 2]).states.tobytes()
