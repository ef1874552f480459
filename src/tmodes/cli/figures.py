"""``tmodes figures``: the figures of a stored result, for print."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmodes.cli.options import stored_result
from tmodes.cli.show import ResultArgument
from tmodes.cli.terminal import warn, working
from tmodes.errors import InputError

__all__ = ["figures"]


def figures(
    result: ResultArgument,
    names: Annotated[
        list[str] | None, typer.Argument(metavar="[NAME]...", help="Which figures; all by default.")
    ] = None,
    png: Annotated[bool, typer.Option("--png", help="As PNG too, 200 dots per inch; else SVG alone.")] = False,
    pdf: Annotated[bool, typer.Option("--pdf", help="As PDF too.")] = False,
    paper: Annotated[
        bool,
        typer.Option("--paper", help="Figures 6, 7 and 8 of the 2010 paper, in its symbols, of its robot's result."),
    ] = False,
    out: Annotated[
        Path | None, typer.Option(help="Folder for the figures; else `figures` in the folder of the result.")
    ] = None,
) -> None:
    """Draw the figures of a stored result for print: 16 cm wide, legible without colour, text as text.

    Their captions are in captions.txt. Files that exist are replaced.

    Example: tmodes figures results/spong1987 tip_tracking spectrum --pdf

    Of a study, its folder: tmodes figures results/gear_known distribution tornado
    """
    from tmodes.interface.show import is_study, result_file
    from tmodes.plot import PAPER_FIGURES, left_out, save_figures
    from tmodes.plot.figure import captions

    formats = ["svg", *(["png"] if png else []), *(["pdf"] if pdf else [])]
    if paper and is_study(result):
        raise InputError("tmodes figures --paper", "a study", "a result of the 2010 robot", "leave `--paper` out")
    if is_study(result):
        _of_study(result, out or result / "figures", formats, names or None)
        return
    stored, file = stored_result(result), result_file(result)
    folder = out or file.parent / "figures"
    if paper:
        reasons = left_out(stored, paper=True)
        names = [*(names or ()), *(name for name in PAPER_FIGURES if name not in reasons)]
        if len(reasons) == len(PAPER_FIGURES):
            hint = "make one: tmodes run filipovic2010 --out results/filipovic2010"
            raise InputError("tmodes figures --paper", next(iter(reasons.values())), "a result of the 2010 robot", hint)
        warn(f"{name} is left out: {reason}" for name, reason in reasons.items())
    with working() as progress:
        written = save_figures(stored, folder, formats, lambda k, n, _: progress("figures", k / n), names or None, file)
    (folder / "captions.txt").write_text(captions([*dict.fromkeys(path.stem for path in written)]), encoding="utf-8")
    print(f"wrote   {len(written)} files to {folder}, and captions.txt")


def _of_study(place: Path, folder: Path, formats: list[str], names: list[str] | None) -> None:
    from tmodes.plot.studies import check_names, save_study_figures
    from tmodes.study.page import figure_data
    from tmodes.study.result import load_study

    check_names(names or ())
    with working() as progress:
        progress("reading", 0.0)
        study = load_study(place)
        data = figure_data(study, progress, bands=names is None or "bands" in names)
        written = save_study_figures(data, folder, formats, names, lambda k, n, _: progress("figures", k / max(n, 1)))
    print(f"wrote   {len(written)} files to {folder}")
    warn(study.unfinished)
