"""Derivatives of a kernel's function as straight-line programs: along directions, and of weighted outputs by inputs.

A. Griewank, A. Walther, Evaluating Derivatives (2008), chapter 3: tangents forwards, adjoints in reverse.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, NamedTuple

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from tmodes.compile.ir.ordering import kernel_function
from tmodes.compile.ir.program import BlockProgram, block_program

__all__ = ["Written", "adjoint_program", "reached", "tangent_program", "turned"]

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
