"""Extrapolated linearly implicit Euler steps, adaptive, as a native loop: for stiff arms.

Row j of the tableau takes j such steps over the whole length; the rows' ends are combined to order 6, so that what
vibrates without damping does not grow. E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, section IV.9
(SEULEX, n_j = j); P. Deuflhard, SIAM Review 27 (1985) 505-535. No Jacobian is needed. The eight rows are taken side by
side in nine passes of four, which is why there is no choice of order: fewer rows would hardly take less.
"""

from __future__ import annotations

from typing import Any

from tmodes.compile.ir.emit import F64, counted, load, number, store, whole
from tmodes.compile.loops.extrapolation_dense import DenseOutput
from tmodes.compile.loops.extrapolation_rows import PairedRows, constants
from tmodes.compile.loops.gate import Gate
from tmodes.compile.loops.motion_norm import MotionNorm
from tmodes.compile.loops.rows_rate import RowsRate
from tmodes.compile.loops.step_control import add_local_errors, power
from tmodes.compile.loops.tableau import limit_weights, spread_weights, steady_weights
from tmodes.compile.loops.time_loop import Status, TimeLoop

__all__ = ["ROWS", "write_extrapolation_loop"]

ROWS = 8
"""Rows of the tableau."""

_FIRST_STEP = 1e-4
_SAFETY, _SMALLEST, _LARGEST = 0.9, 0.1, 6.0
_CAUTION = 2.0
"""What the local error is taken times: vibrations that hardly decay gather those of all steps."""

_EXPONENT = 1.0 / (ROWS - 1)
"""The local error, by which the combination of order 6 differs from the limit of order 8, goes with h^7."""


def write_extrapolation_loop(module: Any, name: str, rate: RowsRate, guarded: int, *, pairs: int) -> None:
    """Write the loop; steps end on knots, samples are interpolated.

    The state begins with ``pairs`` coordinates and as many rates; what follows takes explicit Euler steps.
    """
    loop = TimeLoop(module, name, rate, ("slope", "new", "apart"), guarded)
    _Writer(loop, rate, pairs).write()


class _Writer:
    """Writes the body of the loop."""

    def __init__(self, loop: TimeLoop, rate: RowsRate, pairs: int) -> None:
        self.loop, self.b = loop, loop.builder
        self.paired = PairedRows(loop, rate, pairs, ROWS)
        self.norm, self.gate = MotionNorm(loop, pairs), Gate(loop, rate.gate_offset)
        self.dense = DenseOutput(loop, self.paired)
        steady, limit = steady_weights(), limit_weights(ROWS)
        weights = {"new": steady, "apart": {row: steady[row] - limit[row] for row in limit}}
        self.tables = {label: self._table(label, info) for label, info in weights.items()}

    def _table(self, label: str, weights: dict[int, float]) -> Any:
        """Weights of the ends of rows."""
        return constants(self.loop, label, spread_weights({(row, row): w for row, w in weights.items()}, ROWS))

    def write(self) -> None:
        """One attempt of a step, from the block ``again`` back to it."""
        loop, b = self.loop, self.b
        self.gate.begin("y", "slope")
        with b.if_then(b.fcmp_ordered("<=", loop.get("h"), number(0.0)), likely=False):
            loop.put("h", loop.intrinsic("minnum", number(_FIRST_STEP), b.fsub(loop.knot(1), loop.knot(0))))
        time, wanted = loop.get("t"), loop.get("h")
        h, last, time_after = loop.step_until(loop.knot(1))
        self.paired.take(time, h)
        with counted(b, loop.size, "combined") as i:
            for label, table in self.tables.items():
                store(b, self.paired.weighted(table, whole(0), i), loop.array[label], i)
        error = self.norm.of_error(lambda i: load(b, loop.array["apart"], i), "new", "y", h)
        loop.add("done", 1.0)
        error = b.fmul(error, number(_CAUTION))
        # An error that is no number must stay one: the step is then shortened most.
        floor = b.select(b.fcmp_ordered("<", error, number(1e-10)), number(1e-10), error)
        factor = b.fdiv(number(_SAFETY), power(loop, floor, _EXPONENT))
        accepted, rejected = loop.block("accepted"), loop.block("rejected")
        b.cbranch(b.fcmp_ordered("<=", error, number(1.0)), accepted, rejected)
        b.position_at_end(rejected)
        loop.reject(h, factor, _SMALLEST)
        b.position_at_end(accepted)
        self._accept(h, wanted, factor, last, time_after)

    def _accept(self, h: Any, wanted: Any, factor: Any, last: Any, time_after: Any) -> None:
        loop, b = self.loop, self.b
        loop.stop_if(b.not_(loop.within_bounds("new")), Status.DIVERGED)
        if self.gate.offset is not None:
            loop.evaluate(time_after, "new", "slope")
            loop.add("passes", 1.0)
            self.gate.meet(h)
        add_local_errors(loop, "apart", number(1.0))
        self.dense.write_samples("y", "new", h, time_after)
        loop.copy("y", "new")
        grown = b.fmul(h, loop.intrinsic("minnum", factor, number(_LARGEST)))
        # A step cut short by a knot says little about the next: keep the longer wish.
        loop.put("h", b.select(last, loop.intrinsic("maxnum", grown, wanted), grown))
        loop.put("t", time_after)
        loop.put("segment", b.fadd(loop.get("segment"), b.uitofp(last, F64)))
        loop.count_step(h, last)
        b.branch(loop.again)
