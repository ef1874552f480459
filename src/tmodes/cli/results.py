"""Arguments that are stored results: a result file, or the folder of a run that holds one."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tmodes.result import Result

__all__ = ["plain", "result_file", "stored_result"]


def result_file(path: Path) -> Path:
    """The result file that a path means: itself, or ``result.nc`` in a folder of a run.

    Raises :class:`tmodes.errors.ResultFileError` for a folder without one, and where nothing is.
    """
    from tmodes.io.atomic import file_error

    hint = "name a result.nc, or the folder that `tmodes run --out` was given"
    if path.is_dir():
        if not (path / "result.nc").is_file():
            raise file_error(path, "a folder without result.nc", "the folder of a run", hint)
        return path / "result.nc"
    if not path.exists():
        from tmodes.robots.load import sheet_names

        if str(path) in sheet_names():
            hint = f"run it first: tmodes run {path} --out FOLDER, and name that folder"
            raise file_error(path, "the name of a robot", "a result file, or the folder of a run", hint)
        raise file_error(path, "nothing", "a result file, or the folder of a run", hint)
    return path


def stored_result(path: Path) -> Result:
    """The result that a path means; the errors are those of reading it."""
    from tmodes.result import Result

    return Result.load(result_file(path))


def plain(text: str) -> str:
    """Text of a file that may be anybody's, without what steers a terminal."""
    return "".join(letter if letter.isprintable() else "?" for letter in text)
