"""The rows of a tableau of linearly implicit Euler steps, side by side in the lanes of vectors.

A step takes springs, dampers and servos at its end, through h D + h^2 K inside the recursion, and all else where it is
expected to end, at q + h v. With the geometry left at the start instead, what is not in h D + h^2 K excites the stiff
modes a little in every step, as in W-methods (T. Steihaug, A. Wolfbrandt, Math. Comp. 33 (1979) 521-534), and
extrapolation loses its order: by a factor of 20 in the error of 8 rows over 1 ms on the benchmarks' stiff arm.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from llvmlite import ir
from numpy.typing import ArrayLike

from tmodes.compile.ir.arithmetic import Lanes
from tmodes.compile.ir.emit import F64, POINTER, at, counted, whole
from tmodes.compile.loops.rows_rate import RowsRate
from tmodes.compile.loops.tableau import LANES, passes_of, schedule_of
from tmodes.compile.loops.time_loop import TimeLoop

__all__ = ["PairedRows", "constants"]

_LINE = 64


def constants(loop: TimeLoop, name: str, numbers: ArrayLike) -> Any:
    """The address of constant numbers; the name serves once in a loop."""
    info = np.ravel(numbers).tolist()
    kind = ir.ArrayType(F64, len(info))
    table: Any = ir.GlobalVariable(loop.module, kind, f"{loop.function.name}.{name}")
    table.global_constant, table.linkage, table.align = True, "internal", _LINE
    table.initializer = ir.Constant(kind, info)
    return loop.builder.bitcast(table, POINTER)


class PairedRows:
    """Takes all steps of a tableau and keeps their states.

    Slot 0 of what is kept holds the start in all lanes, slot p + 1 the states after pass p.
    """

    def __init__(self, loop: TimeLoop, rate: RowsRate, pairs: int, rows: int) -> None:
        self.loop, self.rate, self.pairs, self.b = loop, rate, pairs, loop.builder
        self.lanes, self.rows, self.slots = Lanes(loop.module), rows, 1 + passes_of(rows)
        with self.b.goto_entry_block():
            self.kept = self._vectors(self.slots * loop.size, "kept")
            self.slope = self._vectors(loop.size, "slopes")
        loop.array["held"].align = _LINE
        self.tables = {label: constants(loop, label, table) for label, table in self._info().items()}

    def _vectors(self, count: int, name: str) -> Any:
        place: Any = self.b.alloca(F64, size=whole(count * LANES), name=name)
        place.align = _LINE
        return place

    def _info(self) -> dict[str, Any]:
        """By pass and lane: what h is divided by, where a step ends, if a row begins; idle lanes take steps of 0."""
        info = {"lengths": np.inf, "times": 1.0, "begins": 0.0}
        tables = {label: np.full((self.slots, LANES), value) for label, value in info.items()}
        for row, step, pass_, lane in schedule_of(self.rows):
            for label, value in zip(info, (row, (step + 1) / row, step == 0), strict=True):
                tables[label][pass_, lane] = value
        return tables

    def take(self, time: Any, h: Any) -> None:
        """All steps of all rows over h from the array ``y``."""
        b, lanes, loop, passes = self.b, self.lanes, self.loop, self.slots - 1
        with counted(b, loop.size, "start") as i:
            lanes.store(b, lanes.spread(b, loop.load("y", i)), self._vector(self.kept, i), 0)
        wide_h, wide_time = lanes.spread(b, h), lanes.spread(b, time)
        with counted(b, passes, "pass") as p:
            length, share, begins = (self._at(table, p) for table in self.tables.values())
            step, end = b.fdiv(wide_h, length), b.fadd(wide_time, b.fmul(wide_h, share))
            self._expect(p, step, b.fcmp_ordered("!=", begins, lanes.constant(0.0)))
            b.call(self.rate.call_rows, [end, step, loop.row(), loop.array["held"], self.slope])
            self._advance(p, step)
        loop.add("evaluations", float(len(schedule_of(self.rows))))
        loop.add("passes", float(passes))

    def _expect(self, p: Any, step: Any, begins: Any) -> None:
        """What the recursion reads: where steps are expected to end, and the same for springs to start from."""
        b, n = self.b, self.pairs
        moved, start = (
            at(b, self.loop.array["held"], offset) for offset in (self.rate.state_offset, self.rate.start_offset)
        )
        with counted(b, n, "expect") as i:
            paired = b.add(i, whole(n))
            place, rate = (self._begun(p, k, begins) for k in (i, paired))
            self._put([(moved, paired), (start, paired)], rate)
            self._put([(moved, i), (start, i)], b.fadd(place, b.fmul(step, rate)))
        with counted(b, self.loop.size - 2 * n, "others") as i:
            other = b.add(i, whole(2 * n))
            self._put([(moved, other)], self._begun(p, other, begins))

    def _begun(self, p: Any, i: Any, begins: Any) -> Any:
        """Component i before a pass, the start's where a row begins; kept where the pass will find it."""
        before = self._kept(p, i)
        value = self.b.select(begins, self._kept(whole(0), i), before)
        self.lanes.store(self.b, value, self._place(self.b.add(p, whole(1)), i), 0)
        return value

    def _advance(self, p: Any, step: Any) -> None:
        """v+ = v + h a, q+ = q + h v+; what follows them explicit."""
        b, n, after = self.b, self.pairs, self.b.add(p, whole(1))

        def moved(i: Any, slope: Any) -> Any:
            value = b.fadd(self._kept(after, i), b.fmul(step, slope))
            self.lanes.store(b, value, self._place(after, i), 0)
            return value

        with counted(b, n, "pair") as i:
            paired = b.add(i, whole(n))
            moved(i, moved(paired, self._at(self.slope, paired)))
        with counted(b, self.loop.size - 2 * n, "rest") as i:
            other = b.add(i, whole(2 * n))
            moved(other, self._at(self.slope, other))

    def weighted(self, table: Any, line: Any, i: Any) -> Any:
        """Sum of all kept states' component i with the weights of a line of a table (slots of lanes each)."""
        b, lanes = self.b, self.lanes
        with b.goto_entry_block():
            total = b.alloca(lanes.kind, name="weighted")
        b.store(lanes.constant(0.0), total)
        first = b.mul(line, whole(self.slots))
        with counted(b, self.slots, "slot") as slot:
            term = b.fmul(self._at(table, b.add(first, slot)), self._kept(slot, i))
            b.store(b.fadd(b.load(total, typ=lanes.kind), term), total)
        found = b.load(total, typ=lanes.kind)
        parts = [b.extract_element(found, whole(lane)) for lane in range(LANES)]
        return b.fadd(b.fadd(parts[0], parts[1]), b.fadd(parts[2], parts[3]))

    def _vector(self, base: Any, index: Any) -> Any:
        return at(self.b, base, self.b.mul(index, whole(LANES)))

    def _at(self, base: Any, index: Any) -> Any:
        return self.lanes.load(self.b, self._vector(base, index), 0)

    def _place(self, slot: Any, i: Any) -> Any:
        return self._vector(self.kept, self.b.add(self.b.mul(slot, whole(self.loop.size)), i))

    def _kept(self, slot: Any, i: Any) -> Any:
        return self.lanes.load(self.b, self._place(slot, i), 0)

    def _put(self, places: Iterable[tuple[Any, Any]], value: Any) -> None:
        for base, index in places:
            self.lanes.store(self.b, value, self._vector(base, index), 0)
