"""Published robots as data sheets, one file per paper, and the way from a name or a file to a checked robot."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from importlib import resources
from pathlib import Path

from tmodes.errors import InputError

__all__ = ["kept_lines", "names", "text", "unknown"]


def names() -> list[str]:
    """Names of the published robots, sorted."""
    files = (entry.name for entry in resources.files(__name__).iterdir())
    return sorted(name.removesuffix(".yaml") for name in files if name.endswith(".yaml"))


def text(name: str) -> str:
    """The data sheet of a published robot, as it stands in its file; an InputError for an unknown name."""
    if name not in names():
        raise unknown(name, names())
    return (resources.files(__name__) / f"{name}.yaml").read_text(encoding="utf-8")


def kept_lines(positions: Mapping[str, int], changes: Collection[str]) -> dict[str, int]:
    """The lines of what stands in the file; what was changed, given by its dotted paths, has none."""
    lines = {
        path: line
        for path, line in positions.items()
        if not any(path == changed or path.startswith(f"{changed}.") for changed in changes)
    }
    return lines | dict.fromkeys(changes, 0)


def unknown(name: str, known: Sequence[str]) -> InputError:
    """The error for a name that is none of the ``known`` ones, nor the path of a file."""
    from tmodes.io.words import meant, shown

    hint = meant(Path(name).stem, known, "check the path and its spelling")
    return InputError("robot", shown(name), f"one of {', '.join(known)}, or the path of a file that exists", hint)
