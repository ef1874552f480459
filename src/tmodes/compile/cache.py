"""Compiled code on disk, in a folder that is kept small, so that a second run of the same robot compiles nothing.

An entry is an object file that we wrote, behind a seal of its key and its bytes under a secret of the user's; one that
does not fit is made again, never trusted. The key names versions, processor and its features, and the digest of our own
source. What folder and which files are trusted: :mod:`tmodes.compile.cache_folder`.
"""

from __future__ import annotations

import hashlib
import hmac
import os
import re
from collections.abc import Iterator
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import NamedTuple

from tmodes.compile.cache_folder import folder, judged, own_file, secret
from tmodes.errors import ResultFileError
from tmodes.io.atomic import atomic_write, remove_orphans

__all__ = ["MAX_BYTES", "Entry", "clear", "entries", "folder", "judged", "load", "save", "source_digest", "trim"]

MAX_BYTES = 256 * 2**20
"""Size of the cache above which the entries not used for the longest time go."""

_MAX_ENTRY = 64 * 2**20
"""Size of one entry above which it is neither kept nor read."""

_SOURCES = ("chain", "compile", "equations", "kinds", "sheet")

_HEAD = b"tmodes compiled code, layout 2\n"
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


def _entry(place: Path, key: str) -> Path:
    return place / f"{hashlib.sha256(key.encode()).hexdigest()}.o"


def load(key: str) -> bytes | None:
    """The object file of a key, or None where there is none that is whole and the user's own."""
    place = folder()
    known = place and secret(place, make=False)
    if not place or not known:
        return None
    entry = _entry(place, key)
    content = own_file(entry, _START + _MAX_ENTRY) or b""
    binary = content[_START:]
    if not hmac.compare_digest(content[:_START], _seal(known, key, binary)):
        return None
    with suppress(OSError):
        os.utime(entry)
    return binary


def save(key: str, binary: bytes) -> None:
    """Keep an object file; a cache that cannot be written only costs time, so it is no error."""
    place = folder()
    known = place and secret(place, make=True)
    if not place or not known or len(binary) > _MAX_ENTRY:
        return
    entry = _entry(place, key)
    try:
        if entry.is_symlink():
            entry.unlink()  # what it names is not ours to replace
        with atomic_write(entry, durable=False) as temporary:  # a damaged entry is found by its seal, and made again
            temporary.chmod(0o600)
            temporary.write_bytes(_seal(known, key, binary) + binary)
        _bound(entry.parent, _START + len(binary))
    except (OSError, ResultFileError):
        return


def _seal(known: bytes, key: str, binary: bytes) -> bytes:
    return _HEAD + hmac.new(known, key.encode() + b"\0" + binary, hashlib.sha256).hexdigest().encode()


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
