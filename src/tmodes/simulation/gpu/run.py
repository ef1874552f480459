"""Works of a batch on a GPU, one case per thread: blocks that fit its memory, in launches that are short.

No bit of a case depends on its neighbours, on the blocks, or on how its steps are parted into launches.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence

from tmodes.compile.gpu.case_loop import CaseLoop
from tmodes.compile.gpu.cuda import Device
from tmodes.errors import SimulationError
from tmodes.simulation.batch.simulate import run_all
from tmodes.simulation.batch.work import Work
from tmodes.simulation.gpu.block import Block, bytes_per_case, loop_of, suits_gpu
from tmodes.simulation.parts import Trajectory

__all__ = ["block_size", "run_on_gpu"]

_FIRST, _SECONDS = 100, 0.05
"""Steps of the first launch, and how long a launch is to take [s]: so long a wish to stop waits."""

_SHARE = 0.9
"""Of the memory that is free."""


def run_on_gpu(
    works: Sequence[Work],
    progress: Callable[[float], None] = lambda share: None,
    *,
    threads: int | None = None,
    device: Device | None = None,
    clock: Callable[[], float] = time.monotonic,
) -> dict[int, Trajectory]:
    """Run all cases of all works on a GPU, each with its place, as :func:`tmodes.simulation.batch.simulate.run_all`.

    The samples go to ``states`` of the works, or what is ``wanted`` in place of them to its arrays; a run that cannot
    continue keeps what it had, and says why. ``threads``: of the processor, for works whose method does not suit a GPU
    (:func:`suits_gpu`); None: these run on it, too. ``progress`` is given the share of all cases' time that is done;
    what it raises stops the batch. Ctrl-C ends all with what they have (``interrupted``). ``device``: by default the
    first GPU. ``clock`` [s]: by which launches are kept short.

    Raises :class:`tmodes.errors.SimulationError` where there is no GPU, or not the memory for one case, and
    :class:`tmodes.errors.CompileError` for code that LLVM refuses.
    """
    batch = _Batch(_first_gpu() if device is None else device, clock, progress, sum(map(_duration, works)))
    left = [work for work in works if threads is not None and not suits_gpu(work.settings.method)]
    for work in works:
        if not any(work is other for other in left):
            batch.run(work)
    if left and threads is not None and not batch.stopped:
        batch.done |= run_all(left, threads, lambda share: batch.tell(share * sum(map(_duration, left))))
        return batch.done
    for work in left:
        batch.run(work)
    if batch.stopped and not any(one.status == "interrupted" for one in batch.done.values()):
        raise KeyboardInterrupt  # all ended first: what comes next must not begin
    return batch.done


def _duration(work: Work) -> float:
    """The time of all cases of a work [s]."""
    return work.inputs.size * work.settings.duration


class _Batch:
    """Works that go through a device one after the other; after Ctrl-C they end as they stand."""

    def __init__(
        self, device: Device, clock: Callable[[], float], progress: Callable[[float], None], whole: float
    ) -> None:
        """``whole``: the time of all cases [s]."""
        self.device, self.clock, self.progress, self.whole = device, clock, progress, whole
        self.done: dict[int, Trajectory] = {}
        self.reached, self.stopped = 0.0, False

    def tell(self, time: float) -> None:
        """So much more of the cases' time is done [s]."""
        self.progress((self.reached + time) / self.whole)

    def run(self, work: Work) -> None:
        """Run all cases of a work, block after block."""
        loop, first = loop_of(work), 0
        size = block_size(work, loop, self.device)
        while first < work.inputs.size:
            block, began = Block(work, loop, range(first, min(first + size, work.inputs.size))), self.clock()
            if not self.stopped:
                self.stopped = _run(block, self.device, self.clock, self.tell)
            self.reached += float(block.cell("t").sum())
            self.done |= zip(block.places.tolist(), block.ended(self.clock() - began), strict=True)
            first += size


def _first_gpu() -> Device:
    from tmodes.compile.gpu.cuda import first_gpu

    return first_gpu()


def block_size(work: Work, loop: CaseLoop, device: Device) -> int:
    """Cases of a work that are on a device at once."""
    free, each = device.free(loop), bytes_per_case(work, loop)
    count = int(_SHARE * free) // each
    if not count:
        raise SimulationError(
            f"{device.name} has {free / 1e6:.3g} MB free, and one case takes {each / 1e6:.3g} MB; lengthen "
            "integration.output_step, or end other programs that use the GPU"
        )
    return min(count, work.inputs.size)


def _run(block: Block, device: Device, clock: Callable[[], float], reached: Callable[[float], None]) -> bool:
    """Run a block to its end, to its limit on time, or until Ctrl-C: whether that came."""
    piece, began, limit, stopped = _FIRST, clock(), block.work.settings.max_wall_time, False
    try:
        try:
            block.begin(device)
            while len(block.going) and clock() - began < limit:
                started = clock()
                block.advance(piece)
                piece = max(1, int(piece * min(4.0, _SECONDS / max(clock() - started, 1e-6))))
                reached(float(block.cell("t").sum()))
        except KeyboardInterrupt:
            stopped = True
        block.end()
    finally:
        block.release()
    return stopped
