"""LLVM IR to WebAssembly: several modules of compiled code become one that a browser runs, with no other tool."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.metadata import version
from typing import Any

import llvmlite.binding as llvm

from tmodes.compile.cache import load, save, source_digest
from tmodes.compile.native import for_target, free
from tmodes.errors import CompileError

__all__ = ["GIVEN", "WasmPart", "finished", "wasm_module"]

_CUSTOM, _IMPORT, _MEMORY, _GLOBAL, _EXPORT, _CODE, _DATA, _DATA_COUNT = 0, 2, 5, 6, 7, 10, 11, 12
_ORDER = (1, _IMPORT, 3, 4, _MEMORY, _GLOBAL, _EXPORT, 8, 9, _DATA_COUNT, _CODE, _DATA)
"""Sections in the order in which they must stand."""

GIVEN = ("tmodes_far_sin", "tmodes_far_cos", "tmodes_pow")
"""Functions that the engine gives: sine and cosine of very large angles, and powers."""

_HEAD = b"\0asm\1\0\0\0"
_ADDRESSES, _FINAL = (3, 4), (0, 6, 7)
"""Kinds of relocation in code: addresses in memory; indices of functions, types and globals, which are final."""

PAGE = 65536
_ALIGNED = 64
"""Alignment of what has a place in memory [bytes]."""

_WIDTH = 5
"""Bytes of a number that is to be replaced."""


class _BinaryReader:
    def __init__(self, content: bytes, place: int = 0) -> None:
        self.content, self.place = content, place

    def byte(self) -> int:
        self.place += 1
        return self.content[self.place - 1]

    def number(self, *, signed: bool = False) -> int:
        """An integer of any length (LEB128)."""
        value = shift = 0
        more = 0x80
        while more & 0x80:
            more = self.byte()
            value |= (more & 0x7F) << shift
            shift += 7
        return value - (1 << shift) if signed and more & 0x40 else value

    def take(self, count: int) -> bytes:
        self.place += count
        return self.content[self.place - count : self.place]

    def text(self) -> str:
        return self.take(self.number()).decode()

    @property
    def left(self) -> bool:
        return self.place < len(self.content)


def _imports(section: bytes) -> bytes:
    """The section with its functions alone; memory and stack pointer, which the module then has itself, are left out.

    Raises :class:`CompileError` for what else is asked for.
    """
    reader, count, kept = _BinaryReader(section), 0, b""
    for _ in range(reader.number()):
        begin = reader.place
        _, name, kind = reader.text(), reader.text(), reader.byte()
        if kind == 0:
            reader.number()
            count += 1
            if name not in GIVEN:
                raise CompileError(f"WebAssembly: the code calls `{name}`; expected one of {', '.join(GIVEN)}")
            kept += section[begin : reader.place]
        elif (kind, name) == (2, "__linear_memory"):
            _skip_limits(reader)
        elif (kind, name) == (3, "__stack_pointer"):
            reader.take(2)
        else:
            raise CompileError(f"WebAssembly: the code asks for `{name}`, which no page gives it")
    return _unsigned(count) + kept


def _skip_limits(reader: _BinaryReader) -> None:
    for _ in range(1 + (reader.byte() & 1)):
        reader.number()


def finished(obj: bytes, exports: Sequence[str], stack: int) -> bytes:
    """The module of an object file: a stack of so many bytes first in memory, then data, then free space.

    A stack that is too deep traps there, and spoils nothing. Exports the functions named, ``memory``, and the global
    ``heap_base``: where memory is free from. Raises :class:`CompileError` for an object that needs a linker.
    """
    sections = dict(_sections(obj))
    wanted = _exported(sections.pop("linking"), exports)
    places = _addresses(sections.get("reloc.CODE", b""))
    if "reloc.DATA" in sections:
        raise CompileError("WebAssembly: the constants hold addresses; expected numbers alone")
    code = bytearray(sections[_CODE])
    stack = -(-stack // _ALIGNED) * _ALIGNED
    end = _move(sections, code, stack, places)
    info = {
        _IMPORT: _imports(sections[_IMPORT]),
        _CODE: bytes(code),
        _MEMORY: b"\1\0" + _unsigned(-(-end // PAGE)),
        _GLOBAL: b"\2\x7f\1\x41" + _signed(stack) + b"\x0b\x7f\0\x41" + _signed(end) + b"\x0b",
        _EXPORT: _export_section([*wanted, ("memory", 2, 0), ("heap_base", 3, 1)]),
    }
    return _HEAD + b"".join(
        bytes([kind]) + _counted(content) for kind in _ORDER if (content := info.get(kind, sections.get(kind)))
    )


def _sections(obj: bytes) -> Iterator[tuple[int | str, bytes]]:
    """Contents by number, of custom ones by name."""
    reader = _BinaryReader(obj, len(_HEAD))
    while reader.left:
        kind, content = reader.byte(), reader.take(reader.number())
        inner = _BinaryReader(content)
        yield (inner.text(), content[inner.place :]) if kind == _CUSTOM else (kind, content)


def _exported(linking: bytes, exports: Sequence[str]) -> list[tuple[str, int, int]]:
    """Name, kind and index of each function that is wanted."""
    reader = _BinaryReader(linking)
    reader.number()
    indices: dict[str, int] = {}
    while reader.left:
        kind, content = reader.byte(), reader.take(reader.number())
        if kind == 8:
            indices = dict(_function_symbols(_BinaryReader(content)))
    return [(name, 0, indices[name]) for name in exports]


def _function_symbols(reader: _BinaryReader) -> Iterator[tuple[str, int]]:
    for _ in range(reader.number()):
        kind, flags = reader.byte(), reader.number()
        undefined, named = flags & 0x10, flags & 0x40
        if kind == 1:
            reader.text()
            for _ in range(0 if undefined else 3):
                reader.number()
        elif kind == 3:
            reader.number()
        else:
            index = reader.number()
            name = reader.text() if named or not undefined else ""
            if kind == 0 and not undefined:
                yield name, index


def _addresses(content: bytes) -> Iterator[int]:
    """Where in the code addresses stand."""
    reader = _BinaryReader(content)
    if not content:
        return
    reader.number()  # of the section that they are for: the code
    for _ in range(reader.number()):
        kind, place = reader.byte(), reader.number()
        reader.number()
        if kind in _ADDRESSES:
            reader.number(signed=True)
            yield place
        elif kind not in _FINAL:
            raise CompileError(f"WebAssembly: the code has a relocation of kind {kind}, which is not known here")


def _move(sections: dict[int | str, bytes], code: bytearray, by: int, places: Iterable[int]) -> int:
    """Move the data up, in its section and in the code; returns where memory is free from."""
    end = by
    if _DATA in sections:
        reader, moved = _BinaryReader(sections[_DATA]), b""
        count = reader.number()
        for _ in range(count):
            reader.take(2)  # flags: into memory 0; and i32.const
            start = by + reader.number(signed=True)
            reader.take(1)  # end of the constant's expression
            content = reader.take(reader.number())
            moved += b"\0\x41" + _signed(start) + b"\x0b" + _counted(content)
            end = max(end, start + len(content))
        sections[_DATA] = _unsigned(count) + moved
    for place in places:
        value = _BinaryReader(bytes(code[place : place + _WIDTH])).number(signed=True)
        code[place : place + _WIDTH] = _padded(value + by)
    return -(-end // _ALIGNED) * _ALIGNED


def _export_section(entries: Sequence[tuple[str, int, int]]) -> bytes:
    info = [_counted(name.encode()) + bytes([kind]) + _unsigned(index) for name, kind, index in entries]
    return _unsigned(len(info)) + b"".join(info)


def _counted(content: bytes) -> bytes:
    return _unsigned(len(content)) + content


def _unsigned(value: int) -> bytes:
    info = bytearray()
    while value >= 0x80:
        info.append(value & 0x7F | 0x80)
        value >>= 7
    return bytes([*info, value])


def _signed(value: int) -> bytes:
    """A whole number that is not negative as a signed one: its last byte leaves room for the sign."""
    info = _unsigned(value)
    return info if info[-1] < 0x40 else info[:-1] + bytes([info[-1] | 0x80, 0])


def _padded(value: int) -> bytes:
    """A number that is not negative in the five bytes that are kept for it."""
    return bytes([value >> 7 * k & 0x7F | 0x80 for k in range(4)] + [value >> 28])


TRIPLE = "wasm32-unknown-unknown"


@dataclass(frozen=True)
class WasmPart:
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


def wasm_module(name: str, parts: Sequence[WasmPart], *, simd: bool | None = None, level: int = 1) -> bytes:
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
    name: str, parts: Sequence[WasmPart], exports: Sequence[str], level: int, *, simd: bool
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


def _optimised(part: WasmPart, machine: Any) -> Any:
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
