"""Groups of lanes over threads: the native loops run without Python's lock, so each thread keeps one core busy."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor, wait
from threading import Event

import numpy as np

from tmodes.batch.lanes import groups, run_lanes
from tmodes.batch.work import Work
from tmodes.errors import InputError
from tmodes.trajectory import Trajectory

__all__ = ["run_all", "thread_count"]

_PATIENCE = 0.1
"""Seconds between two words about the progress."""


def thread_count(threads: int | None) -> int:
    """Threads of a batch; None: as many as this process may use cores. Raises InputError for fewer than one."""
    if threads is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if threads < 1:
        raise InputError("threads", str(threads), "at least 1", "leave it out to use all cores")
    return threads


def run_all(work: Work, threads: int, progress: Callable[[float], None]) -> list[Trajectory]:
    """Run every lane; Ctrl-C ends them with what they have (``interrupted``).

    ``progress`` is told the share of all lanes' time that is done; what it raises stops the batch.
    """
    reached, stop = np.zeros(work.inputs.size), Event()
    with ThreadPoolExecutor(threads, "tmodes-batch") as pool:
        futures = [pool.submit(run_lanes, work, lanes, stop.is_set, reached) for lanes in groups(work)]
        try:
            _watch(futures, lambda: progress(float(reached.mean()) / work.settings.duration))
        except KeyboardInterrupt:
            stop.set()
        except BaseException:
            stop.set()
            pool.shutdown(cancel_futures=True)
            raise
    return [run for future in futures for run in future.result()]


def _watch(futures: list[Future[list[Trajectory]]], tell: Callable[[], None]) -> None:
    """Wait until all are done; the first one that fails is told at once."""
    waiting = set(futures)
    while waiting:
        done, waiting = wait(waiting, _PATIENCE)
        for future in done:
            future.result()
        tell()
