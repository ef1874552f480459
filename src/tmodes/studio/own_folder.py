"""Folders of one process, readable for its user alone: gone at its end, or when the next studio starts."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from tmodes.io.atomic import process_state, this_place

__all__ = ["make_within", "own_folder", "remove"]


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
