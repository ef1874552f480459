"""Start the studio on this machine, tell its address, and stop it cleanly."""

from __future__ import annotations

import asyncio
import ipaddress
import logging
import os
import secrets
import signal
import socket
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from types import FrameType

import uvicorn

from tmodes.errors import InputError
from tmodes.studio.connection import Connection
from tmodes.studio.folders import WorkingFolder, own_folder
from tmodes.studio.guard import Guard
from tmodes.studio.server import application

__all__ = ["configured", "serve"]

GRACE = 2
"""Seconds in which requests may end when the studio is stopped."""


def serve(
    folder: WorkingFolder, first: str = "", *, host: str = "127.0.0.1", port: int = 0, ready: Callable[[str], None]
) -> None:
    """Serve until Ctrl-C, SIGTERM or SIGHUP; ``ready`` gets the address with its token once it can be opened.

    Raises :class:`tmodes.errors.InputError` for a host or port that cannot be had.
    """
    token = secrets.token_urlsafe(32)
    host = "127.0.0.1" if host == "localhost" else host
    listening = _listening(host, port)
    own = listening.getsockname()[1]
    names = {f"{_in_address(host)}:{own}", f"localhost:{own}", f"127.0.0.1:{own}"}
    if own == 80:  # browsers leave it out
        names |= {name.rpartition(":")[0] for name in names}
    before = {number: signal.getsignal(number) for number in _endings()}
    try:
        with listening, _place() as place:
            app = application(folder, token, frozenset(names), place, first)
            logging.getLogger("uvicorn.error").addFilter(_no_end)
            server = _Server(configured(app), lambda: ready(f"http://{_in_address(host)}:{own}/?token={token}"))
            for number in before:
                signal.signal(number, server.handle_exit)
            server.run(sockets=[listening])
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def configured(app: Guard) -> uvicorn.Config:
    """How the application is served."""
    return uvicorn.Config(app, log_level="warning", access_log=False, server_header=False, date_header=False,
                          timeout_graceful_shutdown=GRACE, ws="none", http=Connection)  # fmt: skip


@contextmanager
def _place() -> Iterator[Path]:
    """The studio's own folder; raises :class:`tmodes.errors.InputError` where there is no room for one."""
    with ExitStack() as until_stopped:
        try:
            place = until_stopped.enter_context(own_folder())
        except OSError as error:
            got, expected = str(error.strerror), "a folder with room"
            raise InputError("the temporary folder", got, expected, "free some space, or set TMPDIR") from None
        yield place


def _no_end(record: logging.LogRecord) -> bool:
    """Requests that wait when the studio is stopped are cut off, which is no fault that anybody needs to see."""
    cut_off = record.exc_info and isinstance(record.exc_info[1], asyncio.CancelledError)
    return not cut_off and "graceful shutdown" not in record.getMessage()


def _endings() -> list[signal.Signals]:
    """What ends the studio: Ctrl-C, SIGTERM, and a terminal that closes, unless `nohup` said that it shall live on."""
    closed = [signal.SIGHUP] if hasattr(signal, "SIGHUP") and signal.getsignal(signal.SIGHUP) != signal.SIG_IGN else []
    return [signal.SIGINT, signal.SIGTERM, *closed]


class _Server(uvicorn.Server):
    def __init__(self, config: uvicorn.Config, ready: Callable[[], None]) -> None:
        super().__init__(config)
        self._ready = ready

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        """End by a signal, however often it is sent: to leave at once would leave uploads and processes behind."""
        del sig, frame
        self.should_exit = True

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        self._ready()


def _in_address(host: str) -> str:
    return f"[{host}]" if ":" in host else host


def _listening(host: str, port: int) -> socket.socket:
    try:
        info = ipaddress.ip_address(host)
        if info.is_unspecified:
            raise ValueError("it names every address at once: name the one that others use")
        family = socket.AF_INET6 if info.version == 6 else socket.AF_INET
        return socket.create_server((host, port), family=family, backlog=128)
    except (OSError, ValueError, OverflowError) as error:
        why = os.strerror(error.errno) if isinstance(error, OSError) and error.errno else str(error)
        got = f"{host}, port {port} ({why})"
        hint = "leave --host out for this machine alone; --port 0 takes any port that is free"
        raise InputError("--host and --port", got, "an address of this machine and a free port", hint) from None
