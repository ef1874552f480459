"""Kernels of sums, products and quotients as programs: their formulas are applied to numbers that note what is done.

CasADi finds the same, twenty times slower: that was a fifth of the time to compile a small robot.
"""

from __future__ import annotations

from typing import Any

from tmodes.compile.ir.program import BlockProgram, Instruction

__all__ = ["traced"]


def traced(kernel: Any) -> BlockProgram:
    """The program of a kernel; each value is computed once, and what is zero for certain not at all."""
    trace = _Trace()
    blocks = [
        [trace.number("input", source=(block, element)) for element in range(size)]
        for block, size in enumerate(kernel.inputs)
    ]
    entries = kernel.build(*blocks)
    assert tuple(map(len, entries)) == kernel.outputs, f"{kernel.key}: {[*map(len, entries)]} numbers"  # noqa: S101
    results = [
        (output, element, None if _is(entry, 0) else trace.of(entry).index)
        for output, block in enumerate(entries)
        for element, entry in enumerate(block)
    ]
    return BlockProgram(len(kernel.inputs), len(kernel.outputs), [*trace.known], results)


class _Trace:
    """What was done so far: each value once, in order."""

    def __init__(self) -> None:
        self.known: dict[Instruction, int] = {}

    def number(
        self, kind: str, args: tuple[int, ...] = (), source: tuple[int, int] = (0, 0), value: float = 0.0
    ) -> _Number:
        """A value."""
        return _Number(self, self.known.setdefault(Instruction(kind, args, source, value), len(self.known)))

    def of(self, value: Any) -> _Number:
        """A number, noted or plain, as a noted one."""
        return value if isinstance(value, _Number) else self.number("constant", value=float(value))


class _Number:
    """A value of a program; ``minus`` is the one that it is the negative of."""

    __array_ufunc__ = None  # NumPy's numbers leave it to ours
    __slots__ = ("index", "minus", "trace")

    def __init__(self, trace: _Trace, index: int, minus: _Number | None = None) -> None:
        self.trace, self.index, self.minus = trace, index, minus

    def __bool__(self) -> bool:
        raise TypeError("what a formula computes is not known while it is noted")

    def __neg__(self) -> _Number:
        if self.minus is not None:
            return self.minus
        return _Number(self.trace, self.trace.number("neg", (self.index,)).index, self)

    def __add__(self, other: Any) -> Any:
        if _is(other, 0):
            return self
        other = self.trace.of(other)
        if other.minus is not None:
            return self - other.minus
        if self.minus is not None:
            return other - self.minus
        return self.trace.number("add", tuple(sorted((self.index, other.index))))

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        if _is(other, 0):
            return self
        other = self.trace.of(other)
        if other.minus is not None:
            return self + other.minus
        return self.trace.number("sub", (self.index, other.index))

    def __rsub__(self, other: Any) -> Any:
        return -self if _is(other, 0) else self.trace.of(other) - self

    def __mul__(self, other: Any) -> Any:
        if _is(other, 0) or _is(other, 1):
            return self if other else 0.0
        other = self.trace.of(other)
        if self.minus is not None:
            return -(self.minus * other)
        if other.minus is not None:
            return -(self * other.minus)
        if self.index == other.index:
            return self.trace.number("sq", (self.index,))
        return self.trace.number("mul", tuple(sorted((self.index, other.index))))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        return self if _is(other, 1) else self.trace.number("div", (self.index, self.trace.of(other).index))

    def __rtruediv__(self, other: Any) -> Any:
        if _is(other, 0):
            return 0.0
        return self.trace.number("inv", (self.index,)) if _is(other, 1) else self.trace.of(other) / self

    def __pow__(self, exponent: int) -> Any:
        value: Any = self
        for _ in range(exponent - 1):
            value = value * self
        return value

    def __lt__(self, other: Any) -> Any:
        return self.trace.number("lt", (self.index, self.trace.of(other).index))

    def __gt__(self, other: Any) -> Any:
        return self.trace.of(other) < self

    def __le__(self, other: Any) -> Any:
        return self.trace.number("le", (self.index, self.trace.of(other).index))

    def __ge__(self, other: Any) -> Any:
        return self.trace.of(other) <= self

    def _function(self, kind: str) -> Any:
        return self.trace.number(kind, (self.index,))

    def sin(self) -> Any:
        """Sine."""
        return self._function("sin")

    def cos(self) -> Any:
        """Cosine."""
        return self._function("cos")

    def sqrt(self) -> Any:
        """Square root."""
        return self._function("sqrt")

    def fabs(self) -> Any:
        """Absolute value."""
        return self._function("fabs")

    def if_else(self, then: Any, otherwise: Any) -> Any:
        """``then`` where this is not 0, else ``otherwise``."""
        return self._where(then) + self._function("not")._where(otherwise)

    def _where(self, value: Any) -> Any:
        return 0.0 if _is(value, 0) else self.trace.number("if_else_zero", (self.index, self.trace.of(value).index))


def _is(value: Any, known: int) -> bool:
    return not isinstance(value, _Number) and value == known
