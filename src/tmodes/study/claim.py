"""A study folder is taken by one writer, once it is sure that what lies there belongs to the study."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tmodes.errors import ResultFileError
from tmodes.io.atomic import FolderLock, check_writable, file_error, remove_orphans
from tmodes.study.store import BLOCKS, MOTIONS, NAME, PAGE, STUDY_FILE, TABLE, Folder, description

__all__ = ["locked"]


@contextmanager
def locked(folder: Folder, *, overwrite: bool = False) -> Iterator[Folder]:
    """The folder, locked for one writer, and checked; what does not belong to it is refused.

    ``overwrite``: what an earlier study has left there is removed, once nothing refuses the next one.
    Raises :class:`tmodes.errors.ResultFileError`.
    """
    path = folder.path
    check_writable(path, folder.room())
    with FolderLock(path):
        _refuse_links(path)
        if overwrite:
            _remove_study(path)
        elif os.path.lexists(path / STUDY_FILE):
            if description(path)["base"] != folder.base:
                hint = "name another folder (--out), or replace what is there (--overwrite)"
                raise file_error(
                    f"folder {path}", "a study of another robot or of other parameters", "a folder of this study", hint
                )
        else:
            _refuse_foreign(path)
        if folder.blocks.is_dir():
            remove_orphans(folder.blocks)
        yield folder


def _refuse_links(path: Path) -> None:
    """What is written or removed in the folder lies there: no link leads elsewhere."""
    for name in (BLOCKS, MOTIONS, TABLE, PAGE):
        if (path / name).is_symlink():
            raise file_error(path / name, "a link", "no link in the folder of a study", "name another folder")


def _refuse_foreign(path: Path) -> None:
    """A folder without a description holds nothing that a study would write over."""
    blocks = path / BLOCKS
    if os.path.lexists(blocks) and (not blocks.is_dir() or any(blocks.iterdir())):
        raise file_error(f"folder {path}", f"blocks without {STUDY_FILE}", "the folder of a study", "name another")
    for name in (TABLE, PAGE):
        if os.path.lexists(path / name):
            hint = "name another folder (--out), or replace it (--overwrite)"
            raise file_error(path / name, f"a file of something else: there is no {STUDY_FILE}", "a new name", hint)


def _remove_study(path: Path) -> None:
    """Remove the files of a study, and nothing else; its description last: what is left halfway is still known.

    Nothing is removed where something would be in the way of the next one.
    """
    blocks = path / BLOCKS
    found = [path / TABLE, path / PAGE, *(path / MOTIONS).glob("case_*.nc"), *_blocks_in(blocks), path / STUDY_FILE]
    if folder := next((file for file in found if file.is_dir() and not file.is_symlink()), None):
        raise file_error(folder, "a folder", "a file of a study", "move it, or name another folder")
    try:
        for file in found:
            file.unlink(missing_ok=True)
    except OSError as error:
        hint = "remove it by hand, or name another folder"
        raise ResultFileError(f"{path} cannot be emptied: {error.strerror}; {hint}") from error


def _blocks_in(folder: Path) -> list[Path]:
    """The files of the folder of blocks, all of which are blocks; what killed writers left there is not counted."""
    if not os.path.lexists(folder):
        return []
    if not folder.is_dir():
        raise file_error(folder, "a file", "the folder of blocks", "move it, or name another folder")
    found = [file for file in folder.iterdir() if not file.name.startswith(".tmodes-")]
    if foreign := next((file for file in found if not NAME.fullmatch(file.name)), None):
        raise file_error(foreign, "a file that is no block", "a block of a study", "move it, or name another folder")
    return found
