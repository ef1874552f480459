"""An NVIDIA GPU of this machine, through :mod:`tmodes.simulation.gpu`: one case per thread."""

from __future__ import annotations

from typing import Self

from tmodes.errors import InputError
from tmodes.study.places.contract import PLACES, How, Job, Place

__all__ = ["Gpu"]


@PLACES.register
class Gpu(Place):
    """One case per thread of the GPU."""

    name = "gpu"

    @classmethod
    def at(cls, address: str, how: How) -> Self:
        """The first GPU."""
        raise InputError(
            "--on", "gpu", "local, dask or slurm: this version of tmodes has no loop for GPUs", "use local"
        )

    def run(self, job: Job) -> None:
        """Block by block."""
        while task := job.next():
            job.done(task, job.compute(task))
