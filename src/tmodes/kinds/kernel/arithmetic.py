"""Elementary functions for kernels: they work on numbers, arrays and the symbols of any backend."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

__all__ = ["cos", "sin", "sqrt"]


def cos(x: Any) -> Any:
    """Cosine of a number, an array or a symbol."""
    return _called("cos", x)


def sin(x: Any) -> Any:
    """Sine of a number, an array or a symbol."""
    return _called("sin", x)


def sqrt(x: Any) -> Any:
    """Square root of a number, an array or a symbol."""
    return _called("sqrt", x)


def _called(name: str, x: Any) -> Any:
    """A symbol has the function as a method; NumPy serves arrays and the standard library plain numbers."""
    if isinstance(x, int | float):
        return getattr(math, name)(x)
    return getattr(x, name)() if hasattr(x, name) else getattr(np, name)(x)
