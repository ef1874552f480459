"""How many cases a block has: by the sheet, or so many that it takes some seconds."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["LEAST", "Pace"]

LEAST, MOST = 64, 1 << 18
"""Cases of a block that is chosen here."""

BYTES = 1 << 26
"""Bytes of a block, which is in memory some times, and once more while the next is prepared."""

SECONDS, LONGEST = 3.0, 30.0
"""What the cases of a block are to take, and at most, where preparing it takes long."""

OVERHEAD = 6.0
"""Cases of a block take at least so many times longer than preparing it."""

GROWTH = 32
"""A block has at most so many times more cases than the one before: its time may be that of the first compilation."""


@dataclass
class Pace:
    """``fixed``: cases of a block by the sheet; ``heavy``: bytes of a case, at least, which bound a block in memory."""

    fixed: int | None = None
    heavy: int = 0
    _size: int = LEAST

    @property
    def _most(self) -> int:
        """Cases of a block of at most so many bytes."""
        return max(1, min(MOST, BYTES // max(self.heavy, 1)))

    def size(self, left: int, workers: int = 1) -> int:
        """Cases of the next block, when ``left`` remain for so many workers: at the end all have something to do."""
        if self.fixed:
            return min(left, self.fixed)
        fair = max(LEAST, -(-left // (2 * workers))) if workers > 1 else left
        return min(left, fair, self._size, self._most)

    def took(self, cases: int, wall: float, work: float, threads: int = 1, heavy: int = 0) -> None:
        """A block of so many cases took ``wall`` seconds; its cases alone ``work`` seconds of some ``threads``.

        ``heavy``: bytes of one of its cases.
        """
        self.heavy = max(self.heavy, heavy)
        if cases < min(self._size, LEAST):  # the rest of a gap says little
            return
        computing = min(wall, work / threads) or wall
        target = min(LONGEST, max(SECONDS, OVERHEAD * (wall - computing)))
        wanted = min(cases * target / max(computing, 1e-6), GROWTH * cases, MOST)
        self._size = max(LEAST, int(wanted) // LEAST * LEAST)
