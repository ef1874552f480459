"""Batches in folders: the same bytes, whole or absent, whatever stops them; and what is refused beforehand."""

from __future__ import annotations

import errno
import json
import os
import signal
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lane_runs import simulate_lanes
from tmodes.errors import InputError, ResultFileError
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.simulation.batch.result import load_batch, room_for


def test_the_folder_holds_the_same_batch(lot, tmp_path):
    memory, disk = lot.run(), lot.run(out=tmp_path / "batch")
    again = load_batch(tmp_path / "batch")
    for batch in (disk, again):
        assert batch.states.tobytes() == memory.states.tobytes()
        assert np.array_equal(batch.times, memory.times)
        assert (batch.status, batch.message, batch.coordinates) == (memory.status, memory.message, memory.coordinates)
        assert all(np.array_equal(batch.statistics[name], memory.statistics[name]) for name in memory.statistics)
        assert batch.folder == tmp_path / "batch"
    assert sorted(path.name for path in (tmp_path / "batch").iterdir()) == ["batch.json", "states.npy", "times.npy"]
    with pytest.raises(ResultFileError, match="new folder"):
        lot.run(out=tmp_path / "batch")


class _Interrupts:
    """A progress that presses Ctrl-C as soon as something is done."""

    def __call__(self, share):
        raise KeyboardInterrupt


def test_interrupted_keeps_what_was_done(lot, tmp_path):
    """Lanes that were ended say so; the folder is whole."""
    settings = lot.settings.model_copy(update={"duration": 2000.0, "output_step": 1.0})
    batch = replace(lot, settings=settings).run(out=tmp_path / "batch", progress=_Interrupts())
    assert set(batch.status) == {"interrupted"}
    assert all("interrupted at t = " in message for message in batch.message)
    assert (batch.counts >= 1).all()
    assert np.isfinite(batch.states[0, : batch.counts[0]]).all()
    assert np.isnan(batch.states[0, batch.counts[0] :]).all()
    assert load_batch(tmp_path / "batch").status == batch.status


def test_a_progress_that_fails_leaves_nothing(lot, tmp_path):
    def fails(share):
        raise RuntimeError("no terminal")

    settings = lot.settings.model_copy(update={"duration": 2000.0, "output_step": 1.0})
    with pytest.raises(RuntimeError, match="no terminal"):
        replace(lot, settings=settings).run(out=tmp_path / "batch", progress=fails)
    assert list((tmp_path / "batch").iterdir()) == []
    with pytest.raises(ResultFileError, match="no whole batch"):
        load_batch(tmp_path / "batch")


KILLED = """
import os, signal, sys
import tmodes
from lane_runs import simulate_lanes
from tmodes.simulation.initial_state import run_setup
setup = run_setup(tmodes.load("filipovic2010"))
settings = setup.robot.integration.model_copy(update={"duration": 2000.0, "output_step": 1.0})
def kill(share):
    os.kill(os.getpid(), signal.SIGKILL)
model, numbers = setup.model, setup.model.numbers
simulate_lanes(model, numbers, setup.planned.schedule, setup.start, settings, out=sys.argv[1], progress=kill)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="no such signal")
def test_killed_leaves_no_batch(lot, tmp_path):
    """After kill -9 there is no file that looks whole, and the folder can be used again."""
    folder = tmp_path / "batch"
    done = subprocess.run(
        [sys.executable, "-c", KILLED, str(folder)], check=False, env=os.environ, cwd=Path(__file__).parents[1]
    )
    assert done.returncode == -signal.SIGKILL
    assert [path.name for path in folder.iterdir() if not path.name.startswith(".")] == []
    with pytest.raises(ResultFileError, match="no whole batch"):
        load_batch(folder)
    lot.run(out=folder)
    assert sorted(path.name for path in folder.iterdir()) == ["batch.json", "states.npy", "times.npy"]


@pytest.mark.parametrize(
    ("key", "value"), [("format", 2), ("shape", [9, 41, 16]), ("status", ["finished"]), ("samples", None)]
)
def test_a_folder_that_does_not_fit_together_is_refused(lot, tmp_path, key, value):
    lot.run(out=tmp_path)
    info = json.loads((tmp_path / "batch.json").read_text(encoding="utf-8"))
    (tmp_path / "batch.json").write_text(json.dumps(info | {key: value}), encoding="utf-8")
    with pytest.raises(ResultFileError):
        load_batch(tmp_path)


def test_truncated_samples_are_refused(lot, tmp_path):
    lot.run(out=tmp_path)
    content = (tmp_path / "states.npy").read_bytes()
    (tmp_path / "states.npy").write_bytes(content[:-8])
    with pytest.raises(ResultFileError, match="no whole batch"):
        load_batch(tmp_path)


def test_too_large_is_refused_with_numbers(lot, tmp_path):
    """Neither memory nor disk is asked for more than there is."""
    settings = lot.settings.model_copy(update={"duration": 1e6, "output_step": 1.0})
    given = (np.tile(lot.many, (3000, 1)), lot.schedule, lot.start, settings)
    with pytest.raises(InputError, match=r"1.8 GB.*27000 lanes of 1000001 samples of 19 numbers, 4.1e\+03 GB.*out="):
        simulate_lanes(lot.model, *given)
    with pytest.raises(ResultFileError, match="at least 4,104,"):
        simulate_lanes(lot.model, *given, out=tmp_path / "new")
    assert not (tmp_path / "new").exists()


def wrong_calls(lot):
    given = {"parameters": lot.many, "schedules": lot.schedule, "states": lot.start, "settings": lot.settings}
    linear = SignalPieces(np.array([0.0, 1.0]), np.zeros((1, 2)))
    numbers, states = lot.many.shape[1], len(lot.start)
    return {
        "lanes": ("9", given | {"states": np.zeros((4, states))}),
        "parameters": (f"{numbers} numbers", given | {"parameters": lot.many[:, :-1]}),
        "states": (f"{states} numbers", given | {"states": np.zeros(states - 1)}),
        "rows": ("4 numbers", given | {"schedules": linear}),
        "shape": ("size", given | {"parameters": np.zeros((2, 2, numbers))}),
        "threads": ("1 to 1024", given | {"threads": 0}),
        "schedules": ("1 or", given | {"schedules": [lot.schedule] * 3}),
    }


@pytest.mark.parametrize("wrong", ["lanes", "parameters", "states", "rows", "shape", "threads", "schedules"])
def test_wrong_calls_are_refused(lot, wrong):
    info, call = wrong_calls(lot)[wrong]
    with pytest.raises(InputError, match=info):
        simulate_lanes(lot.model, **call)


def test_a_disk_that_fills_up_meanwhile_is_reported_before_anything_runs(lot, tmp_path, monkeypatch):
    """Room is taken, not only asked for; where it is gone, nothing is left in the folder."""

    def full(handle, start, length):
        assert length > lot.many.shape[0] * 41 * 19 * 8
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "posix_fallocate", full, raising=False)
    monkeypatch.setattr("tmodes.simulation.batch.executor.Processor.run", lambda *_: pytest.fail("it runs"))
    with pytest.raises(ResultFileError, match="No space left on device"):
        lot.run(out=tmp_path)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(not hasattr(os, "posix_fallocate"), reason="no such call")
def test_room_on_the_disk_is_taken_before_anything_runs(tmp_path):
    with room_for((1000, 10, 10), tmp_path):
        (states,) = tmp_path.glob(".tmodes-*.tmp")
        assert states.stat().st_blocks * 512 >= 1000 * 10 * 10 * 8
