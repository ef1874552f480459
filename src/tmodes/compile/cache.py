"""Compiled code on disk, so that a second run of the same robot compiles nothing.

An entry is an object file that we wrote, behind a line with the digest of its key and of its bytes; one that does not
fit is made again, never trusted. The key names versions, processor and its features, and the digest of our own source.
The folder is private to the user and refused when it belongs to another.
"""

from __future__ import annotations

import hashlib
import os
from functools import cache
from pathlib import Path

from tmodes.compile.cache_folder import folder, trim
from tmodes.errors import ResultFileError
from tmodes.io.atomic import atomic_write

__all__ = ["MAX_BYTES", "folder", "load", "save", "source_digest"]

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
        with atomic_write(entry) as temporary:
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
