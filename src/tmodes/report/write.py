"""Writing the report: one file, complete or as it was before."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from tmodes.io.atomic import atomic_write
from tmodes.plot import drawings
from tmodes.report.page import page

if TYPE_CHECKING:
    from tmodes.plot.save import Drawing
    from tmodes.result import Result

__all__ = ["write_report"]


def write_report(
    result: Result, path: Path | str, figures: Mapping[str, Drawing] | None = None, *, live: bool = True
) -> Path:
    """Write the result's report as one self-contained HTML file; the same result gives the same bytes.

    ``figures`` are drawings from :func:`tmodes.plot.drawings` (all, or a part of them), None draws them
    all. Raises :class:`tmodes.errors.ResultFileError` when the file cannot be written.
    ``live``: with the robot's equations.
    """
    text = page(result, drawings(result) if figures is None else figures, live=live)
    with atomic_write(path) as temporary:
        temporary.write_text(text, encoding="utf-8", newline="\n")
    return Path(path)
