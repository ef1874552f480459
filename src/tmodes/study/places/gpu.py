"""An NVIDIA GPU of this machine: refused, until the cases of a study are reduced there."""

from __future__ import annotations

from typing import Self

from tmodes.errors import InputError
from tmodes.study.places.contract import PLACES, How, Job, Place

__all__ = ["Gpu"]


@PLACES.register
class Gpu(Place):
    """Known by name, so that it is refused with a sentence."""

    name = "gpu"

    @classmethod
    def at(cls, address: str, how: How) -> Self:
        """Always refused."""
        del address, how
        hint = "write --on local, which takes all cores"
        raise InputError("--on", "gpu, on which this version of tmodes runs no studies", "local, dask or slurm", hint)

    def run(self, job: Job) -> None:
        """Never reached: there is no such place."""
        raise NotImplementedError
