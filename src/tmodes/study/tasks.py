"""Consecutive cases that are computed at once, here or on another machine: their number, and as bytes."""

from __future__ import annotations

import json
import time as clock
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from threading import Lock

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, SimulationError
from tmodes.simulation.batch.executor import PROCESSOR, Executor
from tmodes.study.blocks import Block, base_of, engine_of_blocks, in_order, label_of, pack, restricted
from tmodes.study.study import Study

__all__ = ["LEAST", "Pace", "Task", "compute", "compute_block", "order"]


@dataclass(frozen=True, eq=False)
class Task:
    """Consecutive cases: ``values`` (m, d) of which the first has the number ``first``, and which quantities of them.

    ``keep``: the cases among them whose whole motion is kept.
    """

    first: int
    values: NDArray[np.float64]
    quantities: tuple[str, ...]
    keep: tuple[int, ...] = ()


LEAST, MOST = 64, 1 << 18
"""Cases of a block that is chosen here."""

BYTES = 1 << 26
"""Bytes of a block, which is in memory some times, and once more while the next is prepared."""

SECONDS, LONGEST = 3.0, 30.0
"""What the cases of a block are to take, and at most, where preparing it takes long."""

OVERHEAD = 6.0
"""Cases of a block take at least so many times longer than preparing it."""

GROWTH = 32
"""A block has at most so many times more cases than the one before: its time may be that of the first compilation."""


@dataclass
class Pace:
    """``fixed``: cases of a block by the sheet; ``heavy``: bytes of a case, at least, which bound a block in memory."""

    fixed: int | None = None
    heavy: int = 0
    _size: int = LEAST

    @property
    def _most(self) -> int:
        """Cases of a block of at most so many bytes."""
        return max(1, min(MOST, BYTES // max(self.heavy, 1)))

    def size(self, left: int, workers: int = 1) -> int:
        """Cases of the next block, when ``left`` remain for so many workers: at the end all have something to do."""
        if self.fixed:
            return min(left, self.fixed)
        fair = max(LEAST, -(-left // (2 * workers))) if workers > 1 else left
        return min(left, fair, self._size, self._most)

    def took(self, cases: int, wall: float, work: float, threads: int = 1, heavy: int = 0) -> None:
        """A block of so many cases took ``wall`` seconds; its cases alone ``work`` seconds of some ``threads``.

        ``heavy``: bytes of one of its cases.
        """
        self.heavy = max(self.heavy, heavy)
        if cases < min(self._size, LEAST):  # the rest of a gap says little
            return
        computing = min(wall, work / threads) or wall
        target = min(LONGEST, max(SECONDS, OVERHEAD * (wall - computing)))
        wanted = min(cases * target / max(computing, 1e-6), GROWTH * cases, MOST)
        self._size = max(LEAST, int(wanted) // LEAST * LEAST)


Progress = Callable[[str, float], None]


def compute(
    study: Study, task: Task, threads: int | None = None, progress: Progress = lambda stage, share: None,
    executor: Executor = PROCESSOR,
) -> Block:  # fmt: skip
    """Compute the cases of a task; raises KeyboardInterrupt where it was interrupted, so that no half is stored."""
    part = restricted(study, task.quantities)
    began = clock.perf_counter()
    rows = part.evaluate(task.first, task.values, progress, threads=threads, executor=executor)
    if "interrupted" in rows.status:
        raise KeyboardInterrupt
    keys = part.quantity_identities
    if len(rows) != len(task.values) or set(rows.quantities) != set(keys):
        raise SimulationError(
            f"{len(rows)} rows of {sorted(rows.quantities)} came where {len(task.values)} were asked for"
        )
    label = label_of(base_of(study), engine_of_blocks(), keys, rows, clock.perf_counter() - began)
    return Block(label, rows, task.keep)


def order(study: Study, task: Task, threads: int | None = None) -> bytes:
    """The task with its study as bytes of plain data. Raises InputError for functions, which are code."""
    if study.functions:
        hint = "run it with --on local, or write the quantity as an expression"
        raise InputError("quantities", "a Python function", "plain data on other machines", hint)
    head = {
        "data": dict(study.data), "first": task.first, "shape": list(task.values.shape), "threads": threads,
        "quantities": list(task.quantities), "keep": list(task.keep), "engine": engine_of_blocks(),
    }  # fmt: skip
    return in_order(head) + b"\n" + np.ascontiguousarray(task.values, "<f8").tobytes()


def compute_block(asked: bytes) -> bytes:
    """What a worker runs: the order as bytes, the block as bytes. Raises SimulationError for another engine."""
    with _ONE:
        return _computed(asked)


_ONE = Lock()
"""A worker computes one block at a time, over all of its threads."""


def _computed(asked: bytes) -> bytes:
    text, _, numbers = asked.partition(b"\n")
    head = json.loads(text)
    if head["engine"] != engine_of_blocks():
        raise SimulationError(
            f"a worker has version {engine_of_blocks()} of the engine, the study {head['engine']}; "
            "install the same tmodes on all machines"
        )
    values = np.frombuffer(numbers, "<f8").reshape(head["shape"])
    task = Task(head["first"], values, tuple(head["quantities"]), tuple(head["keep"]))
    return pack(compute(_study(in_order(head["data"])), task, head["threads"] or _own_threads()))


def _own_threads() -> int:
    """Threads of the Dask worker that runs this; one where there is none."""
    from tmodes.study.extra import needed

    try:
        return needed("distributed", "cluster").get_worker().state.nthreads
    except ValueError:
        return 1


@lru_cache(maxsize=4)
def _study(data: bytes) -> Study:
    return Study.from_data(json.loads(data))
