"""A CasADi function as a straight-line program in single assignment form."""

from __future__ import annotations

import heapq
from collections import Counter, OrderedDict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import casadi as ca

from tmodes.errors import CompileError
from tmodes.kinds.kernel.schedule import Kernel

__all__ = [
    "READ",
    "BlockProgram",
    "Instruction",
    "block_program",
    "in_good_order",
    "kernel_function",
    "kernel_program",
    "needed",
    "traced",
    "with_shared_inverses",
]

READ = ("constant", "input")
"""Kinds of values that are not computed."""

_WORTH_AN_INVERSE = 2

_UNARY = {
    ca.OP_NEG: "neg", ca.OP_SQ: "sq", ca.OP_TWICE: "twice", ca.OP_SQRT: "sqrt", ca.OP_INV: "inv",
    ca.OP_SIN: "sin", ca.OP_COS: "cos", ca.OP_FABS: "fabs", ca.OP_SIGN: "sign", ca.OP_NOT: "not", ca.OP_ASSIGN: "copy",
}  # fmt: skip
_BINARY = {
    ca.OP_ADD: "add", ca.OP_SUB: "sub", ca.OP_MUL: "mul", ca.OP_DIV: "div", ca.OP_LT: "lt", ca.OP_LE: "le",
    ca.OP_IF_ELSE_ZERO: "if_else_zero",
}  # fmt: skip


class Instruction(NamedTuple):
    """One value: ``opcode`` is an operation, ``constant`` or ``input``; ``args`` are indices of earlier values.

    ``source`` is (argument, element) of an input, ``value`` the number of a constant.
    """

    opcode: str
    args: tuple[int, ...] = ()
    source: tuple[int, int] = (0, 0)
    value: float = 0.0


def _instruction(function: ca.Function, k: int, registers: dict[int, int]) -> Instruction:
    """Instruction ``k`` of a function, which is no output; ``registers`` says which value each register holds."""
    operation, reads = function.instruction_id(k), function.instruction_input(k)
    if operation == ca.OP_CONST:
        return Instruction("constant", value=function.instruction_constant(k))
    if operation == ca.OP_INPUT:
        return Instruction("input", source=(reads[0], reads[1]))
    kind = _UNARY.get(operation) or _BINARY.get(operation)
    if kind is None:
        raise CompileError(f"{function.name()}: operation {operation} of CasADi has no native form here")
    arity = 1 if operation in _UNARY else 2
    return Instruction(kind, tuple(registers[register] for register in reads[:arity]))


@dataclass
class BlockProgram:
    """Straight-line program of several input and output blocks; ``results``: (output, element, index of value).

    ``codes``: as IR, by the kind of numbers, once it is written.
    """

    inputs: int
    outputs: int
    values: list[Instruction] = field(default_factory=list)
    results: list[tuple[int, int, int | None]] = field(default_factory=list)
    codes: dict[str, str] = field(default_factory=dict, repr=False, compare=False)


def block_program(function: ca.Function) -> BlockProgram:
    """Read a function of several vectors with several dense output vectors; what is not given is zero."""
    program = BlockProgram(function.n_in(), function.n_out())
    registers: dict[int, int] = {}
    given: set[tuple[int, int]] = set()
    for k in range(function.n_instructions()):
        into = function.instruction_output(k)
        if function.instruction_id(k) == ca.OP_OUTPUT:
            program.results.append((into[0], into[1], registers[function.instruction_input(k)[0]]))
            given.add((into[0], into[1]))
            continue
        instruction = _instruction(function, k, registers)
        registers[into[0]] = len(program.values)
        program.values.append(instruction)
    every = {(out, element) for out in range(function.n_out()) for element in range(function.nnz_out(out))}
    program.values, places = with_shared_inverses(program.values)
    program.results = [(out, element, places[index]) for out, element, index in program.results if index is not None]
    program.results += [(out, element, None) for out, element in sorted(every - given)]
    return program


def needed(values: Sequence[Instruction], results: Iterable[int]) -> list[int]:
    """Indices of the values that some of them need, in order."""
    marks = bytearray(len(values))
    for index in results:
        marks[index] = True
    for index in reversed(range(len(values))):
        if marks[index]:
            for arg in values[index].args:
                marks[arg] = True
    return [index for index, is_needed in enumerate(marks) if is_needed]


def with_shared_inverses(values: Sequence[Instruction]) -> tuple[list[Instruction], list[int]]:
    """Quotients with one divisor become products with its inverse; and where each value stands now.

    A division keeps its unit busy for as long as five products.
    """
    divided = Counter(value.args[1] for value in values if value.opcode == "div")
    changed: list[Instruction] = []
    places: list[int] = []
    inverses: dict[int, int] = {}
    for value in values:
        divisor = value.args[1] if value.opcode == "div" else -1
        if divided[divisor] >= _WORTH_AN_INVERSE:
            if divisor not in inverses:
                inverses[divisor] = len(changed)
                changed.append(Instruction("inv", (places[divisor],)))
            changed.append(Instruction("mul", (places[value.args[0]], inverses[divisor])))
        else:
            changed.append(value._replace(args=tuple(places[arg] for arg in value.args)))
        places.append(len(changed) - 1)
    return changed, places


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


_LONGEST = 1000
"""Values of a program up to which its order is looked for."""

_UNITS = 2
_CYCLES = {"add": 2, "sub": 2, "twice": 2, "neg": 1, "div": 13, "inv": 13, "sqrt": 13, "sin": 40, "cos": 40}
_ADDERS = ("add", "sub", "twice", "neg")


_programs: OrderedDict[Any, BlockProgram] = OrderedDict()
_KEPT = 256
"""Programs that are kept: the schedules of one robot share most of their kernels."""


def kernel_program(kernel: Any) -> BlockProgram:
    """The program of a kernel, in an order that suits processors where that is not left to LLVM."""
    same = (kernel.key, kernel.inputs, kernel.outputs)
    if same not in _programs:
        _programs[same] = _program(kernel)
        while len(_programs) > _KEPT:
            _programs.popitem(last=False)
    return _programs[same]


def _program(kernel: Any) -> BlockProgram:
    program = traced(kernel) if kernel.plain else block_program(kernel_function(kernel))
    if kernel.long or len(program.values) > _LONGEST:
        return program
    order = in_good_order(program.values, [index for _, _, index in program.results if index is not None])
    places = {index: place for place, index in enumerate(order)}
    values = [program.values[k]._replace(args=tuple(places[arg] for arg in program.values[k].args)) for k in order]
    results = [(out, k, None if index is None else places[index]) for out, k, index in program.results]
    return BlockProgram(program.inputs, program.outputs, values, results)


def in_good_order(values: Sequence[Instruction], results: Sequence[int]) -> list[int]:
    """Indices of the values that ``results`` need, in a better order, what is read first."""
    chosen = needed(values, results)
    scheduler = _Scheduler(values, chosen, results)
    return [k for k in chosen if values[k].opcode in READ] + scheduler.run()


class _Scheduler:
    """One pass over the cycles of a simple processor."""

    def __init__(self, values: Sequence[Instruction], chosen: Sequence[int], results: Iterable[int]) -> None:
        count = len(values)
        reads = [value.opcode in READ for value in values]
        operations = [index for index in chosen if not reads[index]]
        self.cycles = [_CYCLES.get(value.opcode, 4) for value in values]
        self.unit = [value.opcode in _ADDERS for value in values]
        self.args = [[arg for arg in {*value.args} if not reads[arg]] for value in values]
        self.readers: list[list[int]] = [[] for _ in values]
        for index in operations:
            for arg in self.args[index]:
                self.readers[arg].append(index)
        self.unread = [len(readers) for readers in self.readers]
        for index in results:
            self.unread[index] += count  # it is kept to the end, and never read for the last time
        self.after = [0] * count
        for index in reversed(operations):
            self.after[index] = self.cycles[index] + max((self.after[k] for k in self.readers[index]), default=0)
        self.missing = [len(args) for args in self.args]
        self.known = [0] * count
        self.ready = [index for index in operations if not self.missing[index]]

    def run(self) -> list[int]:
        """All operations in the order in which they begin."""
        order: list[int] = []
        waiting: list[tuple[int, int]] = []
        cycle = 0
        while self.ready or waiting:
            while waiting and waiting[0][0] <= cycle:
                self.ready.append(heapq.heappop(waiting)[1])
            order += self._cycle(cycle, waiting)
            cycle += 1
        return order

    def _cycle(self, cycle: int, waiting: list[tuple[int, int]]) -> list[int]:
        """What begins in a cycle."""
        free, begun = [_UNITS, _UNITS], []
        while chosen := [index for index in self.ready if free[self.unit[index]]]:
            best = min(chosen, key=self._rank)
            self.ready.remove(best)
            free[self.unit[best]] -= 1
            begun.append(best)
            for arg in self.args[best]:
                self.unread[arg] -= 1
            for reader in self.readers[best]:
                self.missing[reader] -= 1
                self.known[reader] = max(self.known[reader], cycle + self.cycles[best])
                if not self.missing[reader]:
                    heapq.heappush(waiting, (self.known[reader], reader))
        return begun

    def _rank(self, index: int) -> tuple[int, int, int]:
        last = 0
        for arg in self.args[index]:
            last += self.unread[arg] == 1
        return -last, -self.after[index], index


def kernel_function(kernel: Kernel) -> ca.Function:
    """The kernel as a CasADi function; common subexpressions are found."""
    symbols = [ca.SX.sym(f"i{k}", size) for k, size in enumerate(kernel.inputs)]
    results = [ca.vertcat(*map(ca.SX, entries)) for entries in kernel.build(*symbols)]
    for size, result in zip(kernel.outputs, results, strict=True):
        assert result.numel() == size, f"{kernel.key}: {result.numel()} numbers, expected {size}"  # noqa: S101
    dense = [ca.densify(result) for result in results]
    return ca.Function("kernel", symbols, dense, {"cse": True})
