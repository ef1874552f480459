"""Extrapolated linearly implicit Euler steps, adaptive, as a native loop: for stiff arms.

Row j of the tableau takes j such steps over the whole length; the rows' ends are combined to order 6, so that what
vibrates without damping does not grow. E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, section IV.9
(SEULEX, n_j = j); P. Deuflhard, SIAM Review 27 (1985) 505-535. No Jacobian is needed. The eight rows are taken side by
side in nine passes of four, which is why there is no choice of order: fewer rows would hardly take less.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from llvmlite import ir

from tmodes.compile.ir.emit import F64, counted, load, number, store, whole
from tmodes.compile.loops.extrapolation_rows import (
    PairedRows,
    RowsRate,
    constants,
    difference_weights,
    limit_weights,
    spread_weights,
    steady_weights,
)
from tmodes.compile.loops.frame import MotionNorm
from tmodes.compile.loops.gate import Gate
from tmodes.compile.loops.step_control import ImplicitControl
from tmodes.compile.loops.time_loop import AdaptiveStep, Status, TimeLoop

__all__ = ["FEW", "ROWS", "DenseOutput", "write_extrapolation_loop"]

ROWS = 8
"""Rows of the tableau."""

_CAUTION = 2.0
"""What the local error is taken times: vibrations that hardly decay gather those of all steps."""

_CONTROL = ImplicitControl(exponent=1.0 / (ROWS - 1), smallest=0.1, first=1e-4)
"""The local error, by which the combination of order 6 differs from the limit of order 8, goes with h^7."""

FEW = 5
"""Rows of a step that a sample of a controller cuts short."""

_FEW_CAUTION, _FEW_CONTROL = 4.0, ImplicitControl(exponent=1.0 / (FEW - 1), smallest=0.1, first=1e-4)
"""The same of these, of order 3; a run has more of them."""


def write_extrapolation_loop(
    module: Any, name: str, rate: RowsRate, guarded: int, *, pairs: int, modes: int = 0
) -> None:
    """Write the loop; steps end on knots, samples are interpolated.

    The state begins with ``pairs`` coordinates and as many rates; what follows takes explicit Euler steps. The last
    ``modes`` numbers do not change within a step: combined, they would drift by the rounding of the weights' sum, and
    a direction of slip that is no unit vector is wrong where the slip ends.
    """
    loop = TimeLoop(module, name, rate, ("slope", "new", "apart"), guarded)
    _ExtrapolationWriter(loop, rate, pairs, modes).write()


class _Tableau:
    """The rows of a step, with what follows from their ends: the state ``new``, and its error ``apart``."""

    def __init__(self, loop: TimeLoop, rate: RowsRate, pairs: int, rows: int, modes: int) -> None:
        self.loop, self.rows, self.modes = loop, rows, modes
        self.paired = PairedRows(loop, rate, pairs, rows)
        self.dense = DenseOutput(loop, self.paired, modes)
        self.tables = {"new": self._ends("new", steady_weights(rows)), "apart": self.apart(rows)}

    def apart(self, rows: int) -> Any:
        """What a step of the first so many rows of these would be off."""
        steady, limit = steady_weights(rows), limit_weights(rows)
        return self._ends(f"apart{rows}", {row: steady[row] - limit[row] for row in limit})

    def _ends(self, label: str, weights: dict[int, float]) -> Any:
        """Weights of the ends of rows."""
        ends = spread_weights({(row, row): w for row, w in weights.items()}, self.rows)
        return constants(self.loop, f"{label}_of{self.rows}", ends)

    def take(self, step: AdaptiveStep) -> None:
        """All rows of a step."""
        self.paired.take(step.time, step.h)
        self.combine(self.tables)

    def combine(self, tables: dict[str, Any]) -> None:
        """Arrays from the ends of the rows; of modes ``new`` is where they are, and nothing is off."""
        loop, b = self.loop, self.loop.builder
        with counted(b, loop.size, "combined") as i:
            for label, table in tables.items():
                loop.store(self.paired.weighted(table, whole(0), i), label, i)
        if self.modes:
            with counted(b, self.modes, "mode") as k:
                i = b.add(k, whole(loop.size - self.modes))
                loop.store(loop.load("y", i), "new", i)
                loop.store(number(0.0), "apart", i)


class _ExtrapolationWriter:
    """Writes the body of the loop.

    Where controllers sample, most steps end at the next sample, far sooner than eight rows could go: five rows take
    these where their error allows, in five passes in place of nine. The cell ``few`` holds the length that they could
    go, which the first five of eight rows tell, too.
    """

    def __init__(self, loop: TimeLoop, rate: RowsRate, pairs: int, modes: int) -> None:
        self.loop, self.b = loop, loop.builder
        self.whole = _Tableau(loop, rate, pairs, ROWS, modes)
        self.few = _Tableau(loop, rate, pairs, FEW, modes) if rate.sampled else None
        self.norm, self.gate = MotionNorm(loop, pairs), Gate(loop, implicit=True)

    def write(self) -> None:
        """One attempt of a step, from the block ``again`` back to it."""
        self.gate.begin("y", "slope")
        step = _CONTROL.begin(self.loop)
        if self.few:
            self._write_few(self.few, step)
        self.whole.take(step)
        grown = _CONTROL.judge(self.loop, step, self._error(step, _CAUTION))
        if self.few:
            self.whole.combine({"apart": self.whole.apart(FEW)})
            self.loop.put("few", _FEW_CONTROL.grown(self.loop, step.h, self._error(step, _FEW_CAUTION)))
        self._accept(self.whole, step, grown)

    def _error(self, step: AdaptiveStep, caution: float) -> Any:
        error = self.norm.of_error(lambda i: self.loop.load("apart", i), "new", "y", step.h)
        return self.b.fmul(error, number(caution))

    def _write_few(self, few: _Tableau, step: AdaptiveStep) -> None:
        """A step that ends on a knot, by few rows where they can go so far."""
        loop, b = self.loop, self.b
        short, otherwise = loop.block("few_rows"), loop.block("all_rows")
        b.cbranch(b.and_(step.last, b.fcmp_ordered("<=", step.h, loop.get("few"))), short, otherwise)
        b.position_at_end(short)
        few.take(step)
        loop.put("few", _FEW_CONTROL.judge(loop, step, self._error(step, _FEW_CAUTION), "few"))
        self._accept(few, step, step.h)
        b.position_at_end(otherwise)

    def _accept(self, tableau: _Tableau, step: AdaptiveStep, grown: Any) -> None:
        loop = self.loop
        if self.gate.exists:
            loop.evaluate(step.time_after, "new", "slope")
            loop.add("passes", 1.0)
            self.gate.meet(step.h)
        loop.stop_if(self.b.not_(loop.within_bounds("new")), Status.DIVERGED)
        tableau.dense.write_samples("y", "new", step.h, step.time_after)
        loop.take(step, grown)
        self.b.branch(loop.again)


class DenseOutput:
    """Gives the motion between both ends of a step, by the states of all rows; ``modes``: as of the loop."""

    def __init__(self, loop: TimeLoop, paired: PairedRows, modes: int = 0) -> None:
        self.modes = modes
        self.loop, self.paired, self.rows, self.b = loop, paired, paired.rows, loop.builder
        with self.b.goto_entry_block():
            self.terms = self.b.alloca(F64, size=whole((self.rows + 1) * loop.size), name="terms")
        lines = [spread_weights(difference_weights(self.rows, order), self.rows) for order in range(1, self.rows)]
        self.table = constants(loop, f"differences{self.rows}", np.stack(lines))

    def write_samples(self, start: str, end: str, h: Any, time_after: Any) -> None:
        """Write the samples of a step that went from array ``start`` to ``end``."""
        b, loop = self.b, self.loop
        with b.if_then(loop.sample_due(time_after)):
            self._find_terms(start, end)
            with loop.due_samples(time_after) as target:
                back = b.fdiv(b.fsub(loop.sample_time(), time_after), h)
                with counted(b, loop.size, "value") as i:
                    store(b, self._value(end, i, back), target, i)
                if self.modes:
                    with counted(b, self.modes, "shown_mode") as k:
                        i = b.add(k, whole(loop.size - self.modes))
                        store(b, loop.load(end, i), target, i)

    def _find_terms(self, start: str, end: str) -> None:
        """Coefficients of the powers of the time from the end over h; the last makes the polynomial meet the start."""
        b, n = self.b, self.loop.size
        with counted(b, n, "component") as i:
            missing = self.loop.local("missing")
            b.store(b.fsub(load(b, self.loop.array[start], i), load(b, self.loop.array[end], i)), missing)
            with counted(b, self.rows - 1, "order") as k:
                order = b.add(k, whole(1))
                total = self.paired.weighted(self.table, k, i)
                store(b, total, self.terms, b.add(b.mul(order, whole(n)), i))
                b.store(b.fsub(b.load(missing, typ=F64), b.fmul(self._sign(order), total)), missing)
            last = b.fmul(self._sign(whole(self.rows)), b.load(missing, typ=F64))
            store(b, last, self.terms, b.add(whole(self.rows * n), i))

    def _sign(self, power: Any) -> Any:
        """(-1)^power."""
        odd = self.b.trunc(power, ir.IntType(1))
        return self.b.select(odd, number(-1.0), number(1.0))

    def _value(self, end: str, i: Any, back: Any) -> Any:
        """Horner's scheme from the highest power down."""
        b, n = self.b, self.loop.size
        total = self.loop.local("horner")
        b.store(number(0.0), total)
        with counted(b, self.rows, "power") as k:
            term = load(b, self.terms, b.add(b.mul(b.sub(whole(self.rows), k), whole(n)), i))
            b.store(b.fmul(back, b.fadd(b.load(total, typ=F64), term)), total)
        return b.fadd(load(b, self.loop.array[end], i), b.load(total, typ=F64))
