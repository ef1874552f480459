"""The machine at hand: the cases of a block over all cores, while the next block is prepared."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from dataclasses import dataclass, field
from threading import Lock
from typing import TYPE_CHECKING, Self

from tmodes.errors import InputError
from tmodes.simulation.batch.executor import Processor, Progress, thread_count
from tmodes.simulation.case_results import CaseResults
from tmodes.simulation.problem import Problem
from tmodes.study.places.contract import PLACES, How, Place, PlaceJob, Task

if TYPE_CHECKING:
    from tmodes.simulation.gpu.run import OnDevice

__all__ = ["Gpu", "Local"]

_GLANCE = 0.1
"""Seconds after which who waits for the cores hears Ctrl-C."""


@PLACES.register
class Local(Place):
    """The cases of a block share the cores: threads of the native loops, processes where results are asked for."""

    name = "local"

    @classmethod
    def at(cls, address: str, how: How) -> Self:
        """It has no address."""
        del how
        if address:
            raise InputError("--on", f"local://{address}", "local without an address", "write --on local")
        return cls()

    def run(self, job: PlaceJob) -> None:
        """Block by block, the first by itself: it compiles what all need."""
        first = job.next()
        if first is None:
            return
        job.done(first, job.compute(first))
        if thread_count(job.threads) > 1 and job.study.needs.reductions:
            _ahead(job)
            return
        while task := job.next():
            job.done(task, job.compute(task))


def _ahead(job: PlaceJob) -> None:
    """Two blocks at once: one is prepared, on one core, while the cases of the other keep all of them busy."""
    turns, pending = _InTurn(), dict[Future[bytes], Task]()
    try:
        with ThreadPoolExecutor(2, "tmodes-blocks") as pool, _ending(job):
            while True:
                while len(pending) < 2 and (task := job.next()):
                    pending[pool.submit(job.compute, task, turns)] = task
                if not pending:
                    return
                for future in wait(pending, return_when=FIRST_COMPLETED).done:
                    job.done(pending.pop(future), future.result())
    finally:  # what was finished when another block failed is kept
        for future, task in pending.items():
            if future.exception() is None:
                job.done(task, future.result())


@contextmanager
def _ending(job: PlaceJob) -> Iterator[None]:
    """What is raised within ends the blocks that are being computed."""
    try:
        yield
    except BaseException:
        job.end()
        raise


class _InTurn(Processor):
    """The cores belong to one block at a time."""

    def __init__(self) -> None:
        self._free = Lock()

    def run(self, problems: Sequence[Problem], results: CaseResults, threads: int, progress: Progress) -> None:
        """As the processor does, once it is free."""
        while not self._free.acquire(timeout=_GLANCE):
            progress(0.0)
        try:
            super().run(problems, results, threads, progress)
        finally:
            self._free.release()


@PLACES.register
@dataclass(frozen=True)
class Gpu(Place):
    """Block by block as on the machine at hand; series are made and reduced where the cases run."""

    executor: OnDevice = field(repr=False)

    name = "gpu"

    @classmethod
    def at(cls, address: str, how: How) -> Self:
        """The first GPU; raises :class:`tmodes.errors.SimulationError`, with the reason, where none can be used."""
        from tmodes.compile.gpu import cuda
        from tmodes.simulation.gpu.run import OnDevice

        del how
        if address:
            hint = "write --on gpu; CUDA_VISIBLE_DEVICES says which one is the first"
            raise InputError("--on", f"gpu://{address}"[:80], "gpu without an address", hint)
        return cls(OnDevice(cuda.first_gpu()))

    def run(self, job: PlaceJob) -> None:
        """Block by block; what did not run on the GPU is reported."""
        computed = 0
        while task := job.next():
            job.done(task, job.compute(task, self.executor))
            computed += len(task.values)
        there, elsewhere = self.executor.there, self.executor.elsewhere
        if elsewhere:
            whole = f"{elsewhere:,} of {there + elsewhere:,} runs"
            job.notice(f"{whole} were on the processor: their method does not suit a GPU")
        elif computed and not there:
            job.notice("nothing ran on the GPU: only series are reduced there, of runs that no condition may stop")
