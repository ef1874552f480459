"""Series of a case on a GPU: after each launch, of the samples that it wrote; kept, or reduced at once to a few sums.

The samples stay in the memory of the GPU. What a series is reduced to is stated once, for runs side by side.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from llvmlite import ir

from tmodes.compile.ir.arithmetic import Double
from tmodes.compile.ir.block import write_rate
from tmodes.compile.ir.emit import F64, I64, at, counted, load, scratch, store, whole
from tmodes.compile.lanes.series import SUMS, fold
from tmodes.compile.native import kernel_symbol, pays
from tmodes.compile.wasm.wasm_parts import PIECE, kernel_in_pieces

__all__ = ["CaseSeries", "SeriesWriter", "kernels_of_series"]


@dataclass(frozen=True, eq=False)
class CaseSeries:
    """A schedule of (time, state and ``given`` numbers, row), whose outputs are the series; ``folds``: reduced."""

    schedule: Any
    given: int
    folds: bool

    @property
    def count(self) -> int:
        """How many series."""
        return self.schedule.output_size

    @property
    def key(self) -> str:
        """What identifies the code."""
        return f"{self.schedule.key} {self.given} {self.folds}"

    def numbers(self, samples: int) -> int:
        """Numbers that a case comes to."""
        return self.count * (len(SUMS) if self.folds else samples)


def kernels_of_series(series: CaseSeries | None) -> dict[str, Any]:
    """The modules of all kernels that the series call, by symbol."""
    if series is None or pays(series.schedule):
        return {}
    kernels = {kernel_symbol(kernel, Double.name): kernel for kernel, _, _ in series.schedule.calls}
    return {symbol: kernel_in_pieces(kernel, Double.name, PIECE) for symbol, kernel in kernels.items()}


class SeriesWriter:
    """Writes the code at the end of the function of a case; make it where that begins, for its arrays."""

    def __init__(self, series: CaseSeries, builder: Any, argument: dict[str, Any], size: int) -> None:
        """``argument``: those of the case's function; ``size``: of a state."""
        self.series, self.builder, self.argument, self.size = series, builder, argument, size
        module = builder.function.module
        self.rate = write_rate(module, series.schedule, Double(module), "shown")
        sizes = {"shown": size + series.given, "showing": self.rate.held_size, "series": series.count}
        self.own = {label: scratch(builder, count, label) for label, count in sizes.items()}
        self.piece = builder.alloca(I64, name="piece")

    def write(self, case: Any, given: dict[str, Any], piece: Any, first: Any, last: Any) -> None:
        """Take samples ``first`` to ``last`` (int64, exclusive) of a case whose loop began in a ``piece`` of its input.

        ``given``: arguments of its loop.
        """
        b = self.builder
        b.store(piece, self.piece)
        self.case, self.given = case, given
        count = b.sub(last, first)
        with b.if_then(b.icmp_signed(">", count, whole(0))):
            b.call(self.rate.prepare, [given["p"], self.own["showing"]])
            with counted(b, count, "sample") as i:
                self._sample(b.add(first, i))

    def _sample(self, sample: Any) -> None:
        b, time = self.builder, load(self.builder, self.given["times"], sample)
        self._find(time)
        with counted(b, self.size) as i:
            store(b, load(b, self.given["out"], b.add(b.mul(sample, whole(self.size)), i)), self.own["shown"], i)
        table = b.add(b.mul(self.case, self.argument["table_stride"]), b.mul(sample, whole(self.series.given)))
        with counted(b, self.series.given) as i:
            value = load(b, self.argument["table"], b.add(table, i))
            store(b, value, self.own["shown"], b.add(i, whole(self.size)))
        row = at(b, self.given["rows"], b.mul(b.load(self.piece, typ=I64), whole(self.rate.row)))
        b.call(self.rate.call, [time, self.own["shown"], row, self.own["showing"], self.own["series"]])
        if self.series.folds:
            weight, always = load(b, self.argument["weights"], sample), ir.Constant(ir.IntType(1), 1)
            with counted(b, self.series.count, "series") as i:
                fold(self, i, always, time, weight)
            return
        rows = b.add(b.mul(self.case, self.argument["samples"]), sample)
        with counted(b, self.series.count, "series") as i:
            place = b.add(b.mul(rows, whole(self.series.count)), i)
            store(b, self.load("series", i), self.argument["series"], place)

    def _find(self, time: Any) -> None:
        """The piece of the input at a time: at a knot the one that begins there, but for the last."""
        b = self.builder
        check, step, found = (b.function.append_basic_block(f"piece_{name}") for name in ("check", "step", "found"))
        b.branch(check)
        b.position_at_end(check)
        after = b.add(b.load(self.piece, typ=I64), whole(1))
        left = b.icmp_signed("<", after, self.given["segments"])
        place = b.select(left, after, whole(0))
        b.cbranch(b.and_(left, b.fcmp_ordered("<=", load(b, self.given["knots"], place), time)), step, found)
        b.position_at_end(step)
        b.store(after, self.piece)
        b.branch(check)
        b.position_at_end(found)

    def load(self, label: str, i: Any) -> Any:
        """A number of the series, or of the sums, which are in global memory."""
        return self.builder.load(self._place(label, i), typ=F64)

    def store(self, value: Any, label: str, i: Any) -> None:
        """Keep a sum."""
        self.builder.store(value, self._place(label, i))

    def _place(self, label: str, i: Any) -> Any:
        b = self.builder
        if label != "sums":
            return at(b, self.own[label], i)
        return at(b, self.argument["series"], b.add(b.mul(i, self.argument["cases"]), self.case))
