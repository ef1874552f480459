"""``tmodes view``: stored results in the browser, one or several side by side."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import Annotated

import typer

from tmodes.cli.options import AsJson, stored_result
from tmodes.cli.output import print_json
from tmodes.errors import InputError
from tmodes.io.atomic import atomic_write, file_error

__all__ = ["names_apart", "view"]

MOST = 6
"""Runs side by side: more colours cannot be distinguished."""

ResultsArgument = Annotated[
    list[Path], typer.Argument(metavar="RESULT...", help="Files result.nc, or folders of runs; several are compared.")
]


def view(
    results: ResultsArgument,
    out: Annotated[Path | None, typer.Option(help="Write the page to this file; else to a temporary one.")] = None,
    overwrite: Annotated[bool, typer.Option("--overwrite", help="Replace a page that is there.")] = False,
    browser: Annotated[bool, typer.Option("--open/--no-open", help="Open the page in the browser.")] = True,
    as_json: AsJson = False,
) -> None:
    """Look at stored results in the browser: the robot in 3D, linked charts, numbers; several runs side by side.

    The page is one file that needs no network and can be sent to others. Robots move at the same time, their charts lie
    over each other, their numbers are next to each other.
    """
    from tmodes.report.data import live_page, page_data, robot_name
    from tmodes.report.viewer import viewer_document

    _refuse_too_many(results)
    _refuse_taken(out, overwrite)
    stored = [stored_result(path) for path in results]
    names = names_apart([robot_name(one) for one in stored], results)
    data = page_data(stored, names) if len(stored) > 1 else live_page(stored[0])
    page = _written(viewer_document(data), out, overwrite)
    print_json({"page": str(page), "runs": names}) if as_json else print(f"open    {page}", flush=True)
    if browser:
        import webbrowser

        webbrowser.open(page.absolute().as_uri())


def _refuse_too_many(results: list[Path]) -> None:
    if len(results) > MOST:
        raise InputError("RESULT", f"{len(results)} results", f"at most {MOST}", "compare fewer at a time")


def _refuse_taken(out: Path | None, overwrite: bool) -> None:
    if out is not None and out.is_dir():
        raise file_error(out, "a folder", "the name of a file", f"name the page, such as --out {out / 'view.html'}")
    if out is not None and os.path.lexists(out) and not overwrite:
        raise file_error(out, "a file that exists", "a new name", "--overwrite replaces it, --out names another")


def names_apart(names: list[str], paths: list[Path]) -> list[str]:
    """Names that tell the runs apart: a robot's own; where several share it, with as much of the path as it takes."""
    if len(set(names)) == len(names):
        return names
    files = [path.absolute() for path in paths]
    parts = [(path.parent if path.name == "result.nc" else path.with_suffix("")).parts for path in files]
    longest = max(map(len, parts))
    for depth in range(1, longest + 1):
        info = [f"{name} ({'/'.join(one[-depth:])})" for name, one in zip(names, parts, strict=True)]
        if len(set(info)) == len(info):
            return info
    return [f"{name} ({number})" for number, name in enumerate(names, 1)]


def _written(text: str, out: Path | None, overwrite: bool) -> Path:
    if out is None:
        out, overwrite = _temporary(), True
    with atomic_write(out, overwrite=overwrite) as temporary:
        temporary.write_text(text, encoding="utf-8", newline="\n")
    return out


def _temporary() -> Path:
    """The name of a page in a folder of its own, which stays and which other users cannot look into."""
    try:
        return Path(tempfile.mkdtemp(prefix="tmodes-view-")) / "view.html"
    except OSError as error:
        got = str(error.strerror)
        raise file_error(
            "the temporary folder", got, "a folder with room for a page", "name a file with --out"
        ) from None
