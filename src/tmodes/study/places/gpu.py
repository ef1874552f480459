"""An NVIDIA GPU of this machine."""

from __future__ import annotations

from typing import Self

from tmodes.study.places.contract import PLACES, How, Job, Place

__all__ = ["Gpu"]


@PLACES.register
class Gpu(Place):
    """One case per thread of the GPU."""

    name = "gpu"

    @classmethod
    def at(cls, address: str, how: How) -> Self:
        """Checked."""
        return cls()

    def run(self, job: Job) -> None:
        """Block by block."""
