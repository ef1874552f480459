"""Start the studio on this machine, tell its address, and stop it cleanly."""

from __future__ import annotations

import ipaddress
import secrets
import signal
import socket
from collections.abc import Callable
from types import FrameType

import uvicorn

from tmodes.errors import InputError
from tmodes.studio.folder import WorkingFolder
from tmodes.studio.server import application

__all__ = ["serve"]

GRACE = 2
"""Seconds in which requests may end when the studio is stopped."""


def serve(
    folder: WorkingFolder, first: str = "", *, host: str = "127.0.0.1", port: int = 0, ready: Callable[[str], None]
) -> None:
    """Serve until Ctrl-C or SIGTERM; ``ready`` gets the address with its token once it can be opened.

    Raises :class:`tmodes.errors.InputError` for a host or port that cannot be had.
    """
    token = secrets.token_urlsafe(32)
    host = "127.0.0.1" if host == "localhost" else host
    listening = _listening(host, port)
    own = listening.getsockname()[1]
    names = {f"{_in_address(host)}:{own}", f"localhost:{own}", f"127.0.0.1:{own}"}
    if own == 80:  # browsers leave it out
        names |= {name.rpartition(":")[0] for name in names}
    app = application(folder, token, frozenset(names), first)
    config = uvicorn.Config(app, log_level="warning", access_log=False, server_header=False, date_header=False,
                            timeout_graceful_shutdown=GRACE, ws="none")  # fmt: skip
    server = _Server(config, lambda: ready(f"http://{_in_address(host)}:{own}/?token={token}"))
    before = {number: signal.signal(number, _heard) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        server.run(sockets=[listening])
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        listening.close()


def _heard(number: int, frame: FrameType | None) -> None:
    """The server stops by itself, and then sends the signal once more, which has nothing left to stop."""
    del number, frame


class _Server(uvicorn.Server):
    def __init__(self, config: uvicorn.Config, ready: Callable[[], None]) -> None:
        super().__init__(config)
        self._ready = ready

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        self._ready()


def _in_address(host: str) -> str:
    return f"[{host}]" if ":" in host else host


def _listening(host: str, port: int) -> socket.socket:
    try:
        told = ipaddress.ip_address(host)
        if told.is_unspecified:
            raise ValueError("it names every address at once: name the one that others use")
        family = socket.AF_INET6 if told.version == 6 else socket.AF_INET
        found = socket.socket(family, socket.SOCK_STREAM)
        found.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        found.bind((host, port))
    except (OSError, ValueError, OverflowError) as error:
        got = f"{host}, port {port} ({getattr(error, 'strerror', None) or error})"
        mend = "leave --host out for this machine alone; --port 0 takes any port that is free"
        raise InputError("--host and --port", got, "an address of this machine and a free port", mend) from None
    found.listen(128)
    return found
