"""Functions of numbers: on plain ones exactly as Python and NumPy have them, on noted ones (and arrays of them) alike.

What lowers a data sheet uses these in place of ``float``, ``math.f`` and the functions of NumPy that know no objects.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Iterable, Sequence
from functools import lru_cache, wraps
from typing import Any, Literal, TypeVar, cast

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel

from tmodes.kinds.noted.number import Lost, Noted, is_noted, plain_value

__all__ = [
    "allclose", "array", "by_size", "ceil", "clip", "cos", "cubic_slopes", "distinct", "exp", "floor", "full_like",
    "golub_welsch", "highest", "hypot", "inverse_cholesky", "isclose", "isfinite", "isinf", "kept", "largest",
    "least_eigenvalue_exceeds", "legendre_series", "legendre_values", "log", "maximum", "minimum", "norm", "number",
    "place", "polynomial_derivative", "positive_definite", "regular", "rounded", "same", "sin", "solve", "sqrt",
    "total", "triangle", "zeros",
]  # fmt: skip

Array = NDArray[Any]


F = TypeVar("F", bound=Callable[..., Any])


class _Arguments:
    """Arguments as a key of a cache: noted numbers by their nodes."""

    def __init__(self, arguments: tuple[Any, ...]) -> None:
        self.arguments = arguments
        self.key = tuple(map(self._own, arguments))

    def _own(self, x: Any) -> Any:
        if isinstance(x, (tuple, list, BaseModel)):
            return type(x), *map(self._own, x)
        if isinstance(x, dict):
            return dict, *map(self._own, x.items())
        if type(x) is Noted:
            return Noted, id(x.tape), x.node
        return x if isinstance(x, Hashable) else id(x)

    def __hash__(self) -> int:
        return hash(self.key)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Arguments) and self.key == other.key


def kept(function: F) -> F:
    """:func:`functools.lru_cache` that takes noted numbers too: the same where they are the same nodes."""
    known = lru_cache(maxsize=64)(lambda given: function(*given.arguments))
    return cast(F, wraps(function)(lambda *arguments: known(_Arguments(arguments))))


def number(x: Any) -> Any:
    """``float(x)`` of what is not noted."""
    if type(x) is Noted:
        return x
    if isinstance(x, np.ndarray) and x.dtype == object and x.size == 1:
        return number(x.item())
    return float(x)


def array(values: Any) -> Array:
    """``numpy.asarray(values, dtype=float)``; an array of objects where any item is noted."""
    if isinstance(values, np.ndarray) and values.dtype == float:
        return values
    if not is_noted(values if isinstance(values, (np.ndarray, tuple, list)) else np.asarray(values)):
        return np.asarray(values, dtype=float)
    return np.asarray(values, dtype=object)


def zeros(shape: Any, *like: Any) -> Array:
    """Zeros; an array of objects where any of ``like`` is noted."""
    return np.zeros(shape, dtype=object if any(map(is_noted, like)) else float)


def full_like(values: Array, value: Any) -> Array:
    """An array of one value in the shape of another."""
    return np.full(values.shape, value, dtype=object if is_noted(value) else float)


def _each(function: Callable[..., Any], values: Array) -> Array:
    return np.frompyfunc(function, 1, 1)(values)


def _elementary(name: str, plain: Callable[[float], float], arrays: Callable[[Any], Any]) -> Callable[[Any], Any]:
    def one(x: Any) -> Any:
        return getattr(x, name)() if type(x) is Noted else float(arrays(x))

    def function(x: Any) -> Any:
        if type(x) is Noted:
            return getattr(x, name)()
        if isinstance(x, np.ndarray):
            return _each(one, x) if x.dtype == object else arrays(x)
        return arrays(x) if isinstance(x, np.floating) else plain(x)

    function.__doc__ = f"``{name}`` of a number (as :mod:`math` has it) or of an array (as NumPy has it)."
    return function


sqrt = _elementary("sqrt", math.sqrt, np.sqrt)
sin, cos = _elementary("sin", math.sin, np.sin), _elementary("cos", math.cos, np.cos)
exp, log = _elementary("exp", math.exp, np.exp), _elementary("log", math.log, np.log)


def hypot(*parts: Any) -> Any:
    """As :func:`math.hypot`; of two numbers of NumPy as :func:`numpy.hypot`, whose last digit may be another."""
    if not any(type(part) is Noted for part in parts):
        return np.hypot(*parts) if len(parts) == 2 and isinstance(parts[0], np.floating) else math.hypot(*parts)
    return sqrt(sum((part * part for part in parts[1:]), parts[0] * parts[0]))


def isinf(x: Any) -> Any:
    """Whether a number, or each of an array, is infinite."""
    if isinstance(x, np.ndarray) and x.dtype == object:
        return np.array([isinf(item) for item in x.flat], dtype=bool).reshape(x.shape)
    return not x.finite if type(x) is Noted else np.isinf(x) if isinstance(x, np.ndarray) else math.isinf(x)


def isfinite(x: Any) -> Any:
    """Whether a number, or each of an array, is finite."""
    if isinstance(x, np.ndarray) and x.dtype == object:
        return np.array([isfinite(item) for item in x.flat], dtype=bool).reshape(x.shape)
    return x.finite if type(x) is Noted else np.isfinite(x) if isinstance(x, np.ndarray) else math.isfinite(x)


def isclose(a: Any, b: Any, rel_tol: float) -> bool:
    """As :func:`math.isclose`; of noted numbers that are the same or close, closeness is the guard."""
    if not (type(a) is Noted or type(b) is Noted):
        return math.isclose(a, b, rel_tol=rel_tol)
    return bool(abs(a - b) <= rel_tol * maximum(abs(a), abs(b)))


def allclose(a: Any, b: Any) -> bool:
    """As :func:`numpy.allclose`."""
    if not (is_noted(a) or is_noted(b)):
        return np.allclose(a, b)
    first, second = np.broadcast_arrays(array(a), array(b))
    return all(bool(abs(x - y) <= 1e-8 + 1e-5 * abs(y)) for x, y in zip(first.flat, second.flat, strict=True))


def _whole(name: str, plain: Callable[[Any], int], low: float, high: float) -> Callable[[Any], int]:
    def function(x: Any) -> int:
        if type(x) is not Noted:
            return plain(x)
        found = plain(x.value)
        if not (x >= found + low and x <= found + high):
            raise Lost("a whole number at whose bound a number is", x)
        return found

    function.__doc__ = f"As ``{name}``; that a noted number stays between the same whole numbers is the guard."
    return function


ceil, rounded = _whole("math.ceil", math.ceil, -1.0, 0.0), _whole("round", round, -0.5, 0.5)
floor = _whole("int", int, 0.0, 1.0)


def _pairs(name: str, arrays: Callable[[Any, Any], Any]) -> Callable[[Any, Any], Any]:
    def one(a: Any, b: Any) -> Any:
        if type(a) is Noted:
            return getattr(a, name)(b)
        return getattr(b, name)(a) if type(b) is Noted else float(arrays(a, b))

    def function(a: Any, b: Any) -> Any:
        if not (is_noted(a) or is_noted(b)):
            return arrays(a, b)
        found = np.frompyfunc(one, 2, 1)(a, b)
        return found if isinstance(found, np.ndarray) else number(found)

    function.__doc__ = f"As ``numpy.{arrays.__name__}``, without a branch."
    return function


maximum, minimum = _pairs("fmax", np.maximum), _pairs("fmin", np.minimum)


def clip(x: Any, low: Any, high: Any) -> Any:
    """As :func:`numpy.clip`; of noted numbers which one it is is a guard."""
    if not any(map(is_noted, (x, low, high))):
        return np.clip(x, low, high)
    return np.frompyfunc(_between, 3, 1)(x, low, high)


def _between(x: Any, low: Any, high: Any) -> Any:
    if x <= low:
        return low
    return min(x, high)


def highest(values: Any, axis: int | None = None) -> Any:
    """As :func:`numpy.nanmax`, without a branch."""
    if not is_noted(values):
        return np.nanmax(values, axis=axis)
    flat, along = (values.ravel(), 0) if axis is None else (values, axis)
    found = np.frompyfunc(maximum, 2, 1).reduce(flat, axis=along)
    return found if isinstance(found, np.ndarray) else number(found)


def norm(vector: Any) -> Any:
    """Euclidean norm of a vector."""
    values = array(vector)
    return np.linalg.norm(values) if values.dtype != object else sqrt(number(sum(x * x for x in values.flat)))


def by_size(values: Any) -> list[Any]:
    """Numbers of an array or a list, the largest first: of ``any`` over these only the one that decides is a guard."""
    return sorted(np.ravel(values), key=lambda x: abs(plain_value(x)), reverse=True)


def same(a: Any, b: Any) -> bool:
    """Whether two numbers are one and the same, noted ones whatever their values; no guard."""
    return (a.node if type(a) is Noted else a) == (b.node if type(b) is Noted else b) and type(a) is type(b)


def largest(values: Any) -> int:
    """Index of the largest magnitude, of several the first; that it stays the largest is a guard."""
    sizes = [abs(x) for x in values]
    found = int(np.argmax([plain_value(size) for size in sizes]))
    if not all(size < sizes[found] if k < found else size <= sizes[found] for k, size in enumerate(sizes)):
        raise Lost("the largest of numbers of which some are none", sizes[found])
    return found


def distinct(values: Iterable[Any]) -> list[Any]:
    """Numbers in rising order, each once, as ``sorted({*values})``."""
    found: list[Any] = []
    for value in sorted(values):
        if not found or found[-1] != value:
            found.append(value)
    return found


def place(sorted_values: Any, x: Any, side: Literal["left", "right"] = "left") -> Any:
    """As :func:`numpy.searchsorted`."""
    if is_noted(sorted_values) or is_noted(x):
        return np.searchsorted(np.asarray(sorted_values, dtype=object), np.asarray(x, dtype=object), side=side)
    return np.searchsorted(sorted_values, x, side=side)


def polynomial_derivative(coefficients: Any, order: int, axis: int) -> Array:
    """As :func:`numpy.polynomial.polynomial.polyder`."""
    if not is_noted(coefficients):
        return np.asarray(np.polynomial.polynomial.polyder(coefficients, order, axis=axis), dtype=np.float64)
    found = np.moveaxis(coefficients, axis, -1)
    for _ in range(order):
        found = found[..., 1:] * np.arange(1.0, found.shape[-1]) if found.shape[-1] > 1 else 0.0 * found
    return np.moveaxis(found, -1, axis)


def total(values: Iterable[Any]) -> Any:
    """As :func:`math.fsum`."""
    found = list(values)
    return sum(found, 0.0) if is_noted(found) else math.fsum(found)


def legendre_values(x: Array, order: int) -> Array:
    """As :func:`numpy.polynomial.legendre.legvander`."""
    if not is_noted(x):
        return np.polynomial.legendre.legvander(array(x), order)
    rows = [np.ones(x.shape), x]
    for k in range(2, order + 1):
        rows.append((rows[k - 1] * x * (2 * k - 1) - rows[k - 2] * (k - 1)) / k)
    return np.stack(rows[: order + 1], axis=-1)


def legendre_series(x: Array, rows: Sequence[Array]) -> Array:
    """Values (k, *x) of k series of Legendre polynomials, as :func:`numpy.polynomial.legendre.legval`."""
    if not is_noted(x):
        return np.array([np.polynomial.legendre.legval(array(x), row) for row in rows])
    values = legendre_values(x, max(map(len, rows)) - 1)
    return np.array([values[..., : len(row)] @ row for row in rows])


# Linear algebra. A pivot is chosen at the values, without a guard: that changes no result but by rounding.


def solve(matrix: Array, right: Array) -> Array:
    """As :func:`numpy.linalg.solve`; of noted numbers by elimination with partial pivoting."""
    if not (is_noted(matrix) or is_noted(right)):
        return np.linalg.solve(array(matrix), array(right))
    rows = [[*row] for row in matrix]
    sides = [[*np.atleast_1d(row)] for row in right]
    count = len(rows)
    for k in range(count):
        pivot = max(range(k, count), key=lambda i: abs(plain_value(rows[i][k])))
        rows[k], rows[pivot], sides[k], sides[pivot] = rows[pivot], rows[k], sides[pivot], sides[k]
        for i in range(k + 1, count):
            share = rows[i][k] / rows[k][k]
            rows[i] = [a - share * b if j > k else 0.0 for j, (a, b) in enumerate(zip(rows[i], rows[k], strict=True))]
            sides[i] = [a - share * b for a, b in zip(sides[i], sides[k], strict=True)]
    found: list[Any] = [None] * count
    for k in reversed(range(count)):
        found[k] = [
            (b - sum((rows[k][j] * found[j][m] for j in range(k + 1, count)), 0.0)) / rows[k][k]
            for m, b in enumerate(sides[k])
        ]
    return np.array(found, dtype=object).reshape(right.shape)


def triangle(rows: Array) -> Array:
    """The upper triangle R of a QR factorization, as ``numpy.linalg.qr(rows, mode="r")`` has it; by Householder."""
    if not is_noted(rows):
        return np.asarray(np.linalg.qr(array(rows), mode="r"))
    matrix = np.array(rows, dtype=object)
    count, width = matrix.shape
    for k in range(min(count - 1, width)):
        below = matrix[k + 1 :, k]
        if not any(type(x) is Noted or x for x in below):
            continue
        size = norm(matrix[k:, k])
        beta = -size if plain_value(matrix[k, k]) >= 0.0 else size
        guard = matrix[k, k]
        if type(guard) is Noted:
            _ = guard >= 0.0  # the sign of a row of R
        tau, vector = (beta - guard) / beta, below / (guard - beta)
        for j in range(k + 1, width):
            share = tau * (matrix[k, j] + sum((a * b for a, b in zip(vector, matrix[k + 1 :, j], strict=True)), 0.0))
            matrix[k, j] = matrix[k, j] - share
            matrix[k + 1 :, j] = matrix[k + 1 :, j] - share * vector
        matrix[k, k], matrix[k + 1 :, k] = beta, 0.0
    return np.where(np.tri(min(count, width), width, -1, dtype=bool), 0.0, matrix[: min(count, width)])


def inverse_cholesky(matrix: Array) -> Array:
    """Inverse of the lower triangle L with L L^T = ``matrix``."""
    if not is_noted(matrix):
        return np.linalg.inv(np.linalg.cholesky(array(matrix)))
    count = len(matrix)
    lower = zeros((count, count), matrix)
    for i in range(count):
        for j in range(i + 1):
            left = matrix[i, j] - sum((lower[i, k] * lower[j, k] for k in range(j)), 0.0)
            lower[i, j] = sqrt(left) if i == j else left / lower[j, j]
    return solve(lower, np.eye(count))


def regular(matrix: Array, ratio: float) -> bool:
    """Whether the least singular value is above a ``ratio`` of the largest: sufficient, by the determinant."""
    rows, left = [[*row] for row in matrix], 1.0
    for k in range(len(rows)):
        pivot = max(range(k, len(rows)), key=lambda i: abs(plain_value(rows[i][k])))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        left = left * rows[k][k]
        for i in range(k + 1, len(rows) if plain_value(rows[k][k]) else 0):
            share = rows[i][k] / rows[k][k]
            rows[i] = [a - share * b for a, b in zip(rows[i], rows[k], strict=True)]
    return bool(abs(left) > ratio * norm(matrix.ravel()) ** len(rows))


def cubic_slopes(times: Array, values: Array) -> Array:
    """Slopes of a cubic spline at its knots, 0 at both ends: its second derivative is continuous (Thomas algorithm)."""
    widths = times[1:] - times[:-1]
    rises = (values[1:] - values[:-1]) / widths
    ratios, sides = [0.0], [0.0]
    for k in range(1, len(times) - 1):
        diagonal = 2 * (widths[k - 1] + widths[k]) - widths[k] * ratios[-1]
        side = 3 * (widths[k] * rises[k - 1] + widths[k - 1] * rises[k])
        sides.append((side - widths[k] * sides[-1]) / diagonal)
        ratios.append(widths[k - 1] / diagonal)
    found: list[Any] = [0.0]
    for ratio, side in zip(ratios[:0:-1], sides[:0:-1], strict=True):
        found.append(side - ratio * found[-1])
    return np.array([*found, 0.0][::-1] if len(times) > 1 else found, dtype=object)


_STEPS = 4
"""Newton steps to a node of a quadrature from its value where it was noted."""

_CONVERGED = 1e-9
"""Last Newton step over the range of the nodes, whose square is rounding."""


def golub_welsch(diagonal: Array, off_diagonal: Array) -> tuple[Array, Array]:
    """Nodes of a Gauss rule and its weights over their sum, of the recurrence of its orthonormal polynomials.

    Golub and Welsch, Calculation of Gauss quadrature rules, Math. Comp. 23, 1969. Of noted numbers by Newton's method
    on the recurrence, from the nodes at the values; that the last step is rounding is a guard.
    """
    if not (is_noted(diagonal) or is_noted(off_diagonal)):
        diagonal, off_diagonal = array(diagonal), array(off_diagonal)
        whole = np.diag(diagonal) + np.diag(off_diagonal, 1) + np.diag(off_diagonal, -1)
        nodes, vectors = np.linalg.eigh(whole)
        return nodes, vectors[0] ** 2
    values, neighbours = (np.array([plain_value(x) for x in part]) for part in (diagonal, off_diagonal))
    begin = np.linalg.eigvalsh(np.diag(values) + np.diag(neighbours, 1) + np.diag(neighbours, -1))
    nodes, weights = [], []
    for first in begin:
        node: Any = float(first)
        step: Any = 0.0
        for _ in range(_STEPS):
            value, slope = _characteristic(diagonal, off_diagonal, node)
            step = value / slope
            node = node - step
        if not abs(step) <= _CONVERGED:
            raise Lost("a node of a quadrature that moves too far", step)
        nodes.append(node)
        weights.append(1 / _squares(diagonal, off_diagonal, node))
    return np.array(nodes, dtype=object), np.array(weights, dtype=object)


def _characteristic(diagonal: Array, off_diagonal: Array, x: Any) -> tuple[Any, Any]:
    """The monic polynomial whose zeros are the nodes, and its slope."""
    before: tuple[Any, Any] = (0.0, 0.0)
    now: tuple[Any, Any] = (1.0, 0.0)
    for k, own in enumerate(diagonal):
        square = off_diagonal[k - 1] * off_diagonal[k - 1] if k else 0.0
        following = (x - own) * now[0] - square * before[0], now[0] + (x - own) * now[1] - square * before[1]
        before, now = now, following
    return now


def _squares(diagonal: Array, off_diagonal: Array, x: Any) -> Any:
    """Sum of the squares of the orthonormal polynomials at x, the first of which is 1."""
    before: Any = 0.0
    now: Any = 1.0
    total: Any = 1.0
    for k in range(len(diagonal) - 1):
        left = (x - diagonal[k]) * now - (off_diagonal[k - 1] * before if k else 0.0)
        before, now = now, left / off_diagonal[k]
        total = total + now * now
    return total


def least_eigenvalue_exceeds(matrix: Array, bound: float) -> bool:
    """Whether the least eigenvalue of a symmetric matrix is above a bound; of noted numbers by the signs of pivots."""
    if not is_noted(matrix):
        return bool(np.linalg.eigvalsh(array(matrix))[0] > bound)
    return positive_definite(matrix - bound * np.eye(len(matrix)))


def positive_definite(matrix: Array) -> bool:
    """Whether all pivots of a symmetric matrix are positive, each noted as a guard."""
    rows: Sequence[list[Any]] = [[*row] for row in matrix]
    for k, row in enumerate(rows):
        if not row[k] > 0.0:
            return False
        for i in range(k + 1, len(rows)):
            share = rows[i][k] / row[k]
            rows[i][:] = [a - share * b for a, b in zip(rows[i], row, strict=True)]
    return True
