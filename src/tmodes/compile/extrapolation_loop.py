"""Extrapolated linearly implicit Euler steps, adaptive in step and order, as a native loop: for stiff arms.

Row j of the tableau takes j such steps over the whole length, and the Aitken-Neville scheme raises the order by one
with each row; step and order follow from the least work per time: E. Hairer, G. Wanner, Solving Ordinary Differential
Equations II, section IV.9 (SEULEX, n_j = j); P. Deuflhard, SIAM Review 27 (1985) 505-535. No Jacobian is needed.
"""

from __future__ import annotations

from typing import Any

from tmodes.compile.block import ScheduleRate
from tmodes.compile.emit import F64, I64, counted, load, number, store, whole
from tmodes.compile.extrapolation_dense import DenseOutput
from tmodes.compile.gate import Gate
from tmodes.compile.implicit_step import ImplicitStep, refuse_explicit_only
from tmodes.compile.motion_norm import MotionNorm
from tmodes.compile.step_control import add_local_errors, power
from tmodes.compile.time_loop import Status, TimeLoop

__all__ = ["ROWS", "write_extrapolation_loop"]

ROWS = 8
"""Most rows of the tableau: 36 evaluations; more would lose to rounding what they gain in order."""

_FIRST_ROWS, _FIRST_STEP = 4, 1e-4
_SAFETY, _SMALLEST, _LARGEST, _REJECTED = 0.9, 0.1, 6.0, 0.7
_GAIN = 0.9
"""Another order is taken where its work per time is below this share."""


def write_extrapolation_loop(module: Any, name: str, lowered: ScheduleRate, guarded: int, *, pairs: int) -> None:
    """Write the loop; steps end on knots, samples are interpolated.

    The state begins with ``pairs`` coordinates and as many rates; what follows takes explicit Euler steps. Raises
    :class:`CompileError` for a schedule without inputs for implicit steps.
    """
    refuse_explicit_only(name, lowered)
    arrays = (*(f"row{m}" for m in range(ROWS)), "x", "ahead", "start", "slope", "new", "apart")
    loop = TimeLoop(module, name, lowered, arrays, guarded)
    _Writer(loop, lowered, pairs).write()


class _Writer:
    """Writes the body of the loop; the cell ``old_error`` holds the number of rows that is aimed at."""

    def __init__(self, loop: TimeLoop, lowered: ScheduleRate, pairs: int) -> None:
        self.loop, self.b = loop, loop.builder
        self.step, self.norm = ImplicitStep(loop, lowered, pairs), MotionNorm(loop, pairs)
        self.gate, self.dense = Gate(loop, lowered.gate_offset), DenseOutput(loop, ROWS)
        self.time = loop.local("time")
        with self.b.goto_entry_block():
            self.rows = self.b.alloca(I64, name="rows")
            # By the number of rows: the step that this order could take next, and its work per time.
            self.lengths = self.b.alloca(F64, size=whole(ROWS + 1), name="lengths")
            self.works = self.b.alloca(F64, size=whole(ROWS + 1), name="works")

    def write(self) -> None:
        """One attempt of a step, from the block ``again`` back to it."""
        loop, b = self.loop, self.b
        self.gate.begin("y", "slope")
        with b.if_then(b.fcmp_ordered("<=", loop.get("h"), number(0.0)), likely=False):
            loop.put("h", loop.intrinsic("minnum", number(_FIRST_STEP), b.fsub(loop.knot(1), loop.knot(0))))
        with b.if_then(b.fcmp_ordered("<", loop.get("old_error"), number(2.0)), likely=False):
            loop.put("old_error", number(float(_FIRST_ROWS)))
        time, wanted = loop.get("t"), loop.get("h")
        h, last, time_after = loop.step_until(loop.knot(1))
        self.dense.keep(whole(0), "y")
        store(b, number(1e300), self.works, 1)
        accepted, rejected = loop.block("accepted"), loop.block("rejected")
        for row in range(1, ROWS + 1):
            self._row(row, time, h)
            if row >= 2:
                self._judge(row, h, accepted, rejected)
        b.branch(rejected)
        b.position_at_end(rejected)
        self._reject(h)
        b.position_at_end(accepted)
        self._accept(h, wanted, last, time_after)

    def _row(self, row: int, time: Any, h: Any) -> None:
        """``row`` equal steps into x, then one more column for each row before."""
        loop, b = self.loop, self.b
        part = b.fdiv(h, number(float(row)))
        loop.copy("x", "y")
        b.store(time, self.time)
        with counted(b, row, f"step{row}") as k:
            b.store(b.fadd(b.load(self.time, typ=F64), part), self.time)
            self.step.euler(b.load(self.time, typ=F64), part, "x", "slope")
            self.dense.keep(b.add(k, whole(1 + row * (row - 1) // 2)), "x")
        for column in range(1, row):
            share = number(1.0 / (row / (row - column) - 1.0))
            label = f"row{column - 1}"
            with counted(b, loop.size, f"t{row}.{column}") as i:
                before, here = load(b, loop.array[label], i), load(b, loop.array["x"], i)
                store(b, here, loop.array[label], i)
                store(b, b.fadd(here, b.fmul(b.fsub(here, before), share)), loop.array["x"], i)
        loop.copy(f"row{row - 1}", "x")

    def _judge(self, row: int, h: Any, accepted: Any, rejected: Any) -> None:
        """Take the step, give it up, or go on to the next row: by T_kk - T_k,k-1 over the tolerance."""
        loop, b = self.loop, self.b
        error = self.norm.of_difference(f"row{row - 1}", f"row{row - 2}", "y", h)
        with counted(b, loop.size, "apart") as i:
            apart = b.fsub(load(b, loop.array[f"row{row - 1}"], i), load(b, loop.array[f"row{row - 2}"], i))
            store(b, apart, loop.array["apart"], i)
        b.store(whole(row), self.rows)
        loop.copy("new", f"row{row - 1}")
        floor = loop.intrinsic("maxnum", error, number(1e-12))
        factor = b.fmul(number(_SAFETY), power(loop, b.fdiv(number(_SAFETY), floor), 1.0 / row))
        factor = loop.intrinsic("minnum", loop.intrinsic("maxnum", factor, number(_SMALLEST)), number(_LARGEST))
        length = b.fmul(h, factor)
        store(b, length, self.lengths, row)
        store(b, b.fdiv(number(row * (row + 1) / 2), length), self.works, row)
        aim, here = loop.get("old_error"), number(float(row))
        good = b.fcmp_ordered("<=", error, number(1.0))
        near = b.fcmp_ordered(">=", here, b.fsub(aim, number(1.0)))
        on, next_row = loop.block(f"judge{row}"), loop.block(f"after{row}")
        b.cbranch(b.and_(good, near), accepted, on)
        b.position_at_end(on)
        b.cbranch(self._hopeless(row, error, aim), rejected, next_row)
        b.position_at_end(next_row)

    def _hopeless(self, row: int, error: Any, aim: Any) -> Any:
        """Whether the rows that are left up to one beyond the aim cannot bring the error below the tolerance."""
        b, here = self.b, number(float(row))
        beyond = b.fadd(aim, number(1.0))
        early = b.and_(b.fcmp_ordered("<", here, aim), b.fcmp_ordered(">=", here, b.fsub(aim, number(1.0))))
        bar = b.select(early, b.fmul(beyond, aim), beyond)
        bad = b.fcmp_unordered(">", error, b.fmul(bar, bar))
        near = b.fcmp_ordered(">=", here, b.fsub(aim, number(1.0)))
        return b.or_(b.and_(near, bad), b.fcmp_ordered(">=", here, beyond))

    def _order(self) -> tuple[Any, Any]:
        """Number of rows for the next step by the least work per time, and its length."""
        b, rows = self.b, self.b.load(self.rows, typ=I64)
        before = b.sub(rows, whole(1))
        here, less = load(b, self.works, rows), load(b, self.works, before)
        fewer = b.fcmp_ordered("<", less, b.fmul(number(_GAIN), here))
        more = b.and_(
            b.fcmp_ordered("<", here, b.fmul(number(_GAIN), less)),
            b.icmp_signed("<", rows, whole(ROWS - 1)),
        )
        length = load(b, self.lengths, rows)
        real = b.sitofp(rows, F64)
        longer = b.fmul(length, b.fdiv(b.fadd(real, number(2.0)), real))
        wanted = b.select(more, b.add(rows, whole(1)), b.select(fewer, before, rows))
        return wanted, b.select(more, longer, b.select(fewer, load(b, self.lengths, before), length))

    def _reject(self, h: Any) -> None:
        loop, b = self.loop, self.b
        loop.add("done", 1.0)
        wanted, length = self._order()
        limit = b.fptosi(loop.get("old_error"), I64)
        fewer = b.icmp_signed("<", wanted, limit)
        wanted = b.select(fewer, wanted, limit)
        loop.put("old_error", b.sitofp(wanted, F64))
        length = loop.intrinsic("minnum", length, b.fmul(number(_REJECTED), h))
        loop.put("h", length)
        loop.add("rejected", 1.0)
        b.branch(loop.again)

    def _accept(self, h: Any, wanted: Any, last: Any, time_after: Any) -> None:
        loop, b = self.loop, self.b
        loop.add("done", 1.0)
        loop.stop_if(b.not_(loop.within_bounds("new")), Status.DIVERGED)
        if self.gate.offset is not None:
            loop.evaluate(time_after, "new", "slope")
            self.gate.meet(h)
        add_local_errors(loop, "apart", number(1.0))
        self.dense.write_samples("y", "new", h, time_after, b.load(self.rows, typ=I64))
        loop.copy("y", "new")
        rows, length = self._order()
        loop.put("old_error", b.sitofp(rows, F64))
        # A step cut short by a knot says little about the next: keep the longer wish.
        loop.put("h", b.select(last, loop.intrinsic("maxnum", length, wanted), length))
        loop.put("t", time_after)
        loop.put("segment", b.fadd(loop.get("segment"), b.uitofp(last, F64)))
        loop.count_step(h, last)
        b.branch(loop.again)
