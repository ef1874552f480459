"""``tmodes show``: a stored result on the terminal, with the course of its series."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmodes.cli.options import AsJson, plain, result_file, stored_result
from tmodes.cli.output import notice, print_json, print_table
from tmodes.cli.summary_text import info_summary, integration_lines

if TYPE_CHECKING:
    from tmodes.cli.series import Series
    from tmodes.result import Result

__all__ = ["show"]

WIDTH = 16
"""Heights of a sparkline."""

MOST_MODES = 8

PLAIN_UNITS = str.maketrans({"·": " ", "µ": "u", "Ω": "ohm", "²": "^2", "³": "^3", "–": "-"})
"""Units for terminals that know no other letters."""

ResultArgument = Annotated[Path, typer.Argument(metavar="RESULT", help="A result.nc, or the folder of a run.")]


def show(
    result: ResultArgument,
    everything: Annotated[bool, typer.Option("--all", help="Every series, not only the first ones.")] = False,
    as_json: AsJson = False,
) -> None:
    """What a stored result says: how the run ended, the numbers that matter, frequencies, and every course in a line.

    Of what is known along a link (deflection, moment) the value of the largest size at each instant is shown.
    """
    from tmodes.cli.series import first_series, series_of_result

    stored = stored_result(result)
    data = stored.data
    chosen = list(series_of_result(data)) if everything or as_json else first_series(data)
    if as_json:
        print_json(_for_machines(stored, result_file(result), chosen))
        return
    _show(stored, result_file(result), chosen, sum(1 for _ in series_of_result(data)))


def _for_machines(stored: Result, file: Path, chosen: list[Series]) -> dict[str, Any]:
    return {
        "file": str(file),
        "status": stored.status,
        "message": stored.message,
        "warnings": list(stored.warnings),
        "summary": stored.summary(),
        "frequencies": stored.frequencies,
        "statistics": stored.statistics,
        "series": [
            {"variable": one.variable, "of": one.of, "unit": one.unit} | _extremes(one) for one in chosen
        ],
    }  # fmt: skip


def _extremes(one: Series) -> dict[str, float]:
    return {"min": float(one.values.min()), "max": float(one.values.max()), "end": float(one.values[-1])}


def _show(stored: Result, file: Path, chosen: list[Series], total: int) -> None:
    summary = info_summary(stored)
    print(f"end     {plain(stored.message)}")
    for line in integration_lines(stored, summary):
        print(line)
    if modes := list(_modes(stored.frequencies)):
        print_table("frequencies", ["motors", "dominant element", "frequency [Hz]", "damping ratio"], modes)
    columns = ["series", "min", "max", "at end", f"0 ... {float(stored.data['time'][-1]):.4g} s"]
    print_table("series", columns, [_row(one) for one in chosen])
    if len(chosen) < total:
        print(f"{total - len(chosen)} more series: --all")
    print(f"data    {plain(str(file))}")
    for warning in stored.warnings:
        notice(f"warning: {plain(warning)}")


def _row(one: Series) -> list[str]:
    from tmodes.cli.series import ASCII, sparkline, steps_for
    from tmodes.plot.units import readable

    unit, steps = readable(one.unit, one.values), steps_for(sys.stdout.encoding)
    name = unit.name.translate(PLAIN_UNITS) if steps is ASCII else unit.name
    numbers = [f"{value * unit.factor:.4g}" for value in _extremes(one).values()]
    return [f"{plain(one.name)} [{plain(name)}]", *numbers, sparkline(one.values, WIDTH, steps)]


def _modes(frequencies: dict[str, list[dict[str, Any]]]) -> Iterator[list[str]]:
    """The lowest modes of each case: the damped frequency where it rings, else the natural one."""
    for case, modes in frequencies.items():
        for mode in modes[:MOST_MODES]:
            frequency = mode["damped_frequency_Hz"]
            if frequency or mode["frequency_Hz"]:
                ringing = f"{frequency:.4g}" if frequency else f"{mode['frequency_Hz']:.4g}, over-damped"
                home = plain(str(mode["element"])) + ("" if mode.get("stable", True) else " (UNSTABLE)")
                yield [case, home, ringing, f"{mode['damping_ratio'] + 0.0:.4f}"]
