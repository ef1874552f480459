"""``tmodes show`` and ``tmodes view``: stored results in the terminal, and in the browser, several side by side."""

from __future__ import annotations

import os
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmodes.cli.options import AsJson, SettlingBand, stored_result
from tmodes.cli.terminal import print_json, print_parts, print_result, print_table, terminal_columns, warn, working
from tmodes.errors import InputError
from tmodes.io.atomic import atomic_write, file_error
from tmodes.io.printed import Table, plain

if TYPE_CHECKING:
    from tmodes.cli.series import StoredSeries
    from tmodes.result import Result

__all__ = ["opened", "show", "view"]


WIDTH = 16
"""Heights of a sparkline."""

MOST_MODES = 8

ResultArgument = Annotated[Path, typer.Argument(metavar="RESULT", help="A result.nc, or the folder of a run or study.")]


def show(
    result: ResultArgument,
    everything: Annotated[
        bool, typer.Option("--all", help="All numbers with their errors, frequencies, every series.")
    ] = False,
    events: Annotated[bool, typer.Option("--events", help="What happened when: touch, stick, slip, teeth.")] = False,
    settling_band: SettlingBand = None,
    output: Annotated[
        list[str] | None, typer.Option("--output", help="One output by its name alone; may be repeated.")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """The verdict on a stored result, and at most twelve numbers.

    With `--all` all numbers with their errors, natural frequencies, and a sparkline of every series; of quantities
    along a link (deflection, moment) the value of the largest size at each instant.

    With `--events` its events alone: when and where a contact touched, friction stuck or slipped, teeth of a gear with
    play met, a joint passed its limit, and at which speed; `--json` has them always.

    With `--settling-band` the settling is found in the samples of the file, which end with the run.

    With `--output NAME` outputs by their names, as `tmodes outputs` lists them, stored or computed from the motion.

    Of a study (its folder): statistics of its quantities over all cases.
    """
    from tmodes.cli.series import StoredSeries, series_of_result
    from tmodes.interface.show import is_study, result_file
    from tmodes.interface.summary import events_table, result_record

    if is_study(result):
        _show_study(result, as_json=as_json)
        return
    stored = stored_result(result)
    data = stored.record
    if output:
        named = [stored.output(name) for name in output]
        chosen = [StoredSeries(str(one.name), "", one.attrs["units"], one.values) for one in named]
        if not as_json:
            _print_series(chosen, float(data["time"][-1]))
            return
    else:
        chosen = list(series_of_result(data)) if everything or as_json else []
    if as_json:
        series = [{"variable": one.variable, "of": one.of, "unit": one.unit} | _extremes(one) for one in chosen]
        print_json({"file": str(result_file(result)), **result_record(stored, settling_band), "series": series})
        return
    if events:
        print_parts([events_table(stored)])
        return
    _show(stored, result_file(result), chosen, settling_band)


def _show_study(place: Path, *, as_json: bool) -> None:
    from tmodes.study.result import load_study

    with working("reading", at_once=True):
        study = load_study(place)
    if not study.stored.has_table:
        missing = study.unfinished
        got = missing[0].partition(";")[0] if missing else f"no {study.parquet.name} of these cases"
        hint = "give the same `tmodes study` again: it computes the rest"
        raise file_error(place, got, "a study that is complete", hint)
    print_result(study, as_json)


def _extremes(one: StoredSeries) -> dict[str, float]:
    return {"min": float(one.values.min()), "max": float(one.values.max()), "end": float(one.values[-1])}


def _show(stored: Result, file: Path, chosen: list[StoredSeries], band: str | None) -> None:
    from tmodes.interface.summary import COLUMNS, run_tables

    more = "all numbers with their errors, frequencies, every series: --all"
    parts = run_tables(stored, band, everything=bool(chosen), more=more, columns=terminal_columns() or COLUMNS)
    print_parts(parts, None if chosen else COLUMNS)
    if chosen:
        modes = list(_modes(stored.frequencies))
        columns = ["motors", "dominant element", "natural [Hz]", "damped [Hz]", "damping ratio"]
        print_parts([Table("frequencies", columns, modes)] if modes else ())
        _print_series(chosen, float(stored.record["time"][-1]))
    print(f"data    {plain(str(file))}")
    warn(map(plain, stored.warnings))


def _print_series(chosen: list[StoredSeries], end: float) -> None:
    columns = ["series", "min", "max", "at end", f"0 ... {end:.4g} s"]
    print_table("series", columns, [_row(one) for one in chosen])


def _row(one: StoredSeries) -> list[str]:
    from tmodes.cli.series import sparkline, steps_for
    from tmodes.plot.panels import readable

    unit, steps = readable(one.unit, one.values), steps_for(sys.stdout.encoding)
    numbers = [f"{value * unit.factor:.4g}" for value in _extremes(one).values()]
    return [f"{plain(one.name)} [{plain(unit.name)}]", *numbers, sparkline(one.values, WIDTH, steps)]


def _modes(frequencies: dict[str, list[dict[str, Any]]]) -> Iterator[list[str]]:
    """The lowest modes of each case that vibrate, in the columns of ``tmodes modes``."""
    for case, modes in frequencies.items():
        for mode in [one for one in modes if one["damped_frequency_Hz"]][:MOST_MODES]:
            element = plain(str(mode["element"])) + ("" if mode.get("stable", True) else " (UNSTABLE)")
            ringing = [f"{mode[name]:.4g}" for name in ("frequency_Hz", "damped_frequency_Hz")]
            yield [case, element, *ringing, f"{mode['damping_ratio'] + 0.0:.4f}"]


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
    over each other. Runs of one robot are named by what differs in their sheets, and tables list what differs and how
    every number changes.
    """
    from tmodes.report.data import live_page, page_data
    from tmodes.report.differences import run_names
    from tmodes.report.parts import viewer_document

    _refuse_too_many(results)
    _refuse_taken(out, overwrite)
    stored = [stored_result(path) for path in results]
    names = run_names(stored, [path.absolute() for path in results])
    with working("page", at_once=True):
        data = page_data(stored, names) if len(stored) > 1 else live_page(stored[0])
        page = _written(viewer_document(data), out, overwrite)
    print_json({"page": str(page), "runs": names}) if as_json else print(f"open    {page}", flush=True)
    if browser:
        opened(page)


def opened(page: Path) -> None:
    """Open a page in the browser."""
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
