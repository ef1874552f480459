"""The working folder: the only place of which the studio reads and writes, by plain names, never through a link."""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Iterator
from pathlib import Path

from tmodes.errors import InputError, ResultFileError
from tmodes.io.atomic import atomic_write
from tmodes.io.words import shown, shown_path

__all__ = ["NameTaken", "WorkingFolder", "plain_name"]

LONGEST_NAME = 99
NAME = re.compile(rf"[\w(][\w .+()'-]{{0,{LONGEST_NAME - 1}}}")
"""Letters, digits, and a few signs, as browsers number their downloads; no separator, no dot or blank at the start."""

SIGNS = re.compile(r"[^\w .+()'-]")
"""What no name holds."""

STUDY_ENDINGS = (".yaml", ".yml")
ROBOT_ENDINGS = (*STUDY_ENDINGS, ".urdf", ".xacro", ".xml")
MOST_LISTED = 500
RESERVED = re.compile(r"(?i)(con|prn|aux|nul|com\d|lpt\d)(\.|$)")
"""Names that are devices on some machines."""


class NameTaken(ResultFileError):
    """A study of that name exists, and was not to be replaced."""


def plain_name(name: str, endings: tuple[str, ...]) -> str:
    """``name`` if it is that of a file in one folder, with one of the endings.

    Raises :class:`tmodes.errors.InputError` for paths, hidden files and other endings.
    """
    if not NAME.fullmatch(name) or RESERVED.match(name) or name.endswith((" ", ".")):
        hint = "use letters, digits, spaces and . _ + - ( ) ' alone, without a folder"
        raise InputError("file name", shown(name), "the plain name of a file", hint)
    if Path(name).suffix.lower() not in endings:
        raise InputError("file name", shown(name), f"a name that ends with {' or '.join(endings)}", "add the ending")
    return name


class WorkingFolder:
    """The folder that the studio was started in, or with ``--folder``."""

    def __init__(self, path: Path) -> None:
        if not path.is_dir():
            raise InputError("--folder", shown(str(path)), "a folder that exists", "make it, or name another")
        self.path = path.resolve()

    def names(self) -> list[str]:
        """The data sheets and robots of the folder, sorted; links and hidden files are left out."""
        return sorted(entry.name for entry in self._entries())[:MOST_LISTED]

    def _entries(self) -> Iterator[os.DirEntry[str]]:
        with os.scandir(self.path) as entries:
            for entry in entries:
                fits = NAME.fullmatch(entry.name) and Path(entry.name).suffix.lower() in ROBOT_ENDINGS
                if fits and entry.is_file(follow_symlinks=False):
                    yield entry

    def existing(self, name: str) -> Path:
        """The path of a file of the folder; raises :class:`tmodes.errors.InputError` for anything else."""
        path = self.path / plain_name(name, ROBOT_ENDINGS)
        if not _is_plain_file(path):
            hint = "choose one of the list; links are not followed"
            raise InputError("file name", shown(name), "a file of the working folder", hint)
        return path

    def save(self, name: str, text: str, *, overwrite: bool) -> Path:
        """Write a study, whole or not at all.

        Raises :class:`tmodes.errors.InputError` for a name that is none or taken by a link or a folder, and
        :class:`tmodes.errors.ResultFileError` where it cannot be written, :class:`NameTaken` where the file exists and
        ``overwrite`` is not set; both name it as it was given.
        """
        path = self.path / plain_name(name, STUDY_ENDINGS)
        if os.path.lexists(path) and not _is_plain_file(path):
            raise InputError("file name", shown(name), "a new name, or that of a plain file", "choose another name")
        try:
            with atomic_write(path, overwrite=overwrite) as temporary:
                temporary.write_text(text, encoding="utf-8", newline="\n")
        except ResultFileError as error:
            if isinstance(error.__cause__, FileExistsError):
                raise NameTaken(f"the study {name} exists already; replace it, or choose another name") from None
            raise ResultFileError(str(error).replace(shown_path(path), name)) from None
        return path


def _is_plain_file(path: Path) -> bool:
    try:
        return stat.S_ISREG(path.lstat().st_mode)
    except (OSError, ValueError):
        return False
