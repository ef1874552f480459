"""Published robots as data sheets, one file per paper, and the way from a name or a file to a checked robot."""

from __future__ import annotations

from collections.abc import Sequence
from importlib import resources
from importlib.resources.abc import Traversable
from pathlib import Path

from tmodes.errors import InputError

__all__ = ["FIRST", "MODELS", "installed_models", "names", "published", "text", "unknown"]

FIRST = ("two_link_arm", "filipovic2010")
"""The robots to begin with, which lists begin with."""

MODELS = "example-robot-data"
"""The package of models that published elasticity files stand on (the extra ``robots``)."""


def published() -> dict[str, Traversable]:
    """The files of the published robots, by name."""
    files = sorted(resources.files(__name__).iterdir(), key=lambda file: file.name)
    return {file.name.removesuffix(".yaml"): file for file in files if file.name.endswith(".yaml")}


def names() -> list[str]:
    """Names of the published robots: those to begin with, then the others, sorted."""
    return [*FIRST, *sorted(published().keys() - set(FIRST))]


def text(name: str) -> str:
    """The data sheet of a published robot, as it stands in its file; an InputError for an unknown name."""
    if name not in (files := published()):
        raise unknown(name, names())
    return files[name].read_text(encoding="utf-8")


def unknown(name: str, known: Sequence[str]) -> InputError:
    """The error for a name that is none of the ``known`` ones, nor the path of a file."""
    from tmodes.io.words import meant, shown

    hint = meant(Path(name).stem, known, "check the path and its spelling")
    return InputError("robot", shown(name), f"one of {', '.join(known)}, or the path of a file that exists", hint)


def installed_models() -> tuple[Path, ...]:
    """The folder of the models of :data:`MODELS`, or nothing where it is not installed."""
    from importlib import metadata  # reads mail: not for the help

    try:
        place = Path(str(metadata.distribution(MODELS).locate_file(f"cmeel.prefix/share/{MODELS}")))
    except metadata.PackageNotFoundError:
        return ()
    return (place,) if place.is_dir() else ()
