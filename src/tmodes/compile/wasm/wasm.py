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
from tmodes.compile.native import for_target, free
from tmodes.compile.wasm.wasm_binary import finished
from tmodes.errors import CompileError

__all__ = ["Part", "wasm_module"]

TRIPLE = "wasm32-unknown-unknown"


@dataclass(frozen=True)
class Part:
    """Code of one module of IR: ``key`` identifies it, ``write`` gives it or its text, ``symbols`` are its functions.

    ``exported``: whether these are to be seen outside. ``simd``: whether it works on vectors. ``level``: how far it is
    optimised, 0 for straight lines in which each value is computed once.
    """

    key: str
    write: Callable[[], Any]
    symbols: tuple[str, ...]
    exported: bool = True
    simd: bool = False
    level: int = 0


@cache
def _machine(level: int, *, simd: bool) -> Any:
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    features = "+simd128" if simd else ""
    return llvm.Target.from_triple(TRIPLE).create_target_machine(features=features, opt=level, reloc="static")


def wasm_module(name: str, parts: Sequence[Part], *, simd: bool | None = None, level: int = 1) -> bytes:
    """One WebAssembly module of all parts, from the cache or made and kept.

    ``simd``: whether it may use vectors of two doubles; None: where a part works on vectors. Exports the functions
    of the exported parts, ``memory`` and ``heap_base``. Raises :class:`CompileError` when LLVM refuses the code.
    """
    simd = any(part.simd for part in parts) if simd is None else simd
    import llvmlite

    versions = f"{llvmlite.__version__} {version('casadi')} {source_digest()}"
    info = "\n".join(f"{part.key} {part.symbols} {part.exported}" for part in parts)
    key = f"wasm {name} simd={simd} level={level} {versions}\n{info}"
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
        whole = _optimised(parts[0], machine)
        for part in parts[1:]:
            whole.link_in(_optimised(part, machine))
        whole.verify()
    except RuntimeError as problem:
        raise CompileError(f"{name}: LLVM refuses the code: {problem}") from problem
    for function in whole.functions:
        if not function.is_declaration and function.name not in exports:
            function.linkage = llvm.Linkage.internal
    return machine.emit_object(whole), exports, _stack(str(whole))


def _optimised(part: Part, machine: Any) -> Any:
    """The code of a part, as far optimised as it pays."""
    parsed = llvm.parse_assembly(_with_extremes(for_target(str(part.write()), machine)))
    builder = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=part.level))
    passes = builder.getModulePassManager()
    passes.run(parsed, builder)
    free(passes)
    return parsed


def _with_extremes(code: str) -> str:
    """The smaller and the larger of two numbers as code: WebAssembly has no word for those that pass over no number."""
    for name, first in (("minnum", "olt"), ("maxnum", "ogt")):
        info, own = f'@"llvm.{name}.f64"', f'@"{name}"'
        if info in code:
            code = re.sub(f"^declare double {re.escape(info)}.*$", "", code, flags=re.MULTILINE).replace(info, own)
            code += _EXTREME.format(own, first)
    return code


_EXTREME = """
define internal double {}(double %a, double %b) alwaysinline {{
  %before = fcmp {} double %b, %a
  %extreme = select i1 %before, double %b, double %a
  %none = fcmp uno double %a, %a
  %reported = select i1 %none, double %b, double %extreme
  ret double %reported
}}
"""

_LOCAL = re.compile(r" = alloca (?:\[(\d+) x )?(?:<(\d+) x )?(\w+)[^,\n]*(?:, i\d+ (\d+))?")
"""A variable on the stack: its type as an array, a vector or a number, and how many of them."""

_BYTES = {"double": 8, "i64": 8, "i32": 4, "i8": 1, "ptr": 4}
_EACH, _SPARE = 64, 65536
"""Bytes that aligning one variable may take, and left over for all that the compiler puts there itself."""


def _stack(code: str) -> int:
    """Bytes that the variables of all functions take together: no function calls itself, so no call is deeper."""
    total = _SPARE
    for *counts, kind, many in _LOCAL.findall(code):
        total += _EACH + _BYTES.get(kind, 8) * math.prod(int(count or 1) for count in (*counts, many))
    return total
