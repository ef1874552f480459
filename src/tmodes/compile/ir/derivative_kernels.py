"""Derivatives of a kernel as straight-line programs, and as native kernels of values, slopes and weights."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, NamedTuple

import casadi as ca
import numpy as np
from llvmlite import ir
from numpy.typing import NDArray

from tmodes.compile.ir.arithmetic import Double, Lanes
from tmodes.compile.ir.emit import F64, I64, POINTER, VOID, Builder, at, declare
from tmodes.compile.ir.kernels import row_function
from tmodes.compile.ir.program import BlockProgram, block_program, kernel_function
from tmodes.compile.native import Library

__all__ = [
    "ADD",
    "LANES",
    "NONE",
    "STORE",
    "Adjoint",
    "Tangent",
    "Written",
    "adjoint_program",
    "reached",
    "tangent_program",
    "turned",
]

Elements = tuple[int, ...]
Source = tuple[int, int]


class Written(NamedTuple):
    """A program, and the elements of its block that each of its outputs gives."""

    program: BlockProgram
    elements: list[Elements]


def tangent_program(kernel: Any, active: tuple[Elements, ...], *, valued: bool) -> Written:
    """Slopes of the outputs from slopes of the ``active`` elements of each input; also the outputs where ``valued``.

    Inputs: those of the kernel, then a block of slopes for each input that has active elements. Outputs: those of the
    kernel where ``valued``, then the slopes of each output that has any.
    """
    xs, ys = _expressions(kernel)
    slopes = [
        ca.SX.sym(f"d{k}", x.numel()) if elements else None
        for k, (x, elements) in enumerate(zip(xs, active, strict=True))
    ]
    known: list[Any] = [slope for slope in slopes if slope is not None]
    outs, info = (list(ys), [tuple(range(y.numel())) for y in ys]) if valued else ([], [])
    if known:
        at = ca.vertcat(*(x[list(elements)] for x, elements in zip(xs, active, strict=True) if elements))
        along = ca.vertcat(*(d[list(elements)] for d, elements in zip(known, filter(None, active), strict=True)))
        found = ca.vertsplit(ca.jtimes(ca.vertcat(*ys), at, along), [0, *np.cumsum([y.numel() for y in ys]).tolist()])
        for slope, elements in zip(found, reached(kernel, active), strict=True):
            if elements:
                outs.append(slope[list(elements)])
                info.append(elements)
    return _written([*xs, *known], outs, info)


def adjoint_program(kernel: Any, seeded: tuple[bool, ...], wanted: tuple[bool, ...]) -> Written:
    """Weights of the outputs carried to the ``wanted`` inputs: products of a row of weights with the Jacobian.

    Inputs: those of the kernel, then the weights of each ``seeded`` output. Outputs: the weights of each wanted input.
    """
    xs, ys = _expressions(kernel)
    weights = [
        ca.SX.sym(f"w{k}", y.numel()) if used else None for k, (y, used) in enumerate(zip(ys, seeded, strict=True))
    ]
    known = [weight for weight in weights if weight is not None]
    chosen = [x for x, used in zip(xs, wanted, strict=True) if used]
    value = ca.vertcat(*(y for y, used in zip(ys, seeded, strict=True) if used))
    found = ca.jtimes(value, ca.vertcat(*chosen), ca.vertcat(*known), True)
    outs = ca.vertsplit(found, [0, *np.cumsum([x.numel() for x in chosen]).tolist()])
    return _written([*xs, *known], outs, [tuple(range(x.numel())) for x in chosen])


def reached(kernel: Any, active: tuple[Elements, ...]) -> list[Elements]:
    """The elements of each output that depend on an active element of an input."""
    found: list[Elements] = []
    for pattern in _pattern(_Named.of(kernel)):
        touched = np.zeros(pattern[0].shape[0] if pattern else 0, dtype=bool)
        for block, elements in zip(pattern, active, strict=True):
            if elements:
                touched |= block[:, list(elements)].any(axis=1)
        found.append(tuple(np.flatnonzero(touched).tolist()))
    return found


def turned(kernel: Any) -> tuple[Source, ...]:
    """The elements of inputs, as (input, element), whose sine or cosine the kernel takes as they are."""
    return _turned(_Named.of(kernel))


@dataclass(frozen=True)
class _Named:
    """A kernel by its structure: kernels of one key are one function."""

    key: tuple[Any, ...]
    kernel: Any = field(compare=False)

    @classmethod
    def of(cls, kernel: Any) -> _Named:
        return cls((kernel.key, kernel.inputs, kernel.outputs), kernel)


@lru_cache(maxsize=512)
def _function(named: _Named) -> ca.Function:
    return kernel_function(named.kernel)


@lru_cache(maxsize=4096)
def _turned(named: _Named) -> tuple[Source, ...]:
    values = block_program(_function(named)).values
    angles = (values[value.args[0]] for value in values if value.opcode in ("sin", "cos"))
    return tuple(sorted({angle.source for angle in angles if angle.opcode == "input"}))


def _expressions(kernel: Any) -> tuple[list[Any], list[Any]]:
    function = _function(_Named.of(kernel))
    xs = list(function.sx_in())
    return xs, [ca.densify(y) for y in function.call(xs)]


@lru_cache(maxsize=4096)
def _pattern(named: _Named) -> list[list[NDArray[np.bool_]]]:
    """Which elements of each output depend on which of each input."""
    function = _function(named)
    return [
        [_dense(function.jac_sparsity(out, into)) for into in range(function.n_in())] for out in range(function.n_out())
    ]


def _dense(sparsity: Any) -> NDArray[np.bool_]:
    pattern = np.zeros(sparsity.shape, dtype=bool)
    rows, columns = sparsity.get_triplet()
    pattern[rows, columns] = True
    return pattern


def _written(inputs: list[Any], outputs: list[Any], info: list[Elements]) -> Written:
    function = ca.Function("derivative", inputs, [ca.densify(out) for out in outputs], {"cse": True})
    return Written(block_program(function), info)


LANES = 8
"""Directions side by side: as many doubles as the widest registers hold."""

NONE, STORE, ADD = 0, 1, 2
"""What an adjoint does with the weights of an input: nothing, first to write there, or one more term."""

_LONG = 3000
"""Operations above which code that is seldom called is made quicker to compile than to run."""


class _WideLanes(Lanes):
    stride = LANES
    kind: Any = ir.VectorType(F64, LANES)


class _Block(NamedTuple):
    """A block of a row: among the slopes or the values, read or written, as one more term or not."""

    sloped: bool
    given: bool
    adds: bool = False


@dataclass(frozen=True)
class Tangent:
    """Slopes of a kernel's outputs along ``lanes`` directions of the ``active`` elements of its inputs.

    With ``valued`` the outputs themselves too; ``seldom``: few calls are expected.

    Row: inputs; outputs where valued; slopes of each input that has active elements; slopes of each output that has
    any; where the kernel takes sines of inputs, those and their cosines, which the one that computes values keeps, and
    others take.
    """

    kernel: Any
    active: tuple[Elements, ...]
    lanes: int
    valued: bool
    seldom: bool = False

    def library(self) -> tuple[str, Library]:
        """The native function, made at its first use."""
        info = f"tangent {self.active} {self.lanes} {self.valued} {self.seldom}"
        return _library(self, info, self.lanes, seldom=self.seldom)

    def written(self) -> tuple[Written, list[_Block]]:
        """The program and the blocks of the row."""
        written = tangent_program(self.kernel, self.active, valued=self.valued)
        values = len(self.kernel.outputs) if self.valued else 0
        blocks = [_Block(sloped=False, given=False) for _ in self.active]
        blocks += [_Block(sloped=False, given=True) for _ in range(values)]
        blocks += [_Block(sloped=True, given=False) for elements in self.active if elements]
        return written, blocks + [_Block(sloped=True, given=True) for _ in written.elements[values:]]


@dataclass(frozen=True)
class Adjoint:
    """Weights of the ``seeded`` outputs of a kernel carried to its inputs as ``modes`` says of each.

    Row: inputs; weights of each seeded output; weights of each input whose mode is not ``NONE``; sines and cosines.
    """

    kernel: Any
    seeded: tuple[bool, ...]
    modes: tuple[int, ...]

    def library(self) -> tuple[str, Library]:
        """The native function, made at its first use."""
        return _library(self, f"adjoint {self.seeded} {self.modes}", 1)

    def written(self) -> tuple[Written, list[_Block]]:
        """The program and the blocks of the row."""
        written = adjoint_program(self.kernel, self.seeded, tuple(mode != NONE for mode in self.modes))
        blocks = [_Block(sloped=False, given=False) for _ in self.modes]
        blocks += [_Block(sloped=True, given=False) for used in self.seeded if used]
        return written, blocks + [_Block(sloped=True, given=True, adds=mode == ADD) for mode in self.modes if mode]


def _library(variant: Any, info: str, lanes: int, *, seldom: bool = False) -> tuple[str, Library]:
    kernel = variant.kernel
    digest = hashlib.sha256(f"{kernel.key} {kernel.inputs} {kernel.outputs} {info} {LANES}".encode())
    symbol = f"derived_{digest.hexdigest()[:32]}"

    def write() -> tuple[Any, int]:
        module = ir.Module(symbol)
        program = _Writer(module, symbol, variant, lanes).write()
        return module, 0 if seldom and len(program.values) > _LONG else 1

    return symbol, row_function(symbol, write)


class _Writer:
    """Writes the operations of a program on numbers and on rows of lanes."""

    def __init__(self, module: Any, symbol: str, variant: Tangent | Adjoint, lanes: int) -> None:
        arguments = [("values", POINTER), ("slopes", POINTER), ("row", I64.as_pointer())]
        values, slopes, row = (function := declare(module, symbol, VOID, arguments)).args
        self.b: Any = Builder(function.append_basic_block("entry"))
        self.plain: Double = Double(module)
        self.wide: Any = _WideLanes(module) if lanes > 1 else self.plain
        self.written, self.blocks = variant.written()
        self.angles, self.keeps = turned(variant.kernel), getattr(variant, "valued", False)
        self.kinds = [self.wide if block.sloped else self.plain for block in self.blocks]
        self.spread_values: dict[int, Any] = {}
        blocks = [*self.blocks, _Block(sloped=False, given=True)] if self.angles else self.blocks
        self.places = []
        for k, block in enumerate(blocks):
            place = self.b.load(self.b.gep(row, [ir.Constant(I64, k)], source_etype=I64), typ=I64)
            self.places.append(at(self.b, slopes if block.sloped else values, place))

    def write(self) -> BlockProgram:
        """All of the function; the program that it follows."""
        self._give(self._values(self.written.program))
        self.b.ret_void()
        return self.written.program

    def _values(self, program: BlockProgram) -> list[Any]:
        """All values of the program."""
        taken = [k for k, block in enumerate(self.blocks) if not block.given]
        found: list[Any] = []
        turned: dict[int, tuple[Any, Any]] = {}
        for instruction in program.values:
            if instruction.opcode == "constant":
                value = self.plain.constant(instruction.value)
            elif instruction.opcode == "input":
                k = taken[instruction.source[0]]
                value = self.kinds[k].load(self.b, self.places[k], instruction.source[1])
            elif instruction.opcode in ("sin", "cos"):
                angle = instruction.args[0]
                if angle not in turned:
                    turned[angle] = self._turned(program.values[angle], found[angle])
                value = turned[angle][0 if instruction.opcode == "sin" else 1]
            else:
                value = self._operation(instruction.opcode, [found[arg] for arg in instruction.args])
            found.append(value)
        return found

    def _turned(self, instruction: Any, angle: Any) -> tuple[Any, Any]:
        """Sine and cosine; those of inputs are kept for the derivatives, which are spared to compute them again."""
        kept = instruction.opcode == "input" and instruction.source in self.angles
        place = 2 * self.angles.index(instruction.source) if kept else 0
        if kept and not self.keeps:
            return tuple(self.plain.load(self.b, self.places[-1], place + k) for k in range(2))
        pair = self.plain.turn(self.b, angle)
        for k in range(2 * kept):
            self.plain.store(self.b, pair[k], self.places[-1], place + k)
        return pair

    def _give(self, values: list[Any]) -> None:
        """Write the results, after all is read: an input's weights may stand where others are added."""
        given = [k for k, block in enumerate(self.blocks) if block.given]
        for output, number, index in sorted(self.written.program.results):
            k, element = given[output], self.written.elements[output][number]
            kind = self.kinds[k]
            value = self.plain.constant(0.0) if index is None else values[index]
            value = self._spread(value) if kind is self.wide else value
            if self.blocks[k].adds:
                value = kind.operation(self.b, "add", kind.load(self.b, self.places[k], element), value)
            kind.store(self.b, value, self.places[k], element)

    def _operation(self, kind: str, args: list[Any]) -> Any:
        if any(isinstance(arg.type, ir.VectorType) for arg in args):
            return self.wide.operation(self.b, kind, *map(self._spread, args))
        return self.plain.operation(self.b, kind, *args)

    def _spread(self, value: Any) -> Any:
        """A number in every lane."""
        if self.wide.stride == 1 or isinstance(value.type, ir.VectorType):
            return value
        if isinstance(value, ir.Constant):
            return self.wide.constant(value.constant)
        if id(value) not in self.spread_values:
            self.spread_values[id(value)] = self.wide.spread(self.b, value)
        return self.spread_values[id(value)]
