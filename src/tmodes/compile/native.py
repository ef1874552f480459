"""LLVM IR to native code in this process, and back from an object file of the cache."""

from __future__ import annotations

import ctypes
import hashlib
import itertools
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, nullcontext
from functools import cache, lru_cache
from importlib.metadata import version
from threading import Lock
from typing import Any

import llvmlite.binding as llvm
from llvmlite.binding.newpassmanagers import NewPassManager

from tmodes.errors import CompileError

__all__ = [
    "FAR_COSINE", "FAR_SINE", "LIMIT", "POWER", "WIDTH", "Library", "for_target", "free", "host", "kernel_symbol",
    "pays", "processor", "to_object",
]  # fmt: skip

FAR_SINE, FAR_COSINE, POWER = "tmodes_far_sin", "tmodes_far_cos", "tmodes_pow"
"""Symbols bound to the C library's sin, cos and pow."""

WIDTH = 8 if dict(llvm.get_host_cpu_features()).get("avx512f") else 4
"""Runs, or samples, side by side: as many doubles as a register of this processor holds."""

_SYMBOLS = {FAR_SINE: "sin", FAR_COSINE: "cos", POWER: "pow"}


LIMIT = 500
"""Numbers that the calls of a schedule give up to which unrolling pays: eight rigid joints, 3,000 operations.

Measured: a longer program does not fit into the processor's first cache of instructions (32 kB on most), and then the
calls of kernels, which do, are quicker by a fifth.
"""


def kernel_symbol(kernel: Any, arithmetic: str) -> str:
    """The name of a kernel's native function: the same for the same structure, everywhere."""
    return _symbol(f"{kernel.key} {kernel.inputs} {kernel.outputs} {arithmetic}")


@lru_cache(maxsize=4096)
def _symbol(info: str) -> str:
    return f"kernel_{hashlib.sha256(info.encode()).hexdigest()[:32]}"


def pays(schedule: Any) -> bool:
    """Whether a schedule is called often and is small enough."""
    kernels = [kernel for kernel, _, _ in schedule.calls]
    short = schedule.often and not any(kernel.long for kernel in kernels)
    return short and sum(sum(kernel.outputs) for kernel in kernels) <= LIMIT


@cache
def _machine(level: int) -> Any:
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    target = llvm.Target.from_triple(llvm.get_process_triple())
    features = llvm.get_host_cpu_features().flatten()
    return target.create_target_machine(
        cpu=llvm.get_host_cpu_name(), features=features, opt=level, reloc="pic", codemodel="jitdefault", jit=True
    )


@cache
def host() -> str:
    """What the code is made for: versions, platform, processor and its features."""
    import llvmlite

    features = llvm.get_host_cpu_features().flatten()
    return (
        f"{llvmlite.__version__} {version('casadi')} {llvm.get_process_triple()} {llvm.get_host_cpu_name()} {features}"
    )


def processor() -> str:
    """LLVM's name of this machine's processor."""
    return llvm.get_host_cpu_name()


def to_object(module: Any, level: int, *, tidy: bool = True) -> bytes:
    """Optimise a module of IR and return its object file; raises :class:`CompileError` when LLVM refuses it.

    ``module``: the module, or its text. ``tidy``: False where there is nothing to tidy before code is made: no cells,
    each value computed once, and an order that is kept.
    """
    machine = _machine(level)
    code = for_target(str(module), machine)
    try:
        parsed = llvm.parse_assembly(code)
        parsed.verify()
    except RuntimeError as problem:
        raise CompileError(f"{code.partition(chr(10))[0]}: LLVM refuses the code: {problem}") from problem
    options = llvm.create_pipeline_tuning_options(speed_level=level if tidy else 0)
    builder = llvm.create_pass_builder(machine, options)
    passes = builder.getModulePassManager()
    passes.run(parsed, builder)
    free(passes)
    with _emission, nullcontext() if tidy else _in_the_order_written():
        return machine.emit_object(parsed)


def for_target(code: str, machine: Any) -> str:
    """The text of a module that names no target yet, for this one."""
    code = code.replace('triple = "unknown-unknown-unknown"', f'triple = "{machine.triple}"', 1)
    return code.replace('datalayout = ""', f'datalayout = "{machine.target_data}"', 1)


_emission = Lock()
"""Code is emitted by one thread at a time: no other module is to meet a switch that is not its own."""


@contextmanager
def _in_the_order_written() -> Iterator[None]:
    """Keep LLVM's scheduler of machine instructions from making code in another order.

    Of long straight programs it makes a worse one: of six rigid joints one that takes a tenth longer to compile, and a
    twentieth longer to run. The switch is the whole process's, so it is put back at once.
    """
    llvm.set_option("", "-enable-misched=0")
    try:
        yield
    finally:
        llvm.set_option("", "-enable-misched=1")


def free(passes: Any) -> None:
    """Free a pass manager, some 50 kB: its own ``_dispose`` is hidden behind one of ObjectRef that does nothing."""
    hidden = getattr(NewPassManager, "_dispose", None)
    if hidden is not None and type(passes)._dispose is not hidden:
        hidden(passes)
        passes.detach()


_serial = itertools.count()
"""The linker wants a new name for each library, also for one that was freed."""


_PER_LINKER = 64
"""Libraries of one linker. Some 10 kB of a library that is freed stay with its linker until that is freed too."""


@lru_cache(maxsize=1)
def _linker(generation: int) -> Any:
    """The linker of the libraries of one generation; an older one lives as long as a library of it does."""
    del generation
    return llvm.create_lljit_compiler(_machine(3))


@cache
def _address_in_c(name: str) -> int:
    """Address of a function of the C library: of this process itself where it has it, as Python mostly does."""
    for library in ("msvcrt",) if sys.platform == "win32" else (None, "libm.so.6", "libm.dylib"):
        try:
            address = ctypes.cast(getattr(ctypes.CDLL(library), name), ctypes.c_void_p).value
        except (OSError, AttributeError):
            continue
        if address:
            return address
    raise CompileError(f"the C library of this machine has no function {name} that can be found")


class Library:
    """Native functions loaded from one object file; the code is freed with this object and the last of them."""

    def __init__(
        self, name: str, binary: bytes, functions: dict[str, int], imports: Mapping[str, Library] | None = None
    ) -> None:
        """``functions`` maps each exported name to its number of arguments; all are int64 or pointers.

        ``imports`` holds the library of each foreign symbol that the code calls; it exports that symbol.
        """
        self._imports = dict(imports or {})  # kept alive: our code jumps into theirs
        builder = llvm.JITLibraryBuilder().add_object_img(binary)
        for symbol, in_c in _SYMBOLS.items():
            builder.import_symbol(symbol, _address_in_c(in_c))
        for symbol, library in self._imports.items():
            builder.import_symbol(symbol, library.address(symbol))
        for symbol in functions:
            builder.export_symbol(symbol)
        serial = next(_serial)
        linker = _linker(serial // _PER_LINKER)
        try:
            self._tracker: Any = builder.link(linker, f"{name}.{serial}")
        except RuntimeError as problem:
            raise CompileError(f"{name}: the object file cannot be linked: {problem}") from problem
        self._tracker.linker = linker  # which must outlive it
        self._functions = {symbol: self._function(symbol, count) for symbol, count in functions.items()}

    def __getitem__(self, name: str) -> Any:
        return self._functions[name]

    def _function(self, symbol: str, count: int) -> Any:
        function: Any = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * count)(self._tracker[symbol])
        function.kept = self._tracker, self._imports  # who holds a function may have let the library go
        return function

    def address(self, name: str) -> int:
        """Where an exported function is."""
        return self._tracker[name]
