"""The gate of a force that acts for part of a step (:mod:`tmodes.compile.loops.gate`), for each lane by itself."""

from __future__ import annotations

from typing import Any

from tmodes.compile.lanes.lanes_loop import LanesLoop
from tmodes.compile.loops.gate import SHORTEST
from tmodes.compile.loops.time_loop import Status

__all__ = ["LanesGate"]

_CELLS = ("gate0", "gate1")


class LanesGate:
    """Watches the gate of a loop's right-hand side; does nothing where there is none."""

    def __init__(self, loop: LanesLoop, offset: int | None) -> None:
        self.loop, self.offset = loop, offset
        self._b: Any = loop.builder

    def _now(self) -> list[Any]:
        """The numbers as the last evaluation left them."""
        assert self.offset is not None  # noqa: S101
        loop = self.loop
        return [loop.lanes.load(loop.builder, loop.array["held"], self.offset + k) for k in range(2)]

    def begin(self, state: str, into: str) -> None:
        """The gate at the start of the first steps, which all lanes take together; then it is in the memory."""
        if self.offset is None:
            return
        loop, b = self.loop, self._b
        unknown = b.fcmp_ordered("==", loop.get("gate_known"), loop.constant(0.0))
        with b.if_then(loop.any(unknown), likely=False):
            loop.evaluate(loop.get("t"), state, into)
            self._keep(unknown)
            loop.put("gate_known", loop.constant(1.0))

    def _keep(self, where: Any) -> None:
        for label, value in zip(_CELLS, self._now(), strict=True):
            self.loop.put(label, value, where)

    def meet(self, h: Any, accepted: Any) -> Any:
        """Of the accepted lanes those whose gate did not change too early; the others try again with a shorter step.

        A lane whose gate changes too often is over.
        """
        if self.offset is None:
            return accepted
        loop, b = self.loop, self._b
        changed, missed, shorter = self._missed(h)
        missed = b.and_(accepted, missed)
        loop.put("h", shorter, missed)
        loop.count("rejected", missed)
        met = b.and_(accepted, b.not_(missed))
        changed = b.and_(met, changed)
        with b.if_then(loop.any(changed), likely=False):
            self._count(changed)
        calm = b.fcmp_ordered("<=", loop.get("burst"), loop.option("most_events"))
        loop.end_where(b.and_(met, b.not_(calm)), Status.CHATTERING)
        met = b.and_(met, calm)
        self._keep(met)
        return met

    def _count(self, changed: Any) -> None:
        """Count the changes of each lane, also among those that came within a short time."""
        loop, b = self.loop, self._b
        loop.count("events", changed)
        time = loop.get("t")
        later = b.fcmp_ordered(">", b.fsub(time, loop.get("burst_time")), loop.option("event_time"))
        loop.put("burst", loop.constant(0.0), b.and_(changed, later))
        loop.put("burst_time", time, b.and_(changed, later))
        loop.count("burst", changed)

    def _missed(self, h: Any) -> tuple[Any, Any, Any]:
        """Where the gate changed, where the step must be shortened, and to what."""
        loop, b, zero = self.loop, self._b, self.loop.constant(0.0)
        before, now = [loop.get(label) for label in _CELLS], self._now()
        was, is_ = (b.and_(*(b.fcmp_ordered(">", x, zero) for x in pair)) for pair in (before, now))
        depth_turned = b.fcmp_ordered("<=", b.fmul(before[0], now[0]), zero)
        old, new = (b.select(depth_turned, pair[0], pair[1]) for pair in (before, now))
        share = b.fdiv(old, b.fsub(old, new))
        least, most = loop.constant(0.05), loop.constant(0.95)
        usable = b.and_(b.fcmp_ordered(">", share, least), b.fcmp_ordered("<", share, most))
        share = b.select(usable, share, loop.constant(0.5))
        size = loop.call("maxnum", loop.call("fabs", loop.get("t")), loop.constant(1.0))
        shortest = b.fmul(loop.constant(SHORTEST), size)
        far = b.fcmp_ordered(">", h, shortest)
        changed = b.xor(was, is_)
        return changed, b.and_(changed, far), loop.call("maxnum", b.fmul(h, share), shortest)
