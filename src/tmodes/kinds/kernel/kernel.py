"""A kernel: a small function of blocks of numbers, written as expressions once and compiled once per structure."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial, wraps
from operator import attrgetter
from typing import Any

__all__ = ["Kernel", "kernel"]


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


def kernel(
    key: str, inputs: Sequence[int | str], outputs: Sequence[int | str], *, long: str = "", plain: bool = False
) -> Callable[[Callable[..., Sequence[list[Any]]]], Callable[..., Kernel]]:
    """Turn a function of symbols into one that gives its :class:`Kernel`; a method into that of its structure.

    ``long`` and sizes that depend on the structure are names of its attributes; ``{0}`` in ``key`` is the structure.
    """

    def decorate(build: Callable[..., Sequence[list[Any]]]) -> Callable[..., Kernel]:
        @wraps(build)
        def made(*structure: Any) -> Kernel:
            def of(part: Any) -> Any:
                return attrgetter(part)(*structure) if isinstance(part, str) else part

            sizes = (tuple(map(of, parts)) for parts in (inputs, outputs))
            return Kernel(key.format(*structure), *sizes, partial(build, *structure), bool(long and of(long)), plain)

        return made

    return decorate
