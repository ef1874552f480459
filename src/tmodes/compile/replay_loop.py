"""Native loops over the recorded steps of an explicit Runge-Kutta run: once more, along directions, and in reverse.

A step is a list of combinations and evaluations, whose tableau is data: one piece of code serves every such method and
every robot, whose evaluations are tables of rows. Discrete adjoints of Runge-Kutta methods: W. W. Hager, Numerische
Mathematik 87 (2000) 247-282.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from functools import cache
from typing import Any

from llvmlite import ir

from tmodes.compile.emit import I64, POINTER, VOID, at, counted, declare, load, number, store, whole
from tmodes.compile.kernels import native_functions
from tmodes.compile.native import Library
from tmodes.compile.tape_loop import WORDS, write_run

__all__ = ["ARRAYS", "COUNTS", "replay_loops"]

COUNTS = (
    "steps", "size", "row", "stages", "values", "time_at", "state_at", "row_at", "out_at", "lanes", "slopes_out_at",
    "forward_rows", "other_rows",
)  # fmt: skip
"""Numbers of a replay: steps, numbers of a state and of a row, stages, numbers of one stage's values; where the time,
the state, the row and the rates stand among them, and the rates' slopes among the slopes; rows of both tables."""

_WHOLE = ("counts", "segments", "used", "first_sample", "forward", "other")
_REAL = (
    "t",
    "h",
    "y",
    "rows",
    "a",
    "b",
    "c",
    "weights",
    "values",
    "slopes",
    "moved",
    "stage_slopes",
    "row_slopes",
    "samples",
)
ARRAYS = (*_WHOLE, *_REAL)
"""Arguments of each loop, all pointers.

``counts``; of each step its segment and how many stages it needs, and the first of its samples (steps + 1); the tables
of the evaluation and of its derivative. ``t``, ``h`` (steps,), ``y`` (steps + 1, size); ``rows`` of the segments; the
tableau; ``weights`` (samples, stages) of the stages in each sample. ``values`` of each stage; ``slopes``: memory of the
derivative. ``moved``: slopes or weights of the state, in and out; ``stage_slopes`` those of the stages; ``row_slopes``
those of the rows; ``samples``: states at the samples, their slopes, or their weights.
"""


@cache
def replay_loops() -> Library:
    """``again``: states after each step and at samples; ``along``: slopes of both; ``back``: weights carried back."""
    return native_functions("replay", _write, dict.fromkeys(("again", "along", "back"), len(ARRAYS)))


def _write() -> Any:
    module = ir.Module("replay")
    run = write_run(module)
    for kind in (_Again, _Along, _Back):
        kind(module, run).write()
    return module


class _Loop(ABC):
    """What the three loops share: the step, its stages, its samples."""

    name = ""

    def __init__(self, module: Any, run: Any) -> None:
        kinds = [(label, WORDS if label in _WHOLE else POINTER) for label in ARRAYS]
        function = declare(module, self.name, VOID, kinds)
        self.array: dict[str, Any] = dict(zip(ARRAYS, function.args, strict=True))
        self.run = run
        self.b: Any = ir.IRBuilder(function.append_basic_block("entry"))
        self.n = {label: self.word("counts", k) for k, label in enumerate(COUNTS)}

    def word(self, label: str, index: Any) -> Any:
        index = whole(index) if isinstance(index, int) else index
        return self.b.load(self.b.gep(self.array[label], [index], source_etype=I64), typ=I64)

    def row_of(self, label: str, index: Any, width: Any) -> Any:
        """Address of row ``index`` of an array whose rows are ``width`` numbers."""
        return at(self.b, self.array[label], self.b.mul(index, width))

    def number(self, label: str, *index: Any) -> Any:
        """A number of an array of ``stages`` columns, or of a plain one."""
        b = self.b
        place = index[0] if len(index) == 1 else b.add(b.mul(index[0], self.n["stages"]), index[1])
        return load(b, self.array[label], place)

    def write(self) -> None:
        """The loop over the steps."""
        with counted(self.b, self.n["steps"], "step") as step:
            self.step(step)
        self.b.ret_void()

    @abstractmethod
    def step(self, step: Any) -> None:
        """One step."""

    def stage(self, step: Any, i: Any) -> Any:
        """Evaluate stage i; the address of its values."""
        b, n = self.b, self.n
        values, h = self.row_of("values", i, n["values"]), self.number("h", step)
        time = b.fadd(self.number("t", step), b.fmul(self.number("c", i), h))
        store(b, time, values, n["time_at"])
        segment = self.word("segments", step)
        self.copy(at(b, values, n["row_at"]), self.row_of("rows", segment, n["row"]), n["row"])
        state = at(b, values, n["state_at"])
        self.copy(state, self.row_of("y", step, n["size"]), n["size"])
        with counted(b, i, "before") as j:
            self.more(state, b.fmul(h, self.number("a", i, j)), self.rate(j), n["size"])
        b.call(self.run, [n["forward_rows"], self.array["forward"], values, self.array["slopes"]])
        return values

    def rate(self, j: Any) -> Any:
        """Where the rates of stage j stand."""
        return at(self.b, self.row_of("values", j, self.n["values"]), self.n["out_at"])

    def samples(self, step: Any) -> Any:
        """A loop over the samples of a step; yields the number of each."""
        first = self.word("first_sample", step)
        return first, self.b.sub(self.word("first_sample", self.b.add(step, whole(1))), first)

    def copy(self, to: Any, source: Any, count: Any) -> None:
        b = self.b
        with counted(b, count, "copy") as k:
            store(b, load(b, source, k), to, k)

    def more(self, to: Any, factor: Any, source: Any, count: Any) -> None:
        """``to += factor source``, nothing where the factor is 0."""
        b = self.b
        with b.if_then(b.fcmp_unordered("!=", factor, number(0.0))), counted(b, count, "more") as k:
            term = b.fmul(factor, load(b, source, k), flags=("contract",))
            store(b, b.fadd(load(b, to, k), term, flags=("contract",)), to, k)


class _Again(_Loop):
    name = "again"

    def step(self, step: Any) -> None:
        b, size = self.b, self.n["size"]
        with counted(b, self.word("used", step), "stage") as i:
            self.stage(step, i)
        here, after = self.row_of("y", step, size), self.row_of("y", b.add(step, whole(1)), size)
        self.copy(after, here, size)
        with counted(b, self.word("used", step), "share") as j:
            self.more(after, b.fmul(self.number("h", step), self.number("b", j)), self.rate(j), size)
        first, count = self.samples(step)
        with counted(b, count, "sample") as k:
            sample = b.add(first, k)
            target = self.row_of("samples", sample, size)
            self.copy(target, here, size)
            with counted(b, self.word("used", step), "weight") as j:
                self.more(target, self.number("weights", sample, j), self.rate(j), size)


class _Along(_Loop):
    name = "along"

    def step(self, step: Any) -> None:
        b, n, h = self.b, self.n, self.number("h", step)
        wide, lanes = b.mul(n["size"], n["lanes"]), n["lanes"]
        moved, slopes = self.array["moved"], self.array["slopes"]
        row = b.mul(n["row"], lanes)
        self.copy(
            at(b, slopes, b.mul(n["row_at"], lanes)), self.row_of("row_slopes", self.word("segments", step), row), row
        )
        with counted(b, self.word("used", step), "stage") as i:
            values = self.stage(step, i)
            state = at(b, slopes, b.mul(n["state_at"], lanes))
            self.copy(state, moved, wide)
            with counted(b, i, "earlier") as j:
                self.more(state, b.fmul(h, self.number("a", i, j)), self.row_of("stage_slopes", j, wide), wide)
            b.call(self.run, [n["other_rows"], self.array["other"], values, slopes])
            self.copy(self.row_of("stage_slopes", i, wide), at(b, slopes, n["slopes_out_at"]), wide)
        first, count = self.samples(step)
        with counted(b, count, "sample") as k:
            sample = b.add(first, k)
            target = self.row_of("samples", sample, wide)
            self.copy(target, moved, wide)
            with counted(b, self.word("used", step), "weight") as j:
                self.more(target, self.number("weights", sample, j), self.row_of("stage_slopes", j, wide), wide)
        with counted(b, self.word("used", step), "share") as j:
            self.more(moved, b.fmul(h, self.number("b", j)), self.row_of("stage_slopes", j, wide), wide)


class _Back(_Loop):
    name = "back"

    def step(self, step: Any) -> None:
        b, n = self.b, self.n
        step = b.sub(b.sub(n["steps"], whole(1)), step)
        h, size, moved, used = self.number("h", step), n["size"], self.array["moved"], self.word("used", step)
        with counted(b, used, "stage") as i:
            self.stage(step, i)
            place = self.row_of("stage_slopes", i, size)
            share = b.fmul(h, self.number("b", i))
            with counted(b, size, "seed") as k:
                store(b, b.fmul(share, load(b, moved, k)), place, k)
        first, count = self.samples(step)
        with counted(b, count, "sample") as k:
            sample = b.add(first, k)
            weight = self.row_of("samples", sample, size)
            self.more(moved, number(1.0), weight, size)
            with counted(b, used, "weight") as j:
                self.more(self.row_of("stage_slopes", j, size), self.number("weights", sample, j), weight, size)
        with counted(b, used, "reverse") as k:
            self._stage_back(step, b.sub(b.sub(used, whole(1)), k))

    def _stage_back(self, step: Any, i: Any) -> None:
        b, n, slopes = self.b, self.n, self.array["slopes"]
        size, h = n["size"], self.number("h", step)
        self.copy(at(b, slopes, n["slopes_out_at"]), self.row_of("stage_slopes", i, size), size)
        b.call(self.run, [n["other_rows"], self.array["other"], self.row_of("values", i, n["values"]), slopes])
        state = at(b, slopes, n["state_at"])
        self.more(self.array["moved"], number(1.0), state, size)
        with counted(b, i, "earlier") as j:
            self.more(self.row_of("stage_slopes", j, size), b.fmul(h, self.number("a", i, j)), state, size)
        rows = self.row_of("row_slopes", self.word("segments", step), n["row"])
        self.more(rows, number(1.0), at(b, slopes, n["row_at"]), n["row"])
