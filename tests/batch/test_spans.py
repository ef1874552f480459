"""Spans of lanes: each lane in one of them; what went through a room before is not seen by what comes after."""

from __future__ import annotations

import numpy as np
import pytest

from lane_runs import simulate_lanes
from tmodes.compile.native import WIDTH
from tmodes.errors import InputError
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.simulation.batch.executor import spans, thread_count
from tmodes.simulation.batch.simd_batch import LINE, private
from tmodes.simulation.problem import problem_of


def work(lot, lanes, method):
    settings = lot.settings.model_copy(update={"method": method})
    many = np.tile(lot.many[:1], (lanes, 1))
    return problem_of(lot.model, many, lot.schedule, lot.start, settings, np.zeros((lanes, 1, 1)))


@pytest.mark.parametrize("method", ["dormand_prince", "dop853"])
@pytest.mark.parametrize("threads", [1, 2, 7, 64])
@pytest.mark.parametrize("lanes", [1, 7, 8, 9, 100, 1024, 5000])
def test_each_lane_is_in_one_span(lot, lanes, threads, method):
    """Side by side in whole groups; as many spans as keep all threads busy to the end."""
    found = spans(work(lot, lanes, method), threads)
    assert [lane for span in found for lane in span] == list(range(lanes))
    side = WIDTH if method == "dormand_prince" else 1
    assert all(len(span) % side == 0 for span in found[:-1])
    assert len(found) >= min(8 * threads, -(-lanes // side))
    assert max(map(len, found)) <= 64 * side


@pytest.mark.parametrize("method", ["dormand_prince", "rk4"])
def test_one_room_for_many_groups(lot, method, monkeypatch):
    """In one long span, with bad lanes, starts and motions of their own: the bytes of spans of one group each."""
    rng, lanes = np.random.default_rng(4), 5 * WIDTH + 3
    vector = lot.model.numbers
    many = vector * (1 + 0.02 * rng.normal(size=(lanes, len(vector))))
    many[3, lot.place("payload.mass")] = np.nan
    many[WIDTH + 1, lot.place("controller.position_gain")] = -1e7
    starts = lot.start + 1e-3 * rng.normal(size=(lanes, len(lot.start)))
    starts[2 * WIDTH] = np.inf
    knots = [np.linspace(0.0, 0.02, 2 + lane % 4) for lane in range(lanes)]
    schedules = [SignalPieces(each, 0.1 * rng.normal(size=(len(each) - 1, 3))) for each in knots]
    settings = lot.settings.model_copy(update={"method": method, "max_steps": 20_000})
    for moved in (schedules, lot.schedule):
        given = (many, moved, starts, settings)
        short = simulate_lanes(lot.model, *given, threads=2)
        with monkeypatch.context() as patch:
            patch.setattr("tmodes.simulation.batch.executor._SPANS", 1)
            long = simulate_lanes(lot.model, *given, threads=1)
        assert long.states.tobytes() == short.states.tobytes()
        assert (long.status, long.message) == (short.status, short.message)
        assert all(np.array_equal(long.statistics[name], short.statistics[name]) for name in long.statistics)
        assert (~long.finished).sum() == 3


def test_private_memory_shares_no_line():
    """It begins on a line and the line of its last number has room for nothing else."""
    arrays = [private(3, 5), private(1), private(16, 4), private(2, 8)]
    for array in arrays:
        assert not array.any()
        assert array.flags.c_contiguous
        assert array.ctypes.data % LINE == 0
    lines = [range(a.ctypes.data // LINE, (a.ctypes.data + a.nbytes - 1) // LINE + 1) for a in arrays]
    assert all(set(one).isdisjoint(other) for k, one in enumerate(lines) for other in lines[:k])


@pytest.mark.parametrize("threads", [0, 1_000_000])
def test_threads_without_end_are_refused(threads):
    with pytest.raises(InputError, match=f"threads must be 1 to 1024, got {threads}"):
        thread_count(threads)
