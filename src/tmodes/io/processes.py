"""Which processes of this computer run, so that what the dead ones left behind can be recognised."""

from __future__ import annotations

import hashlib
import os
import socket
import sys
from contextlib import suppress
from pathlib import Path

__all__ = ["place", "state"]


def place() -> str:
    """A short name of this computer, or of the container: within it a process number means one process."""
    path = Path("/proc/self/ns/pid")
    space = path.readlink() if path.is_symlink() else ""
    return hashlib.sha256(f"{socket.gethostname()} {space}".encode()).hexdigest()[:8]


def state(pid: int) -> tuple[bool, str]:
    """Whether a process of this computer runs, and when it started; empty where the system does not tell."""
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
