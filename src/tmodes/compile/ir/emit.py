"""Small helpers to write LLVM IR: pointers to double, counted loops, stores."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from llvmlite import ir

__all__ = [
    "F64",
    "I64",
    "POINTER",
    "VOID",
    "Builder",
    "at",
    "counted",
    "declare",
    "load",
    "number",
    "scratch",
    "spread",
    "store",
    "whole",
]


class _Instruction:
    """An instruction as text, with its type and the name of its value."""

    __slots__ = ("reference", "text", "type")

    def __init__(self, kind: Any, reference: str, text: str) -> None:
        self.type, self.reference, self.text = kind, reference, text

    def get_reference(self) -> str:
        """The name of the value, as other instructions write it."""
        return self.reference

    def __str__(self) -> str:
        return self.text


class Builder(ir.IRBuilder):
    """llvmlite's, quicker: arithmetic, loads, stores and addresses are checked by LLVM's own parser alone."""

    def _line(self, kind: Any, text: str) -> _Instruction:
        scope: Any = self.function.scope
        scope.lines = count = getattr(scope, "lines", 0) + 1
        reference = f'%"v:{count}"'
        line = _Instruction(kind, reference, f"{reference} = {text}")
        self._insert(line)
        return line

    def _insert(self, instr: Any) -> None:
        block: Any = self._block
        block.instructions.insert(self._anchor, instr)
        self._anchor += 1

    def _binary(self, opcode: str, lhs: Any, rhs: Any, flags: Sequence[str]) -> _Instruction:
        words = " ".join([opcode, *flags]) if flags else opcode
        return self._line(lhs.type, f"{words} {lhs.type} {lhs.get_reference()}, {rhs.get_reference()}")

    def fadd(self, lhs: Any, rhs: Any, name: str = "", flags: Sequence[str] = ()) -> Any:  # noqa: ARG002
        """Sum of numbers."""
        return self._binary("fadd", lhs, rhs, flags)

    def fsub(self, lhs: Any, rhs: Any, name: str = "", flags: Sequence[str] = ()) -> Any:  # noqa: ARG002
        """Difference of numbers."""
        return self._binary("fsub", lhs, rhs, flags)

    def fmul(self, lhs: Any, rhs: Any, name: str = "", flags: Sequence[str] = ()) -> Any:  # noqa: ARG002
        """Product of numbers."""
        return self._binary("fmul", lhs, rhs, flags)

    def fdiv(self, lhs: Any, rhs: Any, name: str = "", flags: Sequence[str] = ()) -> Any:  # noqa: ARG002
        """Quotient of numbers."""
        return self._binary("fdiv", lhs, rhs, flags)

    def fneg(self, arg: Any, name: str = "", flags: Sequence[str] = ()) -> Any:  # noqa: ARG002
        """A number with its sign changed."""
        return self._line(arg.type, f"{' '.join(['fneg', *flags])} {arg.type} {arg.get_reference()}")

    def load(self, ptr: Any, name: str = "", align: int | None = None, typ: Any = None) -> Any:
        """What stands at an address."""
        if typ is None:
            return super().load(ptr, name, align)
        where = f"{ptr.type} {ptr.get_reference()}{f', align {align}' if align else ''}"
        return self._line(typ, f"load {typ}, {where}")

    def store(self, value: Any, ptr: Any, align: int | None = None) -> Any:
        """Keep a value at an address."""
        where = f"{ptr.type} {ptr.get_reference()}{f', align {align}' if align else ''}"
        line = _Instruction(None, "", f"store {value.type} {value.get_reference()}, {where}")
        self._insert(line)
        return line

    def gep(
        self, ptr: Any, indices: Sequence[Any], inbounds: bool = False, name: str = "", source_etype: Any = None
    ) -> Any:
        """The address of an element."""
        if source_etype is None:
            return super().gep(ptr, indices, inbounds, name)
        places = ", ".join(f"{one.type} {one.get_reference()}" for one in indices)
        opcode = "getelementptr inbounds" if inbounds else "getelementptr"
        return self._line(ptr.type, f"{opcode} {source_etype}, {ptr.type} {ptr.get_reference()}, {places}")


F64 = ir.DoubleType()
I64 = ir.IntType(64)
VOID = ir.VoidType()
POINTER = F64.as_pointer()


def number(value: float) -> Any:
    """A constant of type double."""
    return ir.Constant(F64, value)


def whole(value: int) -> Any:
    """A constant of type int64."""
    return ir.Constant(I64, value)


def declare(module: Any, name: str, result: Any, arguments: list[tuple[str, Any]], *, private: bool = False) -> Any:
    """A function whose pointer arguments never overlap."""
    function = ir.Function(module, ir.FunctionType(result, [kind for _, kind in arguments]), name)
    for argument, (label, kind) in zip(function.args, arguments, strict=True):
        argument.name = label
        if isinstance(kind, ir.PointerType):
            argument.add_attribute("noalias")
    if private:
        function.linkage = "internal"
    return function


def at(builder: Any, base: Any, index: Any) -> Any:
    """Address of ``base[index]``; the index may be an int."""
    return builder.gep(base, [whole(index) if isinstance(index, int) else index], source_etype=F64)


def load(builder: Any, base: Any, index: Any) -> Any:
    """``base[index]``."""
    return builder.load(at(builder, base, index), typ=F64)


def store(builder: Any, value: Any, base: Any, index: Any) -> None:
    """``base[index] = value``."""
    builder.store(value, at(builder, base, index))


def scratch(builder: Any, size: int, name: str) -> Any:
    """An array of doubles on the stack of the function; call it in the entry block."""
    return builder.alloca(F64, size=whole(max(size, 1)), name=name)


def spread(builder: Any, value: Any, kind: Any) -> Any:
    """A double in all lanes of a kind of vector."""
    empty, first = ir.Constant(kind, ir.Undefined), ir.IntType(32)
    places = ir.Constant(ir.VectorType(first, kind.count), [0] * kind.count)
    return builder.shuffle_vector(builder.insert_element(empty, value, ir.Constant(first, 0)), empty, places)


@contextmanager
def counted(builder: Any, end: Any, name: str = "i") -> Iterator[Any]:
    """``for i in range(end)``; yields i."""
    end = whole(end) if isinstance(end, int) else end
    before = builder.block
    head = builder.append_basic_block(f"{name}.head")
    body = builder.append_basic_block(f"{name}.body")
    after = builder.append_basic_block(f"{name}.after")
    builder.branch(head)
    builder.position_at_end(head)
    index = builder.phi(I64, name)
    index.add_incoming(whole(0), before)
    builder.cbranch(builder.icmp_signed("<", index, end), body, after)
    builder.position_at_end(body)
    yield index
    index.add_incoming(builder.add(index, whole(1)), builder.block)
    builder.branch(head)
    builder.position_at_end(after)
