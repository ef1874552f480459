"""Extrapolated linearly implicit Euler steps, adaptive, as a native loop: for stiff arms, without a Jacobian.

A step of h is one evaluation of the accelerations with h D + h^2 K inside the recursion: v+ = v + h a, q+ = q + h v+.
Row j of the tableau takes j such steps over the whole length, and the Aitken-Neville scheme raises the order by one
with each row: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, section IV.9 (SEULEX, n_j = j);
P. Deuflhard, SIAM Review 27 (1985) 505-535. Rows are added until the last two agree within the tolerance.
"""

from __future__ import annotations

from typing import Any

from tmodes.compile.block import ScheduleRate
from tmodes.compile.emit import F64, counted, load, number, store, whole
from tmodes.compile.gate import Gate
from tmodes.compile.step_control import add_local_errors, mean_square, power
from tmodes.compile.time_loop import Status, TimeLoop
from tmodes.errors import CompileError

__all__ = ["ROWS", "write_extrapolation_loop"]

ROWS = 8
"""Most rows of the tableau: 36 evaluations; more would lose to rounding what they gain in order."""

_SAFETY, _SMALLEST, _LARGEST, _FIRST, _ROUNDING = 0.8, 0.2, 4.0, 1e-4, 1e-12


def write_extrapolation_loop(module: Any, name: str, lowered: ScheduleRate, guarded: int, *, pairs: int) -> None:
    """Write the loop; every step ends on a knot or on the next sample.

    The state begins with ``pairs`` coordinates and as many rates; what follows takes explicit Euler steps. The length
    of a step is put into the held memory. Raises :class:`CompileError` for a schedule without such a place.
    """
    if lowered.step_offset is None:
        raise CompileError(f"{name}: the schedule has no input `step` for implicit steps")
    tableau = tuple(f"row{m}" for m in range(ROWS))
    loop = TimeLoop(module, name, lowered, (*tableau, "x", "slope", "kept", "new"), guarded)
    _Writer(loop, pairs, lowered.step_offset, lowered.gate_offset).write()


class _Writer:
    """Writes the body of the loop."""

    def __init__(self, loop: TimeLoop, pairs: int, step_offset: int, gate_offset: int | None) -> None:
        self.loop, self.pairs, self.step_offset = loop, pairs, step_offset
        self.b: Any = loop.builder
        self.error, self.rows, self.time = loop.local("error"), loop.local("rows"), loop.local("time")
        self.gate = Gate(loop, gate_offset)

    def write(self) -> None:
        """One attempt of a step, from the block ``again`` back to it."""
        loop, b = self.loop, self.b
        self.gate.begin("y", "slope")
        with b.if_then(b.fcmp_ordered("<=", loop.get("h"), number(0.0)), likely=False):
            loop.put("h", loop.intrinsic("minnum", number(_FIRST), b.fsub(loop.knot(1), loop.knot(0))))
        time, wanted = loop.get("t"), loop.get("h")
        h, last, time_after = loop.step_until(self._next_stop())
        judged = loop.block("judged")
        for row in range(1, ROWS + 1):
            self._row(row, time, h)
            if row >= 2:
                self._judge(row, judged)
        b.branch(judged)
        b.position_at_end(judged)
        self._finish(h, wanted, last, time_after)

    def _next_stop(self) -> Any:
        """The end of the segment, or the next sample before it."""
        loop, b = self.loop, self.b
        knot = loop.knot(1)
        left = b.icmp_signed("<", loop.integer("sample"), loop.argument["samples"])
        index = b.select(left, loop.integer("sample"), whole(0))
        sample = load(b, loop.argument["times"], index)
        # A sample and a knot that are one but for rounding are met together.
        near = self._rounding(knot)
        ahead = b.and_(left, b.fcmp_ordered(">", sample, b.fadd(loop.get("t"), near)))
        return b.select(b.and_(ahead, b.fcmp_ordered("<", sample, b.fsub(knot, near))), sample, knot)

    def _rounding(self, time: Any) -> Any:
        return self.b.fmul(number(_ROUNDING), self.loop.intrinsic("maxnum", time, number(1e-3)))

    def _row(self, row: int, time: Any, h: Any) -> None:
        """``row`` equal steps into x, then one more column for each row before."""
        loop, b = self.loop, self.b
        part = b.fdiv(h, number(float(row)))
        loop.copy("x", "y")
        b.store(time, self.time)
        with counted(b, row, f"step{row}"):
            store(b, part, loop.held, self.step_offset)
            loop.evaluate(b.load(self.time, typ=F64), "x", "slope")
            self._euler(part)
            b.store(b.fadd(b.load(self.time, typ=F64), part), self.time)
        for column in range(1, row):
            share = number(1.0 / (row / (row - column) - 1.0))
            label = f"row{column - 1}"
            with counted(b, loop.size, f"t{row}.{column}") as i:
                before, here = load(b, loop.array[label], i), load(b, loop.array["x"], i)
                store(b, here, loop.array[label], i)
                store(b, b.fadd(here, b.fmul(b.fsub(here, before), share)), loop.array["x"], i)
        loop.copy(f"row{row - 1}", "x")

    def _euler(self, h: Any) -> None:
        loop, b, x, slope = self.loop, self.b, self.loop.array["x"], self.loop.array["slope"]
        with counted(b, self.pairs, "pair") as i:
            beside = b.add(i, whole(self.pairs))
            rate = b.fadd(load(b, x, beside), b.fmul(h, load(b, slope, beside)))
            store(b, rate, x, beside)
            store(b, b.fadd(load(b, x, i), b.fmul(h, rate)), x, i)
        with counted(b, loop.size - 2 * self.pairs, "rest") as i:
            place = b.add(i, whole(2 * self.pairs))
            store(b, b.fadd(load(b, x, place), b.fmul(h, load(b, slope, place))), x, place)

    def _judge(self, row: int, judged: Any) -> None:
        """Go on to the next row unless the last two columns agree: T_kk - T_k,k-1 over the tolerance."""
        loop, b = self.loop, self.b

        def difference(i: Any) -> Any:
            apart = b.fsub(load(b, loop.array[f"row{row - 1}"], i), load(b, loop.array[f"row{row - 2}"], i))
            store(b, apart, loop.array["kept"], i)
            return apart

        b.store(mean_square(loop, difference, "y", f"row{row - 1}"), self.error)
        b.store(number(float(row)), self.rows)
        loop.copy("new", f"row{row - 1}")
        if row < ROWS:
            on = loop.block(f"row{row + 1}")
            b.cbranch(b.fcmp_ordered("<=", b.load(self.error, typ=F64), number(1.0)), judged, on)
            b.position_at_end(on)

    def _finish(self, h: Any, wanted: Any, last: Any, time_after: Any) -> None:
        loop, b = self.loop, self.b
        store(b, number(0.0), loop.held, self.step_offset)
        error, rows = b.load(self.error, typ=F64), b.load(self.rows, typ=F64)
        loop.add("done", 1.0)
        accepted, rejected = loop.block("accepted"), loop.block("rejected")
        floor = loop.intrinsic("maxnum", error, number(1e-12))
        factor = b.fdiv(number(_SAFETY), power(loop, floor, b.fdiv(number(1.0), rows)))
        b.cbranch(b.fcmp_ordered("<=", error, number(1.0)), accepted, rejected)
        b.position_at_end(rejected)
        loop.reject(h, factor, _SMALLEST)
        b.position_at_end(accepted)
        loop.stop_if(b.not_(loop.within_bounds("new")), Status.DIVERGED)
        if self.gate.offset is not None:
            loop.evaluate(time_after, "new", "slope")
            self.gate.meet(h)
        loop.copy("y", "new")
        add_local_errors(loop, "kept", number(1.0))
        with loop.due_samples(b.fadd(time_after, self._rounding(time_after))) as target, counted(b, loop.size) as i:
            store(b, load(b, loop.array["new"], i), target, i)
        bounded = loop.intrinsic("minnum", loop.intrinsic("maxnum", factor, number(_SMALLEST)), number(_LARGEST))
        grown = b.fmul(h, bounded)
        loop.put("h", b.select(last, loop.intrinsic("maxnum", grown, wanted), grown))
        loop.put("t", time_after)
        at_knot = b.fcmp_ordered(">=", time_after, loop.knot(1))
        loop.put("segment", b.fadd(loop.get("segment"), b.uitofp(at_knot, F64)))
        loop.count_step(h, last)
        b.branch(loop.again)
