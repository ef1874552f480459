"""Where something that sticks, slips or touches stops doing so: a step ends there, and the state switches.

Each of the functions of a right-hand side is positive while its mode lasts. A step over a change of sign is shortened
onto it by the regula falsi, until what it goes beyond the change is no more than the resolution of the time.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmodes.compile.ir.emit import F64, counted, load, number, store, whole

__all__ = ["MOST_SWITCHES", "Narrow", "Switches", "switch"]

RESOLUTION, SHORTEST = 1e-13, 1e-10
"""How far a step may go beyond a change, and from which length on it is not shortened any more.

As shares of the time, or of 1 s; the rounding of extrapolation is coarser than the first.
"""

LARGEST_CHANGE = 0.3
"""The share by which such a rate may change in a step: more misses that friction that falls lets a motion grow."""

MOST_SWITCHES = 100
"""Switches at one instant after which no state is found that lasts."""


def switch(loop: Any, endless: Any) -> None:
    """At the block ``again``: the state after all switches of this instant, where a change was met.

    ``endless``: the status of a loop that finds no state that lasts.
    """
    b, switched = loop.builder, loop.rate.switched
    if switched is None:
        return
    check, turn, done = (loop.block(f"switch_{name}") for name in ("check", "turn", "done"))
    b.branch(check)
    b.position_at_end(check)
    b.cbranch(b.fcmp_ordered(">", loop.get("switching"), number(0.0)), turn, done)
    b.position_at_end(turn)
    first = b.fcmp_ordered("==", loop.get("switching"), number(1.0))
    with b.if_then(b.and_(first, b.fcmp_ordered(">", loop.get("pause"), number(0.0)))):
        loop.copy("k1", "y")  # it is fresh after this turn
    loop.call(switched, loop.get("t"), "y", "after", "settling")
    changed = loop.local("changed")
    b.store(number(0.0), changed)
    with counted(b, loop.size, "component") as i:
        apart = b.fcmp_unordered("!=", loop.load("y", i), loop.load("after", i))
        b.store(b.select(apart, number(1.0), b.load(changed, typ=F64)), changed)
        kept = b.and_(apart, b.icmp_signed(">=", i, whole(loop.guarded)))  # not where what sticks only comes to rest
        loop.put("met", b.select(kept, number(1.0), loop.get("met")))
    loop.copy("y", "after")
    loop.add("switching", 1.0)
    loop.stop_if(b.fcmp_ordered(">", loop.get("switching"), number(MOST_SWITCHES)), endless)
    on = b.fcmp_ordered("!=", b.load(changed, typ=F64), number(0.0))
    loop.put("switching", b.select(on, loop.get("switching"), number(0.0)))
    loop.put("fresh", number(1.0))
    b.store(number(0.0), loop.known)
    wish = loop.get("wish")
    loop.put("h", b.select(b.fcmp_ordered(">", wish, number(0.0)), wish, loop.get("h")))
    loop.put("wish", number(0.0))
    b.branch(check)
    b.position_at_end(done)


class Switches:
    """Watches the switches of a loop's right-hand side; does nothing where there are none."""

    def __init__(self, loop: Any) -> None:
        self.loop, self.count = loop, loop.rate.switch_count
        if self.count:
            with loop.builder.goto_entry_block():
                self.before = loop.builder.alloca(F64, size=whole(self.count), name="switches")

    def keep(self) -> None:
        """The functions as the last evaluation left them are those at the start of the next step."""
        for k in range(self.count):
            store(self.loop.builder, self._now(k), self.before, k)

    def _now(self, k: int) -> Any:
        return load(self.loop.builder, self.loop.array["held"], self.loop.rate.switches + k)

    def meet(self, h: Any, shorten: Callable[[Any], None], count: Callable[[], None]) -> None:
        """After an evaluation at the step's end: ``shorten`` the step of length h that goes beyond a change.

        ``count`` counts a change.
        """
        if not self.count:
            return
        loop, b = self.loop, self.loop.builder
        zero, one = number(0.0), number(1.0)
        share, crossed = one, b.fcmp_ordered("<", one, zero)
        for k in range(self.count):
            was, now = load(b, self.before, k), self._now(k)
            over = b.fcmp_ordered("<=", now, zero)
            root = b.select(b.fcmp_ordered(">", was, zero), b.fdiv(was, b.fsub(was, now)), number(0.5))
            share = loop.intrinsic("minnum", share, b.select(over, root, one))
            crossed = b.or_(crossed, over)
        size = loop.intrinsic("maxnum", loop.intrinsic("fabs", loop.get("t")), one)
        least = b.fmul(number(RESOLUTION), size)
        beyond = b.fsub(h, b.fmul(h, share))
        far = b.and_(b.fcmp_ordered(">", beyond, least), b.fcmp_ordered(">", h, b.fmul(number(SHORTEST), size)))
        again, met = loop.block("switch_missed"), loop.block("switch_met")
        b.cbranch(b.and_(crossed, far), again, met)
        b.position_at_end(again)
        loop.put("wish", loop.intrinsic("maxnum", loop.get("wish"), loop.get("h")))
        shorten(b.fadd(b.fmul(h, share), b.fmul(number(0.5), least)))
        loop.add("rejected", 1.0)
        b.branch(loop.again)
        b.position_at_end(met)
        with b.if_then(crossed, likely=False):
            loop.put("switching", one)
            loop.put("met", one)
            loop.add("switches", 1.0)
            count()


class Narrow:
    """Keeps steps of implicit methods from passing over narrow friction; does nothing where there is none.

    A rate may change in a step by a share of itself and of the width of its band: so what leaves rest, or comes to it,
    meets the band, in a number of steps that grows with the logarithm of rate/width, whatever error estimates see.
    """

    def __init__(self, loop: Any, *, watched: bool) -> None:
        """``watched``: of an implicit method; the steps of explicit ones are held short within the band anyway."""
        self.loop, self.count = loop, loop.rate.narrow_count if watched else 0
        if self.count:
            with loop.builder.goto_entry_block():
                self.before = loop.builder.alloca(F64, size=whole(self.count), name="narrow")

    def _now(self, k: int) -> Any:
        return load(self.loop.builder, self.loop.array["held"], self.loop.rate.narrow + k)

    def keep(self) -> None:
        """The rates as the last evaluation left them are those at the start of the next step."""
        for k in range(self.count):
            store(self.loop.builder, self._now(k), self.before, k)

    def meet(self, h: Any) -> None:
        """After an evaluation at the step's end: try again with a shorter step where a rate changed too much."""
        if not self.count:
            return
        loop, b = self.loop, self.loop.builder
        worst = number(0.0)
        for k in range(self.count):
            pair = [load(b, self.before, k), self._now(k)]
            least = loop.intrinsic("minnum", *(loop.intrinsic("fabs", rate) for rate in pair))
            change = loop.intrinsic("fabs", b.fsub(pair[1], pair[0]))
            share = b.fdiv(change, b.fadd(self._now(self.count + k), least))
            worst = loop.intrinsic("maxnum", worst, share)
        size = loop.intrinsic("maxnum", loop.intrinsic("fabs", loop.get("t")), number(1.0))
        long = b.fcmp_ordered(">", h, b.fmul(number(SHORTEST), size))
        again, met = loop.block("narrow_missed"), loop.block("narrow_met")
        b.cbranch(b.and_(long, b.fcmp_ordered(">", worst, number(LARGEST_CHANGE))), again, met)
        b.position_at_end(again)
        part = loop.intrinsic("maxnum", b.fdiv(number(0.8 * LARGEST_CHANGE), worst), number(0.2))
        loop.put("h", b.fmul(h, part))
        loop.add("rejected", 1.0)
        b.branch(loop.again)
        b.position_at_end(met)
