"""A figure as bytes: the same bytes for the same numbers, on any day and in any process."""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import Any

from tmodes.plot.style import house_style

__all__ = ["FORMATS", "Drawing", "rendered"]

FORMATS: dict[str, dict[str, Any]] = {
    "svg": {"Date": None, "Creator": None, "Format": None, "Type": None},
    "png": {"Software": None},
    "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
}
"""The formats of files, and the metadata to leave out: dates and versions change, pictures should not."""

DPI = 200
"""Resolution of a PNG in a file, for print [dots per inch]."""


class Drawing:
    """A figure that is drawn when it is first needed, and rendered once for each format however often it is asked."""

    def __init__(self, draw: Callable[[], Any]) -> None:
        self._draw = draw
        self._figure: Any = None
        self._rendered: dict[tuple[str, int], bytes] = {}

    def content(self, kind: str, dpi: int = DPI) -> bytes:
        """The bytes of a file of this ``kind`` (a key of FORMATS)."""
        if self._figure is None:
            self._figure = self._draw()[0].figure
        if (kind, dpi) not in self._rendered:
            self._rendered[kind, dpi] = rendered(self._figure, kind, dpi)
            self._figure.set_layout_engine("none")  # places are found once, and are the same in every format
        return self._rendered[kind, dpi]


def rendered(figure: Any, kind: str, dpi: int = DPI) -> bytes:
    """The figure as the bytes of a file of this ``kind`` (a key of FORMATS)."""
    stream = io.BytesIO()
    with house_style():
        figure.savefig(stream, format=kind, dpi=dpi, metadata=FORMATS[kind])
    return stream.getvalue()
