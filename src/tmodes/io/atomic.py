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
YOUNG = 10.0
"""Age [s] below which a lock file without content is believed to be one that is just being written."""


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
        temporary = target.parent / f".tmodes-{_place()}-{os.getpid()}-{secrets.token_hex(4)}.tmp"
        os.close(os.open(temporary, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666))
    except (OSError, ValueError) as error:
        raise _cannot_write(path, error) from error
    try:
        yield temporary
        _flush(temporary)
        _rename(temporary, target, overwrite)
    except FileExistsError as error:
        raise file_error(path, "a file that exists", "a new name", "choose another name, or overwrite=True") from error
    except OSError as error:
        raise _cannot_write(path, error) from error
    finally:
        with suppress(OSError):
            temporary.unlink(missing_ok=True)
    _flush_folder(target.parent)


def _cannot_write(path: object, error: Exception) -> ResultFileError:
    reason = getattr(error, "strerror", None) or str(error)
    mend = "free some space, or choose another folder or name; what was there before is untouched"
    return file_error(path, f"“{reason}” when writing", "a place that can be written", mend)


def _flush(path: Path) -> None:
    with path.open("rb+") as file:
        os.fsync(file.fileno())


def _flush_folder(folder: Path) -> None:
    """Make the new name itself durable; Windows knows no such call, some file systems refuse it."""
    if sys.platform == "win32":
        return
    with suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def _rename(temporary: Path, target: Path, overwrite: bool) -> None:
    if overwrite:
        temporary.replace(target)
    elif sys.platform == "win32":
        temporary.rename(target)  # on Windows this fails when the target exists
    else:
        target.hardlink_to(temporary)  # fails when the target exists, so of two writers only one wins


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
        now = time.strftime("%Y-%m-%d %H:%M:%S %z")
        return cls(os.getpid(), _start_of(os.getpid()), socket.gethostname(), _boot(), _pid_space(), now)

    def gone(self) -> bool:
        """True only when it is sure that the holder no longer runs; on another computer it never is."""
        me = self.here()
        if self.host != me.host:
            return False
        if self.boot != me.boot:
            return True
        if self.pid_space != me.pid_space:
            return False
        return not _runs(self.pid) or self.started != _start_of(self.pid)


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
        for _ in range(3):
            try:
                self._take(content)
            except FileExistsError:
                self._bury_the_dead()
            except OSError as error:
                raise _cannot_write(self.path, error) from error
            else:
                self._content = content
                _remove_orphans(self.folder)
                return self
        raise self._refusal("another writer that took it first")

    def __exit__(self, *_: object) -> None:
        with suppress(OSError):
            if self.path.read_bytes() == self._content:
                self.path.unlink()

    def _take(self, content: bytes) -> None:
        handle = os.open(self.path, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o644)
        with os.fdopen(handle, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())

    def _bury_the_dead(self) -> None:
        """Remove the lock of a holder that is gone; refuse when it lives.

        The lock is renamed before it is removed and looked at again: of two that found it stale only one may take it
        away, and one that took away a fresh lock by mistake puts it back.
        """
        try:
            content = self.path.read_bytes()
            age = time.time() - self.path.stat().st_mtime
        except FileNotFoundError:
            return
        except OSError as error:
            raise self._refusal(f"a lock that cannot be read ({error.strerror})") from error
        holder = _holder_of(content)
        if holder is None and age < YOUNG:
            raise self._refusal("a lock that is just being taken")
        if holder is not None and not holder.gone():
            raise self._refusal(f"held by process {holder.pid} on {holder.host} since {holder.since}")
        grave = self.folder / f".tmodes-{_place()}-{os.getpid()}-{secrets.token_hex(4)}.tmp"
        with suppress(OSError):
            self.path.rename(grave)
            if grave.read_bytes() != content:
                self.path.hardlink_to(grave)
            grave.unlink()

    def _refusal(self, got: str) -> ResultFileError:
        mend = f"wait for that run to end, or use another folder; if nothing runs there, delete {self.path}"
        return file_error(f"folder {self.folder}", got, "a folder in which nothing else writes", mend)


def _holder_of(content: bytes) -> _Holder | None:
    try:
        return _Holder(**json.loads(content))
    except (ValueError, TypeError):
        return None


def _remove_orphans(folder: Path) -> None:
    """Remove temporary files of writers of this computer that were killed."""
    for path in folder.glob(f".tmodes-{_place()}-*-*.tmp"):
        pid = path.name.split("-")[2]
        if pid.isdigit() and not _runs(int(pid)):
            with suppress(OSError):
                path.unlink()


def _place() -> str:
    """A short name of this computer, for names of temporary files."""
    return hashlib.sha256(f"{socket.gethostname()} {_pid_space()}".encode()).hexdigest()[:8]


def _boot() -> str:
    with suppress(OSError):
        return Path("/proc/sys/kernel/random/boot_id").read_text().strip()
    return ""


def _pid_space() -> str:
    with suppress(OSError, NotImplementedError):
        return str(Path("/proc/self/ns/pid").readlink())
    return ""


def _start_of(pid: int) -> str:
    """When a process started, in clock ticks; empty where the system does not tell (then it is never compared)."""
    with suppress(OSError, IndexError):
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[19]
    return ""


def _runs(pid: int) -> bool:
    """Whether a process of this computer runs; a zombie does not."""
    if sys.platform == "win32":
        return _runs_on_windows(pid)
    try:
        os.kill(pid, 0)
    except (ProcessLookupError, OverflowError):
        return False
    except OSError:
        return True
    with suppress(OSError, IndexError):
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] not in "ZX"
    return True


def _runs_on_windows(pid: int) -> bool:
    import ctypes

    kernel = ctypes.windll.kernel32  # pyright: ignore[reportAttributeAccessIssue]
    handle = kernel.OpenProcess(0x1000, False, pid)  # 0x1000: may ask whether it still runs
    if not handle:
        return False
    code = ctypes.c_ulong()
    kernel.GetExitCodeProcess(handle, ctypes.byref(code))
    kernel.CloseHandle(handle)
    return code.value == 259  # 259: still active


def check_writable(folder: str | os.PathLike[str], bytes_needed: int) -> None:
    """Make sure, before a run, that its result can be stored: make the folder, write a probe, compare the space.

    Raises :class:`ResultFileError` for a read-only folder, missing permission, a file in the way, a name too long,
    a disk too small (with the bytes needed and the bytes free).
    """
    path = Path(folder)
    try:
        standing = next(place for place in (path, *path.absolute().parents) if os.path.lexists(place))
        if not standing.is_dir():
            got = f"{standing}, which is a file"
            raise file_error(f"folder {path}", got, "a folder", "choose another folder, or move that file away")
        free = shutil.disk_usage(standing).free
        if free < bytes_needed:
            got = f"a disk with {free:,} bytes free"
            expected = f"at least {bytes_needed:,} bytes"
            raise file_error(f"folder {path}", got, expected, "free some space, or choose another disk, or sample less")
        path.mkdir(parents=True, exist_ok=True)
        probe = path / f".tmodes-{_place()}-{os.getpid()}-{secrets.token_hex(4)}.tmp"
        os.close(os.open(probe, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o600))
        probe.unlink()
    except (OSError, ValueError) as error:
        raise _cannot_write(f"folder {path}", error) from error
