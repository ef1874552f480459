"""Several figures at once: by helping processes where there are cores, else one after the other; the same bytes.

Figures are taken from a list, by this process from its begin, by helpers from its end. What a helper took and did not
give (it was killed, or the figure fails) is drawn here.
"""

from __future__ import annotations

import multiprocessing
import os
import queue
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, NamedTuple

from tmodes.kinds.outside import USED, use

__all__ = ["Draw", "drawn", "helpers_for"]

Files = dict[str, bytes]
"""The contents of a figure's files, by format."""

Draw = Callable[[Any, str], Files]
"""From a result and the name of a figure to its files."""

FIGURES_EACH = 4
"""Figures for each helper at least: to draw fewer here takes no longer than to start it."""


def helpers_for(figures: int) -> int:
    """How many processes help this one to draw so many figures: one for each further core, none for a few figures."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return min(cores - 1, figures // FIGURES_EACH)


@contextmanager
def drawn(draw: Draw, result: Any, names: Sequence[str], stored: Path | None) -> Iterator[Callable[[int], Files]]:
    """Gives a function from a place in ``names`` to the files of that figure, to be called for one after the other.

    ``draw`` is a function of a module; helpers read the result from ``stored``, without it there are none.
    """
    count = helpers_for(len(names)) if stored else 0
    if stored is None or not count:
        yield lambda place: draw(result, names[place])
        return
    context = multiprocessing.get_context("spawn")
    taken = context.Array("i", [0, len(names)])
    task = _DrawingTask(draw, type(result), stored.resolve(), tuple(names), tuple(USED))
    helpers, arrivals = [], _Arrivals()
    try:
        with _without_interrupts():
            for _ in range(count):
                ours, theirs = context.Pipe(duplex=False)
                helpers.append(context.Process(target=_help, args=(task, taken, theirs), daemon=True))
                helpers[-1].start()
                theirs.close()  # so that its end is seen here
                arrivals.follow(ours)
        yield lambda place: (None if _take_first(taken, place) else arrivals.of(place)) or draw(result, names[place])
    finally:
        for helper in helpers:
            helper.kill()  # SIGTERM may be ignored, as by the script that started the command
            helper.join()


class _DrawingTask(NamedTuple):
    """What a helper needs: how to draw, of which result, and the files of a person's own kinds."""

    draw: Draw
    kind: Any
    stored: Path
    names: tuple[str, ...]
    used: tuple[str, ...]


def _take_first(taken: Any, place: int) -> bool:
    """Take a figure for this process, if no helper has it."""
    with taken.get_lock():
        taken[0] = place + 1
        return place < taken[1]


def _take_last(taken: Any) -> int:
    """Take a figure for a helper; negative where none is left."""
    with taken.get_lock():
        if taken[0] >= taken[1]:
            return -1
        taken[1] -= 1
        return taken[1]


class _Arrivals:
    """Figures that come from helpers, read as they come, so that no helper waits."""

    def __init__(self) -> None:
        self._coming: queue.SimpleQueue[tuple[int, Files]] = queue.SimpleQueue()
        self._known: dict[int, Files] = {}
        self._open = 0

    def follow(self, pipe: Any) -> None:
        """Read from a helper until it ends."""
        self._open += 1
        threading.Thread(target=self._read, args=(pipe,), daemon=True).start()

    def _read(self, pipe: Any) -> None:
        with suppress(EOFError, OSError):
            while True:
                self._coming.put(pipe.recv())
        self._coming.put((_ENDED, {}))

    def of(self, place: int) -> Files | None:
        """The files of a figure that a helper has taken; None where it ended without them."""
        while place not in self._known and self._open:
            which, files = self._coming.get()
            if which == _ENDED:
                self._open -= 1
            else:
                self._known[which] = files
        return self._known.get(place)


_ENDED = -1


@contextmanager
def _without_interrupts() -> Iterator[None]:
    """Processes that start here do not hear Ctrl-C: it is for the one that waits for them, and ends them."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _help(task: _DrawingTask, taken: Any, pipe: Any) -> None:
    """What a helper does; what fails here is drawn again, and fails, where its error is seen."""
    with suppress(Exception):
        if task.used:
            use(*task.used)
        result = task.kind.load(task.stored)
        while (place := _take_last(taken)) >= 0:
            pipe.send((place, task.draw(result, task.names[place])))
