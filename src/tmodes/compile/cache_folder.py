"""The folder of compiled code: where it is, whether it is safe, what is in it, and how it is kept small."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from tmodes.io.atomic import remove_orphans

__all__ = ["Entry", "clear", "entries", "folder", "judged", "trim"]

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
