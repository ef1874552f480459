"""A kernel: a small function of blocks of numbers, written as expressions once and compiled once per structure."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

__all__ = ["Kernel"]


@dataclass(frozen=True)
class Kernel:
    """``build`` takes a vector of symbols for each input size and returns a list of entries for each output size.

    ``key`` names the structure: two kernels of the same key are the same function. ``long``: thousands of operations,
    too many to be written out at each call. ``plain``: made of sums, products and quotients alone.
    """

    key: str
    inputs: tuple[int, ...]
    outputs: tuple[int, ...]
    build: Callable[..., Sequence[list[Any]]]
    long: bool = False
    plain: bool = False
