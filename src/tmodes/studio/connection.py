"""Connections of the studio: one whose request does not end, or whose answer nobody reads, is closed."""

from __future__ import annotations

import asyncio
import sys

from uvicorn.protocols.http.h11_impl import H11Protocol

__all__ = ["PATIENCE", "Connection"]

PATIENCE = 20.0
"""Seconds in which the head of a request must come, each further part of its body, and some of an answer be read."""


class Connection(H11Protocol):
    """A connection that is closed where no head of a request comes for so long, be it the first one or a later one.

    It is given up as well where the client reads nothing of an answer for so long.
    """

    _late: asyncio.TimerHandle | None = None
    _unread: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """It is open."""
        super().connection_made(transport)
        self._watch()

    def data_received(self, data: bytes) -> None:
        """A part of a request came."""
        super().data_received(data)
        self._watch()

    def connection_lost(self, exc: Exception | None) -> None:
        """It is over."""
        super().connection_lost(exc)
        self._forget()
        self._read()

    def pause_writing(self) -> None:
        """More of an answer waits than the client reads."""
        super().pause_writing()
        self._wait_for_reading(sys.maxsize)

    def resume_writing(self) -> None:
        """It has read what waited."""
        super().resume_writing()
        self._read()

    def _wait_for_reading(self, before: int) -> None:
        """Give up a client that has read nothing since ``before`` bytes waited."""
        left = self.transport.get_write_buffer_size()
        if left >= before:
            self.transport.abort()
        else:
            self._unread = self.loop.call_later(PATIENCE, self._wait_for_reading, left)

    def _read(self) -> None:
        if self._unread is not None:
            self._unread.cancel()
            self._unread = None

    def _watch(self) -> None:
        """Wait for the head of a request, unless one is being answered; what comes in small parts gains no time."""
        answering = self.cycle is not None and not self.cycle.response_complete
        if answering or self.transport.is_closing():
            self._forget()
        elif self._late is None:
            self._late = self.loop.call_later(PATIENCE, self.transport.close)

    def _forget(self) -> None:
        if self._late is not None:
            self._late.cancel()
            self._late = None
