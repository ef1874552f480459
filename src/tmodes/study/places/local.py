"""The machine at hand: one block after another, each over all cores."""

from __future__ import annotations

from typing import Self

from tmodes.errors import InputError
from tmodes.study.places.contract import PLACES, How, Job, Place

__all__ = ["Local"]


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

    def run(self, job: Job) -> None:
        """Block by block."""
        while task := job.next():
            job.done(task, job.compute(task))
