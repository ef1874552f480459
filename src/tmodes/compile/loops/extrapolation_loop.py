"""Extrapolated linearly implicit Euler steps, adaptive, as a native loop: for stiff arms.

Row j of the tableau takes j such steps over the whole length; the rows' ends are combined to order 6, so that what
vibrates without damping does not grow. E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, section IV.9
(SEULEX, n_j = j); P. Deuflhard, SIAM Review 27 (1985) 505-535. No Jacobian is needed. The eight rows are taken side by
side in nine passes of four, which is why there is no choice of order: fewer rows would hardly take less.
"""

from __future__ import annotations

from typing import Any

from tmodes.compile.ir.emit import counted, number, whole
from tmodes.compile.loops.extrapolation_dense import DenseOutput
from tmodes.compile.loops.extrapolation_rows import PairedRows, constants
from tmodes.compile.loops.gate import Gate
from tmodes.compile.loops.motion_norm import MotionNorm
from tmodes.compile.loops.rows_rate import RowsRate
from tmodes.compile.loops.step_control import ImplicitControl, add_local_errors
from tmodes.compile.loops.tableau import limit_weights, spread_weights, steady_weights
from tmodes.compile.loops.time_loop import AdaptiveStep, TimeLoop

__all__ = ["ROWS", "write_extrapolation_loop"]

ROWS = 8
"""Rows of the tableau."""

_CAUTION = 2.0
"""What the local error is taken times: vibrations that hardly decay gather those of all steps."""

_CONTROL = ImplicitControl(exponent=1.0 / (ROWS - 1), smallest=0.1, first=1e-4)
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
        self.norm, self.gate = MotionNorm(loop, pairs), Gate(loop)
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
        step = _CONTROL.begin(loop)
        self.paired.take(step.time, step.h)
        with counted(b, loop.size, "combined") as i:
            for label, table in self.tables.items():
                loop.store(self.paired.weighted(table, whole(0), i), label, i)
        error = self.norm.of_error(lambda i: loop.load("apart", i), "new", "y", step.h)
        grown = _CONTROL.judge(loop, step, b.fmul(error, number(_CAUTION)))
        self._accept(step, grown)

    def _accept(self, step: AdaptiveStep, grown: Any) -> None:
        loop = self.loop
        if self.gate.exists:
            loop.evaluate(step.time_after, "new", "slope")
            loop.add("passes", 1.0)
            self.gate.meet(step.h)
        add_local_errors(loop, "apart", number(1.0))
        self.dense.write_samples("y", "new", step.h, step.time_after)
        loop.take(step, grown)
        self.b.branch(loop.again)
