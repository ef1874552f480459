"""Works of a batch on a GPU, one case per thread: blocks that fit its memory, in launches that are short.

No bit of a case depends on its neighbours, on the blocks, or on how its steps are parted into launches.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import ClassVar

from tmodes.compile.gpu.case_loop import CaseLoop
from tmodes.compile.gpu.cuda import Device
from tmodes.errors import SimulationError
from tmodes.simulation.batch.executor import PROCESSOR, Executor, Progress
from tmodes.simulation.case_results import CaseResults
from tmodes.simulation.gpu.block import DeviceBlock, bytes_per_case, loop_of, suits_gpu
from tmodes.simulation.native_run import pieces
from tmodes.simulation.problem import Problem

__all__ = ["OnDevice", "block_size", "run_on_gpu"]

_FIRST = 100
"""Steps of the first launch."""

_SHARE = 0.9
"""Of the memory that is free."""


def run_on_gpu(
    works: Sequence[Problem],
    results: CaseResults,
    progress: Callable[[float], None] = lambda share: None,
    *,
    threads: int | None = None,
    device: Device | None = None,
    clock: Callable[[], float] = time.monotonic,
) -> None:
    """Run all cases of all works on a GPU, as :meth:`tmodes.simulation.batch.executor.Executor.run`.

    The samples go to ``states`` of the works, or what is ``wanted`` in place of them to its arrays; a run that cannot
    continue keeps what it had, and says why. ``threads``: of the processor, for works whose method does not suit a GPU
    (:func:`suits_gpu`); None: these run on it, too. ``device``: by default the first GPU. ``clock`` [s]: by which
    launches are kept short.

    Raises :class:`tmodes.errors.SimulationError` where there is no GPU, or not the memory for one case, and
    :class:`tmodes.errors.CompileError` for code that LLVM refuses.
    """
    device = _first_gpu() if device is None else device
    left = [work for work in works if threads is not None and not suits_gpu(work.settings.method)]
    whole, reached, stopped = sum(work.time for work in works), 0.0, False

    def tell(time: float) -> None:
        progress((reached + time) / whole)

    def run(work: Problem) -> None:
        nonlocal reached, stopped
        loop = loop_of(work)
        size = block_size(work, loop, device)
        for first in range(0, work.size, size):
            block, began = DeviceBlock(work, loop, range(first, min(first + size, work.size))), clock()
            stopped = stopped or _run(block, device, clock, tell)
            reached += float(block.cell("t").sum())
            block.ended(results, clock() - began)

    for work in works:
        if work not in left:
            run(work)
    if left and threads is not None and not stopped:
        PROCESSOR.run(left, results, threads, lambda share: tell(share * sum(work.time for work in left)))
        return
    for work in left:
        run(work)
    if stopped and "interrupted" not in results.status.tolist():
        raise KeyboardInterrupt  # all ended first: what comes next must not begin


def _first_gpu() -> Device:
    from tmodes.compile.gpu.cuda import first_gpu

    return first_gpu()


def block_size(work: Problem, loop: CaseLoop, device: Device) -> int:
    """Cases of a work that are on a device at once."""
    free, each = device.free(loop), bytes_per_case(work, loop)
    count = int(_SHARE * free) // each
    if not count:
        raise SimulationError(
            f"{device.name} has {free / 1e6:.3g} MB free, and one case takes {each / 1e6:.3g} MB; lengthen "
            "integration.output_step, or end other programs that use the GPU"
        )
    return min(count, work.size)


def _run(block: DeviceBlock, device: Device, clock: Callable[[], float], reached: Callable[[float], None]) -> bool:
    """Run a block to its end, to its limit on time, or until Ctrl-C: whether that came."""
    stopped = False
    try:
        try:
            block.begin(device)
            for piece in pieces(block.work.settings.max_wall_time, clock, _FIRST):
                if not len(block.going):
                    break
                block.advance(piece)
                reached(float(block.cell("t").sum()))
        except KeyboardInterrupt:
            stopped = True
        block.end()
    finally:
        block.release()
    return stopped


@dataclass
class OnDevice(Executor):
    """Cases whose method suits a GPU run on a device, the others on the threads of the processor.

    ``there``, ``elsewhere``: how many cases have run on the device, and on the processor.
    """

    device: Device
    there: int = 0
    elsewhere: int = 0

    longest: ClassVar[int] = 1 << 18
    """Enough to fill the largest GPUs several times over."""

    room: ClassVar[int] = 1_000_000_000
    """As much on the device: 40,000 tips of 1,000 samples."""

    def run(self, problems: Sequence[Problem], results: CaseResults, threads: int, progress: Progress) -> None:
        """One case per thread of the device."""
        for work in problems:
            if suits_gpu(work.settings.method):
                self.there += work.size
            else:
                self.elsewhere += work.size
        run_on_gpu(problems, results, progress, threads=threads, device=self.device)
