"""Compiled code on disk, in a folder that is kept small, so that a second run of the same robot compiles nothing.

An entry is an object file that we wrote, behind a line with the digest of its key and of its bytes; one that does not
fit is made again, never trusted. The key names versions, processor and its features, and the digest of our own source.
The folder is private to the user and refused when it belongs to another.
"""

from __future__ import annotations

import hashlib
import os
import re
import sys
from collections.abc import Iterator
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import NamedTuple

from tmodes.errors import ResultFileError
from tmodes.io.atomic import atomic_write, remove_orphans

__all__ = ["MAX_BYTES", "Entry", "clear", "entries", "folder", "judged", "load", "save", "source_digest", "trim"]

MAX_BYTES = 256 * 2**20
"""Size of the cache above which the entries not used for the longest time go."""

_SOURCES = ("chain", "compile", "equations", "kinds", "sheet")

_HEAD = b"tmodes compiled code, layout 1\n"
"""First line of an entry; entries of another layout are made again."""

_START = len(_HEAD) + 64
"""Where the object file begins in an entry."""

_SHARE = 16
"""The folder is listed when this process has written this part of MAX_BYTES since it did so last."""

_written: dict[Path, int] = {}
"""Bytes that this process has written into a folder since it listed it."""


@cache
def source_digest(sources: tuple[str, ...] = _SOURCES) -> str:
    """Digest of source of the package; without argument, of all that the compiled code follows from."""
    root = Path(__file__).parents[1]
    digest = hashlib.sha256()
    for source in sources:
        place = root / source
        for file in sorted(place.rglob("*.py")) if place.is_dir() else [place]:
            digest.update(file.relative_to(root).as_posix().encode() + b"\0" + file.read_bytes() + b"\0")
    return digest.hexdigest()


def _entry(key: str) -> Path | None:
    place = folder()
    return place and place / f"{hashlib.sha256(key.encode()).hexdigest()}.o"


def load(key: str) -> bytes | None:
    """The object file of a key, or None where there is none that is whole."""
    entry = _entry(key)
    try:
        content = entry.read_bytes() if entry else b""
        binary = content[_START:]
        if content[:_START] != _seal(key, binary):
            return None
        os.utime(entry)  # type: ignore[arg-type]
    except OSError:
        return None
    return binary


def save(key: str, binary: bytes) -> None:
    """Keep an object file; a cache that cannot be written only costs time, so it is no error."""
    entry = _entry(key)
    if entry is None:
        return
    try:
        with atomic_write(entry, durable=False) as temporary:  # a damaged entry is found by its digest, and made again
            temporary.write_bytes(_seal(key, binary) + binary)
        _bound(entry.parent, _START + len(binary))
    except (OSError, ResultFileError):
        return


def _seal(key: str, binary: bytes) -> bytes:
    return _HEAD + hashlib.sha256(key.encode() + b"\0" + binary).hexdigest().encode()


def _bound(place: Path, size: int) -> None:
    """Trim the folder now and then: at a process's first entry, then each time that it has written a part of the limit.

    Several processes may together pass the limit by such a part each, until one of them trims.
    """
    _written[place] = _written.get(place, MAX_BYTES) + size
    if _written[place] * _SHARE >= MAX_BYTES:
        trim(place, MAX_BYTES)
        _written[place] = 0


_NAME = re.compile(r"[0-9a-f]{64}\.o")
"""Names of our entries; whatever else is in the folder is not ours, and never touched."""

_KEPT = 7 / 8
"""Share of the limit that trimming leaves, so that the next entry does not trim again."""


class Entry(NamedTuple):
    """One entry: when it was used last [s since 1970], its size [bytes], its file."""

    used: float
    size: int
    file: Path


def folder() -> Path | None:
    """The cache's folder, or None where there is none that is safe; ``TMODES_CACHE`` names another (empty: none)."""
    place, refusal = judged()
    return None if refusal else place


def judged() -> tuple[Path | None, str]:
    """The folder, made where it is missing, and why it is not used, or nothing where it is."""
    named = os.environ.get("TMODES_CACHE")
    if named is not None and not named.strip():
        return None, "the environment variable TMODES_CACHE is empty: nothing is kept"
    try:
        place = Path(named) if named else _user_cache() / "tmodes"
        if not place.is_dir():
            place.mkdir(mode=0o700, parents=True, exist_ok=True)
        status = place.stat()
    except (OSError, RuntimeError, ValueError) as error:  # RuntimeError: a user without a home
        return None, f"it cannot be made: {error}"
    if not hasattr(os, "getuid"):
        return place, ""
    if status.st_uid != os.getuid():
        return place, "it belongs to another user, whose code is not run"
    if status.st_mode & 0o022:
        return place, f"others may write into it; private is: chmod go-w {place}"
    return place, ""


def _user_cache() -> Path:
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", Path.home() / "AppData/Local"))
    if sys.platform == "darwin":
        return Path.home() / "Library/Caches"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")


def entries(place: Path) -> Iterator[Entry]:
    """All entries of a folder; one that goes meanwhile is passed over, for others use the folder too."""
    with os.scandir(place) as found:
        for one in found:
            if _NAME.fullmatch(one.name):
                with suppress(OSError):
                    status = one.stat()
                    yield Entry(status.st_mtime, status.st_size, Path(one.path))


def trim(place: Path, limit: int) -> int:
    """Remove the entries not used for the longest time where all take more than ``limit`` bytes; returns what is left.

    What killed writers left behind goes too.
    """
    remove_orphans(place)
    found = sorted(entries(place))
    total = sum(entry.size for entry in found)
    aim = total if total <= limit else _KEPT * limit
    for entry in found:
        if total <= aim:
            break
        entry.file.unlink(missing_ok=True)
        total -= entry.size
    return total


def clear(place: Path) -> tuple[int, int]:
    """Remove all entries; returns how many, and their size [bytes]."""
    remove_orphans(place)
    removed = list(entries(place))
    for entry in removed:
        entry.file.unlink(missing_ok=True)
    return len(removed), sum(entry.size for entry in removed)
