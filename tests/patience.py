"""What holds on a busy machine: waiting for a state instead of a time, and bounds on one's own processor time.

No other test sleeps or reads a clock (``repo/test_house.py``).
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TypeVar

__all__ = ["LONG", "WAIT", "bounded", "steady", "until", "work"]

T = TypeVar("T")

LONG = 300.0
"""Seconds after which a state is believed never to come; what holds does not depend on how long it took."""

WAIT = 1e3 * LONG
"""The same in milliseconds, as browsers count."""


def until(state: Callable[[], T], what: str = "the state") -> T:
    """The first answer that is true, asked for again and again."""
    end = time.monotonic() + LONG
    while not (found := state()):
        assert time.monotonic() < end, f"{what} did not come within {LONG:g} s"
        time.sleep(0.01)
    return found


def steady(read: Callable[[], T]) -> T:
    """What is read once it is the same twice in a row."""
    last = [read()]

    def same() -> bool:
        last.append(read())
        return last[-1] == last[-2]

    until(same, "an answer that stays")
    return last[-1]


@contextmanager
def bounded(seconds: float) -> Iterator[None]:
    """What is done in the block costs at most so much processor time of this process; others do not count."""
    start = time.process_time()
    yield
    spent = time.process_time() - start
    assert spent < seconds, f"{spent:.1f} s of processor time, at most {seconds:g} s were expected"


def work(seconds: float) -> None:
    """A piece of work that takes so long at least."""
    time.sleep(seconds)
