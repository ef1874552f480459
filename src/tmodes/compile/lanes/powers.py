"""Powers of two and logarithms in lanes, for the control of steps."""

from __future__ import annotations

import math
import struct
from typing import Any

from llvmlite import ir

from tmodes.compile.ir.arithmetic import Lanes
from tmodes.compile.ir.emit import I64

__all__ = ["exponential", "logarithm"]

_SHIFT, _ONE = 52, 1023 << 52
_MAGIC = 1.5 * 2.0**52
"""Added to a number below 2^51 it leaves the nearest whole number in the low bits."""
_ROOT_HALF = struct.unpack("<q", struct.pack("<d", math.sqrt(0.5)))[0]
"""Bits of the square root of 1/2."""


def _whole(lanes: Lanes) -> Any:
    return ir.VectorType(I64, lanes.stride)


def _bits(lanes: Lanes, value: int) -> Any:
    return ir.Constant(_whole(lanes), [value] * lanes.stride)


def logarithm(b: Any, lanes: Lanes, x: Any) -> Any:
    """Logarithm to base 2 of positive normal numbers; of others some finite number."""
    bits = b.bitcast(x, _whole(lanes))
    # The mantissa lies in [sqrt(1/2), sqrt(2)) when the exponent is taken at that boundary.
    shifted = b.sub(bits, _bits(lanes, _ROOT_HALF))
    exponent = b.and_(b.lshr(shifted, _bits(lanes, _SHIFT)), _bits(lanes, 0xFFF))
    mantissa = b.bitcast(b.sub(bits, b.shl(exponent, _bits(lanes, _SHIFT))), lanes.kind)
    # As a double: the whole number becomes the low bits of 2^52, or, where it is negative, of 2^52 + 2^12.
    signed = b.xor(exponent, _bits(lanes, 0x800))
    number = b.bitcast(b.or_(signed, _bits(lanes, (1023 + _SHIFT) << _SHIFT)), lanes.kind)
    power = b.fsub(number, lanes.constant(2.0**_SHIFT + 0x800))
    t = b.fdiv(b.fsub(mantissa, lanes.constant(1.0)), b.fadd(mantissa, lanes.constant(1.0)))
    series = _polynomial(b, lanes, b.fmul(t, t), [2 / math.log(2) / (2 * k + 1) for k in range(6)])
    return b.fadd(power, b.fmul(t, series))


def exponential(b: Any, lanes: Lanes, x: Any) -> Any:
    """2 to the power x, for |x| below 1000."""
    moved = b.fadd(x, lanes.constant(_MAGIC))
    share = b.fsub(x, b.fsub(moved, lanes.constant(_MAGIC)))
    scale = b.add(b.shl(b.bitcast(moved, _whole(lanes)), _bits(lanes, _SHIFT)), _bits(lanes, _ONE))
    series = _polynomial(b, lanes, share, [math.log(2) ** k / math.factorial(k) for k in range(9)])
    return b.fmul(series, b.bitcast(scale, lanes.kind))


def _polynomial(b: Any, lanes: Lanes, x: Any, coefficients: list[float]) -> Any:
    value = lanes.constant(coefficients[-1])
    for coefficient in reversed(coefficients[:-1]):
        value = b.fadd(lanes.constant(coefficient), b.fmul(x, value))
    return value
