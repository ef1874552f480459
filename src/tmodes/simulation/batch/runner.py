"""What runs the works of a batch: this machine's processor, or another device that gives the same answer."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from typing import ClassVar

from tmodes.simulation.batch.simulate import run_all
from tmodes.simulation.batch.work import Work
from tmodes.simulation.parts import Trajectory

__all__ = ["PROCESSOR", "Processor", "Runner"]


class Runner(ABC):
    """How works are run, and how many cases of a study are given to it at once."""

    longest: ClassVar[int] = 8192
    """Cases of the longest part."""

    room: ClassVar[int] = 128_000_000
    """Bytes of what cases are compared with, or of the series that percentiles are of, of one part."""

    @abstractmethod
    def run(self, works: Sequence[Work], threads: int, progress: Callable[[float], None]) -> dict[int, Trajectory]:
        """All cases of all works, each with its place, as :func:`tmodes.simulation.batch.simulate.run_all`."""


class Processor(Runner):
    """Threads of this machine."""

    def run(self, works: Sequence[Work], threads: int, progress: Callable[[float], None]) -> dict[int, Trajectory]:
        """Spans of lanes over the threads."""
        return run_all(works, threads, progress)


PROCESSOR = Processor()
