"""Files that somebody sends: hostile until they are parsed, in a folder of their own."""

from __future__ import annotations

import base64
import binascii
from collections.abc import Mapping
from pathlib import Path, PurePosixPath
from typing import Any, NamedTuple

from tmodes.errors import InputError, InputErrors
from tmodes.io.words import shown
from tmodes.robots.load import urdf_of
from tmodes.sheet import Robot
from tmodes.studio.folder import LONGEST_NAME, NAME, SIGNS
from tmodes.studio.lay_out import lay_out
from tmodes.studio.looks import Shelf
from tmodes.studio.main_file import main_file
from tmodes.studio.messages import as_sent
from tmodes.studio.own_folder import make_within, remove
from tmodes.studio.sheets import loaded

__all__ = ["MOST_UPLOADED", "Uploaded", "uploaded"]

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
        sheet = loaded(top / main, roots=roots)
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
        raise InputError(
            "files", f"the name {shown(name)}, {len(parts) - 1} folders deep", f"at most {MOST_DEPTH - 1}", hint
        )
    if not parts or not all(NAME.fullmatch(part) and part != ".." for part in parts):
        got, expected = (
            f"the name {shown(name)}{_why(parts)}",
            "a relative path of letters, digits and . _ + - ( ) ' alone",
        )
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
