"""Folders of one process, readable for its user alone, and the page in one of them that leads to the studio."""

from __future__ import annotations

import html
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

from tmodes.compile.cache import folder
from tmodes.io.atomic import process_state, this_place

__all__ = ["door", "make_within", "own_folder", "remove"]


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
