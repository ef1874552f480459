"""LLVM IR to WebAssembly: several modules of compiled code become one that a browser runs, with no other tool."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.metadata import version
from typing import Any

import llvmlite.binding as llvm

from tmodes.compile.cache import load, save, source_digest
from tmodes.compile.native import free
from tmodes.compile.wasm_binary import finished
from tmodes.errors import CompileError

__all__ = ["Part", "wasm_module"]

TRIPLE = "wasm32-unknown-unknown"


@dataclass(frozen=True)
class Part:
    """Code of one module of IR: ``key`` tells all of it, ``write`` gives it, ``symbols`` are the functions in it.

    ``exported``: whether these are to be seen outside. ``simd``: whether it works on vectors.
    """

    key: str
    write: Callable[[], Any]
    symbols: tuple[str, ...]
    exported: bool = True
    simd: bool = False


@cache
def _machine(level: int, *, simd: bool) -> Any:
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    features = "+simd128" if simd else ""
    return llvm.Target.from_triple(TRIPLE).create_target_machine(features=features, opt=level, reloc="static")


def wasm_module(name: str, parts: Sequence[Part], *, simd: bool | None = None, level: int = 2) -> bytes:
    """One WebAssembly module of all parts, from the cache or made and kept.

    ``simd``: whether it may use vectors of two doubles; None: where a part works on vectors. Exports the functions
    of the exported parts, ``memory`` and ``heap_base``. Raises :class:`CompileError` when LLVM refuses the code.
    """
    simd = any(part.simd for part in parts) if simd is None else simd
    import llvmlite

    versions = f"{llvmlite.__version__} {version('casadi')} {source_digest()}"
    told = "\n".join(f"{part.key} {part.symbols} {part.exported}" for part in parts)
    key = f"wasm {name} simd={simd} level={level} {versions}\n{told}"
    binary = load(key)
    if binary is None:
        exports = [symbol for part in parts if part.exported for symbol in part.symbols]
        binary = finished(*_object(name, parts, exports, level, simd=simd))
        save(key, binary)
    return binary


def _object(
    name: str, parts: Sequence[Part], exports: Sequence[str], level: int, *, simd: bool
) -> tuple[bytes, Sequence[str], int]:
    """Object file, what it exports, and bytes of stack that it needs."""
    machine = _machine(level, simd=simd)
    try:
        whole = _parsed(parts[0], machine)
        for part in parts[1:]:
            whole.link_in(_parsed(part, machine))
        whole.verify()
    except RuntimeError as problem:
        raise CompileError(f"{name}: LLVM refuses the code: {problem}") from problem
    for function in whole.functions:
        if not function.is_declaration and function.name not in exports:
            function.linkage = llvm.Linkage.internal
    builder = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=level))
    passes = builder.getModulePassManager()
    passes.run(whole, builder)
    free(passes)
    return machine.emit_object(whole), exports, _stack(str(whole))


_LOCAL = re.compile(r" = alloca (?:\[(\d+) x )?(?:<(\d+) x )?(\w+)[^,\n]*(?:, i\d+ (\d+))?")
"""A variable on the stack: its type as an array, a vector or a number, and how many of them."""

_BYTES = {"double": 8, "i64": 8, "i32": 4, "i8": 1, "ptr": 4}
_EACH, _SPARE = 64, 65536
"""Bytes that aligning one variable may take, and left over for all that the compiler puts there itself."""


def _stack(code: str) -> int:
    """Bytes that the variables of all functions take together: no function calls itself, so no call is deeper."""
    total = _SPARE
    for *counts, kind, many in _LOCAL.findall(code):
        total += _EACH + _BYTES[kind] * math.prod(int(count or 1) for count in (*counts, many))
    return total


def _parsed(part: Part, machine: Any) -> Any:
    module = part.write()
    module.triple, module.data_layout = TRIPLE, str(machine.target_data)
    return llvm.parse_assembly(str(module))
