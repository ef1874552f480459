"""Stiffness seen during a run: explicit steps that are held back by stability, no longer by their error.

The last two stages of a step lie at the same time; the difference of their slopes over that of their states gives the
largest |eigenvalue| of the motion, about. Where step times eigenvalue stands at the method's limit, step after step,
the motion is stiff: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, section IV.2. A fast vibration
that hardly decays has imaginary eigenvalues, where the limit may be far lower; but steps that stand there may follow
the vibration for the sake of the error. So that limit counts only where another method can be tried.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmodes.compile.ir.emit import F64, I64, counted, number, whole
from tmodes.compile.loops.time_loop import Status, TimeLoop

__all__ = ["StiffnessTest"]

_IN_A_ROW, _CALM, _EVERY = 15.0, 6.0, 8
"""Stiff steps that tell; steps not stiff that forget; each so many steps are looked at while nothing is suspected."""


@dataclass(frozen=True)
class StiffnessTest:
    """``slopes`` and ``states`` are the two arrays of each; ``limit``: of step times eigenvalue.

    ``ringing``: the same on the imaginary axis.
    """

    slopes: tuple[str, str]
    states: tuple[str, str]
    limit: float
    ringing: float

    def write(self, loop: TimeLoop, h: Any) -> None:
        """After a step of length h was taken: count it, and end the loop where it is asked to watch."""
        b: Any = loop.builder
        watched = b.fcmp_ordered("!=", loop.option("watch"), number(0.0))
        limit = b.select(watched, number(self.ringing), number(self.limit))
        suspected = b.fcmp_ordered(">", loop.get("stiff"), number(0.0))
        turn = b.icmp_signed("==", b.and_(b.fptosi(loop.get("steps"), I64), whole(_EVERY - 1)), whole(0))
        with b.if_then(b.or_(suspected, turn), likely=False):
            self._count(loop, b.fcmp_ordered(">", self._reach(loop, h), limit))
        info = b.fcmp_ordered(">=", loop.get("stiff"), number(_IN_A_ROW))
        with b.if_then(b.and_(info, b.fcmp_ordered("<=", loop.get("stiff_time"), number(0.0))), likely=False):
            loop.put("stiff_time", loop.get("t"))
        loop.stop_if(b.and_(info, watched), Status.STIFF)

    def _reach(self, loop: TimeLoop, h: Any) -> Any:
        """Step times eigenvalue; not a number where nothing moves, which counts as calm."""
        b: Any = loop.builder
        above, below = self._size(loop, "above", self.slopes), self._size(loop, "below", self.states)
        return b.fmul(h, loop.intrinsic("sqrt", b.fdiv(above, below)))

    def _size(self, loop: TimeLoop, name: str, pair: tuple[str, str]) -> Any:
        b: Any = loop.builder
        total = loop.local(name)
        b.store(number(0.0), total)
        with counted(b, loop.size) as i:
            apart = b.fsub(*(loop.load(label, i) for label in pair))
            b.store(b.fadd(b.load(total, typ=F64), b.fmul(apart, apart)), total)
        return b.load(total, typ=F64)

    def _count(self, loop: TimeLoop, stiff: Any) -> None:
        b: Any = loop.builder
        zero, one = number(0.0), number(1.0)
        calm = b.select(stiff, zero, b.fadd(loop.get("calm"), one))
        count = b.select(stiff, b.fadd(loop.get("stiff"), one), loop.get("stiff"))
        forgotten = b.fcmp_ordered(">=", calm, number(_CALM))
        loop.put("stiff", b.select(forgotten, zero, count))
        loop.put("calm", b.select(forgotten, zero, calm))
