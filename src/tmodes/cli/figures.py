"""``tmodes figures``: the figures of a stored result, for print."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmodes.cli.options import result_file, stored_result
from tmodes.cli.show import ResultArgument
from tmodes.cli.terminal import working

__all__ = ["figures"]


def figures(
    result: ResultArgument,
    names: Annotated[
        list[str] | None, typer.Argument(metavar="[NAME]...", help="Which figures; all by default.")
    ] = None,
    png: Annotated[bool, typer.Option("--png", help="As PNG too, 200 dots per inch; else SVG alone.")] = False,
    pdf: Annotated[bool, typer.Option("--pdf", help="As PDF too.")] = False,
    out: Annotated[
        Path | None, typer.Option(help="Folder for the figures; else `figures` in the folder of the result.")
    ] = None,
) -> None:
    """Draw the figures of a stored result for print: 16 cm wide, legible without colour. Files that exist are replaced.

    Example: tmodes figures results/spong1987 tip_tracking spectrum --pdf
    """
    from tmodes.plot import save_figures

    stored, folder = stored_result(result), out or result_file(result).parent / "figures"
    formats = ["svg", *(["png"] if png else []), *(["pdf"] if pdf else [])]
    with working() as progress:
        written = save_figures(
            stored, folder, formats, progress=lambda k, n, _: progress("figures", k / n), names=names or None
        )
    print(f"wrote   {len(written)} files to {folder}")
