"""A builder of LLVM IR that writes the common instructions as text at once: most of the time to compile went there."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from llvmlite import ir

__all__ = ["Builder"]


class _Line:
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

    def _line(self, kind: Any, text: str) -> _Line:
        scope: Any = self.function.scope
        scope.lines = count = getattr(scope, "lines", 0) + 1
        reference = f'%"v:{count}"'
        line = _Line(kind, reference, f"{reference} = {text}")
        self._insert(line)
        return line

    def _insert(self, instr: Any) -> None:
        block: Any = self._block
        block.instructions.insert(self._anchor, instr)
        self._anchor += 1

    def _binary(self, opcode: str, lhs: Any, rhs: Any, flags: Sequence[str]) -> _Line:
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
        line = _Line(None, "", f"store {value.type} {value.get_reference()}, {where}")
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
