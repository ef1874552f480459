"""The gate of a force that acts for part of a step (:mod:`tmodes.compile.loops.gate`), for each lane by itself."""

from __future__ import annotations

from typing import Any

from tmodes.compile.lanes.lanes_loop import LanesLoop
from tmodes.compile.loops.gate import gate_change, gate_numbers
from tmodes.compile.loops.time_loop import Status

__all__ = ["begin", "meet"]

_CELLS = ("gate0", "gate1")


def begin(loop: LanesLoop, state: str, into: str) -> None:
    """The gate at the start of the first steps, which all lanes take together; then it is in the memory."""
    if loop.rate.gate_offset is None:
        return
    b = loop.builder
    unknown = b.fcmp_ordered("==", loop.get("gate_known"), loop.constant(0.0))
    with b.if_then(loop.any(unknown), likely=False):
        loop.evaluate(loop.get("t"), state, into)
        _keep(loop, unknown)
        loop.put("gate_known", loop.constant(1.0))


def _keep(loop: LanesLoop, where: Any) -> None:
    for label, value in zip(_CELLS, gate_numbers(loop), strict=True):
        loop.put(label, value, where)


def meet(loop: LanesLoop, h: Any, accepted: Any) -> Any:
    """Of the accepted lanes those whose gate did not change too early; the others try again with a shorter step.

    A lane whose gate changes too often is over.
    """
    if loop.rate.gate_offset is None:
        return accepted
    b = loop.builder
    changed, missed, shorter = gate_change(loop, [loop.get(label) for label in _CELLS], h)
    missed = b.and_(accepted, missed)
    loop.put("h", shorter, missed)
    loop.count("rejected", missed)
    met = b.and_(accepted, b.not_(missed))
    changed = b.and_(met, changed)
    with b.if_then(loop.any(changed), likely=False):
        _count(loop, changed)
    calm = b.fcmp_ordered("<=", loop.get("burst"), loop.option("most_events"))
    loop.end_where(b.and_(met, b.not_(calm)), Status.CHATTERING)
    met = b.and_(met, calm)
    _keep(loop, met)
    return met


def _count(loop: LanesLoop, changed: Any) -> None:
    """Count the changes of each lane, also among those that came within a short time."""
    b, time = loop.builder, loop.get("t")
    loop.count("events", changed)
    later = b.fcmp_ordered(">", b.fsub(time, loop.get("burst_time")), loop.option("event_time"))
    loop.put("burst", loop.constant(0.0), b.and_(changed, later))
    loop.put("burst_time", time, b.and_(changed, later))
    loop.count("burst", changed)
