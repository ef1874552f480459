"""Published robots as data sheets, one file per paper, and the way from a name or a file to a checked robot."""

from __future__ import annotations

import os
from collections.abc import Collection, Mapping, Sequence
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError

if TYPE_CHECKING:
    from tmodes.paper.sheet import PaperRobot

__all__ = ["kept_lines", "load_robot", "names", "text", "unknown"]


def names() -> list[str]:
    """Names of the published robots, sorted."""
    files = (entry.name for entry in resources.files(__name__).iterdir())
    return sorted(name.removesuffix(".yaml") for name in files if name.endswith(".yaml"))


def text(name: str) -> str:
    """The data sheet of a published robot, as it stands in its file; an InputError for an unknown name."""
    if name not in names():
        raise unknown(name, names())
    return (resources.files(__name__) / f"{name}.yaml").read_text(encoding="utf-8")


def load_robot(name_or_path: str | os.PathLike[str], changes: Mapping[str, Any] | None = None) -> PaperRobot:
    """A checked robot from the name of a published one, or from a file (a name wins; write ``./name`` for a file).

    ``changes`` are values by dotted path, as in :meth:`tmodes.paper.sheet.PaperRobot.with_`. Raises
    :class:`tmodes.errors.InputError` when there is no such robot or the file is no YAML, and
    :class:`tmodes.errors.InputErrors` with all wrong values and their lines.
    """
    from tmodes.io.words import shown_path
    from tmodes.io.yaml_file import parse_yaml, read_yaml
    from tmodes.paper.sheet import PaperRobot

    if name_or_path in names():
        data, _ = parse_yaml(text(str(name_or_path)), f"{name_or_path}.yaml")
    elif os.path.lexists(name_or_path):
        data, _ = read_yaml(name_or_path)
    else:
        raise unknown(shown_path(name_or_path), names())
    return PaperRobot.from_data(data).with_(changes or {})


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
    from tmodes.io.words import nearest, shown

    close = nearest(Path(name).stem, known)
    hint = f"did you mean `{close}`?" if close else "check the path and its spelling"
    return InputError("robot", shown(name), f"one of {', '.join(known)}, or the path of a file that exists", hint)
