"""Where compiled code is kept, whether that place is the user's alone, and the secret that seals its entries.

What is loaded from there is executed. So the folder and each file in it belong to the user and nobody else may write
them, nor any folder on the way there (a sticky one, as /tmp, excepted: there nobody can replace what is another's).
"""

from __future__ import annotations

import os
import stat
import sys
import time
from contextlib import suppress
from functools import lru_cache
from pathlib import Path

from tmodes.errors import ResultFileError
from tmodes.io.atomic import atomic_write

__all__ = ["folder", "judged", "own_file", "secret"]

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
