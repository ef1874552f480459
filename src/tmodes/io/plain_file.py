"""Regular files of a bounded size, and JSON: how everything is read that anybody may have put there.

A pipe, a device or a folder is refused before anything is read of it, so that nothing waits; a size is compared with
its limit before there is memory for it.
"""

from __future__ import annotations

import errno
import json
import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from io import BufferedReader
from pathlib import Path
from typing import Any

__all__ = ["parsed_json", "regular_file", "whole_file"]

FilePath = str | os.PathLike[str]


@contextmanager
def regular_file(path: FilePath, most: int, *, links: bool = True) -> Iterator[tuple[BufferedReader, int]]:
    """A regular file that is open for reading, and its size [bytes].

    Raises OSError with words for anything else, for more than ``most`` bytes, and, unless ``links`` are followed, for a
    link. Asked before it is opened, as to open a device may do something, and again of what was opened.
    """
    _refuse_others(Path(path).stat(follow_symlinks=links))
    flags = os.O_RDONLY | sum(getattr(os, name, 0) for name in ("O_NONBLOCK", "O_BINARY", "O_CLOEXEC"))
    handle = os.open(path, flags if links else flags | getattr(os, "O_NOFOLLOW", 0))
    try:
        found = os.fstat(handle)
        _refuse_others(found)
        if found.st_size > most:
            raise OSError(errno.EFBIG, f"{found.st_size:,} bytes")
        with open(handle, "rb", closefd=False) as file:
            yield file, found.st_size
    finally:
        os.close(handle)


def whole_file(path: FilePath, most: int, *, links: bool = True) -> bytes:
    """The content of a regular file; raises OSError as :func:`regular_file`."""
    with regular_file(path, most, links=links) as (file, size):
        return file.read(size)


def _refuse_others(status: os.stat_result) -> None:
    if not stat.S_ISREG(status.st_mode):
        kinds = {stat.S_IFDIR: "a directory", stat.S_IFLNK: "a link"}
        kind = kinds.get(stat.S_IFMT(status.st_mode), "a device, pipe or socket")
        raise OSError(errno.EINVAL, kind)


def parsed_json(content: bytes | str) -> Any:
    """What JSON holds; raises ValueError where it is none, goes too deep, or has numbers that JSON does not know."""
    try:
        return json.loads(content, parse_constant=_no_number)
    except RecursionError:
        raise ValueError("lists or objects that go too deep") from None


def _no_number(word: str) -> Any:
    raise ValueError(f"{word}, which is no number of JSON")
