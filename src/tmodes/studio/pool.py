"""The workers: processes that simulate, each one job at a time, ended and replaced where they do not obey."""

from __future__ import annotations

import asyncio
import json
import os
import signal
import sys
import tempfile
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

from tmodes.kinds.outside import USED
from tmodes.studio.folders import remove

__all__ = ["Pool", "WorkerLost"]

PATIENCE = 0.5
"""Seconds in which a worker may end a cancelled job by itself."""

FAREWELL = 2.0
LONGEST_LINE = 2**24
COMMAND = (sys.executable, "-P", "-m", "tmodes.studio.worker")

ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}
"""Matrices of robots are small: threads for them only wait for each other, and there are several workers."""

Listener = Callable[[str, float], None]


class WorkerLost(Exception):
    """The process that worked on a job is no more."""


class _Worker:
    """One process with a folder for what it writes; ``last`` is what it did last and for whom: it is warm for that."""

    def __init__(self, process: asyncio.subprocess.Process, room: Path) -> None:
        self.process = process
        self.room = room
        self.last = ""
        self._doomed = False

    @classmethod
    async def started(cls, place: Path) -> _Worker:
        pipe = asyncio.subprocess.PIPE
        room = Path(tempfile.mkdtemp(prefix="worker-", dir=place))
        return cls(
            await asyncio.create_subprocess_exec(
                *COMMAND,
                *USED,
                stdin=pipe,
                stdout=pipe,
                limit=LONGEST_LINE,
                start_new_session=os.name != "nt",
                env=os.environ | ONE_THREAD | dict.fromkeys(("TMPDIR", "TEMP", "TMP"), str(room)),
            ),
            room,
        )

    @property
    def alive(self) -> bool:
        return self.process.returncode is None and not self._doomed

    def tell(self, order: dict[str, Any]) -> None:
        if self.process.stdin:
            self.process.stdin.write(json.dumps(order).encode() + b"\n")

    async def answers(self) -> tuple[dict[str, Any], bytes]:
        """The next head and its bytes."""
        stream = self.process.stdout
        if stream is None:
            raise WorkerLost
        try:
            head = json.loads(await stream.readline())
            return head, await stream.readexactly(head["bytes"])
        except (ValueError, asyncio.IncompleteReadError):
            raise WorkerLost from None

    async def end(self) -> None:
        """Let the orders end, upon which the process does; kill it where it does not."""
        if self.process.stdin:
            with suppress(OSError):
                self.process.stdin.close()
        with suppress(TimeoutError):
            await asyncio.wait_for(self.process.wait(), FAREWELL)
        await self.kill()

    async def kill(self) -> None:
        if self.alive:
            self._doomed = True
            with suppress(ProcessLookupError):
                # Popen.kill would also reap the process, which the loop waits for.
                os.kill(self.process.pid, signal.SIGKILL) if os.name != "nt" else self.process.kill()
        await self.process.wait()
        remove(self.room)  # a process that is killed leaves what it was writing


class Pool:
    """``size`` workers; a job waits until one is free, the one that last did the same for the same client if it is.

    So the curves that somebody drags stay with one worker, and longer work, such as a report, continues next to them.
    What workers write meanwhile lies in ``place``, which its owner removes. A pool that was not started starts each
    worker when a job needs it.
    """

    def __init__(self, size: int, place: Path) -> None:
        self._place = place
        self._free: list[_Worker | None] = [None] * size
        self._all: set[_Worker] = set()
        self._room = asyncio.Condition()
        self._numbers = 0
        self._stopped = False

    async def start(self) -> None:
        """Start the workers."""
        self._free = [await self._living(None) for _ in self._free]

    async def stop(self) -> None:
        """End all workers; jobs that still run are lost."""
        self._stopped = True
        await asyncio.gather(*(worker.end() for worker in self._all))
        self._all.clear()

    async def run(
        self, order: dict[str, Any], client: str, listen: Listener, cancelled: asyncio.Event
    ) -> tuple[dict[str, Any], bytes]:
        """Do one job: the last head of its worker (``kind`` done, error or cancelled) and its bytes."""
        worker = await self._borrowed(f"{client} {order['product'] in ('curves', 'change')}")
        self._numbers += 1
        number = self._numbers
        waiting = asyncio.create_task(_until_cancelled(worker, number, cancelled))
        try:
            if cancelled.is_set():
                return {"kind": "cancelled"}, b""
            worker.tell({"job": number, **order})
            while True:
                head, content = await worker.answers()
                if head["job"] == number and head["kind"] != "progress":
                    return head, content
                listen(head.get("stage", ""), head.get("share", 0.0))
        except WorkerLost:
            await worker.kill()
            if cancelled.is_set():
                return {"kind": "cancelled"}, b""
            raise
        finally:
            waiting.cancel()
            await self._give_back(worker)

    async def _borrowed(self, work: str) -> _Worker:
        async with self._room:
            await self._room.wait_for(lambda: self._free)
            idle = min(self._free, key=lambda worker: worker is None)  # rather one that runs than a new one
            known = next((worker for worker in self._free if worker and worker.last == work), idle)
            self._free.remove(known)
        try:
            living = await self._living(known)
        except OSError:
            await self._free_again(known)
            raise
        living.last = work
        return living

    async def _give_back(self, worker: _Worker) -> None:
        if self._stopped:
            return
        with suppress(OSError):  # the next job tries again, and reports
            worker = await self._living(worker)
        await self._free_again(worker)

    async def _living(self, worker: _Worker | None) -> _Worker:
        """The worker, or a new one for one that is dead or none; :class:`OSError` where none can be started."""
        if worker and worker.alive:
            return worker
        if worker:
            await worker.kill()
        living = await _Worker.started(self._place)
        self._all -= {worker}
        self._all.add(living)
        return living

    async def _free_again(self, worker: _Worker | None) -> None:
        async with self._room:
            self._free.append(worker)
            self._room.notify()


async def _until_cancelled(worker: _Worker, number: int, cancelled: asyncio.Event) -> None:
    """Ask the worker to end a job that is not wanted any more; a worker that does not hear is ended."""
    await cancelled.wait()
    worker.tell({"cancel": number})
    await asyncio.sleep(PATIENCE)
    await worker.kill()
