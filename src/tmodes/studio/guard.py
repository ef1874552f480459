"""What stands before every request: who may ask, from where, how much may be sent, and what the answer may do."""

from __future__ import annotations

import asyncio
import hmac
import json
from collections.abc import Mapping
from typing import Any
from urllib.parse import parse_qs

from tmodes.studio import connection
from tmodes.studio.messages import error_record

__all__ = ["MOST_BODY", "Guard"]

MOST_BODY = 24 * 1024 * 1024
"""Bytes of a request: an upload of the largest size in base64."""

CSP = (
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; img-src data: blob:; "
    "worker-src blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
HEADERS = (
    (b"content-security-policy", CSP.encode()),
    (b"x-content-type-options", b"nosniff"),
    (b"x-frame-options", b"DENY"),
    (b"referrer-policy", b"no-referrer"),
    (b"cross-origin-opener-policy", b"same-origin"),
    (b"cross-origin-resource-policy", b"same-origin"),
    (b"cache-control", b"no-store"),
)

Message = dict[str, Any]


class Guard:
    """Around the application (ASGI): refuses what is not of its own page, and bounds what is sent.

    ``hosts``: what the header Host may say, so that no other name can be made to lead here (DNS rebinding).
    """

    def __init__(self, app: Any, token: str, hosts: frozenset[str], cookie: str) -> None:
        self._app, self._token, self._hosts, self._cookie = app, token, hosts, cookie

    async def __call__(self, scope: Mapping[str, Any], receive: Any, send: Any) -> None:
        """One request, or the start and stop of the application."""
        if scope["type"] != "http":
            if scope["type"] == "lifespan":
                await self._app(scope, receive, send)
            return
        headers = {name.decode("latin-1").lower(): value.decode("latin-1") for name, value in scope["headers"]}
        answer = _Answer(send)
        if wrong := self._refusal(scope, headers):
            await answer.error(*wrong)
            return
        if self._token_in_address(scope):
            answer.more = [(b"set-cookie", self._new_cookie())]
        info = headers.get("content-length", "")
        try:
            body = None if info.isdecimal() and int(info[:15]) > MOST_BODY else await _whole_body(receive)
        except TimeoutError:
            answer.more = [(b"connection", b"close")]
            await answer.error(408, error_record("body", "the rest of the request did not come", hint="send it again"))
            return
        if body is None:
            got, expected = (f"{words} {MOST_BODY:,} bytes" for words in ("more than", "at most"))
            await answer.error(413, error_record("body", "too much was sent", got, expected))
            return
        await self._app(scope, _given(body, receive), answer.send)

    def _refusal(self, scope: Mapping[str, Any], headers: Mapping[str, str]) -> tuple[int, Message] | None:
        host = headers.get("host", "").lower()
        if host not in self._hosts:
            return 421, error_record("host", "a name that is not this studio's", host[:80], " or ".join(self._hosts))
        origin = headers.get("origin")
        if origin is not None and origin.lower() != f"http://{host}":
            return 403, error_record("origin", "a request of another page", origin[:80], f"http://{host}")
        if headers.get("sec-fetch-site", "same-origin") not in ("same-origin", "none") and scope["method"] != "GET":
            return 403, error_record("sec-fetch-site", "a request of another page")
        if not (self._token_in_address(scope) or self._known(headers)):
            hint = "open the address that `tmodes studio` printed"
            return 401, error_record("token", f"no token, or a wrong one; {hint}", hint=hint)
        return None

    def _token_in_address(self, scope: Mapping[str, Any]) -> bool:
        if scope["path"] != "/" or scope["method"] != "GET":
            return False
        given = parse_qs(scope["query_string"].decode("latin-1")).get("token", [""])[0]
        return self._is_token(given)

    def _known(self, headers: Mapping[str, str]) -> bool:
        # By hand: other programs on this machine share the cookies of all ports, http.cookies gives up at a bad one.
        pairs = (pair.strip().partition("=") for pair in headers.get("cookie", "").split(";"))
        kept = next((value for name, _, value in pairs if name == self._cookie), None)
        return self._is_token(kept or headers.get("x-tmodes-token", ""))

    def _is_token(self, given: str) -> bool:
        return hmac.compare_digest(given.encode(), self._token.encode())

    def _new_cookie(self) -> bytes:
        return f"{self._cookie}={self._token}; Path=/; HttpOnly; SameSite=Strict".encode()


async def _whole_body(receive: Any) -> bytes | None:
    """All that is sent; None where it is too much, of which only so much is heard that the answer can be heard too.

    Raises :class:`TimeoutError` where the next part does not come.
    """
    parts: list[bytes] = []
    size, more = 0, True
    while more and size <= 2 * MOST_BODY:
        message = await asyncio.wait_for(receive(), connection.PATIENCE)
        part = message.get("body", b"")
        size += len(part)
        parts.append(part) if size <= MOST_BODY else parts.clear()
        more = message.get("more_body", False)
    return b"".join(parts) if size <= MOST_BODY else None


def _given(body: bytes, receive: Any) -> Any:
    """What the application receives: the body at once, then whatever else comes."""
    waiting = [{"type": "http.request", "body": body, "more_body": False}]

    async def next_message() -> Message:
        return waiting.pop() if waiting else await receive()

    return next_message


class _Answer:
    """What goes back, with the headers that every answer has."""

    def __init__(self, send: Any) -> None:
        self._send = send
        self.more: list[tuple[bytes, bytes]] = []

    async def send(self, message: Message) -> None:
        if message["type"] == "http.response.start":
            message = message | {"headers": [*message.get("headers", []), *HEADERS, *self.more]}
        await self._send(message)

    async def error(self, status: int, info: Message) -> None:
        body = json.dumps({"errors": [info]}).encode()
        headers = [(b"content-type", b"application/json"), (b"content-length", str(len(body)).encode())]
        await self.send({"type": "http.response.start", "status": status, "headers": headers})
        await self._send({"type": "http.response.body", "body": body})
