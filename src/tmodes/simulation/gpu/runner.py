"""A GPU that runs the works of a batch: it is opened once, and keeps the code that it was given."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import ClassVar

from tmodes.compile.gpu.cuda import Device
from tmodes.simulation.batch.runner import Runner
from tmodes.simulation.batch.work import Work
from tmodes.simulation.gpu.block import suits_gpu
from tmodes.simulation.gpu.run import run_on_gpu
from tmodes.simulation.parts import Trajectory

__all__ = ["OnDevice"]


@dataclass
class OnDevice(Runner):
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

    def run(self, works: Sequence[Work], threads: int, progress: Callable[[float], None]) -> dict[int, Trajectory]:
        """One case per thread of the device."""
        for work in works:
            if suits_gpu(work.settings.method):
                self.there += work.inputs.size
            else:
                self.elsewhere += work.inputs.size
        return run_on_gpu(works, progress, threads=threads, device=self.device)
