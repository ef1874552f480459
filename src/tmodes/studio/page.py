"""The studio's page itself: one document, one program, one sheet of style, all from this package."""

from __future__ import annotations

import html
from importlib import resources

from fastapi import FastAPI, Response

__all__ = ["add_page", "document"]

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
        sheets = (_shipped("page.css"), _shipped("app.css"), own)
        return Response(b"\n".join(sheets), media_type="text/css; charset=utf-8")


def _shipped(*path: str) -> bytes:
    return resources.files("tmodes.report").joinpath(*path).read_bytes()
