"""Puts the meshes of an upload where the robot's file looks for them, where they came without their folders."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path, PurePosixPath

from tmodes.errors import InputError
from tmodes.io.mesh_paths import Folders
from tmodes.io.urdf import UrdfRobot
from tmodes.studio.folder import NAME
from tmodes.studio.own_folder import make_within

__all__ = ["lay_out"]

MOST_MESHES = 500
DEEPEST = 12
PACKAGE = "package://"


def lay_out(robot: UrdfRobot, sent: Sequence[Path], top: Path) -> None:
    """Link each mesh that is missing to the one file of its name among those ``sent``, which all lie in ``top``.

    A browser gives the names of chosen files without their folders. Nothing is written outside of the folder of
    ``top``, and a mesh whose path is not allowed stays where it is.
    """
    by_name: dict[str, list[Path]] = {}
    for path in sent:
        by_name.setdefault(path.name.lower(), []).append(path)
    for name, place in _meshes(robot):
        alike = by_name.get(PurePosixPath(name).name.lower(), [])
        if len(alike) == 1 and (target := _missing(robot.folders, name, place, top)):
            with suppress(OSError):  # it stays missing, which is reported
                make_within(top.parent, target.parent)
                os.link(alike[0], target)


def _meshes(robot: UrdfRobot) -> Iterator[tuple[str, str]]:
    found = (one for link in robot.links.values() for one in link.within() if one.tag == "mesh")
    for _, one in zip(range(MOST_MESHES), found, strict=False):
        yield one.attributes.get("filename", "").strip().replace("\\", "/"), one.place


def _missing(folders: Folders, name: str, place: str, top: Path) -> Path | None:
    """Where the file of a name would be, if it may lie there and does not."""
    try:
        if folders.find(name, "mesh", place) is not None:
            return None
    except InputError:
        return None
    base, steps = (top, name.removeprefix(PACKAGE)) if name.startswith(PACKAGE) else (folders.home, name)
    parts = PurePosixPath(steps).parts
    if len(parts) > DEEPEST or not all(NAME.fullmatch(part) or part == ".." for part in parts):
        return None
    target = Path(os.path.normpath(base.joinpath(*parts)))
    return target if target.is_relative_to(top.parent) else None
