"""Files that are whole or absent: atomic replacement, one writer per folder, and trouble told before a run.

A reader sees the old file or the new one, never a piece, whatever kills the writer in between.
"""

from __future__ import annotations

import hashlib
import json
import os
import secrets
import shutil
import socket
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Self

from tmodes.errors import ResultFileError
from tmodes.io.words import shown_path

__all__ = ["FolderLock", "atomic_write", "check_writable", "file_error"]

LOCK_NAME = ".tmodes.lock"
YOUNG = 10.0  # age [s] below which a lock without content is believed to be one that is just being written


def file_error(which: object, got: str, expected: str, mend: str) -> ResultFileError:
    """The error of this floor; it tells four things: which, got, expected, mend."""
    return ResultFileError(f"{shown_path(str(which))}: got {got}; expected {expected}. Mend: {mend}")


@contextmanager
def atomic_write(path: str | os.PathLike[str], *, overwrite: bool = True) -> Iterator[Path]:
    """Give a temporary path beside ``path``; what is written there becomes ``path`` when the block ends well.

    The content is on the disk before the name changes. When the block fails, or the process dies, the old file is
    untouched. A symbolic link is followed: the file it names is replaced, not the link.

    Raises :class:`ResultFileError` when the folder cannot be written, the disk is full, or the file exists and
    ``overwrite`` is False (then also when another process made it meanwhile).
    """
    try:
        target = Path(os.path.realpath(path))
        with _temporary(target.parent) as temporary:
            yield temporary
            _flush(temporary, os.O_RDWR)
            if overwrite:
                temporary.replace(target)
            else:
                _claim(temporary, target)
    except FileExistsError as error:
        raise file_error(path, "a file that exists", "a new name", "choose another name, or overwrite=True") from error
    except (OSError, ValueError) as error:
        raise _cannot_write(path, error) from error
    if sys.platform != "win32":  # Windows knows no such call, and some file systems refuse it
        with suppress(OSError):
            _flush(target.parent, os.O_RDONLY)


@contextmanager
def _temporary(folder: Path) -> Iterator[Path]:
    """A new empty file, gone at the end; named after the process that writes it, so that orphans can be told."""
    path = folder / f".tmodes-{_place()}-{os.getpid()}-{secrets.token_hex(4)}.tmp"
    _create(path)
    try:
        yield path
    finally:
        with suppress(OSError):
            path.unlink(missing_ok=True)


def _create(path: Path) -> None:
    """Make an empty file with the usual permissions; fails when the name is taken."""
    os.close(os.open(path, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666))


def _flush(path: Path, flags: int) -> None:
    handle = os.open(path, flags)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def _claim(temporary: Path, target: Path) -> None:
    """Give a whole file its name, unless the name is taken: of two that try, one wins."""
    try:
        target.hardlink_to(temporary)
    except FileExistsError:
        raise
    except OSError:  # a file system without hard links
        _create(target)
        temporary.replace(target)


def _cannot_write(path: object, error: Exception) -> ResultFileError:
    mend = "free some space, or choose another folder or name; what was there before is untouched"
    reason = getattr(error, "strerror", None) or str(error)
    return file_error(path, f"“{reason}” when writing", "a place that can be written", mend)


@dataclass(frozen=True)
class _Holder:
    """Who holds a lock, told so that another process can judge whether it still lives."""

    pid: int
    started: str
    host: str
    boot: str
    pid_space: str
    since: str

    @classmethod
    def here(cls) -> Self:
        path = Path("/proc/sys/kernel/random/boot_id")
        boot, now = path.read_text().strip() if path.exists() else "", time.strftime("%Y-%m-%d %H:%M:%S %z")
        return cls(os.getpid(), _process(os.getpid())[1], socket.gethostname(), boot, _pid_space(), now)

    def gone(self) -> bool:
        """True only when it is sure that the holder no longer runs; on another computer it never is."""
        me = self.here()
        if self.host != me.host or (self.boot == me.boot and self.pid_space != me.pid_space):
            return False
        runs, started = _process(self.pid)
        return self.boot != me.boot or not runs or self.started != started


class FolderLock:
    """One writer per folder: ``with FolderLock(folder): ...``; a second one is refused before it touches anything.

    A lock whose holder is gone (killed, or the computer restarted) is taken over; nobody has to clean up by hand.
    """

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self.folder = Path(folder)
        self.path = self.folder / LOCK_NAME
        self._content = b""

    def __enter__(self) -> Self:
        content = json.dumps(asdict(_Holder.here()), indent=1).encode()
        try:
            if os.path.lexists(self.path):
                self._bury_the_dead()
            with _temporary(self.folder) as temporary:
                temporary.write_bytes(content)
                _claim(temporary, self.path)
        except FileExistsError as error:
            raise self._refusal("a lock that another just took", self.path) from error
        except (OSError, ValueError) as error:
            raise _cannot_write(self.path, error) from error
        self._content = content
        _remove_orphans(self.folder)
        return self

    def __exit__(self, *_: object) -> None:
        with suppress(OSError):
            if self.path.read_bytes() == self._content:
                self.path.unlink()

    def _bury_the_dead(self) -> None:
        """Remove the lock of a holder that is gone; refuse when it lives.

        One at a time, and looked at again once its holder is known to be dead, for only then nobody can change it:
        the holder may have released it and ended while it was judged, and another have taken it.
        """
        undertaker = self.path.with_suffix(".bury")
        try:
            _create(undertaker)
        except FileExistsError as error:
            raise self._refusal("a stale lock that another is just taking over", undertaker) from error
        try:
            stale = self._refuse_if_held()
            if self.path.read_bytes() == stale:
                self.path.unlink()
        except FileNotFoundError:
            pass  # released meanwhile
        finally:
            undertaker.unlink()

    def _refuse_if_held(self) -> bytes:
        """The content of a lock that nobody holds."""
        content, age = self.path.read_bytes(), time.time() - self.path.stat().st_mtime
        try:
            holder = _Holder(**json.loads(content))
        except (ValueError, TypeError) as error:
            if age < YOUNG:
                raise self._refusal("a lock that is just being taken", self.path) from error
            return content
        if not holder.gone():
            raise self._refusal(f"held by process {holder.pid} on {holder.host} since {holder.since}", self.path)
        return content

    def _refusal(self, got: str, path: Path) -> ResultFileError:
        mend = f"wait for that run to end, or use another folder; if nothing runs there, delete {path}"
        return file_error(f"folder {self.folder}", got, "a folder in which nothing else writes", mend)


def _remove_orphans(folder: Path) -> None:
    """Remove temporary files of writers of this computer that were killed."""
    for path in folder.glob(f".tmodes-{_place()}-*-*.tmp"):
        pid = path.name.split("-")[2]
        with suppress(OSError, ValueError):
            if not _process(int(pid))[0]:
                path.unlink()


def _place() -> str:
    """A short name of this computer, for names of temporary files."""
    return hashlib.sha256(f"{socket.gethostname()} {_pid_space()}".encode()).hexdigest()[:8]


def _pid_space() -> str:
    with suppress(OSError, NotImplementedError):
        return str(Path("/proc/self/ns/pid").readlink())
    return ""


def _process(pid: int) -> tuple[bool, str]:
    """Whether a process of this computer runs, and when it started; empty where the system does not tell."""
    with suppress(OSError, IndexError):
        told = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
        return told[0] not in "ZX", told[19]  # zombies and the dead do not run
    if sys.platform == "win32":
        return _runs_on_windows(pid), ""
    try:
        with suppress(PermissionError):  # then it runs, under another user
            os.kill(pid, 0)
    except (OSError, OverflowError):
        return False, ""
    return True, ""


def _runs_on_windows(pid: int) -> bool:
    """Never os.kill here: on Windows that ends the process."""
    import ctypes

    kernel = ctypes.windll.kernel32  # pyright: ignore[reportAttributeAccessIssue]
    handle, code = kernel.OpenProcess(0x1000, False, pid), ctypes.c_ulong()  # 0x1000: may ask whether it runs
    kernel.GetExitCodeProcess(handle, ctypes.byref(code))
    kernel.CloseHandle(handle)
    return code.value == 259  # 259: still active


def check_writable(folder: str | os.PathLike[str], bytes_needed: int) -> None:
    """Make sure, before a run, that its result can be stored: make the folder, write a probe, compare the space.

    Raises :class:`ResultFileError`; for a disk too small with the bytes needed and the bytes free.
    """
    path = Path(folder)
    try:
        standing = next(place for place in (path, *path.absolute().parents) if os.path.lexists(place))
        if not standing.is_dir():
            got = f"{standing}, which is a file"
            raise file_error(f"folder {path}", got, "a folder", "choose another folder, or move that file away")
        free = shutil.disk_usage(standing).free
        if free < bytes_needed:
            got, expected = f"a disk with {free:,} bytes free", f"at least {bytes_needed:,} bytes"
            raise file_error(f"folder {path}", got, expected, "free some space, or choose another disk, or sample less")
        path.mkdir(parents=True, exist_ok=True)
        with _temporary(path):
            pass
    except (OSError, ValueError) as error:
        raise _cannot_write(f"folder {path}", error) from error
