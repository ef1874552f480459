"""How works go through a device: blocks, launches, their lengths, and what ends them early."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tmodes.compile.gpu.cuda import HostDevice
from tmodes.errors import SimulationError
from tmodes.integrate.registry import integrators
from tmodes.simulation.batch.executor import PROCESSOR
from tmodes.simulation.case_results import CaseResults
from tmodes.simulation.gpu.block import bytes_per_case, loop_of, suits_gpu
from tmodes.simulation.gpu.run import block_size

from .conftest import on_device


class Watched(HostDevice):
    """A device that keeps what was asked of it: cases and steps of each launch, rooms that are taken."""

    def __init__(self, memory=2**30, stops_at=None):
        super().__init__(memory)
        self.launches, self.taken, self.stops_at = [], 0, stops_at

    def empty(self, size):
        self.taken += 1
        return super().empty(size)

    def launch(self, loop, rooms, whole):
        if len(self.launches) == self.stops_at:
            raise KeyboardInterrupt
        options = rooms["options"].view(np.float64)
        self.launches.append((whole["threads"], options[3]))
        super().launch(loop, rooms, whole)

    def release(self, rooms):
        self.taken -= len(rooms)


def ticking(step):
    """A clock that moves at each look."""
    now = 0.0

    def clock():
        nonlocal now
        now += step
        return now

    return clock


def some(cases, count):
    return replace(cases, numbers=cases.numbers[:count])


def run(cases, device, **how):
    work = cases.work()
    return work.states, on_device([work], device=device, **how)


@pytest.fixture
def short(monkeypatch):
    """First launches of five steps."""
    monkeypatch.setattr("tmodes.simulation.gpu.run._FIRST", 5)


@pytest.mark.parametrize("step", [1e-6, 1.0])
def test_bytes_do_not_depend_on_launches(published, short, step):
    """Launches that seem short grow, those that seem long shrink to one step: the result is the same."""
    cases = some(published.by("dormand_prince"), 3)
    whole, _ = run(cases, Watched(), clock=ticking(0.05))
    device = Watched()
    parted, _ = run(cases, device, clock=ticking(step))
    assert parted.tobytes() == whole.tobytes()
    steps = [steps for _, steps in device.launches]
    assert len(steps) > 2
    later = [4.0**k if step == 1e-6 else 0.2 for k in range(1, len(steps))]
    assert steps == [5.0, *(5.0 * share for share in later)]


class Timed(Watched):
    """A device whose steps take 1 ms each."""

    now = 0.0

    def launch(self, loop, rooms, whole):
        super().launch(loop, rooms, whole)
        self.now += 1e-3 * self.launches[-1][1]


def test_launches_take_as_long_as_they_should(published):
    """50 ms, which are 50 steps here; the last ones find nothing more to do."""
    device = Timed()
    run(some(published.by("rk4", step=1e-5), 2), device, clock=lambda: device.now)
    steps = [steps for _, steps in device.launches]
    assert steps[0] == 100
    assert len(steps) == 10
    assert steps[1:] == pytest.approx([50] * 9, abs=1.1)


def test_blocks_fit_the_memory_and_change_nothing(published):
    cases = some(published.by("rk4"), 7)
    whole, _ = run(cases, Watched())
    each = bytes_per_case(cases.work(), loop_of(cases.work()))
    device = Watched(memory=int(3.5 * each / 0.9))
    assert block_size(cases.work(), loop_of(cases.work()), device) == 3
    parted, runs = run(cases, device)
    assert parted.tobytes() == whole.tobytes()
    assert len(runs) == 7
    assert {threads for threads, _ in device.launches} == {3, 1}
    assert device.taken == 0


def test_too_little_memory_is_said_with_numbers(published):
    with pytest.raises(SimulationError, match=r"this processor has 0\.001 MB free, and one case takes"):
        run(published.by("rk4"), Watched(memory=1000))


def test_who_is_over_is_launched_no_more(published, short):
    """Cases of different length; the threads are those that still run, and there are never more than needed."""
    cases = some(published.by("dormand_prince"), 100)
    device = Watched()
    _, runs = run(cases, device, clock=ticking(0.3))
    threads = [threads for threads, _ in device.launches]
    assert threads[0] == 100
    assert threads == sorted(threads, reverse=True)
    assert len(set(runs.statistics["steps"] + runs.statistics["rejected"])) > 1
    assert 1 <= threads[-1] < 100


def test_one_case_that_is_lost_disturbs_no_other(published):
    """Not-a-number among its numbers, or among its start: it says why, the others are as without it."""
    cases = some(published.by("dormand_prince"), 4)
    whole, _ = run(cases, Watched())
    starts, numbers = np.repeat(cases.starts, 4, axis=0), cases.numbers.copy()
    numbers[1], starts[3, 0] = np.nan, np.nan
    states, runs = run(replace(cases, starts=starts, numbers=numbers), Watched())
    assert [runs.status[case] for case in range(4)] == ["finished", "diverged", "finished", "diverged"]
    assert runs.message[1].startswith("diverged at t = 0 s in coordinate")
    assert runs.samples[1] == 1
    assert runs.samples[3] == 0
    assert np.isnan(states[1, 1:]).all()
    for case in (0, 2):
        assert states[case].tobytes() == whole[case].tobytes()


def test_limit_on_steps_is_exact(published):
    cases = some(published.by("dormand_prince", max_steps=17), 3)
    states, runs = run(cases, Watched())
    assert set(runs.status) == {"stopped"}
    assert all("integration.max_steps = 17 is used up" in message for message in runs.message)
    assert set(runs.statistics["steps"] + runs.statistics["rejected"]) == {17}
    assert np.isfinite(states[:, 0]).all()


def test_limit_on_time_stops(published):
    cases = some(published.by("rk4", max_wall_time=20.0), 2)
    _, runs = run(cases, Watched(), clock=ticking(3.0))
    assert set(runs.status) == {"stopped"}
    assert "integration.max_wall_time = 20 s is used up" in runs.message[0]


def test_interrupted_cases_keep_what_they_have(published):
    """Ctrl-C in the third launch of the second of three blocks."""
    cases = some(published.by("rk4"), 6)
    whole, _ = run(cases, Watched())
    memory = int(2.5 * bytes_per_case(cases.work(), loop_of(cases.work())) / 0.9)
    before = Watched(memory)
    run(some(cases, 2), before, clock=ticking(0.3))
    device = Watched(memory, stops_at=len(before.launches) + 2)
    states, runs = run(cases, device, clock=ticking(0.3))
    assert [runs.status[case] for case in range(6)] == ["finished"] * 2 + ["interrupted"] * 4
    assert runs.message[2].startswith("interrupted at t = 0.00")
    count = runs.samples[2]
    assert 1 < count < len(whole[2])
    assert states[2, :count].tobytes() == whole[2, :count].tobytes()
    assert np.isnan(states[2, count:]).all()
    assert runs.samples[5] == 1
    assert device.taken == 0


def test_interrupted_before_the_first_launch(published):
    device = Watched(stops_at=0)
    _, runs = run(some(published.by("rk4"), 2), device)
    assert set(runs.status) == {"interrupted"}
    assert set(runs.samples) == {1}
    assert device.taken == 0


def test_what_progress_raises_stops_and_gives_memory_back(published):
    device, shares = Watched(), []

    def progress(share):
        shares.append(share)
        if len(shares) == 3:
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        on_device([some(published.by("rk4"), 2).work()], progress, device=device, clock=ticking(0.3))
    assert shares == sorted(shares)
    assert 0 < shares[0] < shares[-1] < 1
    assert device.taken == 0


def test_answer_is_of_the_same_shape_as_that_of_the_processor(published, swinging):
    """Two works of different structure, in one batch of places."""
    works = [some(published.by("dormand_prince"), 3).work(), some(swinging.by("rk4"), 2).work()]
    rooms = [[np.full((5, *work.states.shape[1:]), np.nan) for work in works] for _ in range(2)]
    places = (np.arange(3), np.array([4, 3]))
    works, again = (
        [replace(work, states=room, places=at) for work, room, at in zip(works, each, places, strict=True)]
        for each in rooms
    )
    shares = []
    found = on_device(works, shares.append, device=Watched())
    expected = CaseResults.of_all(5)
    PROCESSOR.run(again, expected, 1, lambda share: None)
    assert shares[-1] == pytest.approx(1.0)
    assert (found.status == expected.status).all()
    assert (found.message == expected.message).all()
    assert (found.samples == expected.samples).all()
    for work, other in zip(works, again, strict=True):
        gone, right = (one.states[one.places] for one in (work, other))
        assert np.abs(gone - right).max() < 1e-9 * np.abs(right).max()


def test_explicit_methods_gain_from_a_gpu():
    found = {name for name in integrators() if suits_gpu(name)}
    assert found == {"dormand_prince", "dop853", "rk4"}


def mixed(published, swinging):
    """A work that does not suit a GPU between two that do, and their places in one batch."""
    given = [published.by("rk4"), swinging.by("rosenbrock"), swinging.by("dormand_prince")]
    works = [some(one, 2).work() for one in given]
    rooms = [np.full((6, *work.states.shape[1:]), np.nan) for work in works]
    return [
        replace(work, states=room, places=2 * k + np.arange(2))
        for k, (work, room) in enumerate(zip(works, rooms, strict=True))
    ]


def test_stiff_works_run_on_the_processor(published, swinging):
    device, shares = Watched(), []
    works = mixed(published, swinging)
    runs = on_device(works, shares.append, threads=1, device=device)
    assert set(runs.status) == {"finished"}
    assert len(runs) == 6
    assert shares == sorted(shares)
    assert shares[-1] == pytest.approx(1.0)
    alone = swinging.by("rosenbrock")
    for case in range(2):
        assert works[1].states[2 + case].tobytes() == alone.alone(case).states.tobytes()
    again = Watched()
    on_device(mixed(published, swinging), device=again)
    assert len(again.launches) > len(device.launches)


def test_after_an_interruption_the_processor_begins_nothing(published, swinging):
    runs = on_device(mixed(published, swinging), threads=1, device=Watched(stops_at=1), clock=ticking(0.3))
    assert set(runs.status) == {"interrupted"}
    assert [runs.samples[place] for place in (2, 3, 4, 5)] == [1] * 4
