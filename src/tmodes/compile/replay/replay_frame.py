"""What native loops over the recorded steps of a run share: their arguments, the step, its samples."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from llvmlite import ir

from tmodes.compile.ir.emit import I64, POINTER, VOID, Builder, at, counted, declare, load, number, store, whole
from tmodes.compile.ir.kernels import native_functions
from tmodes.compile.loops.tape_loop import WORDS, write_run
from tmodes.compile.native import Library

__all__ = ["ARRAYS", "COUNTS", "ReplayLoop", "written_loops"]

COUNTS = (
    "steps", "size", "row", "stages", "values", "time_at", "state_at", "row_at", "out_at", "lanes", "slopes_out_at",
    "forward_rows", "other_rows", "pairs", "step_at", "start_at",
)  # fmt: skip
"""Numbers of a replay: steps, numbers of a state and of a row, stages, numbers of one stage's values; where the time,
the state, the row and the rates stand among them, and the rates' slopes among the slopes; rows of both tables. Of
implicit steps also how many coordinates a state begins with, and where a step's length and its start stand."""

_WHOLE = ("counts", "segments", "used", "first_sample", "forward", "other")
_REAL = (
    "t", "h", "y", "rows", "a", "b", "c", "weights", "values", "states", "slopes", "moved", "stage_slopes",
    "row_slopes", "samples",
)  # fmt: skip
ARRAYS = (*_WHOLE, *_REAL)
"""Arguments of each loop, all pointers.

``counts``; of each step its segment and how many stages (or rows) it needs, and the first of its samples (steps + 1);
the tables of the evaluation and of its derivative. ``t``, ``h`` (steps,), ``y`` (steps + 1, size); ``rows`` of the
segments; the tableau; ``weights`` (samples, stages) of the stages in each sample. ``values`` of each stage; ``states``
(stages, size) of extrapolated steps; ``slopes``: memory of the derivative. ``moved``: slopes or weights of the state,
in and out; ``stage_slopes`` those of the stages; ``row_slopes`` those of the rows; ``samples``: states at the samples,
their slopes, or their weights.
"""


class ReplayLoop(ABC):
    """The loop over the steps, and what its parts are written with."""

    name = ""

    def __init__(self, module: Any, run: Any) -> None:
        kinds = [(label, WORDS if label in _WHOLE else POINTER) for label in ARRAYS]
        function = declare(module, self.name, VOID, kinds)
        self.array: dict[str, Any] = dict(zip(ARRAYS, function.args, strict=True))
        self.run = run
        self.b: Any = Builder(function.append_basic_block("entry"))
        self.n = {label: self.word("counts", k) for k, label in enumerate(COUNTS)}

    def word(self, label: str, index: Any) -> Any:
        """A whole number of an array."""
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

    @contextmanager
    def samples(self, step: Any) -> Iterator[Any]:
        """A loop over the samples of a step; yields the number of each."""
        b = self.b
        first, after = (self.word("first_sample", b.add(step, whole(k))) for k in range(2))
        with counted(b, b.sub(after, first), "sample") as k:
            yield b.add(first, k)

    def tell(self, step: Any, here: Any, width: Any, stages: tuple[Any, Callable[[Any], Any]]) -> None:
        """Write the samples of a step: what is ``here``, and the stages (how many, where each is) with weights."""
        b = self.b
        with self.samples(step) as sample:
            target = self.row_of("samples", sample, width)
            self.copy(target, here, width)
            with counted(b, stages[0], "weight") as j:
                self.more(target, self.number("weights", sample, j), stages[1](j), width)

    def collect(self, step: Any, stages: Any) -> None:
        """Add the weights of a step's samples to those of its start and of its stages."""
        b, size = self.b, self.n["size"]
        with self.samples(step) as sample:
            weight = self.row_of("samples", sample, size)
            self.more(self.array["moved"], number(1.0), weight, size)
            with counted(b, stages, "weight") as j:
                self.more(self.row_of("stage_slopes", j, size), self.number("weights", sample, j), weight, size)

    def backwards(self, step: Any) -> Any:
        """The number of a step counted from the last."""
        return self.b.sub(self.b.sub(self.n["steps"], whole(1)), step)

    def evaluate(self, step: Any, time: Any, values: Any) -> None:
        """Run the table of the evaluation, whose state is set."""
        b, n = self.b, self.n
        store(b, time, values, n["time_at"])
        self.copy(at(b, values, n["row_at"]), self.row_of("rows", self.word("segments", step), n["row"]), n["row"])
        b.call(self.run, [n["forward_rows"], self.array["forward"], values, self.array["slopes"]])

    def differentiate(self, values: Any) -> None:
        """Run the table of the derivative."""
        b, n = self.b, self.n
        b.call(self.run, [n["other_rows"], self.array["other"], values, self.array["slopes"]])

    def set_row_slopes(self, step: Any) -> None:
        """Slopes of the row of a step's segment, where the table takes them."""
        b, n = self.b, self.n
        width = b.mul(n["row"], n["lanes"])
        source = self.row_of("row_slopes", self.word("segments", step), width)
        self.copy(at(b, self.array["slopes"], b.mul(n["row_at"], n["lanes"])), source, width)

    def add_row_weights(self, step: Any) -> None:
        """Weights of the row of a step's segment, as the table gives them."""
        rows = self.row_of("row_slopes", self.word("segments", step), self.n["row"])
        self.more(rows, number(1.0), at(self.b, self.array["slopes"], self.n["row_at"]), self.n["row"])

    def copy(self, to: Any, source: Any, count: Any) -> None:
        """``to = source``."""
        b = self.b
        with counted(b, count, "copy") as k:
            store(b, load(b, source, k), to, k)

    def more(self, to: Any, factor: Any, source: Any, count: Any) -> None:
        """``to += factor source``, nothing where the factor is 0."""
        b = self.b
        with b.if_then(b.fcmp_unordered("!=", factor, number(0.0))), counted(b, count, "more") as k:
            term = b.fmul(factor, load(b, source, k), flags=("contract",))
            store(b, b.fadd(load(b, to, k), term, flags=("contract",)), to, k)


def written_loops(name: str, kinds: Sequence[type[ReplayLoop]]) -> Library:
    """``again``: states after each step and at samples; ``along``: slopes of both; ``back``: weights carried back.

    Made at their first use; ``name`` says all of them.
    """

    def write() -> Any:
        module = ir.Module(name)
        run = write_run(module)
        for kind in kinds:
            kind(module, run).write()
        return module

    return native_functions(name, write, {kind.name: len(ARRAYS) for kind in kinds})
