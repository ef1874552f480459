"""One way in for every file that describes a robot: its ending and first words say what it is."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from tmodes.errors import InputError
from tmodes.io.files import FilePath, Roots, folders_of
from tmodes.io.words import shown, shown_path
from tmodes.io.yaml_file import Positions, read_yaml

if TYPE_CHECKING:
    from tmodes.io.urdf import UrdfRobot

__all__ = ["RobotFile", "read_file", "read_sheet"]

ENDINGS = (".yaml", ".yml", ".urdf", ".xacro", ".xml", ".mjcf")
XML = (".urdf", ".xml", ".mjcf", ".sdf", ".world")
"""Endings of what is XML; the format is told by its root element."""


class RobotFile(NamedTuple):
    """Plain data of a sheet, the line of each of its dotted paths, and the URDF (or xacro) on which it stands."""

    data: dict[str, Any]
    positions: Positions
    urdf: UrdfRobot | None = None


def read_sheet(
    path: FilePath, *, roots: Roots = (), trust_paths: bool = False
) -> tuple[dict[str, Any], Positions, str]:
    """Plain data of a robot's sheet, the line of its dotted paths, and the file's name; see :func:`read_file`."""
    _check_ending(path)
    return *read_file(path, roots, trust_paths)[:2], shown_path(path)


def read_file(path: FilePath, roots: Roots = (), trust_paths: bool = False, *, fix_inertia: bool = False) -> RobotFile:
    """The sheet that a file means; it is not checked here.

    ``.urdf``; ``.xacro``; ``.xml``: URDF or MJCF by its root element (``.mjcf`` too); else YAML: a robot's sheet, a
    Denavit-Hartenberg table (``kind: dh``) or an elasticity file (with ``urdf:``). Files that a robot's file names must
    lie in its folder or in ``roots``, unless ``trust_paths``; ``fix_inertia``: impossible inertias of a URDF are raised
    to possible ones, with a notice. Raises :class:`tmodes.errors.InputError` or :class:`tmodes.errors.InputErrors`.
    """
    ending = Path(path).suffix.lower()
    if ending == ".xacro":
        from tmodes.io.xacro import read_xacro

        robot = read_xacro(path, roots, trust_paths, fix_inertia=fix_inertia)
    elif ending in XML:
        from tmodes.io.mjcf import sheet_of_mjcf
        from tmodes.io.urdf import urdf_robot
        from tmodes.io.xml_file import read_xml

        root = read_xml(path)
        if ending in {".xml", ".mjcf"} and root.tag == "mujoco":
            return RobotFile(*sheet_of_mjcf(path, root, roots, trust_paths))
        robot = urdf_robot(root, folders_of(path, roots, trust_paths), fix_inertia=fix_inertia)
    else:
        read = data, positions = read_yaml(path)
        if "urdf" not in data and data.get("kind") not in {"dh", "elasticity"}:
            return RobotFile(data, positions)
        _check_ending(path)
        if data.get("kind") == "dh":
            from tmodes.io.dh_table import sheet_of_table

            return RobotFile(*sheet_of_table(data, positions, shown_path(path)))
        from tmodes.io.elasticity import read_elasticity

        robot = read_elasticity(path, roots, trust_paths, read, fix_inertia=fix_inertia)
    return RobotFile(robot.data, robot.positions, robot)


def _check_ending(path: FilePath) -> None:
    if (ending := Path(path).suffix.lower()) not in ENDINGS:
        got, expected = f"a file with the ending {shown(ending)}", f"one of {', '.join(ENDINGS)}"
        raise InputError(shown_path(path), got, expected, "give the file the ending of what it is")
