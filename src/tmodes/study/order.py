"""In which order quantities are computed that need others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

__all__ = ["circle", "ordered"]


def ordered(needs: Mapping[str, Sequence[str]]) -> list[str]:
    """The names, each after those that it needs; those that need nothing of the others stay in their order."""
    done: dict[str, None] = {}

    def visit(name: str) -> None:
        if name in needs and name not in done:
            for inner in needs[name]:
                visit(inner)
            done[name] = None

    for name in needs:
        visit(name)
    return list(done)


def circle(needs: Mapping[str, Sequence[str]]) -> list[str]:
    """Names of which each needs the next, the first and last the same; empty where there is no circle."""
    state: dict[str, bool] = {}

    def visit(name: str, path: list[str]) -> list[str]:
        if name in path:
            return [*path[path.index(name) :], name]
        if name not in needs or state.get(name):
            return []
        for inner in needs[name]:
            if found := visit(inner, [*path, name]):
                return found
        state[name] = True
        return []

    return next((found for name in needs if (found := visit(name, []))), [])
