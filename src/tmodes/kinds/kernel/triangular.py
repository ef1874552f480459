"""A small symmetric system, factored and solved as expressions."""

from __future__ import annotations

from typing import Any

__all__ = ["factor", "forward_substitution"]


def factor(matrix: list[list[Any]]) -> tuple[list[list[Any]], list[Any]]:
    """L (rows below its unit diagonal) and 1/d of a matrix given by its lower triangle: L diag(d) L^T."""
    n = len(matrix)
    lower: list[list[Any]] = [[0.0] * i for i in range(n)]
    share: list[Any] = []
    for i in range(n):
        scaled: list[Any] = []
        for j in range(i):
            value = matrix[i][j]
            for k in range(j):
                value = value - scaled[k] * lower[j][k]
            scaled.append(value)
        lower[i] = [value * share[j] for j, value in enumerate(scaled)]
        pivot = matrix[i][i]
        for j, value in enumerate(scaled):
            pivot = pivot - value * lower[i][j]
        share.append(1 / pivot)
    return lower, share


def forward_substitution(lower: list[list[Any]], right: list[list[Any]]) -> list[list[Any]]:
    """L^-1 times the rows of a right-hand side."""
    result: list[list[Any]] = []
    for i, row in enumerate(right):
        values = list(row)
        for j, factor in enumerate(lower[i]):
            values = [value - factor * other for value, other in zip(values, result[j], strict=True)]
        result.append(values)
    return result
