"""Where a study runs: a place takes blocks of cases from a job, has them computed, and gives them back.

A place of a user's own is a class with the word by which ``--on`` knows it, and two methods::

    @PLACES.register
    class Nightly(Place):
        name = "nightly"

        @classmethod
        def at(cls, address: str, how: How) -> Nightly:
            return cls()

        def run(self, job: Job) -> None:
            while task := job.next():
                job.done(task, my_queue(job.order(task)))   # somewhere: tmodes.study.tasks.compute_block(order)
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import ClassVar, Protocol, Self

from tmodes.errors import InputError
from tmodes.kinds.registry import Registry
from tmodes.simulation.batch.executor import PROCESSOR, Executor
from tmodes.study.study import Study
from tmodes.study.tasks import Task

__all__ = ["PLACES", "How", "Place", "PlaceJob", "Task", "place_of"]


class PlaceJob(Protocol):
    """What is to be computed, as places see it; ``notice`` is given sentences for the user."""

    study: Study
    threads: int | None
    notice: Callable[[str], None]

    def next(self, workers: int = 1) -> Task | None:
        """The next task, of a size for so many that work at once; None when none is left."""
        ...

    def again(self, task: Task) -> None:
        """Put back a task that was lost."""
        ...

    def order(self, task: Task, threads: int | None = None) -> bytes:
        """The task with the study as plain data, for another process or machine."""
        ...

    def compute(self, task: Task, executor: Executor = PROCESSOR) -> bytes:
        """Compute a task here, its cases by an executor; its block as bytes. Threads may compute several at once."""
        ...

    def end(self) -> None:
        """Interrupt what other threads compute: KeyboardInterrupt is raised there."""
        ...

    def done(self, task: Task, block: bytes) -> None:
        """Verify and store the block of a task. Raises ResultFileError for bytes that are not its block."""
        ...

    def report(self) -> None:
        """Report progress; raises KeyboardInterrupt at Ctrl-C."""
        ...


@dataclass(frozen=True)
class How:
    """How a place is used: ``threads`` of each worker; ``insecure``: without TLS to other machines; ``tls``: folder of
    certificates (``ca.pem``, ``cert.pem``, ``key.pem``); ``resources``: what a queue is asked for.
    """  # noqa: D205 - one sentence

    threads: int | None = None
    insecure: bool = False
    tls: Path | None = None
    resources: Mapping[str, str] = field(default_factory=dict)


class Place(ABC):
    """Where blocks are computed."""

    name: ClassVar[str] = ""
    """What stands before ``://`` in ``--on``, or is all of it."""

    also: ClassVar[tuple[str, ...]] = ()
    """Other words for it."""

    @classmethod
    @abstractmethod
    def at(cls, address: str, how: How) -> Self:
        """The place at an address, checked before anything runs.

        Raises :class:`tmodes.errors.InputError`, and :class:`tmodes.errors.SimulationError` where this machine has no
        such device.
        """

    def refuse(self) -> None:
        """Raise :class:`tmodes.errors.InputError` where it does not answer: asked before a folder is touched."""
        return

    @abstractmethod
    def run(self, job: PlaceJob) -> None:
        """Compute all tasks of the job. What it raises leaves the blocks that are done where they are."""


PLACES: Registry[type[Place]] = Registry("place", Place, names=lambda member: (member.name, *member.also))
"""Those of tmodes, and what a user registers: ``@PLACES.register``."""


def place_of(on: str, how: How) -> Place:
    """The place that ``on`` names: ``local``, ``dask://HOST:PORT``, ``dask+tls://HOST:PORT``, ``slurm``, ``gpu``."""
    word, _, address = on.partition("://")
    if word not in PLACES:
        hint = "write --on local, --on dask://HOST:PORT, --on slurm or --on gpu"
        raise InputError("--on", ascii(on)[:80], f"one of {', '.join(PLACES.names)}", hint)
    return PLACES[word].at(address, how)
