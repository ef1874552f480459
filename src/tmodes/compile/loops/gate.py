"""Where a force starts or ends within a step: a step that changes the state of a gate is shortened onto the change.

A gate is open while both of its numbers are positive: the depth of a point inside a surface, or of the teeth of a gear
with play in each other, and the push of spring and damper. A smooth method that steps over the change would not see it,
or see it too late, and its error estimate neither.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmodes.compile.ir.emit import F64, number
from tmodes.compile.loops.frame import Frame
from tmodes.compile.loops.switches import SHORTEST, Narrow, Switches
from tmodes.compile.loops.time_loop import Status, TimeLoop

__all__ = ["Gate", "gate_change", "gate_numbers"]


def gate_numbers(loop: Frame) -> list[Any]:
    """Both numbers of each gate as the last evaluation left them."""
    assert loop.rate.gate_offset is not None  # noqa: S101
    places = range(loop.rate.gate_offset, loop.rate.gate_offset + 2 * loop.rate.gate_count)
    return [loop.numbers.load(loop.builder, loop.array["held"], k) for k in places]


def gate_change(loop: Frame, before: list[Any], h: Any) -> tuple[Any, Any, Any]:
    """Whether a gate changed since ``before``, whether the step must be shortened, and to what."""
    b, now = loop.builder, gate_numbers(loop)
    each = [_one_change(loop, before[k : k + 2], now[k : k + 2]) for k in range(0, len(now), 2)]
    changed, share = each[0]
    for another, its in each[1:]:
        one = loop.constant(1.0)
        first = b.select(changed, share, one), b.select(another, its, one)
        changed, share = b.or_(changed, another), loop.intrinsic("minnum", *first)
    size = loop.intrinsic("maxnum", loop.intrinsic("fabs", loop.get("t")), loop.constant(1.0))
    shortest = b.fmul(loop.constant(SHORTEST), size)
    missed = b.and_(changed, b.fcmp_ordered(">", h, shortest))
    return changed, missed, loop.intrinsic("maxnum", b.fmul(h, share), shortest)


def _one_change(loop: Frame, before: list[Any], now: list[Any]) -> tuple[Any, Any]:
    """Whether one gate changed, and at which share of the step."""
    b, zero = loop.builder, loop.constant(0.0)
    was, is_ = (b.and_(*(b.fcmp_ordered(">", x, zero) for x in pair)) for pair in (before, now))
    depth_turned = b.fcmp_ordered("<=", b.fmul(before[0], now[0]), zero)
    old, new = (b.select(depth_turned, pair[0], pair[1]) for pair in (before, now))
    share = b.fdiv(old, b.fsub(old, new))
    least, most = loop.constant(0.05), loop.constant(0.95)
    usable = b.and_(b.fcmp_ordered(">", share, least), b.fcmp_ordered("<", share, most))
    return b.xor(was, is_), b.select(usable, share, loop.constant(0.5))


class Gate:
    """Watches the gates of a loop's right-hand side; does nothing where there is none."""

    def __init__(self, loop: TimeLoop, *, implicit: bool = False) -> None:
        """``implicit``: of a method whose steps may be long where the motion is stiff."""
        self.loop, self.gated, self.switches = loop, loop.rate.gate_offset is not None, Switches(loop)
        self.narrow = Narrow(loop, watched=implicit)
        self.before = [loop.local(f"gate{k}") for k in range(2 * loop.rate.gate_count)]

    @property
    def exists(self) -> bool:
        """Whether there is anything to be watched."""
        return self.gated or self.switches.count > 0 or self.narrow.count > 0

    def begin(self, state: str, into: str) -> None:
        """The gate at the start of the first step of a call; later it is known from the step before."""
        if not self.exists:
            return
        b = self.loop.builder
        unknown = b.fcmp_ordered("==", b.load(self.loop.known, typ=F64), number(0.0))
        with b.if_then(unknown, likely=False):
            self.loop.evaluate(self.loop.get("t"), state, into)
            self.loop.add("evaluations", -1.0)  # how often a loop is called must not be seen in its result
            self._keep()
            self.switches.keep()
            self.narrow.keep()
            b.store(number(1.0), self.loop.known)

    def _keep(self) -> None:
        """The gate at the end of a step that is taken is that at the start of the next."""
        for cell, value in zip(self.before, gate_numbers(self.loop) if self.gated else (), strict=True):
            self.loop.builder.store(value, cell)

    def meet(self, h: Any, shorten: Callable[[Any], None] | None = None) -> None:
        """After an evaluation at the step's end: try again with a shorter step where the gate changed too early.

        ``shorten``: how a step gets its length, by default as the wish for the next.
        """
        shorten = shorten or (lambda shorter: self.loop.put("h", shorter))
        changed = self._shortened(h, shorten) if self.gated else None
        self.narrow.meet(h)
        self.switches.meet(h, shorten, self._count)
        if changed is not None:
            with self.loop.builder.if_then(changed, likely=False):
                self.loop.add("events", 1.0)
                self._count()
                self.loop.put("switching", number(1.0))
                self.loop.put("met", number(1.0))
        if self.loop.rate.changes:
            chatters = self.loop.builder.fcmp_ordered(">", self.loop.get("burst"), self.loop.option("most_events"))
            self.loop.stop_if(chatters, Status.CHATTERING)
        self._keep()
        self.switches.keep()
        self.narrow.keep()

    def _shortened(self, h: Any, shorten: Callable[[Any], None]) -> Any:
        """Try again with a shorter step where the gate changed too early; whether it changes in this one."""
        loop, b = self.loop, self.loop.builder
        changed, missed, shorter = gate_change(loop, [b.load(cell, typ=F64) for cell in self.before], h)
        again, met = loop.block("gate_missed"), loop.block("gate_met")
        b.cbranch(missed, again, met)
        b.position_at_end(again)
        shorten(shorter)
        loop.add("rejected", 1.0)
        b.branch(loop.again)
        b.position_at_end(met)
        return changed

    def _count(self) -> None:
        """Count a change among those that came within a short time: too many are no motion any more."""
        loop, b = self.loop, self.loop.builder
        later = b.fcmp_ordered(">", b.fsub(loop.get("t"), loop.get("burst_time")), loop.option("event_time"))
        loop.put("burst", b.fadd(b.select(later, number(0.0), loop.get("burst")), number(1.0)))
        loop.put("burst_time", b.select(later, loop.get("t"), loop.get("burst_time")))
