"""The studio's page, all from this package, and what its requests hold: plain JSON of bounded depth."""

from __future__ import annotations

import html
from importlib import resources
from typing import Any

from fastapi import FastAPI, Request, Response

from tmodes.errors import InputError
from tmodes.io.plain_file import parsed_json
from tmodes.io.words import shown
from tmodes.report.parts import styles

__all__ = ["add_page", "body_of", "document", "sheet_of", "word_of", "words_of"]


_DOCUMENT = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>tmodes studio</title>
<link rel="stylesheet" href="studio.css">
<link rel="icon" href="data:,">
</head>
<body data-first="{first}">
<noscript><p>The studio needs JavaScript: allow it for this page.</p></noscript>
<script src="studio.js" defer></script>
</body>
</html>
"""


def document(first: str) -> str:
    """The page as HTML; ``first`` is the robot or file that is shown first."""
    return _DOCUMENT.format(first=html.escape(first))


def add_page(app: FastAPI, first: str) -> None:
    """Serve the document, its program and its style; ``first`` is the robot or file that is shown first."""

    @app.get("/")
    async def page() -> Response:
        return Response(document(first), media_type="text/html; charset=utf-8")

    @app.get("/studio.js")
    async def program() -> Response:
        return Response(_shipped("web", "studio.js"), media_type="text/javascript; charset=utf-8")

    @app.get("/studio.css")
    async def style() -> Response:
        own = resources.files("tmodes.studio").joinpath("studio.css").read_bytes()
        sheets = (styles().encode(), own)
        return Response(b"\n".join(sheets), media_type="text/css; charset=utf-8")


def _shipped(*path: str) -> bytes:
    return resources.files("tmodes.report").joinpath(*path).read_bytes()


LONGEST_WORD = 200
MOST_WORDS = 200


async def body_of(request: Request) -> dict[str, Any]:
    """The JSON object of a request.

    Raises :class:`tmodes.errors.InputError` for anything else: no JSON, numbers that are none, nesting without end.
    """
    kind = request.headers.get("content-type", "").partition(";")[0].strip().lower()
    if kind != "application/json":
        raise InputError("content-type", shown(kind), "application/json", "send JSON")
    try:
        data = parsed_json(await request.body())
    except ValueError as error:
        raise InputError("body", f"no JSON ({str(error)[:200]})", "a JSON object", "send what the page sends") from None
    if not isinstance(data, dict):
        raise InputError("body", shown(data), "a JSON object", "send what the page sends")
    return data


def sheet_of(data: dict[str, Any]) -> dict[str, Any]:
    """The plain data of the sheet; raises :class:`tmodes.errors.InputError` where there is no such field, or another.

    What is wrong within it, its check says.
    """
    sheet = data.get("sheet")
    if not isinstance(sheet, dict) or not sheet:
        got = shown(sheet) if "sheet" in data else "nothing"
        raise InputError(
            "sheet", got, "the data of a robot, a JSON object", "send `sheet`, as /api/robots/NAME gives it"
        )
    return sheet


def word_of(data: dict[str, Any], key: str) -> str:
    """A short text field; raises :class:`tmodes.errors.InputError` where it is missing, long, or no text."""
    value = data.get(key)
    if not isinstance(value, str) or not 0 < len(value) <= LONGEST_WORD:
        raise InputError(key, shown(value), f"a text of at most {LONGEST_WORD} characters", f"send `{key}`")
    return value


def words_of(data: dict[str, Any], key: str) -> list[str]:
    """A field of some short texts; raises :class:`tmodes.errors.InputError` for any other."""
    value: Any = data.get(key)
    if isinstance(value, list) and len(value) <= MOST_WORDS:
        words = [one for one in value if isinstance(one, str) and len(one) <= LONGEST_WORD]
        if len(words) == len(value):
            return words
    expected = f"at most {MOST_WORDS} texts of at most {LONGEST_WORD} characters"
    raise InputError(key, shown(value), expected, f"send `{key}`")
