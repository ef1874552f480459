"""A page of the user's own that leads to the studio, so that no browser has the token on its command line."""

from __future__ import annotations

import html
import os
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from tmodes.compile.cache import folder
from tmodes.studio.own_folder import own_folder

__all__ = ["door"]

_DOCUMENT = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="referrer" content="no-referrer">
<meta http-equiv="refresh" content="0;url={address}">
<title>tmodes studio</title>
</head>
<body><p><a href="{address}">Open the studio</a></p></body>
</html>
"""


@contextmanager
def door(address: str) -> Iterator[Path | None]:
    """A page that leads on to ``address``, which nobody but its user can read; gone at the end.

    Other users see the command lines of all processes, and with the token in one of them they could enter. None where
    no such page can be written.
    """
    with ExitStack() as until_stopped:
        try:
            place = until_stopped.enter_context(own_folder(_private()))
        except OSError:
            place = None
        yield place and _written(place / "open.html", _DOCUMENT.format(address=html.escape(address)))


def _written(page: Path, text: str) -> Path | None:
    try:
        with os.fdopen(os.open(page, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o600), "w", encoding="utf-8") as file:
            file.write(text)
    except OSError:
        return None
    return page


def _private() -> Path | None:
    """The user's folder for what lives as long as a session, else that of the cache; None: the temporary one."""
    session = os.environ.get("XDG_RUNTIME_DIR")
    if session and Path(session).is_absolute() and os.access(session, os.W_OK):
        return Path(session)
    return folder()
