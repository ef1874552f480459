"""An NVIDIA GPU of this machine: the first one, one case per thread; what does not suit it runs on the processor."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Self

from tmodes.errors import InputError
from tmodes.study.places.contract import PLACES, How, Job, Place

if TYPE_CHECKING:
    from tmodes.simulation.gpu.runner import OnDevice

__all__ = ["Gpu"]


@PLACES.register
@dataclass(frozen=True)
class Gpu(Place):
    """Block by block as on the machine at hand; series are made and reduced where the cases run."""

    runner: OnDevice = field(repr=False)

    name = "gpu"

    @classmethod
    def at(cls, address: str, how: How) -> Self:
        """The first GPU; raises :class:`tmodes.errors.SimulationError`, with the reason, where none can be used."""
        from tmodes.compile.gpu import cuda
        from tmodes.simulation.gpu.runner import OnDevice

        del how
        if address:
            hint = "write --on gpu; CUDA_VISIBLE_DEVICES says which one is the first"
            raise InputError("--on", f"gpu://{address}"[:80], "gpu without an address", hint)
        return cls(OnDevice(cuda.first_gpu()))

    def run(self, job: Job) -> None:
        """Block by block; what did not run on the GPU is reported."""
        computed = 0
        while task := job.next():
            job.done(task, job.compute(task, self.runner))
            computed += len(task.values)
        there, elsewhere = self.runner.there, self.runner.elsewhere
        if elsewhere:
            whole = f"{elsewhere:,} of {there + elsewhere:,} runs"
            job.notice(f"{whole} were on the processor: their method does not suit a GPU")
        elif computed and not there:
            job.notice("nothing ran on the GPU: only series are reduced there, of runs that no condition may stop")
