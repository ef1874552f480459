"""The functions of the C library that compiled code calls, as code of our own: a GPU has no C library.

Powers only set the lengths of steps: an error of 1e-9 is nothing to them. Sines are as exact as those of near angles.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir

from tmodes.compile.ir.arithmetic import Lanes
from tmodes.compile.ir.emit import F64, Builder, declare, number, whole
from tmodes.compile.ir.trigonometry import of_quarter_turns
from tmodes.compile.lanes.lanes_explicit import exponential, logarithm
from tmodes.compile.native import FAR_COSINE, FAR_SINE, POWER

__all__ = ["mathematics_module"]

_LARGEST = 1e300
_REACH = 2.0**40
_TWO_OVER_PI = 6.36619772367581382433e-01
_HALF_PI = (1.57079632679489655800e00, 6.12323399573676603587e-17, -1.49738490485916980920e-33)
"""pi/2 as a sum of three doubles, each the nearest to what the ones before leave."""


class _SingleLane(Lanes):
    """A vector of one number, for functions that are written for vectors."""

    stride = 1
    kind: Any = ir.VectorType(F64, 1)


def mathematics_module() -> Any:
    """The powers of positive numbers, and sine and cosine of large angles, under the names that compiled code calls."""
    module = ir.Module("mathematics")
    _write_power(module)
    for name, which in ((FAR_SINE, 0), (FAR_COSINE, 1)):
        _write_far(module, name, which)
    return module


def _write_power(module: Any) -> None:
    """Of a number that is none, and beyond 1e300, the power of 1e300."""
    function = declare(module, POWER, F64, [("x", F64), ("y", F64)])
    b, one, (x, y) = Builder(function.append_basic_block("entry")), _SingleLane(module), function.args
    x = b.select(b.fcmp_ordered("<", x, number(_LARGEST)), x, number(_LARGEST))
    base, exponent = (b.insert_element(one.constant(0.0), value, whole(0)) for value in (x, y))
    power = exponential(b, one, b.fmul(exponent, logarithm(b, one, base)))
    b.ret(b.extract_element(power, whole(0)))


def _write_far(module: Any, name: str, which: int) -> None:
    """Sine (0) or cosine (1) of an angle up to 2^40 rad, to rounding; beyond, no number.

    Products are exact by fused operations: x - n pi/2 needs no more digits than a double has, then n times the rest.
    """
    function = declare(module, name, F64, [("x", F64)])
    function.attributes.add("noinline")
    b, x = Builder(function.append_basic_block("entry")), function.args[0]
    turns = _call(b, "rint", b.fmul(x, number(_TWO_OVER_PI)))
    less = b.fneg(turns)
    first = _call(b, "fma", less, number(_HALF_PI[0]), x)
    second = b.fmul(turns, number(_HALF_PI[1]))
    lost = _call(b, "fma", turns, number(_HALF_PI[1]), b.fneg(second))
    head = b.fsub(first, second)
    tail = b.fsub(b.fsub(first, head), second)
    tail = b.fsub(_call(b, "fma", less, number(_HALF_PI[2]), tail), lost)
    near = b.fcmp_ordered("<", _call(b, "fabs", x), number(_REACH))
    b.ret(b.select(near, of_quarter_turns(b, module, turns, head, tail)[which], number(float("nan"))))


def _call(b: Any, name: str, *values: Any) -> Any:
    module, name = b.function.module, f"llvm.{name}.f64"
    known = module.globals.get(name)
    return b.call(known or ir.Function(module, ir.FunctionType(F64, [F64] * len(values)), name), [*values])
