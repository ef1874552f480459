"""The folders of the studio: the working one, of plain names alone; private ones, gone at the end; the leading page."""

from __future__ import annotations

import html
import os
import re
import shutil
import stat
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

from tmodes.compile.cache import folder
from tmodes.errors import InputError, ResultFileError
from tmodes.io.atomic import atomic_write, process_state, this_place
from tmodes.io.words import shown, shown_path

__all__ = ["NameTaken", "WorkingFolder", "door", "make_within", "own_folder", "plain_name", "remove"]


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


@contextmanager
def own_folder(parent: Path | None = None) -> Iterator[Path]:
    """A new folder in ``parent``, default: the temporary one; named after this process.

    Those of processes that were killed are removed first. At the end it is given another name before it is emptied, so
    that nothing that still continues can write into it. Raises :class:`OSError` where none can be made.
    """
    parent = Path(parent or tempfile.gettempdir()).resolve()
    _sweep(parent)
    made = Path(tempfile.mkdtemp(prefix=f"{_prefix()}{os.getpid()}-", dir=parent))
    try:
        yield made
    finally:
        gone = made.with_name(f"{made.name}-gone")
        with suppress(OSError):  # where a file in it is open and the system minds
            made.rename(gone)
        remove(made)
        remove(gone)


def make_within(room: Path, folder: Path) -> None:
    """Make ``folder`` and those above it up to ``room``, which is not made: it may just have been removed for good.

    Raises :class:`OSError` where they cannot be made.
    """
    step = room
    for name in folder.relative_to(room).parts:
        step /= name
        step.mkdir(exist_ok=True)


def remove(room: Path) -> None:
    """Remove a folder with all that is in it."""
    shutil.rmtree(room, ignore_errors=True)


def _prefix() -> str:
    return f"tmodes-studio-{this_place()}-"


def _sweep(parent: Path) -> None:
    """Remove the folders of this user's studios that were killed; process numbers mean this computer's."""
    for path in parent.glob(f"{_prefix()}*"):
        with suppress(OSError, ValueError):
            number = int(path.name.removeprefix(_prefix()).partition("-")[0])
            if _is_mine(path) and not process_state(number)[0]:
                remove(path)


def _is_mine(path: Path) -> bool:
    return not hasattr(os, "getuid") or path.lstat().st_uid == os.getuid()


_LEADING_PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="referrer" content="no-referrer">
<meta http-equiv="refresh" content="0;url={address}">
<title>tmodes studio</title>
</head>
<body><p><a href="{address}">Open the studio</a></p></body>
</html>
"""


@contextmanager
def door(address: str) -> Iterator[Path | None]:
    """A page that leads on to ``address``, which nobody but its user can read; gone at the end.

    Other users see the command lines of all processes, and with the token in one of them they could enter. None where
    no such page can be written.
    """
    with ExitStack() as until_stopped:
        try:
            place = until_stopped.enter_context(own_folder(_private()))
        except OSError:
            place = None
        yield place and _written(place / "open.html", _LEADING_PAGE.format(address=html.escape(address)))


def _written(page: Path, text: str) -> Path | None:
    try:
        with os.fdopen(os.open(page, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o600), "w", encoding="utf-8") as file:
            file.write(text)
    except OSError:
        return None
    return page


def _private() -> Path | None:
    """The user's folder for what lives as long as a session, else that of the cache; None: the temporary one."""
    session = os.environ.get("XDG_RUNTIME_DIR")
    if session and Path(session).is_absolute() and os.access(session, os.W_OK):
        return Path(session)
    return folder()
