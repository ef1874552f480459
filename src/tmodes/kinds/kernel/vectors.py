"""Vectors and matrices of three as plain lists of expressions: no shapes to check, zeros fold away as they are met."""

from __future__ import annotations

from collections.abc import Sequence
from math import factorial
from typing import Any

__all__ = [
    "Matrix", "Vector", "about", "add", "cross", "dot", "flat", "identity", "matmul", "matvec", "outer", "rodrigues",
    "scale", "series", "six", "skew", "slope_of_series", "sub", "symmetric", "total", "transpose", "tri", "turn",
    "unit", "vec", "zero",
]  # fmt: skip

Vector = list[Any]
Matrix = list[list[Any]]
"""Rows of a 3 x 3 matrix."""


def vec(symbol: Any, start: int = 0) -> Vector:
    """Three components of a vector of symbols."""
    return [symbol[start + i] for i in range(3)]


def zero() -> Vector:
    """The zero vector."""
    return [0.0, 0.0, 0.0]


def unit(axis: int) -> Vector:
    """A unit vector."""
    return [1.0 if i == axis else 0.0 for i in range(3)]


def identity() -> Matrix:
    """The unit matrix."""
    return [unit(0), unit(1), unit(2)]


def add(*vectors: Vector) -> Vector:
    """Sum of vectors."""
    return [total([v[i] for v in vectors]) for i in range(3)]


def total(terms: Sequence[Any]) -> Any:
    """Sum of expressions."""
    result = terms[0]
    for term in terms[1:]:
        result = result + term
    return result


def sub(a: Vector, b: Vector) -> Vector:
    """``a - b``."""
    return [a[i] - b[i] for i in range(3)]


def scale(factor: Any, a: Vector) -> Vector:
    """``factor a``."""
    return [factor * a[i] for i in range(3)]


def dot(a: Vector, b: Vector) -> Any:
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    """Vector product."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def skew(a: Vector) -> Matrix:
    """The matrix of ``a x``."""
    return [[0.0, -a[2], a[1]], [a[2], 0.0, -a[0]], [-a[1], a[0], 0.0]]


def outer(a: Vector, b: Vector) -> Matrix:
    """``a b^T``."""
    return [[a[i] * b[j] for j in range(3)] for i in range(3)]


def transpose(a: Matrix) -> Matrix:
    """The transpose."""
    return [[a[j][i] for j in range(3)] for i in range(3)]


def matvec(a: Matrix, b: Vector) -> Vector:
    """``A b``."""
    return [dot(a[i], b) for i in range(3)]


def matmul(a: Matrix, b: Matrix) -> Matrix:
    """``A B``."""
    other = transpose(b)
    return [[dot(a[i], other[j]) for j in range(3)] for i in range(3)]


def about(axis: int, cosine: Any, sine: Any) -> Matrix:
    """Rotation about an axis of the frame."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix = identity()
    matrix[i][i], matrix[j][j], matrix[i][j], matrix[j][i] = cosine, cosine, -sine, sine
    return matrix


def rodrigues(axis: Vector, cosine: Any, sine: Any) -> Matrix:
    """Rotation about a unit vector."""
    part, lever = outer(scale(1 - cosine, axis), axis), skew(axis)
    return [[part[i][j] + (cosine if i == j else 0.0) + sine * lever[i][j] for j in range(3)] for i in range(3)]


def six(a: Matrix) -> list[Any]:
    """The six entries of a symmetric matrix."""
    return [a[0][0], a[1][1], a[2][2], a[0][1], a[0][2], a[1][2]]


def tri(symbol: Any, start: int = 0) -> Matrix:
    """A 3 x 3 matrix from nine symbols, row by row."""
    return [[symbol[start + 3 * i + j] for j in range(3)] for i in range(3)]


def symmetric(symbol: Any, start: int = 0) -> Matrix:
    """A symmetric matrix from its six entries xx, yy, zz, xy, xz, yz."""
    xx, yy, zz, xy, xz, yz = (symbol[start + i] for i in range(6))
    return [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]


def turn(rotation: Matrix, a: Matrix, *, is_symmetric: bool = False) -> Matrix:
    """``R A R^T``; of a symmetric matrix only the six entries that matter are computed."""
    half = matmul(rotation, a)
    if not is_symmetric:
        return matmul(half, transpose(rotation))
    upper = {(i, j): dot(half[i], rotation[j]) for i in range(3) for j in range(i, 3)}
    return [[upper[min(i, j), max(i, j)] for j in range(3)] for i in range(3)]


def flat(*parts: Any) -> list[Any]:
    """All entries of vectors, matrices and nested lists in one list."""
    result: list[Any] = []
    for part in parts:
        if isinstance(part, list):
            result += flat(*part)
        else:
            result.append(part)
    return result


def series(z: Any, first: int, terms: int) -> Any:
    """Sum of (-z)^k/(2k + first)!: sin(x)/x for first = 1, (1 - cos x)/x^2 for 2, (x - sin x)/x^3 for 3; z = x^2."""
    value: Any = 0.0
    for k in reversed(range(terms)):
        value = value * z + (-1) ** k / factorial(2 * k + first)
    return value


def slope_of_series(z: Any, first: int, terms: int) -> Any:
    """Derivative of the series by z."""
    value: Any = 0.0
    for k in reversed(range(1, terms)):
        value = value * z + k * (-1) ** k / factorial(2 * k + first)
    return value
