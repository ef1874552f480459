"""The viewer inside a notebook: a result, several side by side, or a robot at rest with its modes.

tmodes.show(result)    tmodes.show(before, after)    tmodes.show(robot)    result.show()    robot.show()
"""

from __future__ import annotations

import html
import os
from pathlib import Path
from typing import Any

from tmodes.errors import InputError
from tmodes.io.arguments import checked_arguments
from tmodes.io.atomic import atomic_write
from tmodes.report.data import live_page, page_data
from tmodes.report.parts import viewer_document
from tmodes.report.rest import rest_page
from tmodes.result import Result
from tmodes.sheet import Robot

__all__ = ["Shown", "show"]

HEIGHT = 760
"""Height of the frame in a notebook [pixels]."""


class Shown:
    """A self-contained page that notebooks embed by themselves; ``document`` is its HTML."""

    def __init__(self, document: str, title: str, height: int = HEIGHT) -> None:
        self.document, self.title, self.height = document, title, height

    def _repr_html_(self) -> str:
        frame = f'title="{html.escape(self.title)}" width="100%" height="{self.height:d}" frameborder="0"'
        return (
            f'<iframe {frame} sandbox="allow-scripts allow-downloads" srcdoc="{html.escape(self.document)}"></iframe>'
        )

    def __repr__(self) -> str:
        return f"<tmodes view of {self.title}: a notebook shows it; .save(path) writes the page>"

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> Path:
        """Write the page as a file that a browser opens.

        Raises :class:`tmodes.errors.ResultFileError` where it exists, or cannot be written.
        """
        with atomic_write(path, overwrite=overwrite) as temporary:
            temporary.write_text(self.document, encoding="utf-8", newline="\n")
        return Path(path)


@checked_arguments
def show(*shown: Result | Robot, names: list[str] | None = None, height: int = HEIGHT) -> Shown:
    """The viewer of one result, of several side by side, or of one robot at rest with its modes.

    ``names`` tell several results apart; ``height`` of the frame in pixels. Raises
    :class:`tmodes.errors.InputError` for anything else, and what simulating the robot's rest raises.
    """
    # Results are shown next to each other, a robot by itself: what a person gave decides which page is made.
    robots = [one for one in shown if isinstance(one, Robot)]
    results = [one for one in shown if isinstance(one, Result)]
    if not shown or len(robots) + len(results) < len(shown) or (robots and len(shown) > 1):
        got = ", ".join(type(one).__name__ for one in shown) or "nothing"
        raise InputError("show", got, "one result or more, or one robot", "run robots first to compare them")
    if names is not None and len(names) != len(shown):
        raise InputError("names", f"{len(names)} names", f"{len(shown)}, one for each", "name each result")
    page = rest_page(robots[0]) if robots else _page_of(results, names)
    return Shown(viewer_document(page), str(page["title"]), height)


def _page_of(results: list[Result], names: list[str] | None) -> dict[str, Any]:
    """One result with its equations, so that it can be run again in the page; several side by side."""
    return live_page(results[0]) if len(results) == 1 and names is None else page_data(results, names)
