"""A process that simulates for the studio: orders come in as lines of JSON, answers go out as a line and bytes.

In:  ``{"job": 7, "product": "page", "sheet": {...}, "looks": null, "series": []}`` or ``{"cancel": 7}``
Out: ``{"job": 7, "kind": "progress", "stage": "actual robot", "share": 0.3, "bytes": 0}``, then one of ``done``,
``error`` and ``cancelled``, each followed by as many bytes as it reports.

When the orders end, because the server closed them or is no more, the process ends too, whatever it does.
"""

from __future__ import annotations

import json
import os
import queue
import signal
import sys
import threading
import time as clock
from typing import Any, BinaryIO

from tmodes.errors import TmodesError
from tmodes.studio.messages import error_record, error_records

__all__ = ["main"]

PROGRESS_EVERY = 0.05
"""Seconds between two words on progress."""


class _Cancelled(BaseException):  # no Exception: nothing on the way may take it for a failure of its own
    pass


class _Orders:
    """What is to be done, and what is no more to be done: read next to the work, so that a run can be ended."""

    def __init__(self, source: BinaryIO) -> None:
        self.waiting: queue.Queue[dict[str, Any]] = queue.Queue()
        self.cancelled: set[int] = set()
        self._source = source
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        for line in self._source:
            order = json.loads(line)
            self.cancelled.add(order["cancel"]) if "cancel" in order else self.waiting.put(order)
        os._exit(0)  # nobody is there any more


class _Answers:
    def __init__(self, sink: BinaryIO) -> None:
        self._sink = sink

    def send(self, job: int, kind: str, content: bytes = b"", **info: Any) -> None:
        head = json.dumps({"job": job, "kind": kind, **info, "bytes": len(content)})
        self._sink.write(head.encode() + b"\n" + content)
        self._sink.flush()


def main() -> None:
    """Work until the orders end; arguments are kinds of a user, which the server has loaded."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the server reports when it is over
    answers = _Answers(os.fdopen(os.dup(sys.stdout.fileno()), "wb"))
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # what a library prints is no answer
    orders = _Orders(sys.stdin.buffer)
    from tmodes.kinds.outside import use
    from tmodes.studio.work import Workshop

    if sys.argv[1:]:
        use(*sys.argv[1:])
    workshop = Workshop()
    while True:
        _work(orders.waiting.get(), workshop, orders, answers)


def _work(order: dict[str, Any], workshop: Any, orders: _Orders, answers: _Answers) -> None:
    job, sheet = order["job"], order["sheet"]
    last = [0.0]

    def progress(stage: str, share: float) -> None:
        if job in orders.cancelled:
            raise _Cancelled
        if clock.monotonic() - last[0] >= PROGRESS_EVERY:
            last[0] = clock.monotonic()
            answers.send(job, "progress", stage=stage, share=float(share))

    try:
        progress("reading", 0.0)
        answer = workshop.answer(order["product"], sheet, progress, order.get("looks"), order.get("series", ()))
        answers.send(job, "done", answer.content, info=answer.info)
    except _Cancelled:
        answers.send(job, "cancelled")
    except TmodesError as error:
        answers.send(job, "error", errors=error_records(error, sheet))
    except MemoryError:
        hint = "sample more coarsely (integration.output_step), or simulate a shorter time"
        answers.send(job, "error", errors=[error_record("", f"out of memory; {hint}", hint=hint)])
    except Exception as error:
        message = f"a fault of tmodes itself, please report it: {type(error).__name__}: {error}"
        answers.send(job, "error", errors=[error_record("", message)])
    orders.cancelled.discard(job)


if __name__ == "__main__":
    main()
