"""Numbers that a caller gives: as doubles of the wanted shape, or an InputError that says which it is."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.errors import InputError
from tmodes.io.words import shown

__all__ = ["StateRows", "in_a_row", "one_row", "real_numbers", "wrong_shape"]

Array = NDArray[np.float64]


def real_numbers(name: str, values: ArrayLike, expected: str, *, finite: bool = True) -> Array:
    """Values as an array of doubles; ``expected`` says in an error which they should be.

    Raises :class:`tmodes.errors.InputError` for text, nothing, complex or Boolean values, lists of uneven length, and,
    where they must be ``finite``, for NaN and infinite ones.
    """
    try:
        array = np.asarray(values)
    except ValueError as error:  # rows of uneven length
        raise InputError(name, "a list of uneven rows", expected, "give each row the same length") from error
    if not (np.issubdtype(array.dtype, np.floating) or np.issubdtype(array.dtype, np.integer)) and array.size:
        got = "nothing" if values is None else shown(values) if array.ndim == 0 else f"values of type {array.dtype}"
        raise InputError(name, got, expected, "give real numbers")
    array = np.asarray(array, dtype=float)
    if finite and not np.isfinite(np.vdot(array, array)) and not np.isfinite(array).all():
        bad = tuple(map(int, np.argwhere(~np.isfinite(array))[0]))
        place = f" at {list(bad)}" if bad else ""
        raise InputError(name, f"{array[bad]}{place}", expected, "remove what is NaN or infinite")
    return array


_DOUBLE = np.dtype(float)


def _finite_doubles(values: ArrayLike, *, finite: bool) -> Array | None:
    """Values that are right at first sight, which most are; None for those that :func:`real_numbers` is to look at."""
    try:
        array = np.asarray(values)
    except ValueError:
        return None
    if array.dtype != _DOUBLE or (finite and not math.isfinite(np.vdot(array, array))):
        return None
    return array


def wrong_shape(name: str, array: Array, expected: str) -> InputError:
    """The error of an array of another shape than ``expected`` says."""
    return InputError(
        name, f"an array of shape {array.shape}", expected, "check the number and the order of the values"
    )


class StateRows:
    """States as rows, one or many; ``finite``: they, and what comes with them, must be.

    Raises :class:`tmodes.errors.InputError` for what is no state of ``size`` coordinates.
    """

    def __init__(self, q: ArrayLike, v: ArrayLike, size: int, *, finite: bool = True) -> None:
        self._finite = finite
        given = _finite_doubles(q, finite=finite)
        if given is None or given.ndim not in {1, 2} or given.shape[-1] != size:
            given = self._checked(q, size)
        self.single = given.ndim == 1
        self.q = given[None] if self.single else given
        self.count = len(self.q)  # an arm in which nothing moves has states too
        self.v = self.of(v, size, "v")

    def _checked(self, q: ArrayLike, size: int) -> Array:
        expected = f"finite numbers of shape ({size},), or (n, {size}) for n states"
        given = real_numbers("q", q, expected, finite=self._finite)
        if given.ndim not in {1, 2} or given.shape[-1] != size:
            raise wrong_shape("q", given, expected)
        return given

    def of(self, values: ArrayLike, width: int, name: str) -> Array:
        """Values as rows of ``width`` numbers, one for each state; one number is all of them.

        ``wrenches`` are (points, 6) or (n, points, 6); a ``base`` is no single number.
        """
        right = _finite_doubles(values, finite=self._finite)
        if right is not None and right.ndim == 0 and name != "base":
            return np.full((self.count, width), right)
        if right is not None and right.shape == (width,) and self.count == 1:
            return right[None]
        if right is not None and right.shape == (self.count, width):
            return right
        return self._rows_of(values, width, name)

    def _rows_of(self, values: ArrayLike, width: int, name: str) -> Array:
        """The same of what is converted or repeated, or wrong."""
        one = f"{width // 6}, 6" if name == "wrenches" else f"{width},"
        expected = "" if name == "base" else "one finite number, or "
        expected += f"finite numbers of shape ({one}) or ({self.count}, {one.rstrip(',')})"
        array = given = real_numbers(name, values, expected, finite=self._finite)
        if name == "wrenches" and array.ndim > 1 and width and array.size % width == 0:
            array = array.reshape(-1, width)
        if array.ndim == 0 and name != "base":
            return np.full((self.count, width), array)
        if array.ndim not in {1, 2} or array.shape[-1] != width or array.size not in {width, self.count * width}:
            raise wrong_shape(name, given, expected)
        return np.broadcast_to(array, (self.count, width))

    def shaped(self, values: Array) -> Array:
        """Rows as the states were given."""
        return values[0] if self.single else values


def one_row(name: str, values: ArrayLike, size: int, *, scalar: bool = True) -> Array:
    """Values (size,) of one state, in any shape of that size; one number is all of them where a ``scalar`` may be."""
    right = _finite_doubles(values, finite=True)
    if right is not None and right.ndim and right.size == size:
        return right.reshape(size)
    if right is not None and right.ndim == 0 and scalar:
        return np.full(size, right)
    expected = ("one finite number, or " if scalar else "") + f"finite numbers of shape ({size},), of one state"
    array = real_numbers(name, values, expected)
    if scalar and array.ndim == 0:
        return np.full(size, array)
    if array.size != size or array.ndim == 0:
        raise wrong_shape(name, array, expected)
    return array.reshape(size)


def in_a_row(blocks: Mapping[str, Array], names: Iterable[str]) -> Array:
    """Blocks one after the other."""
    return np.concatenate([blocks[name] for name in names])
