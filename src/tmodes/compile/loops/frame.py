"""What the native time loops of single runs and of lanes share: cells, arrays of numbers, and sums over them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from tmodes.compile.ir.arithmetic import Double
from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.emit import VOID, Builder, at, counted, declare, whole

__all__ = ["Frame", "MotionNorm"]


class Frame:
    """The function of a loop. ``guarded``: how many first components of the state are watched for divergence."""

    def __init__(
        self, name: str, rate: ScheduleRate, numbers: Double, arguments: Sequence[tuple[str, Any]], guarded: int
    ) -> None:
        self.module, self.rate, self.numbers, self.guarded = numbers.module, rate, numbers, guarded
        self.size = rate.size
        self.function = declare(self.module, name, VOID, [*arguments])
        labels = [label for label, _ in arguments]
        self.argument: dict[str, Any] = dict(zip(labels, self.function.args, strict=True))
        self.builder: Any = Builder(self.function.append_basic_block("entry"))
        self.cell: dict[str, Any] = {}
        self.array: dict[str, Any] = {"y": self.argument["y"], "k1": self.argument["k1"]}

    def block(self, name: str) -> Any:
        """A new basic block."""
        return self.function.append_basic_block(name)

    def local(self, name: str) -> Any:
        """A number on the stack of the function."""
        with self.builder.goto_entry_block():
            return self.builder.alloca(self.numbers.kind, name=name)

    def constant(self, value: float) -> Any:
        """A number known beforehand."""
        return self.numbers.constant(value)

    def get(self, label: str) -> Any:
        """Value of a cell."""
        return self.builder.load(self.cell[label], typ=self.numbers.kind)

    def intrinsic(self, name: str, *values: Any) -> Any:
        """Call of an LLVM intrinsic."""
        return self.numbers.call(self.builder, name, *values)

    def load(self, label: str, i: Any) -> Any:
        """Component i of an array."""
        return self.builder.load(self._component(label, i), typ=self.numbers.kind, align=8)

    def store(self, value: Any, label: str, i: Any) -> None:
        """Set component i of an array."""
        self.builder.store(value, self._component(label, i), align=8)

    def _component(self, label: str, i: Any) -> Any:
        stride = self.numbers.stride
        index = i if stride == 1 else self.builder.mul(i, whole(stride))
        return self.builder.bitcast(at(self.builder, self.array[label], index), self.numbers.kind.as_pointer())

    def call(self, rate: ScheduleRate, time: Any, state: str, into: str, held: str = "held") -> None:
        """A function of time, state and row at a state array, into an array; ``held``: its memory."""
        arrays = (self.array[state], self.row(), self.array[held], self.array[into])
        self.builder.call(rate.call, [time, *arrays])

    def combine(self, into: str, weights: dict[str, Any], base: str = "y") -> None:
        """``into = base + sum weights[a] a`` for whole arrays."""
        b = self.builder
        with counted(b, self.size) as i:
            total = self.load(base, i)
            for label, weight in weights.items():
                term = b.fmul(weight, self.load(label, i), flags=("contract",))
                total = b.fadd(total, term, flags=("contract",))
            self.store(total, into, i)

    def weighted(self, weights: dict[str, Any], i: Any) -> Any:
        """The weighted sum of components i of arrays; a weight None counts as 1."""
        b, value = self.builder, None
        for label, weight in weights.items():
            term = self.load(label, i) if weight is None else b.fmul(weight, self.load(label, i))
            value = term if value is None else b.fadd(value, term)
        return value

    def within_bounds(self, label: str) -> Any:
        """Whether every guarded component is finite and below the bound (not-a-number is not)."""
        b, good, bound = self.builder, None, self.option("bound")
        for i in range(self.guarded):
            below = b.fcmp_ordered("<", self.intrinsic("fabs", self.load(label, whole(i))), bound)
            good = below if good is None else b.and_(good, below)
        return good

    def mean_square(self, value_of: Callable[[Any], Any], *states: str) -> Any:
        """Root of the mean square of ``value_of(i)`` over atol + rtol times the larger of the states' components."""
        b, total = self.builder, self.cell["total"]
        absolute, relative = self.option("atol"), self.option("rtol")
        b.store(self.constant(0.0), total)
        with counted(b, self.size) as i:
            sizes = [self.intrinsic("fabs", self.load(state, i)) for state in states]
            largest = sizes[0] if len(sizes) == 1 else self.intrinsic("maxnum", *sizes)
            ratio = b.fdiv(value_of(i), b.fadd(absolute, b.fmul(relative, largest)))
            b.store(b.fadd(self.get("total"), b.fmul(ratio, ratio)), total)
        return self.intrinsic("sqrt", b.fdiv(self.get("total"), self.constant(float(self.size))))

    def evaluate(self, time: Any, state: str, into: str) -> None:
        """Right-hand side at a state array, into an array."""
        raise NotImplementedError

    def row(self) -> Any:
        """Address of the row of the present segment of the input."""
        raise NotImplementedError

    def option(self, label: str) -> Any:
        """Value of an option."""
        raise NotImplementedError

    def segment(self) -> tuple[Any, Any]:
        """Times at which the present segment of the input starts and ends."""
        raise NotImplementedError


class MotionNorm:
    """Writes the norm for a state of ``pairs`` coordinates, as many rates, and more behind them."""

    def __init__(self, loop: Frame, pairs: int) -> None:
        self.loop, self.pairs, self.b = loop, pairs, loop.builder
        self.total, self.largest, self.zero = loop.local("norm"), loop.local("largest"), loop.constant(0.0)

    def of_difference(self, one: str, other: str, before: str, h: Any) -> Any:
        """Norm of ``one`` - ``other``; scales of ``one`` and ``before``."""
        load = self.loop.load
        return self.of_error(lambda i: self.b.fsub(load(one, i), load(other, i)), one, before, h)

    def of_error(self, error: Callable[[Any], Any], one: str, before: str, h: Any) -> Any:
        """Root of the mean square of ``error(i)`` over the tolerance; scales of ``one`` and ``before``.

        What stands behind the rates (works, currents) is measured by the largest among it.
        """
        b, n, rest = self.b, self.pairs, self.loop.size - 2 * self.pairs
        b.store(self.zero, self.total)
        self._add_pairs(error, one, before, h)
        b.store(self.zero, self.largest)
        with counted(b, rest, "size") as i:
            size = self._size(b.add(i, whole(2 * n)), one, before)
            b.store(self.loop.intrinsic("maxnum", self._now(self.largest), size), self.largest)
        with counted(b, rest, "rest") as i:
            self._add(b.fdiv(error(b.add(i, whole(2 * n))), self._scale(self._now(self.largest))))
        mean = b.fdiv(self._now(self.total), self.loop.constant(float(max(self.loop.size, 1))))
        return self.loop.intrinsic("sqrt", mean)

    def _add_pairs(self, error: Callable[[Any], Any], one: str, before: str, h: Any) -> None:
        """Of a rate what counts less: its own error, or what it moves the coordinate by in a step."""
        b = self.b
        with counted(b, self.pairs, "pair") as i:
            paired = b.add(i, whole(self.pairs))
            scale = self._scale(self._size(i, one, before))
            self._add(b.fdiv(error(i), scale))
            rate = error(paired)
            shares = [b.fdiv(b.fmul(h, rate), scale), b.fdiv(rate, self._scale(self._size(paired, one, before)))]
            self._add(self.loop.intrinsic("minnum", *(self.loop.intrinsic("fabs", share) for share in shares)))

    def _size(self, i: Any, one: str, before: str) -> Any:
        return self.loop.intrinsic(
            "maxnum", *(self.loop.intrinsic("fabs", self.loop.load(a, i)) for a in (one, before))
        )

    def _scale(self, size: Any) -> Any:
        return self.b.fadd(self.loop.option("atol"), self.b.fmul(self.loop.option("rtol"), size))

    def _add(self, ratio: Any) -> None:
        term = self.b.fmul(ratio, ratio)
        self.b.store(self.b.fadd(self._now(self.total), term), self.total)

    def _now(self, local: Any) -> Any:
        return self.b.load(local, typ=self.loop.numbers.kind)
