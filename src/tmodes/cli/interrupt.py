"""Ctrl-C as a wish: noted at once, obeyed where the work can stop with all its results whole."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

__all__ = ["Wish", "heard"]


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
