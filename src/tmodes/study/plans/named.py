"""Names of parameters in a plan."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from tmodes.io.words import meant
from tmodes.kinds.schema.quantity import Issue
from tmodes.study.plans.contract import Space

__all__ = ["unknown_names"]


def unknown_names(field: str, names: Iterable[str], space: Space) -> Iterator[Issue]:
    """An issue for each name that no parameter has, at its key in a field."""
    for name in names:
        if name not in space.names:
            hint = meant(name, space.names, "write the name of a parameter")
            yield Issue(f"{field}.{name}", "an unknown key", f"one of {', '.join(space.names)}", hint)
