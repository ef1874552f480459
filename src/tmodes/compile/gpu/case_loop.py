"""The loop over cases of one structure by one method: PTX for a GPU, and native code to check it without one."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property
from importlib.metadata import version
from typing import Any

import llvmlite.binding as llvm
from llvmlite import ir

from tmodes.compile import cache as disk
from tmodes.compile.gpu.mathematics import mathematics_module
from tmodes.compile.ir.arithmetic import Double
from tmodes.compile.ir.block import write_rate
from tmodes.compile.ir.emit import (
    F64,
    I64,
    POINTER,
    VOID,
    Builder,
    at,
    counted,
    declare,
    load,
    number,
    scratch,
    store,
    whole,
)
from tmodes.compile.ir.kernels import library
from tmodes.compile.lanes.series import SUMS, fold
from tmodes.compile.loops.time_loop import ARGUMENTS, CELLS, OPTIONS
from tmodes.compile.native import Library, for_target, free, kernel_symbol, pays
from tmodes.compile.wasm.wasm_parts import PIECE, kernel_in_pieces, schedule_loop
from tmodes.errors import CompileError

__all__ = [
    "ARRAYS",
    "BLOCK",
    "CASE",
    "CASE_ARGUMENTS",
    "CASE_OPTIONS",
    "KERNEL",
    "LEAST_TARGET",
    "LOOP",
    "WHOLE",
    "CaseLoop",
    "CaseSeries",
    "SeriesWriter",
    "blocks",
    "case_module",
    "kernels_of_series",
    "write_kernel",
]


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


TRIPLE = "nvptx64-nvidia-cuda"

LEAST_TARGET = "sm_70"
"""The oldest kind of GPU for which code is made; the driver turns it into that of any later kind."""

_LEVEL = 3


@cache
def _machine(target: str) -> Any:
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    try:
        kind = llvm.Target.from_triple(TRIPLE)
    except RuntimeError as problem:
        raise CompileError(
            f"this llvmlite cannot write code for NVIDIA GPUs: {problem}; install one that can"
        ) from None
    return kind.create_target_machine(cpu=target, opt=_LEVEL)


@dataclass(frozen=True, eq=False)
class CaseLoop:
    """A schedule of rates with the method that integrates it; ``guarded``, ``more``: as of the loops of single runs.

    ``series``: what is wanted of the samples; None: the samples.
    """

    schedule: Any
    guarded: int
    method: str
    more: Mapping[str, Any] = field(default_factory=dict)
    series: CaseSeries | None = None

    @property
    def parameters(self) -> int:
        """Numbers of a case."""
        return self.schedule.parameters

    @property
    def size(self) -> int:
        """Numbers of a state."""
        return self.schedule.output_size

    @cached_property
    def key(self) -> str:
        """What identifies the code."""
        wanted = self.series.key if self.series else ""
        return f"{self.method} {self.guarded} {dict(self.more)} {self.schedule.key} {wanted}"

    def ptx(self, target: str = LEAST_TARGET) -> str:
        """The text of the kernel ``run(*CASE_ARGUMENTS)``, from the cache or made and kept.

        Raises :class:`tmodes.errors.CompileError` when LLVM refuses the code.
        """
        import llvmlite

        key = f"ptx {target} {llvmlite.__version__} {version('casadi')} {disk.source_digest()}\n{self.key}"
        found = disk.load(key)
        if found is None:
            found = self._ptx(target).encode()
            disk.save(key, found)
        return found.decode()

    def _ptx(self, target: str) -> str:
        machine = _machine(target)
        whole = self._linked(machine, kernel=True)
        builder = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=_LEVEL))
        passes = builder.getModulePassManager()
        passes.run(whole, builder)
        free(passes)
        return re.sub(r"\s*//.*", "", machine.emit_assembly(whole))  # its remarks count calls of the whole process

    def native(self, *, mathematics: bool = True) -> Library:
        """The same for this machine's processor: ``tmodes_case(thread, *CASE_ARGUMENTS)``.

        ``mathematics``: False takes the functions of the C library, as the loops of single runs do.
        """
        functions = {CASE: 1 + len(CASE_ARGUMENTS)}

        def write() -> str:
            return str(self._linked(None, kernel=False, mathematics=mathematics))

        return library("cases", f"cases mathematics={mathematics} {self.key}", write, functions, 1)

    def _linked(self, machine: Any, *, kernel: bool, mathematics: bool = True) -> Any:
        """All code in one module; only what is called from outside is seen there."""
        try:
            module = case_module(self.parameters, self.size, self.series)
            if kernel:
                write_kernel(module)
            texts = [str(module), *self._texts()]
            texts += [str(mathematics_module())] if mathematics else []
            whole, *others = (llvm.parse_assembly(for_target(text, machine) if machine else text) for text in texts)
            for other in others:
                whole.link_in(other)
            whole.verify()
        except RuntimeError as problem:
            raise CompileError(f"the loop of cases by {self.method}: LLVM refuses the code: {problem}") from problem
        for function in whole.functions:
            if not function.is_declaration and function.name != (KERNEL if kernel else CASE):
                function.linkage = llvm.Linkage.internal
        return whole

    def _texts(self) -> list[str]:
        """The loop of single runs and all kernels, each once."""
        parts = schedule_loop(LOOP, self.schedule, self.guarded, self.method, **self.more)
        known = {symbol for part in parts for symbol in part.symbols}
        more = [code for symbol, code in kernels_of_series(self.series).items() if symbol not in known]
        return [str(part.write()) for part in parts] + [str(code) for code in more]
