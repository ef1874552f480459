"""The IR of one case of many: its numbers from global arrays to its own, the loop of a single run, and back.

In global memory number i of all cases stand side by side, so that neighbouring threads read neighbouring addresses. All
that the loop works on is its own: on a GPU local memory, where the hardware does the same.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir

from tmodes.compile.gpu.case_series import CaseSeries, SeriesWriter
from tmodes.compile.ir.builder import Builder
from tmodes.compile.ir.emit import F64, I64, POINTER, VOID, at, counted, declare, load, number, scratch, store, whole
from tmodes.compile.loops.time_loop import ARGUMENTS, CELLS, OPTIONS

__all__ = [
    "ARRAYS", "BLOCK", "CASE", "CASE_ARGUMENTS", "CASE_OPTIONS", "KERNEL", "LOOP", "WHOLE", "blocks", "case_module",
    "write_kernel",
]  # fmt: skip

LOOP, CASE, KERNEL = "tmodes_loop", "tmodes_case", "run"
"""Names of the loop of a single run, of the function of one case, and of the kernel."""

BLOCK = 64
"""Threads of a block: each may have all the registers that a thread can have, and an uneven number leaves few idle."""

CASE_OPTIONS = (*OPTIONS, "most")
"""Settings, the same for all cases; ``most``: attempted steps of a case after which it is given up."""

WHOLE = (
    "threads", "cases", "case_stride", "number_stride", "knot_stride", "row_stride", "segment_stride", "table_stride",
    "samples",
)  # fmt: skip

ARRAYS = (
    "which", "memory", "y", "k1", "p", "knots", "rows", "segments", "times", "out", "options", "table", "weights",
    "series",
)  # fmt: skip

CASE_ARGUMENTS = (*ARRAYS, *WHOLE)
"""Arguments, in order: pointers to global arrays, then int64.

``which`` (threads,): the case of each thread; it and ``segments`` hold int64, the others doubles. Of ``memory``, ``y``
and ``k1`` number i of case k is at i cases + k; of ``p`` at i number_stride + k case_stride. ``knots`` and ``rows``
of a case begin a stride after those of the case before (0: the same for all), as does its number of ``segments``.
``out`` is (cases, samples, size). Where series are wanted, ``table`` has the numbers given for each sample, a stride
apart from case to case (0: the same for all), ``weights`` those of the samples in a mean over time, and ``series`` is
what they come to: (cases, samples, series), or of sums number i of case k at i cases + k.
"""


def blocks(threads: int) -> int:
    """Blocks of so many threads; those of the last one that are beyond do nothing."""
    return -(-threads // BLOCK)


def case_module(parameters: int, size: int, series: CaseSeries | None = None) -> Any:
    """The module of the function ``tmodes_case(thread, *CASE_ARGUMENTS)`` around the loop of a single run.

    ``parameters``: of a case; ``size``: of its state; ``series``: what is wanted of its samples.
    """
    module = ir.Module(CASE)
    _OneCase(module, parameters, size, series).write()
    return module


def write_kernel(module: Any) -> None:
    """The kernel ``run(*CASE_ARGUMENTS)`` of a GPU around the function of one case."""
    arguments = [("thread", I64), *_kinds()]
    case = module.globals[CASE]
    kernel = declare(module, KERNEL, VOID, arguments[1:])
    kernel.calling_convention = "ptx_kernel"
    b = Builder(kernel.append_basic_block("entry"))
    block, size, inside = (_index(b, name) for name in ("ctaid", "ntid", "tid"))
    b.call(case, [b.add(b.mul(block, size), inside), *kernel.args])
    b.ret_void()
    note = [kernel, ir.MetaDataString(module, "maxntidx"), ir.Constant(ir.IntType(32), BLOCK)]
    module.add_named_metadata("nvvm.annotations", note)


def _index(b: Any, name: str) -> Any:
    """A whole number that says which thread this is."""
    kind = ir.FunctionType(ir.IntType(32), [])
    function = ir.Function(b.function.module, kind, f"llvm.nvvm.read.ptx.sreg.{name}.x")
    return b.zext(b.call(function, []), I64)


def _kinds() -> list[tuple[str, Any]]:
    return [(label, I64 if label in WHOLE else POINTER) for label in CASE_ARGUMENTS]


class _OneCase:
    def __init__(self, module: Any, parameters: int, size: int, series: CaseSeries | None) -> None:
        self.function = declare(module, CASE, VOID, [("thread", I64), *_kinds()])
        self.argument: dict[str, Any] = dict(zip(("thread", *CASE_ARGUMENTS), self.function.args, strict=True))
        kinds = [(label, I64 if label in ("segments", "samples") else POINTER) for label in ARGUMENTS]
        self.loop = declare(module, LOOP, VOID, kinds)
        self.b = b = Builder(self.function.append_basic_block("entry"))
        self.size = size
        self.kept = {"memory": len(CELLS), "y": size, "k1": size}
        sizes = self.kept | {"p": parameters, "options": len(OPTIONS), "seen": 1}
        self.own = {label: scratch(b, count, label) for label, count in sizes.items()}
        self.parameters = parameters
        self.series = None if series is None else SeriesWriter(series, b, self.argument, size)

    def write(self) -> None:
        """All of the function; threads beyond the last do nothing."""
        b = self.b
        with b.if_then(b.icmp_signed("<", self.argument["thread"], self.argument["threads"])):
            case = b.load(at(b, self.argument["which"], self.argument["thread"]), typ=I64)
            for label, count in self.kept.items():
                self._take(label, count, case, self.argument["cases"])
            start = b.mul(case, self.argument["case_stride"])
            self._take("p", self.parameters, start, self.argument["number_stride"])
            self._take_options()
            store(b, number(0.0), self.own["seen"], 0)
            given = {label: self._given(label, case) for label in ARGUMENTS}
            piece, first = self._cell("segment"), self._cell("sample")
            b.call(self.loop, [given[label] for label in ARGUMENTS])
            if self.series is not None:
                self.series.write(case, given, piece, first, self._cell("sample"))
            for label, count in self.kept.items():
                self._give(label, count, case)
        b.ret_void()

    def _place(self, label: str, i: Any, start: Any, stride: Any) -> Any:
        return at(self.b, self.argument[label], self.b.add(start, self.b.mul(i, stride)))

    def _take(self, label: str, count: int, start: Any, stride: Any) -> None:
        with counted(self.b, count, label) as i:
            value = self.b.load(self._place(label, i, start, stride), typ=F64)
            store(self.b, value, self.own[label], i)

    def _give(self, label: str, count: int, case: Any) -> None:
        with counted(self.b, count, label) as i:
            value = load(self.b, self.own[label], i)
            self.b.store(value, self._place(label, i, case, self.argument["cases"]))

    def _cell(self, name: str) -> Any:
        """A number of the loop's memory as an int64."""
        return self.b.fptosi(load(self.b, self.own["memory"], CELLS.index(name)), I64)

    def _take_options(self) -> None:
        """The options of all, but for the steps of this call: no more than are left to this case."""
        b, given = self.b, self.argument["options"]
        for place in range(len(OPTIONS)):
            store(b, load(b, given, place), self.own["options"], place)
        tried = b.fadd(*(load(b, self.own["memory"], CELLS.index(label)) for label in ("steps", "rejected")))
        left, chunk = b.fsub(load(b, given, CASE_OPTIONS.index("most")), tried), OPTIONS.index("chunk")
        asked = load(b, given, chunk)
        store(b, b.select(b.fcmp_ordered("<", left, asked), left, asked), self.own["options"], chunk)

    def _given(self, label: str, case: Any) -> Any:
        """An argument of the loop."""
        b, argument = self.b, self.argument
        if label in self.own:
            return self.own[label]
        if label == "segments":
            return b.load(at(b, argument["segments"], b.mul(case, argument["segment_stride"])), typ=I64)
        if label == "out":
            return at(b, argument["out"], b.mul(b.mul(case, argument["samples"]), whole(self.size)))
        stride = {"knots": "knot_stride", "rows": "row_stride"}.get(label)
        return at(b, argument[label], b.mul(case, argument[stride])) if stride else argument[label]
