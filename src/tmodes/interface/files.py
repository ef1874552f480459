"""Files that a command writes next to what it prints: a data sheet, a figure."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

__all__ = ["write_files"]

Name = str | os.PathLike[str] | None


def write_files(out: Name, found: Any, figure: Name, *, overwrite: bool, **plot: Any) -> None:
    """The ``sheet`` of what was found to ``out``, its ``plot`` with these arguments to ``figure``; None: not.

    Raises :class:`tmodes.errors.ResultFileError` where a file is there, or cannot be written, and
    :class:`tmodes.errors.InputError` for a figure of an unknown kind.
    """
    from tmodes.io.atomic import atomic_write, check_writable, file_error

    for path in map(Path, filter(None, (out, figure))):
        if os.path.lexists(path) and not overwrite:
            raise file_error(path, "a file that exists", "a new name", "choose another name, or give --overwrite")
    files = {} if out is None else {Path(out): found.sheet.encode()}
    if figure is not None:
        from tmodes.plot.figure import picture_file

        files |= {Path(figure): picture_file(figure, lambda: found.plot(**plot)[0].figure)}
    for path, content in files.items():
        check_writable(path.parent, len(content))
        with atomic_write(path, overwrite=overwrite) as temporary:
            temporary.write_bytes(content)
