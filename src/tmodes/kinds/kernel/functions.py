"""Elementary functions for kernels, without a numeric library of their own: the operand's implementation is called.

Operands: CasADi expressions, floats, NumPy arrays, and the numbers of :mod:`tmodes.compile.ir.program`. A symbolic
operand has ``sin``, ``cos``, ``sqrt``, ``fabs`` and ``if_else`` as methods, or ``if_else`` stands in its module (as in
CasADi's). What is built from these and from sums, products and quotients compiles to native code and to WebAssembly:
so are ``exp`` and ``tanh`` of a symbolic operand.
"""

from __future__ import annotations

import math
import sys
from math import factorial
from typing import Any

import numpy as np

__all__ = ["atan2", "cos", "exp", "fabs", "fmax", "fmin", "if_else", "sin", "sqrt", "tan", "tanh"]

_HALVINGS = 10
"""exp(x) is found at x/2^10 and squared ten times."""

_TERMS = 16
"""Terms of the series of exp(x) - 1; at |x| <= 700/2^10 the remainder is below 1e-16."""

_SATURATED = 20.0
"""tanh differs from 1 by less than half a unit in the last place from here on."""


def _is_number(x: Any) -> bool:
    return isinstance(x, (int, float))


def _is_array(x: Any) -> bool:
    return isinstance(x, (np.ndarray, np.generic))


def _unary(name: str, x: Any) -> Any:
    if _is_number(x):
        return getattr(math, name)(x)
    return getattr(np, name)(x) if _is_array(x) else getattr(x, name)()


def sin(x: Any) -> Any:
    """Sine of an angle [rad]."""
    return _unary("sin", x)


def cos(x: Any) -> Any:
    """Cosine of an angle [rad]."""
    return _unary("cos", x)


def tan(x: Any) -> Any:
    """Tangent of an angle [rad]."""
    return sin(x) / cos(x)


def sqrt(x: Any) -> Any:
    """Square root."""
    return _unary("sqrt", x)


def fabs(x: Any) -> Any:
    """Absolute value; its slope at 0 is 1."""
    return _unary("fabs", x)


def if_else(condition: Any, then: Any, otherwise: Any) -> Any:
    """``then`` where the condition holds, else ``otherwise``; the other value may be infinite or undefined."""
    if isinstance(condition, (bool, np.bool_)):
        return then if condition else otherwise
    if _is_array(condition):
        return np.where(condition, then, otherwise)
    own = getattr(condition, "if_else", None)
    if own is not None:
        return own(then, otherwise)
    return sys.modules[type(condition).__module__].if_else(condition, then, otherwise)


def fmin(a: Any, b: Any) -> Any:
    """The smaller of two values."""
    return if_else(a < b, a, b)


def fmax(a: Any, b: Any) -> Any:
    """The larger of two values."""
    return if_else(a < b, b, a)


def exp(x: Any) -> Any:
    """Exponential function; of a symbolic operand to (2 + |x|) units in the last place."""
    if _is_number(x) or _is_array(x):
        return np.exp(x)
    value = 1 + _growth(fabs(x))
    return if_else(x < 0, 1 / value, value)


def tanh(x: Any) -> Any:
    """Hyperbolic tangent."""
    if _is_number(x) or _is_array(x):
        return np.tanh(x)
    growth = _growth(2 * fmin(fabs(x), _SATURATED))
    value = growth / (growth + 2)
    return if_else(x < 0, -value, value)


_ANGLE_HALVINGS = 4
_ANGLE_TERMS = 8
"""Terms of the series of the arc tangent: exact where the halved angle has a tangent below 0.1."""

_TINY = 1e-300


def atan2(y: Any, x: Any) -> Any:
    """Angle of the point (x, y) against the x axis [rad], 0 at the origin; of a symbolic operand to a few roundings."""
    if all(_is_number(one) or _is_array(one) for one in (y, x)):
        return np.arctan2(y, x)
    tangent = y / (sqrt(x * x + y * y) + fabs(x) + _TINY)
    for _ in range(_ANGLE_HALVINGS - 1):
        tangent = tangent / (1 + sqrt(1 + tangent * tangent))
    square, series = tangent * tangent, 0.0
    for k in reversed(range(_ANGLE_TERMS)):
        series = series * square + (-1) ** k / (2 * k + 1)
    acute = 2**_ANGLE_HALVINGS * tangent * series
    return if_else(x < 0, if_else(y < 0, -math.pi, math.pi) - acute, acute)


def _growth(x: Any) -> Any:
    """exp(x) - 1 of a value that is not negative: a series at x/2^n, then (1 + g)^2 - 1 = g (2 + g), n times."""
    small = x / 2**_HALVINGS
    growth: Any = 0.0
    for k in reversed(range(1, _TERMS)):
        growth = (growth + 1 / factorial(k)) * small
    for _ in range(_HALVINGS):
        growth = growth * (2 + growth)
    return growth
