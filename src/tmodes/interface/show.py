"""Stored results by their path, and the viewer of results and robots inside a notebook."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, overload

from tmodes.io.atomic import file_error

if TYPE_CHECKING:
    from tmodes.interface.objects import Result
    from tmodes.report.notebook import Shown
    from tmodes.result.result import Result as AnyResult
    from tmodes.sheet import Robot
    from tmodes.study.result import StudyResult

__all__ = ["is_study", "result_file", "show"]


@overload
def show(*shown: AnyResult | Robot, names: list[str] | None = None, height: int = 760) -> Shown: ...
@overload
def show(shown: str | os.PathLike[str], /) -> Result | StudyResult: ...
def show(
    *shown: AnyResult | Robot | str | os.PathLike[str], names: list[str] | None = None, height: int = 760
) -> Shown | Result | StudyResult:
    """A stored result by its path, which prints itself as ``tmodes show``; of results and robots the viewer.

    The path is that of a result.nc, or of the folder of a run or a study. The viewer, for notebooks, is of one result,
    of several side by side, which ``names`` tell apart, or of one robot at rest with its modes; ``height`` of its frame
    in pixels. Raises :class:`tmodes.errors.ResultFileError` for a path without a result,
    :class:`tmodes.errors.InputError` for anything else, and what simulating the robot's rest raises.

    >>> tmodes.show(tmodes.load("spong1987").run(duration=0.1))
    <tmodes view of ...>
    """
    if len(shown) == 1 and isinstance(shown[0], str | os.PathLike):
        path = Path(shown[0])
        if is_study(path):
            from tmodes.study.result import load_study

            return load_study(path)
        from tmodes.interface.objects import Result

        return Result.load(result_file(path))
    from tmodes.report.notebook import show as viewer

    return viewer(*shown, names=names, height=height)  # pyright: ignore[reportArgumentType]  # it refuses others


def result_file(path: Path) -> Path:
    """The result file that a path means: itself, or ``result.nc`` in a folder of a run.

    Raises :class:`tmodes.errors.ResultFileError` for a folder without one, and where nothing is.
    """
    from tmodes.robots.load import sheet_names

    hint = "name a result.nc, or the folder that `tmodes run --out` was given"
    if path.is_dir():
        if not (path / "result.nc").is_file():
            raise file_error(path, "a folder without result.nc", "the folder of a run", hint)
        return path / "result.nc"
    if not path.exists():
        if str(path) in sheet_names():
            hint = f"run it first: tmodes run {path} --out FOLDER, and name that folder"
            raise file_error(path, "the name of a robot", "a result file, or the folder of a run", hint)
        raise file_error(path, "nothing", "a result file, or the folder of a run", hint)
    return path


def is_study(path: Path) -> bool:
    """Whether a path means the folder of a study, which has what that of a run has not."""
    return (path / "study.json").is_file()
