"""Compiled code on disk, so that a second run of the same robot compiles nothing.

An entry is an object file that we wrote, behind a line with the digest of its key and of its bytes; one that does not
fit is made anew, never trusted. The folder is private to the user and refused when it belongs to another.
"""

from __future__ import annotations

import hashlib
import os
import sys
from functools import cache
from pathlib import Path

from tmodes.errors import ResultFileError
from tmodes.io.atomic import atomic_write

__all__ = ["MAX_BYTES", "folder", "load", "save", "source_digest"]

MAX_BYTES = 256 * 2**20
"""Size of the cache above which the entries not used for the longest time go."""

_SOURCES = ("chain.py", "compile", "contact", "control", "elements", "equations", "mechanism.py", "robot.py")


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


def folder() -> Path | None:
    """The cache's folder, or None where there is none that is safe; ``TMODES_CACHE`` names another (empty: none)."""
    named = os.environ.get("TMODES_CACHE")
    if named is not None and not named.strip():
        return None
    try:
        place = Path(named) if named else _user_cache() / "tmodes"
        place.mkdir(mode=0o700, parents=True, exist_ok=True)
        status = place.stat()
    except (OSError, RuntimeError, ValueError):  # RuntimeError: a user without a home
        return None
    if hasattr(os, "getuid") and (status.st_uid != os.getuid() or status.st_mode & 0o022):
        return None
    return place


def _user_cache() -> Path:
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", Path.home() / "AppData/Local"))
    if sys.platform == "darwin":
        return Path.home() / "Library/Caches"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")


def _entry(key: str) -> Path | None:
    place = folder()
    return place and place / f"{hashlib.sha256(key.encode()).hexdigest()}.o"


def load(key: str) -> bytes | None:
    """The object file of a key, or None where there is none that is whole."""
    entry = _entry(key)
    try:
        content = entry.read_bytes() if entry else b""
        binary = content[64:]
        if content[:64] != _seal(key, binary):
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
        _trim(entry.parent)
    except (OSError, ResultFileError):
        return


def _seal(key: str, binary: bytes) -> bytes:
    return hashlib.sha256(key.encode() + b"\0" + binary).hexdigest().encode()


def _trim(place: Path) -> None:
    entries = sorted(((f.stat().st_mtime, f.stat().st_size, f) for f in place.glob("*.o")), reverse=True)
    total = 0
    for _, size, file in entries:
        total += size
        if total > MAX_BYTES:
            file.unlink(missing_ok=True)
