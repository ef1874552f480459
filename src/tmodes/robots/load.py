"""From a name or a file to a checked robot."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from contextlib import nullcontext
from importlib import resources
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError
from tmodes.robots import kept_lines, unknown
from tmodes.robots import names as sheet_names
from tmodes.robots import text as sheet_text
from tmodes.robots.packages import MODELS, installed_models

if TYPE_CHECKING:
    from tmodes.io.urdf import UrdfRobot
    from tmodes.sheet import Robot

__all__ = ["load", "sheet_names", "sheet_text", "urdf_of"]

Roots = Sequence[str | os.PathLike[str]]
Sheet = tuple[dict[str, Any], dict[str, int]]
"""Plain data of a sheet and the line of each of its dotted paths."""

FOREIGN = (".urdf", ".xacro", ".xml")
"""Endings of files that are no YAML."""


def load(
    name_or_path: str | os.PathLike[str],
    changes: Mapping[str, Any] | None = None,
    *,
    roots: Roots = (),
    trust_paths: bool = False,
) -> Robot:
    """A checked robot from the name of a published one, or from a file (a name wins; write ``./name`` for a file).

    A file is a data sheet, a Denavit-Hartenberg table, URDF, xacro, MJCF, an elasticity file of a URDF, or a sheet of
    the 2010 robot. ``changes`` are values by dotted path; ``roots`` and ``trust_paths`` say where the files that a file
    names may lie. Raises :class:`tmodes.errors.InputError` when there is no such robot or it cannot be read, and
    :class:`tmodes.errors.InputErrors` with all wrong values and their lines.
    """
    from tmodes.io.words import shown_path
    from tmodes.io.yaml_file import read_yaml

    published = _published()
    if str(name_or_path) in published:
        with resources.as_file(published[str(name_or_path)]) as path:
            data, positions = read_yaml(path)
            _refuse_without_model(data, roots)
            return _checked(*_whole(path, data, positions, roots, trust_paths=False), path.name, changes or {})
    if not os.path.lexists(name_or_path):
        raise unknown(shown_path(name_or_path), sheet_names())
    return _checked(*_read(Path(name_or_path), roots, trust_paths), shown_path(name_or_path), changes or {})


def urdf_of(name_or_path: str | os.PathLike[str], *, roots: Roots = (), trust_paths: bool = False) -> UrdfRobot | None:
    """The URDF (or xacro) on which the robot of this name or file stands; None for what stands on none.

    Raises as :func:`load`.
    """
    from tmodes.io.elasticity import read_elasticity
    from tmodes.io.mesh_paths import folders_of
    from tmodes.io.urdf import urdf_robot
    from tmodes.io.xacro import read_xacro
    from tmodes.io.xml_file import read_xml
    from tmodes.io.yaml_file import read_yaml

    published, folders = _published().get(str(name_or_path)), (*roots, *installed_models())
    with resources.as_file(published) if published else nullcontext(Path(name_or_path)) as path:
        ending = path.suffix.lower()
        if ending == ".xacro":
            return read_xacro(path, folders, trust_paths)
        if ending in FOREIGN:
            root = read_xml(path)
            return urdf_robot(root, folders_of(path, folders, trust_paths)) if root.tag == "robot" else None
        return read_elasticity(path, folders, trust_paths) if "urdf" in read_yaml(path)[0] else None


def _refuse_without_model(data: dict[str, Any], roots: Roots) -> None:
    """A published sheet that stands on a model of another package says which, where that is not installed."""
    if "urdf" in data and not roots and not installed_models():
        got, expected = f"a robot of the package {MODELS}, which is not installed", "a robot whose package is installed"
        raise InputError("robot", got, expected, "install it: pip install 'tmodes[robots]'")


def _read(path: Path, roots: Roots, trust_paths: bool) -> Sheet:
    """Plain data of a file and the line of each dotted path."""
    if path.suffix.lower() in FOREIGN:
        from tmodes.io.sheet_files import read_sheet

        return read_sheet(path, roots=(*roots, *installed_models()), trust_paths=trust_paths)[:2]
    from tmodes.io.yaml_file import read_yaml

    return _whole(path, *read_yaml(path), roots, trust_paths)


def _whole(path: Path, data: dict[str, Any], positions: dict[str, int], roots: Roots, trust_paths: bool) -> Sheet:
    """The sheet that a YAML file means: itself, or what is read with it of a table or of a robot's other file."""
    if "urdf" not in data and data.get("kind") != "dh":
        return data, positions
    from tmodes.io.sheet_files import sheet_of_yaml

    return sheet_of_yaml(path, data, positions, (*roots, *installed_models()), trust_paths)


def _checked(data: dict[str, Any], positions: dict[str, int], source: str, changes: Mapping[str, Any]) -> Robot:
    from tmodes.io.sheet_check import sheet_from_data
    from tmodes.io.sheet_paths import changed_places, later_changes
    from tmodes.io.words import shown

    if data.get("kind", "arm") != "arm":
        where = f"{source}:{positions.get('kind', 1)}"
        raise InputError("kind", shown(data["kind"]), "arm", "write `kind: arm`", where)
    later = later_changes(data, changes)
    changed, places = changed_places(data, {path: changes[path] for path in changes if path not in later})
    robot = sheet_from_data(changed, kept_lines(positions, places), source)
    return robot.with_(later) if later else robot


def _published() -> dict[str, Traversable]:
    files = resources.files("tmodes.robots").iterdir()
    return {file.name.removesuffix(".yaml"): file for file in files if file.name.endswith(".yaml")}
