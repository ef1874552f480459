"""Files that somebody sends: hostile until they are parsed, in a folder of their own that goes away again."""

from __future__ import annotations

import base64
import binascii
import os
import tempfile
from collections.abc import Mapping
from pathlib import Path, PurePosixPath
from typing import Any

from tmodes.arm import Arm
from tmodes.errors import InputError, InputErrors
from tmodes.io.words import shown
from tmodes.robot import Robot
from tmodes.studio.folder import NAME
from tmodes.studio.sheets import loaded

__all__ = ["MOST_UPLOADED", "uploaded_sheet"]

MOST_UPLOADED = 16 * 1024 * 1024
"""Bytes of all files of one upload together."""

MOST_FILES = 100
MOST_DEPTH = 6
MAIN = (".yaml", ".yml", ".urdf", ".xacro", ".xml")
"""Endings of a robot's own file; where there are several, that of the first ending in this order is meant."""


def uploaded_sheet(files: Any) -> Robot | Arm:
    """The checked sheet of uploaded files: ``[{"name": "ur5.urdf", "content": base64 text}, ...]``.

    A YAML file is meant before a URDF, which it then names. Raises :class:`tmodes.errors.InputError` or
    :class:`tmodes.errors.InputErrors` with the file and line of each wrong value, names as they were sent.
    """
    contents = _decoded(files)
    main = _main(list(contents))
    with tempfile.TemporaryDirectory(prefix="tmodes-upload-") as folder:
        home = Path(folder).resolve()
        for name, content in contents.items():
            _put(home.joinpath(*PurePosixPath(name).parts), content, name)
        try:
            return loaded(home / main, roots=(home,))
        except (InputError, InputErrors) as error:
            for one in error.errors if isinstance(error, InputErrors) else (error,):
                for part in ("which", "got", "expected", "mend", "where"):
                    setattr(one, part, _as_sent(getattr(one, part), home))
            raise


def _put(path: Path, content: bytes, name: str) -> None:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    except OSError as error:
        got, expected = f"{shown(name)} ({error.strerror})", "files that can lie in one folder"
        raise InputError("files", got, expected, "use short and different names, or free some space") from None


def _as_sent(text: str, home: Path) -> str:
    """A sentence in which files have the names that they were sent with."""
    return text.replace(f"{home}{os.sep}", "").replace(str(home), "the folder of the upload")


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
    if not parts or len(parts) > MOST_DEPTH or not all(NAME.fullmatch(part) and part != ".." for part in parts):
        mend = "use plain names, in folders below that of the robot's file"
        raise InputError("files", f"the name {shown(name)}", "a relative path of plain names", mend)
    return str(PurePosixPath(*parts))


def _main(names: list[str]) -> str:
    found = [name for ending in MAIN for name in names if name.lower().endswith(ending) and "/" not in name]
    if not found:
        expected = f"a file with the ending {', '.join(MAIN)}"
        raise InputError("files", f"{', '.join(names[:5])}", expected, "choose the robot's own file too")
    return found[0]
