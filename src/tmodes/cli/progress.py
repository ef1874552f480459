"""Long work: Ctrl-C as a wish that is obeyed where all results are whole, and progress after two seconds."""

from __future__ import annotations

import signal
import sys
import time as clock
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType, TracebackType
from typing import Any, Self

__all__ = ["Stages", "Wish", "heard", "working"]


class Wish:
    """Whether Ctrl-C was pressed. Python raises its KeyboardInterrupt anywhere, even where it is lost."""

    def __init__(self) -> None:
        self.made = False

    def obey(self) -> None:
        """Raise KeyboardInterrupt where the wish was made."""
        if self.made:
            self.made = False
            raise KeyboardInterrupt

    def _note(self, number: int, frame: FrameType | None) -> None:
        del number, frame
        if self.made:  # pressed again: at once
            raise KeyboardInterrupt
        self.made = True


@contextmanager
def heard() -> Iterator[Wish]:
    """Within the block the first Ctrl-C is a wish; the second one interrupts at once. Ignored signals stay so."""
    wish = Wish()
    before = signal.getsignal(signal.SIGINT)
    if before is not signal.default_int_handler:
        yield wish
        return
    signal.signal(signal.SIGINT, wish._note)
    try:
        yield wish
    finally:
        signal.signal(signal.SIGINT, before)


PATIENCE = 1.5
"""Seconds of silence before progress is shown."""

LINE_EVERY = 10.0
"""Seconds between lines where there is no terminal."""


class Stages:
    """``with Stages(wish) as tell: tell("reference", 0.3)``; nothing is shown for short work."""

    def __init__(self, wish: Wish) -> None:
        self._wish = wish
        self._started = clock.monotonic()
        self._last_line = self._started - LINE_EVERY
        self._bar: Any = None
        self._tasks: dict[str, Any] = {}

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bar:
            self._bar.stop()

    def __call__(self, stage: str, share: float) -> None:
        """Tell that a share of a stage is done; here Ctrl-C is obeyed."""
        self._wish.obey()
        now = clock.monotonic()
        if now - self._started < PATIENCE:
            return
        if sys.stderr.isatty():
            self._draw(stage, share)
        elif now - self._last_line >= LINE_EVERY:
            self._last_line = now
            print(f"{stage}: {share:.0%} after {now - self._started:.0f} s", file=sys.stderr, flush=True)

    def _draw(self, stage: str, share: float) -> None:
        if self._bar is None:
            from rich.console import Console
            from rich.progress import Progress

            self._bar = Progress(console=Console(stderr=True), transient=True)
            self._bar.start()
        if stage not in self._tasks:
            self._tasks[stage] = self._bar.add_task(stage, total=1.0)
        self._bar.update(self._tasks[stage], completed=share)


@contextmanager
def working() -> Iterator[Stages]:
    """Within the block Ctrl-C is a wish, and what is called with a stage and its share shows the progress."""
    with heard() as wish, Stages(wish) as tell:
        yield tell
