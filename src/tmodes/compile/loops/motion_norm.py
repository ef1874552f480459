"""How large an error of a state is: in its coordinates, and in its rates by what they move within a step.

The rates of stiff modes are wild where their angles are still; measured like the angles they would rule the step. An
error of a rate counts as the change of the coordinate within the step that it makes, where that is less (the norm of
multistep and extrapolation codes for second-order systems; E. Hairer, S. Norsett, G. Wanner, Solving ODEs I, II.14).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmodes.compile.ir.emit import F64, counted, number, whole
from tmodes.compile.loops.time_loop import TimeLoop

__all__ = ["MotionNorm"]


class MotionNorm:
    """Writes the norm for a state of ``pairs`` coordinates, as many rates, and more behind them."""

    def __init__(self, loop: TimeLoop, pairs: int) -> None:
        self.loop, self.pairs, self.b = loop, pairs, loop.builder
        self.total, self.largest = loop.local("norm"), loop.local("largest")

    def of_difference(self, one: str, other: str, before: str, h: Any) -> Any:
        """Norm of ``one`` - ``other``; scales of ``one`` and ``before``."""
        load = self.loop.load
        return self.of_error(lambda i: self.b.fsub(load(one, i), load(other, i)), one, before, h)

    def of_error(self, error: Callable[[Any], Any], one: str, before: str, h: Any) -> Any:
        """Root of the mean square of ``error(i)`` over the tolerance; scales of ``one`` and ``before``.

        What stands behind the rates (works, currents) is measured by the largest among it.
        """
        b, n, rest = self.b, self.pairs, self.loop.size - 2 * self.pairs
        b.store(number(0.0), self.total)
        with counted(b, n, "pair") as i:
            paired = b.add(i, whole(n))
            scale = self._scale(self._size(i, one, before))
            self._add(b.fdiv(error(i), scale))
            rate = error(paired)
            shares = [b.fdiv(b.fmul(h, rate), scale), b.fdiv(rate, self._scale(self._size(paired, one, before)))]
            self._add(self.loop.intrinsic("minnum", *(self.loop.intrinsic("fabs", share) for share in shares)))
        b.store(number(0.0), self.largest)
        with counted(b, rest, "size") as i:
            size = self._size(b.add(i, whole(2 * n)), one, before)
            b.store(self.loop.intrinsic("maxnum", b.load(self.largest, typ=F64), size), self.largest)
        with counted(b, rest, "rest") as i:
            self._add(b.fdiv(error(b.add(i, whole(2 * n))), self._scale(b.load(self.largest, typ=F64))))
        mean = b.fdiv(b.load(self.total, typ=F64), number(float(max(self.loop.size, 1))))
        return self.loop.intrinsic("sqrt", mean)

    def _size(self, i: Any, one: str, before: str) -> Any:
        return self.loop.intrinsic(
            "maxnum", *(self.loop.intrinsic("fabs", self.loop.load(a, i)) for a in (one, before))
        )

    def _scale(self, size: Any) -> Any:
        return self.b.fadd(self.loop.option("atol"), self.b.fmul(self.loop.option("rtol"), size))

    def _add(self, ratio: Any) -> None:
        term = self.b.fmul(ratio, ratio)
        self.b.store(self.b.fadd(self.b.load(self.total, typ=F64), term), self.total)
