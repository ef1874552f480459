"""Compiled code on disk, in a folder that is kept small, so that a second run of the same robot compiles nothing.

An entry is an object file that we wrote, behind a seal of its key and its bytes under a secret of the user's; one that
does not fit is made again, never trusted. The key names versions, processor and its features, and the digest of our own
source. What folder and which files are trusted: :mod:`tmodes.compile.cache`.
"""

from __future__ import annotations

import hashlib
import hmac
import os
import re
import stat
import sys
import time
from collections.abc import Iterator
from contextlib import suppress
from functools import cache, lru_cache
from pathlib import Path
from typing import NamedTuple

from tmodes.errors import ResultFileError
from tmodes.io.atomic import atomic_write, remove_orphans

__all__ = [
    "MAX_BYTES",
    "Entry",
    "clear",
    "entries",
    "folder",
    "judged",
    "load",
    "own_file",
    "save",
    "secret",
    "source_digest",
    "trim",
]

_SECRET_FILE = "secret"  # noqa: S105 - a name, not a secret
"""Name of the file that holds the secret of a folder; whoever cannot read it cannot write an entry that is loaded."""

_BYTES, _YOUNG = 32, 1.0
"""Size of the secret, and the age [s] below which a shorter one is believed to be just being written."""

_OTHERS = stat.S_IWGRP | stat.S_IWOTH
_NO_LINK = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)


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
        place = _absolute("TMODES_CACHE") or _user_cache() / "tmodes"
        if not place.is_dir():
            place.mkdir(mode=0o700, parents=True, exist_ok=True)
        status = place.stat()
    except (OSError, RuntimeError, ValueError, KeyError) as error:  # KeyError, RuntimeError: a user without a home
        return None, f"it cannot be made: {error}"
    if not hasattr(os, "getuid"):  # Windows: the access list of the user's profile guards it
        return place, ""
    if status.st_uid != os.getuid():
        return place, "it belongs to another user, whose code is not run"
    if status.st_mode & _OTHERS:
        with suppress(OSError):  # who could write here may have left code: nothing sealed so far is trusted again
            (place / _SECRET_FILE).unlink()
        return place, f"others may write into it; private is: chmod go-w {place}"
    return place, _on_the_way(place, os.getuid(), int(time.monotonic()))


@lru_cache(maxsize=16)
def _on_the_way(place: Path, user: int, second: int) -> str:
    """Which folder above this one lets others replace it, in words; nothing where none does. Asked once a second."""
    del second
    for one in dict.fromkeys([*place.parents, *Path(os.path.realpath(place)).parents]):
        for status in (one.lstat(), one.stat()):
            if status.st_uid not in (0, user):
                return f"it is in {one}, which belongs to another user, who could replace it"
        if status.st_mode & _OTHERS and not status.st_mode & stat.S_ISVTX:
            return f"it is in {one}, into which others may write; private is: chmod go-w {one}"
    return ""


def _absolute(variable: str) -> Path | None:
    """The folder that a variable names; a relative path is ignored, as the XDG base directory specification says."""
    path = Path(os.environ.get(variable, ""))
    return path if path.is_absolute() else None


def _user_cache() -> Path:
    if sys.platform == "win32":
        return _absolute("LOCALAPPDATA") or Path.home() / "AppData/Local"
    if sys.platform == "darwin":
        return _home() / "Library/Caches"
    return _absolute("XDG_CACHE_HOME") or _home() / ".cache"


def _home() -> Path:
    import pwd

    return _absolute("HOME") or Path(pwd.getpwuid(os.getuid()).pw_dir)


def own_file(path: Path, most: int, *, private: bool = False) -> bytes | None:
    """The content of a regular file of the user's own that nobody else may write (``private``: nor read).

    None where it is missing, a link, something else, another's, or larger than ``most`` bytes.
    """
    try:
        with open(path, "rb", opener=lambda name, flags: os.open(name, flags | _NO_LINK)) as file:
            status = os.fstat(file.fileno())
            if not stat.S_ISREG(status.st_mode) or status.st_size > most or path.is_symlink():
                return None
            return file.read(most + 1) if not hasattr(os, "getuid") or _own(status, private=private) else None
    except OSError:
        return None


def _own(status: os.stat_result, *, private: bool) -> bool:
    others = _OTHERS | (stat.S_IRGRP | stat.S_IROTH if private else 0)
    return status.st_uid == os.getuid() and not status.st_mode & others and status.st_nlink == 1


def secret(place: Path, *, make: bool) -> bytes | None:
    """The secret of a folder, made at first use where asked for; None where there is none that can be relied on."""
    path = place / _SECRET_FILE
    if (found := _whole(path)) or not make:
        return found
    with suppress(OSError, ResultFileError):
        if os.path.lexists(path) and time.time() - path.lstat().st_mtime > _YOUNG:
            path.unlink()  # not ours, or not whole
        with atomic_write(path, overwrite=False, durable=False) as temporary:
            temporary.chmod(0o600)
            temporary.write_bytes(os.urandom(_BYTES))
    return _whole(path)


def _whole(path: Path) -> bytes | None:
    found = own_file(path, _BYTES, private=True)
    return found if found and len(found) == _BYTES else None


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
