"""Files that somebody sends: hostile until they are parsed, in a folder of their own."""

from __future__ import annotations

import base64
import binascii
import os
import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path, PurePosixPath
from typing import Any, NamedTuple

from tmodes.errors import InputError, InputErrors
from tmodes.io.files import Folders
from tmodes.io.urdf import UrdfRobot
from tmodes.io.words import shown
from tmodes.robots.load import load, urdf_of
from tmodes.sheet import Robot
from tmodes.studio.folders import LONGEST_NAME, NAME, SIGNS, make_within, remove
from tmodes.studio.looks import Shelf
from tmodes.studio.messages import as_sent

__all__ = ["MOST_UPLOADED", "Uploaded", "lay_out", "main_file", "uploaded"]

MOST_UPLOADED = 16 * 1024 * 1024
"""Bytes of all files of one upload together."""

MOST_FILES = 100
MOST_DEPTH = 6


class Uploaded(NamedTuple):
    """The checked sheet of an upload, and where its looks are: the name that a :class:`Shelf` knows, or nothing."""

    sheet: Robot
    looks: str


def uploaded(files: Any, shelf: Shelf) -> Uploaded:
    """The robot of uploaded files: ``[{"name": "ur5.urdf", "content": base64 text}, ...]``.

    A YAML file is meant before a URDF, which it then names. Files of a URDF whose links have shapes stay on the shelf.
    Raises :class:`tmodes.errors.InputError` or :class:`tmodes.errors.InputErrors` with the file and line of each wrong
    value, names as they were sent.
    """
    contents = _decoded(files)
    main = main_file(contents)
    room = shelf.room()
    top = room / "upload"  # one folder further in: a URDF next to the folder of its meshes names them with `..`
    roots = (top, room)
    try:
        paths = [_put(room, top.joinpath(*PurePosixPath(name).parts), content, name)
                 for name, content in contents.items()]  # fmt: skip
        sheet = load(top / main, roots=roots)
        looks = _kept(top / main, roots, paths, shelf)
    except (InputError, InputErrors) as error:
        remove(room)
        names = [*map(str, roots)]
        if isinstance(error, InputErrors):
            raise InputErrors([as_sent(one, names) for one in error.errors]) from None
        raise as_sent(error, names) from None
    if not looks:
        remove(room)
    return Uploaded(sheet, looks)


def _kept(main: Path, roots: tuple[Path, Path], paths: list[Path], shelf: Shelf) -> str:
    """Keep the files of a URDF, its meshes where it looks for them; of other robots there is nothing to see."""
    robot = urdf_of(main, roots=roots)
    if robot is None or not any(one.tag == "geometry" for link in robot.links.values() for one in link.within()):
        return ""
    lay_out(robot, paths, roots[0])
    return shelf.keep(roots[1], main, roots)


def _put(room: Path, path: Path, content: bytes, name: str) -> Path:
    try:
        make_within(room, path.parent)
        path.write_bytes(content)
        return path
    except OSError as error:
        got, expected = f"{shown(name)} ({error.strerror})", "files that can lie in one folder"
        raise InputError("files", got, expected, "use short and different names, or free some space") from None


def _decoded(files: Any) -> dict[str, bytes]:
    if not isinstance(files, list) or not files or len(files) > MOST_FILES:
        got = f"a list of {len(files)}" if isinstance(files, list) else shown(files)
        raise InputError("files", got, f"one to {MOST_FILES} files", "choose the robot's file and what it names")
    contents: dict[str, bytes] = {}
    for file in files:
        name = _checked_name(file)
        try:
            contents[name] = base64.b64decode(str(file.get("content", "")), validate=True)
        except (binascii.Error, ValueError):
            raise InputError(name, "content that is no base64", "the file's bytes in base64", "send it again") from None
    if (size := sum(map(len, contents.values()))) > MOST_UPLOADED:
        raise InputError("files", f"{size:,} bytes", f"at most {MOST_UPLOADED:,}", "leave out what is not needed")
    return contents


def _checked_name(file: Any) -> str:
    name = file.get("name") if isinstance(file, Mapping) else None
    parts = PurePosixPath(name).parts if isinstance(name, str) else ()
    if len(parts) > MOST_DEPTH:
        hint = "choose the folder of the robot itself, or the files without their folders"
        got = f"the name {shown(name)}, {len(parts) - 1} folders deep"
        raise InputError("files", got, f"at most {MOST_DEPTH - 1}", hint)
    if not parts or not all(NAME.fullmatch(part) and part != ".." for part in parts):
        got = f"the name {shown(name)}{_why(parts)}"
        expected = "a relative path of letters, digits and . _ + - ( ) ' alone"
        raise InputError("files", got, expected, "rename it, also where another file names it")
    return str(PurePosixPath(*parts))


def _why(parts: tuple[str, ...]) -> str:
    """The sign that is wrong in a name, or its length."""
    for part in parts:
        if sign := SIGNS.search(part):
            return f" with the sign {shown(sign[0])}"
        if part[0] in " .-+'":
            return f" with {shown(part[0])} at the start of {shown(part)}"
        if len(part) > LONGEST_NAME:
            return f" with {len(part)} characters, more than {LONGEST_NAME}"
    return ""


KINDS = ((".yaml", ".yml"), (".urdf",), (".urdf.xacro", ".xacro"), (".xml",))
"""Endings of a robot's own file; where there are several kinds, the first in this order is meant."""

SHEET = re.compile(rb"^\s*[\"']?(urdf|kind|format)[\"']?\s*:", re.MULTILINE)
"""What reports a data sheet from the other YAML files of a package of models."""


def main_file(contents: Mapping[str, bytes]) -> str:
    """The robot's own file among those of an upload, by their names: of its kind the one that lies highest.

    Raises :class:`tmodes.errors.InputError` where none may be it, or several may.
    """
    able = [name for name in contents if name.lower().endswith(sum(KINDS, ())) and not name.endswith("package.xml")]
    sheets = [name for name in able if not name.lower().endswith(KINDS[0]) or SHEET.search(contents[name])]
    for kind in KINDS:
        alike = [name for name in sheets or able if name.lower().endswith(kind)]
        if alike:
            return _highest(alike)
    got = ", ".join(list(contents)[:5])
    expected = f"a file with the ending {', '.join(ending for kind in KINDS for ending in kind)}"
    raise InputError("files", got, expected, "choose the robot's own file too")


def _highest(alike: list[str]) -> str:
    """The one that lies highest; of files for xacro the one that names its result in its ending."""
    least = min(name.count("/") for name in alike)
    found = [name for name in alike if name.count("/") == least]
    if len(whole := [name for name in found if name.lower().endswith(".urdf.xacro")]) == 1:
        return whole[0]
    if len(found) > 1:
        got = f"several files that may be the robot's own: {', '.join(sorted(found)[:5])}"
        raise InputError("files", got, "one of them", "choose one, and what it names, but not the others")
    return found[0]


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
