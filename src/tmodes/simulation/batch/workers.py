"""Spans of lanes over threads: the native loops run without Python's lock, so each thread keeps one core busy."""

from __future__ import annotations

import os
import time as clock
from collections.abc import Callable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, wait
from threading import Event

import numpy as np

from tmodes.errors import InputError
from tmodes.simulation.batch.lanes import run_lanes, spans
from tmodes.simulation.batch.work import Work
from tmodes.simulation.trajectory import Trajectory

__all__ = ["run_all", "thread_count"]

_MOST_THREADS = 1024

_PATIENCE = 0.1
"""Seconds between two words about the progress."""


def thread_count(threads: int | None) -> int:
    """Threads of a batch; None: as many as this process may use cores. Raises InputError for none, or too many."""
    if threads is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if not 1 <= threads <= _MOST_THREADS:
        raise InputError("threads", str(threads), f"1 to {_MOST_THREADS}", "leave it out to use all cores")
    return threads


def run_all(works: Sequence[Work], threads: int, progress: Callable[[float], None]) -> dict[int, Trajectory]:
    """Run all lanes of all works, each with its place; Ctrl-C ends them with what they have (``interrupted``).

    ``progress`` is given the share of all lanes' time that is done; what it raises stops the batch.
    """
    lanes = [(work, span) for work in works for span in spans(work, threads)]
    reached, stop = np.zeros(len(works[0].states) if works else 0), Event()
    whole = sum(work.inputs.size * work.settings.duration for work in works)
    with ThreadPoolExecutor(threads, "tmodes-batch") as pool:
        futures = [pool.submit(run_lanes, work, span, stop.is_set, reached) for work, span in lanes]
        try:
            _watch(futures, lambda: progress(float(reached.sum()) / whole))
        except KeyboardInterrupt:
            stop.set()
        except BaseException:
            stop.set()
            pool.shutdown(cancel_futures=True)
            raise
    done: dict[int, Trajectory] = {}
    for (work, span), future in zip(lanes, futures, strict=True):
        done |= zip(work.places[span.start : span.stop].tolist(), future.result(), strict=True)
    return done


def _watch(futures: list[Future[list[Trajectory]]], tell: Callable[[], None]) -> None:
    """Wait for one after the other, which costs nothing however many there are; what one raises is raised."""
    info = clock.monotonic()
    for future in futures:
        while not future.done():
            wait([future], _PATIENCE)
            if clock.monotonic() - info >= _PATIENCE:
                tell()
                info = clock.monotonic()
        future.result()
    tell()
