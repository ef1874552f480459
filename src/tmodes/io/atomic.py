"""Files that are whole or absent, whatever kills the writer; one writer per folder; trouble reported before a run."""

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
from pathlib import Path
from typing import NamedTuple, Self

from tmodes.errors import ResultFileError, sentence
from tmodes.io.plain_file import parsed_json, whole_file
from tmodes.io.words import shown_path

__all__ = ["FolderLock", "atomic_write", "check_writable", "file_error", "process_state", "real_path"]
__all__ += ["remove_orphans", "this_place"]

LOCK_NAME = ".tmodes.lock"
MOST_LOCK = 1 << 16
YOUNG = 10.0  # age [s] below which a lock without content is believed to be one that is just being written


def file_error(which: object, got: str, expected: str, hint: str) -> ResultFileError:
    """The error of a file: which, what was found, what is expected, and a hint."""
    return ResultFileError(sentence(shown_path(str(which)), got, expected, hint))


@contextmanager
def atomic_write(path: str | os.PathLike[str], *, overwrite: bool = True, durable: bool = True) -> Iterator[Path]:
    """Give a temporary path next to ``path``; what is written there becomes ``path`` when the block ends well.

    The content is on the disk before the name changes, unless it need not be ``durable``: checked when it is read back,
    and made again. When the block fails, or the process dies, the old file is untouched. A symbolic link is followed.

    Raises :class:`ResultFileError` when it cannot be written, or exists (even since just now) without ``overwrite``.
    """
    target = real_path(path)
    try:
        with _temporary(target.parent) as temporary:
            yield temporary
            if durable:
                _flush(temporary, os.O_RDWR)
            (Path.replace if overwrite else _claim)(temporary, target)
    except FileExistsError as error:
        raise file_error(path, "a file that exists", "a new name", "choose another name, or overwrite=True") from error
    except OSError as error:
        raise _cannot_write(path, error) from error
    if durable:
        with suppress(OSError):  # Windows and some file systems know no such call for a folder
            _flush(target.parent, os.O_RDONLY)


def real_path(path: str | os.PathLike[str]) -> Path:
    """The absolute path of a file, links followed; raises :class:`ResultFileError` where there is none."""
    try:
        return Path(os.path.realpath(path))
    except (OSError, ValueError) as error:
        raise _cannot_write(path, error) from error


@contextmanager
def _temporary(folder: Path) -> Iterator[Path]:
    """A new empty file, gone at the end; named after the process that writes it, so that orphans can be recognised."""
    path = folder / f".tmodes-{this_place()}-{os.getpid()}-{secrets.token_hex(4)}.tmp"
    _create(path)
    try:
        yield path
    finally:
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
    hint = "free some space, or choose another folder or name; what was there before is untouched"
    got = f"“{getattr(error, 'strerror', None) or error}” when writing"
    return file_error(path, got, "a place that can be written", hint)


def this_place() -> str:
    """A short name of this computer, or of the container: within it a process number means one process."""
    path = Path("/proc/self/ns/pid")
    space = path.readlink() if path.is_symlink() else ""
    return hashlib.sha256(f"{socket.gethostname()} {space}".encode()).hexdigest()[:8]


def process_state(pid: int) -> tuple[bool, str]:
    """Whether a process of this computer runs, and when it started; empty where the system does not report it."""
    with suppress(OSError, IndexError):
        info = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
        return info[0] not in "ZX", info[19]  # zombies and the dead do not run
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


class _Holder(NamedTuple):
    """Who holds a lock, stated so that another process can judge whether it still runs."""

    pid: int
    started: str
    host: str
    place: str
    since: str

    @classmethod
    def here(cls) -> Self:
        now = time.strftime("%Y-%m-%d %H:%M:%S %z")
        return cls(os.getpid(), process_state(os.getpid())[1], socket.gethostname(), this_place(), now)

    def gone(self) -> bool:
        """True only when it is sure that the holder no longer runs; on another computer it never is."""
        runs, started = process_state(self.pid)
        reused = bool(self.started and started) and self.started != started
        return self.place == this_place() and (not runs or reused)


def _holder(content: bytes) -> _Holder:
    """Who a lock names; raises TypeError where another version of tmodes has written it, ValueError where none has."""
    found = parsed_json(content)
    if not isinstance(found, dict):
        raise ValueError("a lock that names nobody")
    holder = _Holder(**found)
    if type(holder.pid) is not int or not all(isinstance(one, str) for one in holder[1:]):
        raise TypeError("a lock of other fields")
    return holder


class FolderLock:
    """One writer per folder: ``with FolderLock(folder): ...``; a second one is refused before it touches anything.

    A lock whose holder is gone (killed, or the computer restarted) is taken over; nobody has to clean up by hand.
    """

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self.folder = Path(folder)
        self.path = self.folder / LOCK_NAME
        self._content = json.dumps(_Holder.here()._asdict(), indent=1).encode()

    def __enter__(self) -> Self:
        try:
            if os.path.lexists(self.path):
                with suppress(FileNotFoundError):  # released meanwhile
                    self._remove_stale()
            with _temporary(self.folder) as temporary:
                temporary.write_bytes(self._content)
                _claim(temporary, self.path)
        except FileExistsError as error:
            raise self._refusal("a lock that another is just taking") from error
        except (OSError, ValueError) as error:
            raise _cannot_write(self.path, error) from error
        remove_orphans(self.folder)
        return self

    def __exit__(self, *_: object) -> None:
        with suppress(OSError):
            if whole_file(self.path, MOST_LOCK) == self._content:
                self.path.unlink()

    def _remove_stale(self) -> None:
        """Remove the lock of a holder that is gone; refuse when it runs.

        One at a time, and read again once its holder is known to be dead: it may have been taken again.
        """
        removing = self.folder / f"{LOCK_NAME}.bury"
        _create(removing)
        try:
            stale = self._refuse_if_held()
            if whole_file(self.path, MOST_LOCK) == stale:
                self.path.unlink()
        finally:
            removing.unlink()

    def _refuse_if_held(self) -> bytes:
        """The content of a lock that nobody holds."""
        try:
            content, age = whole_file(self.path, MOST_LOCK), time.time() - self.path.stat().st_mtime
        except FileNotFoundError:
            raise
        except OSError as error:
            raise self._refusal(f"a lock that cannot be read (“{error.strerror}”)") from error
        try:
            holder = _holder(content)
        except TypeError as error:
            raise self._refusal("a lock of another version of tmodes") from error
        except ValueError as error:
            if age < YOUNG:
                raise self._refusal("a lock that is just being taken") from error
            return content
        if not holder.gone():
            raise self._refusal(f"held by process {holder.pid} on {holder.host} since {holder.since}")
        return content

    def _refusal(self, got: str) -> ResultFileError:
        hint = f"wait for that run to end, or use another folder; if nothing runs there, delete {self.path}*"
        return file_error(f"folder {self.folder}", got, "a folder in which nothing else writes", hint)


def remove_orphans(folder: Path) -> None:
    """Remove temporary files of writers of this computer that were killed."""
    for path in folder.glob(f".tmodes-{this_place()}-*-*.tmp"):
        with suppress(OSError, ValueError):
            if not process_state(int(path.name.split("-")[2]))[0]:
                path.unlink()


def check_writable(folder: str | os.PathLike[str], bytes_needed: int) -> None:
    """Make the folder, write a probe, compare the space, before a run; ResultFileError where nothing can be stored."""
    path = Path(folder)
    try:
        standing = next(place for place in (path, *path.absolute().parents) if os.path.lexists(place))
        if not standing.is_dir():
            raise file_error(f"folder {path}", f"{standing}, which is a file", "a folder", "choose another, or move it")
        free = shutil.disk_usage(standing).free
        if free < bytes_needed:
            got, hint = f"a disk with {free:,} bytes free", "free some space, or choose another disk, or sample less"
            raise file_error(f"folder {path}", got, f"at least {bytes_needed:,} bytes", hint)
        path.mkdir(parents=True, exist_ok=True)
        with _temporary(path):
            pass
    except (OSError, ValueError) as error:
        raise _cannot_write(f"folder {path}", error) from error
