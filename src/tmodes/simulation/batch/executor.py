"""What runs the works of a batch: threads of this machine, each of which keeps a core busy, or another device.

The native loops run without Python's lock.
"""

from __future__ import annotations

import os
import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, wait
from threading import Event
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.native import WIDTH
from tmodes.errors import InputError
from tmodes.simulation.batch.simd_batch import lane_group
from tmodes.simulation.case_results import CaseResults
from tmodes.simulation.native_run import pieces
from tmodes.simulation.problem import Problem

__all__ = ["PROCESSOR", "Executor", "Processor", "Progress", "run_lanes", "spans", "thread_count"]

Progress = Callable[[float], None]

_SPANS, _LONGEST = 8, 64
"""Spans that each thread gets, so that none waits long for the last; groups of lanes in the longest."""

_MOST_THREADS = 1024

_PATIENCE = 0.1
"""Seconds between two words about the progress."""


class Executor(ABC):
    """How works are run, and how many cases of a study are given to it at once."""

    longest: ClassVar[int] = 8192
    """Cases of the longest part."""

    room: ClassVar[int] = 128_000_000
    """Bytes of what cases are compared with, or of the series that percentiles are of, of one part."""

    @abstractmethod
    def run(self, problems: Sequence[Problem], results: CaseResults, threads: int, progress: Progress) -> None:
        """Run all cases of all problems to their ends; ``results`` says at their places how they ended.

        ``progress`` is given the share of all cases' time that is done; what it raises stops the batch. Ctrl-C ends
        all with what they have (``interrupted``).
        """


def thread_count(threads: int | None) -> int:
    """Threads of a batch; None: as many as this process may use cores. Raises InputError for none, or too many."""
    if threads is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if not 1 <= threads <= _MOST_THREADS:
        raise InputError("threads", str(threads), f"1 to {_MOST_THREADS}", "leave it out to use all cores")
    return threads


class Processor(Executor):
    """Threads of this machine."""

    def run(self, problems: Sequence[Problem], results: CaseResults, threads: int, progress: Progress) -> None:
        """Spans of lanes over the threads."""
        for work in problems:
            prepare_loop(work)
        reached, stop = np.zeros(len(results)), Event()
        whole = sum(work.time for work in problems)
        with ThreadPoolExecutor(threads, "tmodes-batch") as pool:
            futures = [
                pool.submit(run_lanes, work, span, stop.is_set, reached, results)
                for work in problems for span in spans(work, threads)
            ]  # fmt: skip
            try:
                _watch(futures, lambda: progress(float(reached.sum()) / (whole or 1.0)))
            except KeyboardInterrupt:
                stop.set()
            except BaseException:
                stop.set()
                pool.shutdown(cancel_futures=True)
                raise
        for future in futures:
            future.result()
        if stop.is_set() and "interrupted" not in results.status.tolist():
            raise KeyboardInterrupt  # all ended first: what comes next must not begin


PROCESSOR = Processor()


def _watch(futures: list[Future[None]], tell: Callable[[], None]) -> None:
    """Wait for one after the other, which costs nothing however many there are; what one raises is raised."""
    info = time.monotonic()
    for future in futures:
        while not future.done():
            wait([future], _PATIENCE)
            if time.monotonic() - info >= _PATIENCE:
                tell()
                info = time.monotonic()
        future.result()
    tell()


def spans(work: Problem, threads: int) -> list[range]:
    """Lanes that a thread takes at once: many, so that threads seldom ask for more; whole groups side by side."""
    side, lanes = _side(work), work.size
    groups = -(-lanes // side)
    size = side * min(max(1, groups // (threads * _SPANS)), _LONGEST)
    return [range(first, min(first + size, lanes)) for first in range(0, lanes, size)]


def _side(work: Problem) -> int:
    """Lanes that go at once."""
    return WIDTH if work.model.goes_side_by_side(work.settings.method) else 1


def run_lanes(
    work: Problem, lanes: range, wish: Callable[[], bool], reached: NDArray[np.float64], results: CaseResults
) -> None:
    """Run a span of lanes to their ends, or until ``wish`` to stop; ``reached`` (all,) gets their times [s].

    How spans and pieces are cut, and what else the machine does, changes no bit of the samples, unless a limit on time
    ends the run.
    """
    running, side = lane_group(work), _side(work)
    for first in range(lanes.start, lanes.stop, side):
        group = range(first, min(first + side, lanes.stop))
        places, began, own = work.places[first : group.stop], time.monotonic(), time.thread_time()
        running.begin(group)
        for piece in pieces(work.settings.max_wall_time):
            if wish():
                break
            running.advance(piece)
            reached[places] = running.times
            if not running.going:
                break
        running.end(results, time.monotonic() - began)
        results.seconds[places] = (time.thread_time() - own) / len(group)


def prepare_loop(work: Problem) -> None:
    """Compile once, before the threads want the loop."""
    model, method, wanted = work.model, work.settings.method, work.wanted
    if not model.goes_side_by_side(method):
        model.loops[method]
    elif wanted is None:
        model.lane_loop(method)
    else:
        wanted.library(model, method)
