"""From a name or a file to a checked data sheet of either kind: the robot of the 2010 paper, or any arm."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from importlib import resources
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError
from tmodes.robots.packages import MODELS, installed_models

if TYPE_CHECKING:
    from tmodes.arm import Arm
    from tmodes.robot import Robot

__all__ = ["load_sheet", "sheet_names"]

FOLDERS = ("", "arms")
"""Where published data sheets are, in the package of this module."""

FOREIGN = (".urdf", ".xacro", ".xml")
"""Endings of files that are no YAML."""


def sheet_names() -> list[str]:
    """Names of all published data sheets, robots and arms, sorted."""
    return sorted(_published())


def load_sheet(
    name_or_path: str | os.PathLike[str],
    changes: Mapping[str, Any] | None = None,
    *,
    roots: Sequence[str | os.PathLike[str]] = (),
    trust_paths: bool = False,
) -> Robot | Arm:
    """A checked data sheet from the name of a published one, or from a file (a name wins; write ``./name`` for a file).

    A sheet without a kind becomes the 2010 paper's :class:`tmodes.robot.Robot`; one with ``kind: arm``, a
    Denavit-Hartenberg table, URDF, xacro, MJCF and an elasticity file beside a URDF an :class:`tmodes.arm.Arm`.
    ``changes`` are values by dotted path; ``roots`` and ``trust_paths`` say where the files that a file names may lie.
    Raises :class:`tmodes.errors.InputError` when there is no such sheet or it cannot be read, and
    :class:`tmodes.errors.InputErrors` with all wrong values and their lines.
    """
    from tmodes.io.words import shown_path

    published = _published()
    if str(name_or_path) in published:
        with resources.as_file(published[str(name_or_path)]) as path:
            data, positions = _read_published(path, roots)
            return _checked(data, positions, path.name, changes or {})
    if not os.path.lexists(name_or_path):
        raise _unknown(shown_path(name_or_path))
    return _checked(*_read(Path(name_or_path), roots, trust_paths), shown_path(name_or_path), changes or {})


def _read_published(path: Path, roots: Sequence[str | os.PathLike[str]]) -> tuple[dict[str, Any], dict[str, int]]:
    """A published sheet; one that stands on a model of another package says which, where that is not installed."""
    from tmodes.io.yaml_file import read_yaml

    models = installed_models()
    if not models and not roots and "urdf" in read_yaml(path)[0]:
        got, expected = f"a robot of the package {MODELS}, which is not installed", f"the package {MODELS}"
        raise InputError("robot", got, expected, "install it: pip install 'tmodes[robots]'")
    return _read(path, roots, trust_paths=False)


def _read(
    path: Path, roots: Sequence[str | os.PathLike[str]], trust_paths: bool
) -> tuple[dict[str, Any], dict[str, int]]:
    """Plain data of a file and the line of each dotted path."""
    from tmodes.io.arm_files import read_arm_data
    from tmodes.io.yaml_file import read_yaml

    if path.suffix.lower() not in FOREIGN:
        data, positions = read_yaml(path)
        if "urdf" not in data and data.get("kind") != "dh":
            return data, positions
    data, positions, _ = read_arm_data(path, roots=(*roots, *installed_models()), trust_paths=trust_paths)
    return data, positions


def _checked(data: dict[str, Any], positions: dict[str, int], source: str, changes: Mapping[str, Any]) -> Robot | Arm:
    if "kind" not in data:
        from tmodes.io.check import robot_from_data
        from tmodes.io.paths import set_paths

        return robot_from_data(set_paths(data, changes), _kept(positions, changes), source)
    if data["kind"] != "arm":
        from tmodes.io.words import shown

        where = f"{source}:{positions.get('kind', 1)}"
        raise InputError("kind", shown(data["kind"]), "arm", "write `kind: arm`", where)
    from tmodes.io.arm_check import arm_from_data
    from tmodes.io.arm_paths import set_arm_paths, steps_of

    paths = {".".join(map(str, steps_of(path, data))): 0 for path in changes}
    return arm_from_data(set_arm_paths(data, changes), _kept(positions, paths), source)


def _kept(positions: dict[str, int], changes: Mapping[str, Any]) -> dict[str, int]:
    """The lines of what stands in the file; what was changed has none."""
    lines = {
        path: line
        for path, line in positions.items()
        if not any(path == changed or path.startswith(f"{changed}.") for changed in changes)
    }
    return lines | dict.fromkeys(changes, 0)


def _published() -> dict[str, Traversable]:
    return {file.name.removesuffix(".yaml"): file for folder in FOLDERS for file in _sheets(folder)}


def _sheets(folder: str) -> Iterator[Traversable]:
    place = resources.files("tmodes.robots") / folder if folder else resources.files("tmodes.robots")
    if place.is_dir():
        yield from (file for file in place.iterdir() if file.name.endswith(".yaml"))


def _unknown(name: str) -> InputError:
    from tmodes.io.words import nearest, shown

    names = sheet_names()
    close = nearest(Path(name).stem, names)
    mend = f"did you mean `{close}`?" if close else "check the path and its spelling"
    return InputError("robot", shown(name), f"one of {', '.join(names)}, or the path of a file that exists", mend)
