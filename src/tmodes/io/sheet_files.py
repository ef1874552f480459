"""One way in for every file that describes a robot: its ending and first words say what it is."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from tmodes.errors import InputError
from tmodes.io.dh_table import sheet_of_table
from tmodes.io.elasticity import elasticity_of
from tmodes.io.mesh_paths import folders_of
from tmodes.io.mjcf import sheet_of_mjcf
from tmodes.io.urdf import urdf_robot
from tmodes.io.words import shown, shown_path
from tmodes.io.xacro import read_xacro
from tmodes.io.xml_file import read_xml
from tmodes.io.yaml_file import Positions, read_yaml

__all__ = ["read_sheet", "sheet_of_yaml"]

ENDINGS = (".yaml", ".yml", ".urdf", ".xacro", ".xml")


def read_sheet(
    path: str | os.PathLike[str], *, roots: Sequence[str | os.PathLike[str]] = (), trust_paths: bool = False
) -> tuple[dict[str, Any], Positions, str]:
    """Plain data of a robot's sheet, the line of its dotted paths, and the file's name for messages.

    ``.yaml``: a robot's sheet, a Denavit-Hartenberg table (``kind: dh``) or an elasticity file (with ``urdf:``);
    ``.urdf``; ``.xacro``; ``.xml``: URDF or MJCF by its root element. Files that a robot's file names must lie in its
    folder or in ``roots``, unless ``trust_paths``. Raises :class:`tmodes.errors.InputError` or
    :class:`tmodes.errors.InputErrors`; the data of a sheet is not checked here.
    """
    ending, source = Path(path).suffix.lower(), shown_path(path)
    _check_ending(path)
    if ending in {".yaml", ".yml"}:
        return *sheet_of_yaml(path, *read_yaml(path), roots, trust_paths), source
    if ending == ".xacro":
        robot = read_xacro(path, roots, trust_paths)
        return robot.data, robot.positions, source
    root = read_xml(path)
    if ending == ".xml" and root.tag == "mujoco":
        return *sheet_of_mjcf(path, root, roots, trust_paths), source
    robot = urdf_robot(root, folders_of(path, roots, trust_paths))
    return robot.data, robot.positions, source


def sheet_of_yaml(
    path: str | os.PathLike[str],
    data: dict[str, Any],
    positions: Positions,
    roots: Sequence[str | os.PathLike[str]],
    trust_paths: bool,
) -> tuple[dict[str, Any], Positions]:
    """Plain data and lines of the sheet that a YAML file means, from the data and positions that were read of it.

    Raises as :func:`read_sheet` does, also for a file whose ending is none of a robot's.
    """
    _check_ending(path)
    if "urdf" in data:
        robot = elasticity_of(path, data, positions, roots, trust_paths)
        return robot.data, robot.positions
    if data.get("kind") == "dh":
        return sheet_of_table(data, positions, shown_path(path))
    return data, positions


def _check_ending(path: str | os.PathLike[str]) -> None:
    if (ending := Path(path).suffix.lower()) not in ENDINGS:
        got, expected = f"a file with the ending {shown(ending)}", f"one of {', '.join(ENDINGS)}"
        raise InputError(shown_path(path), got, expected, "give the file the ending of what it is")
