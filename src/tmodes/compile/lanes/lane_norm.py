"""The norm of motions in lanes, with few divisions: they take longest there."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmodes.compile.ir.emit import counted, whole
from tmodes.compile.loops.frame import MotionNorm

__all__ = ["LaneNorm"]


class LaneNorm(MotionNorm):
    """The same norm to rounding."""

    def _add_pairs(self, error: Callable[[Any], Any], one: str, before: str, h: Any) -> None:
        b = self.b
        often = b.fdiv(self.loop.constant(1.0), h)
        with counted(b, self.pairs, "pair") as i:
            paired = b.add(i, whole(self.pairs))
            scale = self._scale(self._size(i, one, before))
            own = self._scale(self._size(paired, one, before))
            self._add(b.fdiv(error(i), scale))
            self._add(b.fdiv(error(paired), self.loop.intrinsic("maxnum", b.fmul(scale, often), own)))
