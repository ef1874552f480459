"""Where in a study's plain data text may stand for numbers: everywhere but in what a table has filled."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Any

__all__ = ["filled_places"]

_NUMBERS = ("distribution",)
"""Groups of a parameter in which numbers with units stand."""


def filled_places(plain: Mapping[str, Any], filled: Collection[str]) -> tuple[str, ...]:
    """Dotted paths of the parts of plain data to look at: long tables were read already, and choices hold none."""
    return tuple(_places(plain, filled))


def _places(plain: Mapping[str, Any], filled: Collection[str]) -> Iterator[str]:
    for key, value in plain.items():
        if key == "parameters" and isinstance(value, Mapping):
            for name, group in value.items():
                yield from (
                    place
                    for part in _NUMBERS
                    if isinstance(group, Mapping) and part in group
                    for place in _without(group[part], f"parameters.{name}.{part}", filled)
                )
        elif key == "plan":
            yield from _without(value, "plan", filled)
        else:
            yield key


def _without(value: Any, path: str, filled: Collection[str]) -> Iterator[str]:
    """A path, or of a group in which something is filled the paths of all else in it."""
    if path in filled:
        return
    if isinstance(value, Mapping) and any(place.startswith(f"{path}.") for place in filled):
        for key, inner in value.items():
            yield from _without(inner, f"{path}.{key}", filled)
    else:
        yield path
