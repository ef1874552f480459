"""Symbols of a system by the names of its coordinates or parameters."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

__all__ = ["Members"]


class Members:
    """Symbols by name: ``q.cart``, ``q["cart"]``, or in order."""

    def __init__(self, names: Sequence[str], values: Any, of: str) -> None:
        self._values = {name: values[k] for k, name in enumerate(names)}
        self._of = of

    def __getitem__(self, name: str | int) -> Any:
        if isinstance(name, int):
            return [*self._values.values()][name]
        if name not in self._values:
            raise AttributeError(f"no {self._of} `{name}`; there are {', '.join(self._values)}")
        return self._values[name]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return self[name]

    def __iter__(self) -> Iterator[Any]:
        return iter(self._values.values())

    def __len__(self) -> int:
        return len(self._values)
