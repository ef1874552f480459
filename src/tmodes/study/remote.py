"""A task as bytes, and its block from them: what a worker in another process or on another machine is asked.

An order is plain data: the study's sheet, the names of the quantities, and the numbers of the cases. Nothing in it is
code; a worker builds the study from the data, as from a file.
"""

from __future__ import annotations

import json
import time as clock
from collections.abc import Callable
from functools import lru_cache
from threading import Lock

import numpy as np

from tmodes.errors import InputError, SimulationError
from tmodes.simulation.batch.runner import PROCESSOR, Runner
from tmodes.study.addresses import base_of, engine_of_blocks, in_order, restricted
from tmodes.study.blocks import Block, label_of, pack
from tmodes.study.study import Study
from tmodes.study.task import Task

__all__ = ["compute", "compute_block", "order"]

Progress = Callable[[str, float], None]


def compute(
    study: Study, task: Task, threads: int | None = None, progress: Progress = lambda stage, share: None,
    runner: Runner = PROCESSOR,
) -> Block:  # fmt: skip
    """Compute the cases of a task; raises KeyboardInterrupt where it was interrupted, so that no half is stored."""
    part = restricted(study, task.quantities)
    began = clock.perf_counter()
    rows = part.evaluate(task.first, task.values, progress, threads=threads, runner=runner)
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
