"""Straight-line programs: what a function did with its numbers, for many cases at once, with its derivative."""

from __future__ import annotations

import hashlib
import operator
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property, reduce
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.kernel import functions as symbolic
from tmodes.kinds.kernel.schedule import Kernel, Schedule, Slot
from tmodes.kinds.noted.number import OPERATIONS, RELATIONS, NotedTape

__all__ = ["Program", "program_of"]

Array = NDArray[np.float64]

_BLOCK = 2048
"""Cases that are computed at once: their numbers stay in the processor's cache."""


@dataclass(frozen=True, eq=False)
class Program:
    """``inputs`` numbers -> ``outputs``, by ``operations`` (name, operands) in order on a list of registers.

    Registers begin with the inputs, then the ``constants``, then one for each operation. ``guards`` (relation, a, b)
    are what must hold of registers; ``outputs``: the register of each number.
    """

    inputs: int
    constants: Array
    operations: tuple[tuple[Any, ...], ...]
    outputs: NDArray[np.intp]
    guards: tuple[tuple[str, int, int], ...]
    _last: dict[int, list[int]] = field(init=False, repr=False)
    _still: NDArray[np.intp] = field(init=False, repr=False)
    _standing: Array = field(init=False, repr=False)
    _moving: list[int] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        constant = (self.outputs >= self.inputs) & (self.outputs < self.inputs + len(self.constants))
        object.__setattr__(self, "_still", np.flatnonzero(constant))
        object.__setattr__(self, "_standing", self.constants[self.outputs[constant] - self.inputs])
        object.__setattr__(self, "_moving", np.flatnonzero(~constant).tolist())
        last: dict[int, int] = {}
        for k, (_, *operands) in enumerate(self.operations):
            last.update(dict.fromkeys(operands, k))
        first = self.inputs + len(self.constants)
        kept = {*self.outputs.tolist(), *(k for _, *both in self.guards for k in both)}
        ends: dict[int, list[int]] = {}
        for register, k in last.items():
            if register >= first and register not in kept:
                ends.setdefault(k, []).append(register)
        object.__setattr__(self, "_last", ends)

    def __call__(self, values: Array) -> tuple[Array, NDArray[np.bool_]]:
        """Outputs (n, numbers) of cases ``values`` (n, inputs), and which cases hold to the guards (n,)."""
        cases = np.asarray(values, dtype=float)
        found, holds = np.empty((len(cases), len(self.outputs))), np.empty(len(cases), dtype=bool)
        for start in range(0, len(cases), _BLOCK):
            part = slice(start, start + _BLOCK)
            registers = self._registers(cases[part])
            found[part, self._still] = self._standing
            for k in self._moving:
                found[part, k] = registers[self.outputs[k]]
            holds[part] = self._holds(registers, cases[part])
        return found, holds

    def part(self, outputs: NDArray[np.intp], *, guarded: bool = False) -> Program:
        """The program of some outputs alone; ``guarded``: with all guards."""
        guards, chosen = self.guards if guarded else (), self.outputs[outputs]
        first = self.inputs + len(self.constants)
        needed = {*chosen.tolist(), *(k for _, *both in guards for k in both)}
        for k in range(len(self.operations) - 1, -1, -1):
            if first + k in needed:
                needed.update(self.operations[k][1:])
        kept = [k for k in sorted(needed) if k >= first]
        own = {k: k for k in range(first)} | {k: first + place for place, k in enumerate(kept)}
        operations = tuple(
            (name, *(own[k] for k in operands)) for name, *operands in (self.operations[k - first] for k in kept)
        )
        guards = tuple((relation, own[a], own[b]) for relation, a, b in guards)
        places = np.array([own[k] for k in chosen], dtype=np.intp)
        return Program(self.inputs, self.constants, operations, places, guards)

    def acting(self, outputs: NDArray[np.intp]) -> set[int]:
        """The inputs that some outputs depend on."""
        masks = [1 << k for k in range(self.inputs)] + [0] * len(self.constants)
        for _, *operands in self.operations:
            masks.append(0)
            for k in operands:
                masks[-1] |= masks[k]
        found = reduce(operator.or_, (masks[place] for place in self.outputs[outputs].tolist()), 0)
        return {k for k in range(self.inputs) if found >> k & 1}

    @property
    def is_constant(self) -> bool:
        """Whether no output depends on an input."""
        return not self.operations and bool((self.outputs >= self.inputs).all())

    def _registers(self, cases: Array) -> list[Any]:
        registers: list[Any] = [*cases.T, *self.constants]
        with np.errstate(all="ignore"):
            for k, (name, *operands) in enumerate(self.operations):
                registers.append(OPERATIONS[name](*(registers[j] for j in operands)))
                for done in self._last.get(k, ()):
                    registers[done] = None
        return registers

    def _holds(self, registers: Sequence[Any], cases: Array) -> NDArray[np.bool_]:
        holds = np.asarray(np.isfinite(cases).all(axis=1))
        with np.errstate(all="ignore"):
            for relation, a, b in self.guards:
                np.logical_and(holds, RELATIONS[relation](registers[a], registers[b]), out=holds)
        return holds

    @cached_property
    def _exponents(self) -> dict[int, float]:
        """The powers that are constants, by their registers."""
        first, end = self.inputs, self.inputs + len(self.constants)
        powers = {ends[1] for name, *ends in self.operations if name == "pow"}
        return {b: float(self.constants[b - first]) for b in sorted(powers) if first <= b < end}

    @cached_property
    def compiles(self) -> bool:
        """Whether compiled code has all operations: it lacks logarithms, and powers but small whole numbers."""
        return all(
            self._exponents.get(ends[1]) in _POWERS if name == "pow" else name in _SYMBOLIC
            for name, *ends in self.operations
        )

    @cached_property
    def schedule(self) -> Schedule:
        """For compiled code: ``values`` -> ``numbers`` and ``holds`` (1 or 0); the constants are its parameters.

        Raises ValueError where the program does not compile.
        """
        if not self.compiles:
            raise ValueError("a logarithm, or a power that is no small whole number, does not compile")
        info = repr((self.operations, self._exponents, self.outputs.tolist(), self.guards))
        sizes = (len(self.constants), self.inputs), (len(self.outputs), 1)
        key = f"program {hashlib.sha256(info.encode()).hexdigest()}"
        kernel = Kernel(key, *sizes, self._symbols, plain=True)
        schedule = Schedule(len(self.constants))
        given = Slot("parameters", 0, len(self.constants)), schedule.input("values", self.inputs)
        numbers, holds = schedule.call(kernel, *given)
        schedule.output("numbers", numbers)
        schedule.output("holds", holds)
        return schedule

    def _symbols(self, constants: Any, values: Any) -> list[list[Any]]:
        """Outputs, and whether the guards hold, of symbols; each guard as soon as its numbers are known."""
        registers = [*(values[k] for k in range(self.inputs)), *(constants[k] for k in range(len(self.constants)))]
        guards: dict[int, list[tuple[str, int, int]]] = {}
        for relation, a, b in self.guards:
            guards.setdefault(max(a, b, len(registers) - 1), []).append((relation, a, b))
        holds: Any = 1.0
        for k, (name, *operands) in enumerate([("", 0), *self.operations], len(registers) - 1):
            if name == "pow":
                registers.append(_whole_power(registers[operands[0]], int(self._exponents[operands[1]])))
            elif name:
                registers.append(_SYMBOLIC[name](*(registers[j] for j in operands)))
            for relation, a, b in guards.get(k, ()):
                holds = _RELATED[relation](registers[a], registers[b]) * holds
        return [[registers[k] for k in self.outputs.tolist()], [holds]]

    def derivative(self, values: Array) -> Array:
        """Exact derivatives (numbers, inputs) of the outputs by the inputs at ``values`` (inputs,)."""
        point = np.asarray(values, dtype=float)
        registers: list[Any] = [*point, *self.constants]
        slopes: list[Any] = [*np.eye(self.inputs), *np.zeros((len(self.constants), self.inputs))]
        with np.errstate(all="ignore"):
            for name, *operands in self.operations:
                x = [registers[j] for j in operands]
                registers.append(OPERATIONS[name](*x))
                parts = _SLOPES[name](registers[-1], *x)
                slopes.append(sum(part * slopes[j] for part, j in zip(parts, operands, strict=True) if slopes[j].any())
                              + np.zeros(self.inputs))  # fmt: skip
        return np.array([slopes[k] for k in self.outputs]).reshape(len(self.outputs), self.inputs)


_POWERS = frozenset(k for k in range(-16, 17) if k)
"""Whole powers that compiled code has, as products."""


def _whole_power(x: Any, exponent: int) -> Any:
    """A product of squares, whose rounding errors are fewer than those of a row of factors."""
    found: Any = None
    square, left = x, abs(exponent)
    while left:
        if left & 1:
            found = square if found is None else found * square
        left >>= 1
        square = square * square if left else square
    return found if exponent > 0 else 1.0 / found


def _cathetus(x: Any) -> Any:
    return symbolic.sqrt((1.0 - x) * (1.0 + x))


_SYMBOLIC: dict[str, Callable[..., Any]] = {
    "add": operator.add, "sub": operator.sub, "mul": operator.mul, "div": operator.truediv, "neg": operator.neg,
    "abs": symbolic.fabs, "sqrt": symbolic.sqrt, "sin": symbolic.sin, "cos": symbolic.cos, "tan": symbolic.tan,
    "exp": symbolic.exp, "tanh": symbolic.tanh, "arctan2": symbolic.atan2, "arctan": lambda x: symbolic.atan2(x, 1.0),
    "arcsin": lambda x: symbolic.atan2(x, _cathetus(x)),
    "arccos": lambda x: symbolic.atan2(_cathetus(x), x),
    "hypot": lambda a, b: symbolic.sqrt(a * a + b * b), "fmin": symbolic.fmin, "fmax": symbolic.fmax,
}  # fmt: skip
"""The operations on the symbols of compiled code: sums, products, quotients and square roots to the last bit."""


def _no(truth: Any) -> Any:
    return symbolic.if_else(truth, 0.0, 1.0)


def _equal(a: Any, b: Any) -> Any:
    return (a <= b) * (b <= a)


_RELATED: dict[str, Callable[[Any, Any], Any]] = {
    "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge, "==": _equal,
    "!=": lambda a, b: _no(_equal(a, b)), "not !=": _equal, "not ==": lambda a, b: _no(_equal(a, b)),
    "not <": lambda a, b: _no(a < b), "not <=": lambda a, b: _no(a <= b), "not >": lambda a, b: _no(a > b),
    "not >=": lambda a, b: _no(a >= b), "finite": lambda a, b: symbolic.fabs(a) < np.inf,
}  # fmt: skip
"""The relations of guards on symbols: the numbers 1 and 0."""


def _power(y: float, a: float, b: float) -> tuple[float, float]:
    return b * a ** (b - 1), (y * np.log(a) if a > 0 else 0.0)


_SLOPES: dict[str, Any] = {
    "add": lambda y, a, b: (1.0, 1.0), "sub": lambda y, a, b: (1.0, -1.0), "mul": lambda y, a, b: (b, a),
    "div": lambda y, a, b: (1 / b, -y / b), "pow": _power, "neg": lambda y, a: (-1.0,),
    "abs": lambda y, a: (np.sign(a),), "sqrt": lambda y, a: (0.5 / y if y else 0.0,), "sin": lambda y, a: (np.cos(a),),
    "cos": lambda y, a: (-np.sin(a),), "tan": lambda y, a: (1 + y * y,), "exp": lambda y, a: (y,),
    "log": lambda y, a: (1 / a,), "arcsin": lambda y, a: (1 / np.sqrt(1 - a * a),),
    "arccos": lambda y, a: (-1 / np.sqrt(1 - a * a),), "arctan": lambda y, a: (1 / (1 + a * a),),
    "arctan2": lambda y, a, b: (b / (a * a + b * b), -a / (a * a + b * b)),
    "hypot": lambda y, a, b: (a / y if y else 0.0, b / y if y else 0.0), "tanh": lambda y, a: (1 - y * y,),
    "fmin": lambda y, a, b: (float(a <= b), float(a > b)), "fmax": lambda y, a, b: (float(a >= b), float(a < b)),
}  # fmt: skip
"""Partial derivatives of each operation: of its result y by its operands."""


def program_of(tape: NotedTape, inputs: Sequence[Any], outputs: Sequence[Any]) -> Program:
    """The program of a tape from ``inputs`` (noted numbers) to ``outputs`` (noted or plain numbers).

    What no output and no guard needs is left out.
    """
    ends = [tape.operand(x) for x in outputs]
    if None in ends:
        raise TypeError("an output is no number")
    needed, stack = set[int](), [*ends, *(k for _, *both in tape.guards for k in both)]
    while stack:
        node = stack.pop()
        if node not in needed:
            needed.add(node)
            stack += [] if tape.nodes[node][0] in ("input", "constant") else tape.nodes[node][1:]
    own = {x.node: k for k, x in enumerate(inputs)}
    constants = sorted(node for node in needed if tape.nodes[node][0] == "constant")
    own |= {node: len(inputs) + k for k, node in enumerate(constants)}
    operations = []
    for node in sorted(needed):
        name, *operands = tape.nodes[node]
        if name not in ("input", "constant"):
            own[node] = len(inputs) + len(constants) + len(operations)
            operations.append((name, *(own[k] for k in operands)))
    guards = tuple((relation, own[a], own[b]) for relation, a, b in tape.guards)
    values = np.array([tape.values[k] for k in constants])
    return Program(len(inputs), values, tuple(operations), np.array([own[k] for k in ends], dtype=np.intp), guards)
