"""What a request holds: plain JSON of bounded depth, with the fields that are asked of it."""

from __future__ import annotations

import json
from typing import Any

from fastapi import Request

from tmodes.errors import InputError
from tmodes.io.words import shown

__all__ = ["body_of", "word_of"]

LONGEST_WORD = 200


async def body_of(request: Request) -> dict[str, Any]:
    """The JSON object of a request.

    Raises :class:`tmodes.errors.InputError` for anything else: no JSON, numbers that are none, nesting without end.
    """
    kind = request.headers.get("content-type", "").partition(";")[0].strip().lower()
    if kind != "application/json":
        raise InputError("content-type", shown(kind), "application/json", "send JSON")
    try:
        data = json.loads(await request.body(), parse_constant=_no_number)
    except (ValueError, RecursionError) as error:
        reason = "too many levels" if isinstance(error, RecursionError) else str(error)[:200]
        raise InputError("body", f"no JSON ({reason})", "a JSON object", "send what the page sends") from None
    if not isinstance(data, dict):
        raise InputError("body", shown(data), "a JSON object", "send what the page sends")
    return data


def _no_number(text: str) -> float:
    raise ValueError(f"{text} is no number of JSON")


def word_of(data: dict[str, Any], key: str) -> str:
    """A short text field; raises :class:`tmodes.errors.InputError` where it is missing, long, or no text."""
    value = data.get(key)
    if not isinstance(value, str) or not 0 < len(value) <= LONGEST_WORD:
        raise InputError(key, shown(value), f"a text of at most {LONGEST_WORD} characters", f"send `{key}`")
    return value
