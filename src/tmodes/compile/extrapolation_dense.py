"""Dense output of extrapolated steps: a polynomial through both ends, with the derivatives at the right one.

Backward differences of a row of j steps, over (h/j)^k, tend to the k-th derivative at the end with an expansion in
1/j; they are extrapolated like the states: E. Hairer, A. Ostermann, Numer. Math. 58 (1990) 419-439. The error of the
polynomial of degree k is of the order of that of a step of k rows. All of it is sums of the rows' states with weights.
"""

from __future__ import annotations

from math import comb, factorial, prod
from typing import Any

from llvmlite import ir

from tmodes.compile.emit import F64, POINTER, counted, load, number, store, whole
from tmodes.compile.time_loop import TimeLoop

__all__ = ["DenseOutput", "difference_weights"]


def difference_weights(rows: int, order: int) -> list[float]:
    """Weights of the states of ``rows`` rows in the derivative of this order at the end, times h^order / order!.

    First the state at the start, then row by row its states after each step: 1 + rows (rows + 1)/2 numbers.
    """
    weights = [0.0] * (1 + rows * (rows + 1) // 2)
    used = range(order, rows + 1)
    for row in used:
        share = prod(row / (row - other) for other in used if other != row) * row**order / factorial(order)
        for back in range(order + 1):
            stage = row - back
            weights[row * (row - 1) // 2 + stage if stage else 0] += share * (-1) ** back * comb(order, back)
    return weights


class DenseOutput:
    """Keeps the states of all rows of a loop, and gives the motion between both ends of a step."""

    def __init__(self, loop: TimeLoop, rows: int) -> None:
        self.loop, self.rows, self.b = loop, rows, loop.builder
        self.count = 1 + rows * (rows + 1) // 2
        with self.b.goto_entry_block():
            self.states = self.b.alloca(F64, size=whole(self.count * loop.size), name="states")
            self.terms = self.b.alloca(F64, size=whole((rows + 1) * loop.size), name="terms")
        self.table = self._table()

    def _table(self) -> Any:
        """Weights of all states for each number of rows and each derivative, as one constant array."""
        numbers: list[float] = []
        for rows in range(self.rows + 1):
            for order in range(self.rows + 1):
                told = difference_weights(rows, order) if 1 <= order < rows else []
                numbers += told + [0.0] * (self.count - len(told))
        kind = ir.ArrayType(F64, len(numbers))
        table: Any = ir.GlobalVariable(self.loop.module, kind, f"{self.loop.function.name}.differences")
        table.global_constant, table.linkage = True, "internal"
        table.initializer = ir.Constant(kind, numbers)
        return self.b.bitcast(table, POINTER)

    def keep(self, stage: Any, label: str) -> None:
        """Keep an array of the loop as a state; 0 is the start, row r begins after r (r - 1)/2."""
        first = self.b.mul(stage, whole(self.loop.size))
        with counted(self.b, self.loop.size, "keep") as i:
            store(self.b, load(self.b, self.loop.array[label], i), self.states, self.b.add(first, i))

    def write_samples(self, start: str, end: str, h: Any, time_after: Any, rows: Any) -> None:
        """Write the samples of a step of so many ``rows`` (int64) that went from array ``start`` to ``end``."""
        b, loop = self.b, self.loop
        with b.if_then(loop.sample_due(time_after)):
            self._find_terms(start, end, rows)
            with loop.due_samples(time_after) as target:
                back = b.fdiv(b.fsub(loop.sample_time(), time_after), h)
                with counted(b, loop.size, "value") as i:
                    store(b, self._value(end, i, back, rows), target, i)

    def _find_terms(self, start: str, end: str, rows: Any) -> None:
        """Coefficients of the powers of the time from the end over h; the last makes the polynomial meet the start."""
        b, n = self.b, self.loop.size
        places = b.add(b.sdiv(b.mul(rows, b.add(rows, whole(1))), whole(2)), whole(1))
        orders = b.sub(rows, whole(1))
        with counted(b, n, "component") as i:
            missing = self.loop.local("missing")
            b.store(b.fsub(load(b, self.loop.array[start], i), load(b, self.loop.array[end], i)), missing)
            with counted(b, orders, "order") as k:
                order = b.add(k, whole(1))
                total = self._weighted(i, order, rows, places)
                store(b, total, self.terms, b.add(b.mul(order, whole(n)), i))
                b.store(b.fsub(b.load(missing, typ=F64), b.fmul(self._sign(order), total)), missing)
            last = b.fmul(self._sign(rows), b.load(missing, typ=F64))
            store(b, last, self.terms, b.add(b.mul(rows, whole(n)), i))

    def _weighted(self, i: Any, order: Any, rows: Any, places: Any) -> Any:
        b, n = self.b, self.loop.size
        total = self.loop.local("total")
        b.store(number(0.0), total)
        line = b.mul(b.add(b.mul(rows, whole(self.rows + 1)), order), whole(self.count))
        with counted(b, places, "state") as k:
            weight = load(b, self.table, b.add(line, k))
            term = b.fmul(weight, load(b, self.states, b.add(b.mul(k, whole(n)), i)))
            b.store(b.fadd(b.load(total, typ=F64), term), total)
        return b.load(total, typ=F64)

    def _sign(self, power: Any) -> Any:
        """(-1)^power."""
        odd = self.b.trunc(power, ir.IntType(1))
        return self.b.select(odd, number(-1.0), number(1.0))

    def _value(self, end: str, i: Any, back: Any, rows: Any) -> Any:
        """Horner's scheme from the highest power down."""
        b, n = self.b, self.loop.size
        total = self.loop.local("horner")
        b.store(number(0.0), total)
        with counted(b, rows, "power") as k:
            term = load(b, self.terms, b.add(b.mul(b.sub(rows, k), whole(n)), i))
            b.store(b.fmul(back, b.fadd(b.load(total, typ=F64), term)), total)
        return b.fadd(load(b, self.loop.array[end], i), b.load(total, typ=F64))
