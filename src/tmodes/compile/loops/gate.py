"""Where a force starts or ends within a step: a step that changes the state of a gate is shortened onto the change.

A gate is open while both of its numbers are positive: the depth of a point inside a surface, and the push of spring and
damper. A smooth method that steps over the change would not see it, or see it too late, and its error estimate neither.
"""

from __future__ import annotations

from typing import Any

from tmodes.compile.ir.emit import F64, number
from tmodes.compile.loops.frame import Frame
from tmodes.compile.loops.time_loop import Status, TimeLoop

__all__ = ["SHORTEST", "Gate", "gate_change", "gate_numbers"]

SHORTEST = 1e-10
"""A change is met when the step over it is not longer than this share of the time, or this time [s]."""


def gate_numbers(loop: Frame) -> list[Any]:
    """Both numbers of a gate as the last evaluation left them."""
    assert loop.rate.gate_offset is not None  # noqa: S101
    return [loop.numbers.load(loop.builder, loop.array["held"], loop.rate.gate_offset + k) for k in range(2)]


def gate_change(loop: Frame, before: list[Any], h: Any) -> tuple[Any, Any, Any]:
    """Whether a gate changed since ``before``, whether the step must be shortened, and to what."""
    b, zero, now = loop.builder, loop.constant(0.0), gate_numbers(loop)
    was, is_ = (b.and_(*(b.fcmp_ordered(">", x, zero) for x in pair)) for pair in (before, now))
    depth_turned = b.fcmp_ordered("<=", b.fmul(before[0], now[0]), zero)
    old, new = (b.select(depth_turned, pair[0], pair[1]) for pair in (before, now))
    share = b.fdiv(old, b.fsub(old, new))
    least, most = loop.constant(0.05), loop.constant(0.95)
    usable = b.and_(b.fcmp_ordered(">", share, least), b.fcmp_ordered("<", share, most))
    share = b.select(usable, share, loop.constant(0.5))
    size = loop.intrinsic("maxnum", loop.intrinsic("fabs", loop.get("t")), loop.constant(1.0))
    shortest = b.fmul(loop.constant(SHORTEST), size)
    changed = b.xor(was, is_)
    missed = b.and_(changed, b.fcmp_ordered(">", h, shortest))
    return changed, missed, loop.intrinsic("maxnum", b.fmul(h, share), shortest)


class Gate:
    """Watches the gate of a loop's right-hand side; does nothing where there is none."""

    def __init__(self, loop: TimeLoop) -> None:
        self.loop, self.exists = loop, loop.rate.gate_offset is not None
        if self.exists:
            self.before, self.known = [loop.local(f"gate{k}") for k in range(2)], loop.local("gate_known")
            with loop.builder.goto_entry_block():
                loop.builder.store(number(0.0), self.known)

    def begin(self, state: str, into: str) -> None:
        """The gate at the start of the first step of a call; later it is known from the step before."""
        if not self.exists:
            return
        b = self.loop.builder
        unknown = b.fcmp_ordered("==", b.load(self.known, typ=F64), number(0.0))
        with b.if_then(unknown, likely=False):
            self.loop.evaluate(self.loop.get("t"), state, into)
            self.loop.add("evaluations", -1.0)  # how often a loop is called must not be seen in its result
            self._keep()

    def _keep(self) -> None:
        """The gate at the end of a step that is taken is that at the start of the next."""
        b = self.loop.builder
        for cell, value in zip(self.before, gate_numbers(self.loop), strict=True):
            b.store(value, cell)
        b.store(number(1.0), self.known)

    def meet(self, h: Any) -> None:
        """After an evaluation at the step's end: try again with a shorter step where the gate changed too early."""
        if not self.exists:
            return
        loop, b = self.loop, self.loop.builder
        changed, missed, shorter = gate_change(loop, [b.load(cell, typ=F64) for cell in self.before], h)
        again, met = loop.block("gate_missed"), loop.block("gate_met")
        b.cbranch(missed, again, met)
        b.position_at_end(again)
        loop.put("h", shorter)
        loop.add("rejected", 1.0)
        b.branch(loop.again)
        b.position_at_end(met)
        with b.if_then(changed, likely=False):
            self._count()
        loop.stop_if(b.fcmp_ordered(">", loop.get("burst"), loop.option("most_events")), Status.CHATTERING)
        self._keep()

    def _count(self) -> None:
        """Count a change, also among those that came within a short time: too many are no motion any more."""
        loop, b = self.loop, self.loop.builder
        loop.add("events", 1.0)
        later = b.fcmp_ordered(">", b.fsub(loop.get("t"), loop.get("burst_time")), loop.option("event_time"))
        loop.put("burst", b.fadd(b.select(later, number(0.0), loop.get("burst")), number(1.0)))
        loop.put("burst_time", b.select(later, loop.get("t"), loop.get("burst_time")))
