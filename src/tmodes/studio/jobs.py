"""The jobs of all tabs: each tab has one run at a time, and none can see or end those of another by accident."""

from __future__ import annotations

import asyncio
import secrets
import time as clock
from dataclasses import dataclass, field
from typing import Any

from tmodes.errors import InputError
from tmodes.studio.messages import error_record
from tmodes.studio.pool import Pool, WorkerLost

__all__ = ["Job", "JobBook"]

MOST_KEPT = 8
"""Jobs of which the answer is kept."""

ABANDONED = 20.0
"""Seconds after which a job that nobody asks about is ended."""

FORGOTTEN = 120.0
"""Seconds after which an answer that nobody asks for is dropped."""


@dataclass
class Job:
    """One order and how far it is: ``waiting``, ``running``, ``done``, ``error`` or ``cancelled``."""

    name: str
    client: str
    product: str
    state: str = "waiting"
    stage: str = ""
    share: float = 0.0
    info: dict[str, Any] = field(default_factory=dict)
    errors: list[dict[str, Any]] = field(default_factory=list)
    content: bytes = b""
    asked: float = field(default_factory=clock.monotonic)
    cancelled: asyncio.Event = field(default_factory=asyncio.Event)
    changed: asyncio.Event = field(default_factory=asyncio.Event)

    @property
    def over(self) -> bool:
        """True where nothing more comes."""
        return self.state in ("done", "error", "cancelled")

    def as_info(self) -> dict[str, Any]:
        """What the page gets."""
        names = ("state", "stage", "share", "info", "errors", "product")
        return {"job": self.name} | {name: getattr(self, name) for name in names}

    def heard(self, stage: str, share: float) -> None:
        """Note how far it is."""
        self.state, self.stage, self.share = "running", stage, share


class JobBook:
    """All jobs by their names, which nobody can guess."""

    def __init__(self, pool: Pool) -> None:
        self._pool = pool
        self._jobs: dict[str, Job] = {}
        self._tasks: set[asyncio.Task[None]] = set()

    def begin(self, order: dict[str, Any], client: str) -> Job:
        """Start a job; one of the same client and product that still runs is ended, one that is over is forgotten.

        ``order``: ``product``, the plain data of the ``sheet``, and ``looks``, where its shapes are.
        """
        product = order["product"]
        for other in [one for one in self._jobs.values() if (one.client, one.product) == (client, product)]:
            self._supersede(other)
        job = Job(secrets.token_urlsafe(12), client, product)
        self._jobs[job.name] = job
        self._forget_old()
        task = asyncio.create_task(self._run(job, order))
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)
        return job

    def find(self, name: str) -> Job:
        """The job of a name; raises :class:`tmodes.errors.InputError` for one that is not known any more."""
        if name not in self._jobs:
            raise InputError("job", repr(name[:40]), "a job that is kept", "simulate again")
        job = self._jobs[name]
        job.asked = clock.monotonic()
        return job

    def cancel(self, job: Job) -> None:
        """End a job that is not over; one that still waits for a worker is over at once."""
        if not job.over:
            job.cancelled.set()
        if job.state == "waiting":
            job.state = "cancelled"
            job.changed.set()

    def _supersede(self, job: Job) -> None:
        """End a job or, where it is over, forget it: its answer may be large."""
        if job.over:
            del self._jobs[job.name]
        self.cancel(job)

    async def wait(self, job: Job, seconds: float) -> None:
        """Until the job is over, at most so long."""
        try:
            await asyncio.wait_for(job.changed.wait(), seconds)
        except TimeoutError:
            job.asked = clock.monotonic()

    def end_abandoned(self) -> None:
        """End the jobs that nobody asks about, and forget their answers: their tab is closed."""
        for job in [*self._jobs.values()]:
            silent = clock.monotonic() - job.asked
            if job.over and silent > FORGOTTEN:
                del self._jobs[job.name]
            elif silent > ABANDONED:
                self.cancel(job)

    async def _run(self, job: Job, order: dict[str, Any]) -> None:
        try:
            head, job.content = await self._pool.run(order, job.client, job.heard, job.cancelled)
            job.state, job.info, job.errors = head["kind"], head.get("info", {}), head.get("errors", [])
        except WorkerLost:
            job.state = "error"
            hint = "try again; with fewer samples where the memory may have been too small"
            job.errors = [error_record("", f"the process that worked on it ended unexpectedly; {hint}", hint=hint)]
        except OSError as error:
            job.state = "error"
            job.errors = [error_record("", f"no process could be started: {error.strerror}; free some memory")]
        finally:
            job.asked = clock.monotonic()
            job.changed.set()

    def _forget_old(self) -> None:
        over = sorted((job for job in self._jobs.values() if job.over), key=lambda job: job.asked)
        old = [job.name for job in over]
        for name in old[: max(0, len(self._jobs) - MOST_KEPT)]:
            del self._jobs[name]
