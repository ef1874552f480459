"""Dense output of extrapolated steps: a polynomial through both ends, with the derivatives at the right one.

Backward differences of a row of j steps, over (h/j)^k, tend to the k-th derivative at the end with an expansion in
1/j; they are extrapolated like the states: E. Hairer, A. Ostermann, Numer. Math. 58 (1990) 419-439. The error of the
polynomial of degree k is of the order of that of a step of k rows. All of it is sums of the rows' states with weights.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from llvmlite import ir

from tmodes.compile.ir.emit import F64, counted, load, number, store, whole
from tmodes.compile.loops.extrapolation_rows import PairedRows, constants
from tmodes.compile.loops.tableau import difference_weights, spread_weights
from tmodes.compile.loops.time_loop import TimeLoop

__all__ = ["DenseOutput"]


class DenseOutput:
    """Gives the motion between both ends of a step, by the states of all rows."""

    def __init__(self, loop: TimeLoop, paired: PairedRows) -> None:
        self.loop, self.paired, self.rows, self.b = loop, paired, paired.rows, loop.builder
        with self.b.goto_entry_block():
            self.terms = self.b.alloca(F64, size=whole((self.rows + 1) * loop.size), name="terms")
        lines = [spread_weights(difference_weights(self.rows, order), self.rows) for order in range(1, self.rows)]
        self.table = constants(loop, "differences", np.stack(lines))

    def write_samples(self, start: str, end: str, h: Any, time_after: Any) -> None:
        """Write the samples of a step that went from array ``start`` to ``end``."""
        b, loop = self.b, self.loop
        with b.if_then(loop.sample_due(time_after)):
            self._find_terms(start, end)
            with loop.due_samples(time_after) as target:
                back = b.fdiv(b.fsub(loop.sample_time(), time_after), h)
                with counted(b, loop.size, "value") as i:
                    store(b, self._value(end, i, back), target, i)

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
