"""Values with their first and second derivative by time: what differentiates a formula that is written for values.

A. Griewank, A. Walther, Evaluating Derivatives (2008), chapter 13: Taylor coefficients forwards.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmodes.kinds.kernel import functions as f

__all__ = ["Jet", "jet"]


@dataclass(frozen=True, eq=False)
class Jet:
    """x, x' and x''; each a number or an expression."""

    value: Any
    first: Any = 0.0
    second: Any = 0.0

    __array_ufunc__ = None

    def __neg__(self) -> Jet:
        return Jet(-self.value, -self.first, -self.second)

    def __add__(self, other: Any) -> Jet:
        y = jet(other)
        return Jet(self.value + y.value, self.first + y.first, self.second + y.second)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Jet:
        return self + -jet(other)

    def __rsub__(self, other: Any) -> Jet:
        return -self + other

    def __mul__(self, other: Any) -> Jet:
        y = jet(other)
        second = self.value * y.second + 2 * (self.first * y.first) + self.second * y.value
        return Jet(self.value * y.value, self.value * y.first + self.first * y.value, second)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Jet:
        return self * jet(other)._chained(lambda x: (1 / x, -1 / (x * x), 2 / (x * x * x)))

    def __rtruediv__(self, other: Any) -> Jet:
        return jet(other) / self

    def __pow__(self, exponent: int) -> Jet:
        result: Jet = self
        for _ in range(exponent - 1):
            result = result * self
        return result

    def __lt__(self, other: Any) -> Any:
        return self.value < jet(other).value

    def __gt__(self, other: Any) -> Any:
        return self.value > jet(other).value

    def _chained(self, function: Any) -> Jet:
        """Of a function, given as its value, slope and curvature at a value."""
        value, slope, curvature = function(self.value)
        return Jet(value, slope * self.first, slope * self.second + curvature * (self.first * self.first))

    def sin(self) -> Jet:
        """Sine."""
        return self._chained(lambda x: (f.sin(x), f.cos(x), -f.sin(x)))

    def cos(self) -> Jet:
        """Cosine."""
        return self._chained(lambda x: (f.cos(x), -f.sin(x), -f.cos(x)))

    def sqrt(self) -> Jet:
        """Square root."""
        root = f.sqrt(self.value)
        return self._chained(lambda x: (root, 1 / (2 * root), -1 / (4 * root * x)))

    def fabs(self) -> Jet:
        """Absolute value."""
        side = f.if_else(self.value < 0, -1.0, 1.0)
        return Jet(f.fabs(self.value), side * self.first, side * self.second)


def jet(x: Any) -> Jet:
    """A value as a jet; a number does not change."""
    return x if isinstance(x, Jet) else Jet(x)
