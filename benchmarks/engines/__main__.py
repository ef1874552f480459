"""``python -m benchmarks.engines``: how fast this engine is here, next to others."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmodes.cli.terminal import notice, print_json, print_table, working
from tmodes.errors import InputError
from tmodes.io.atomic import atomic_write

if TYPE_CHECKING:
    from benchmarks.engines.measure import Plan

__all__ = ["bench", "print_tables"]


def bench(
    sizes: Annotated[str, typer.Option(metavar="N,N,…", help="Joints of the rigid chains.")] = "6,12,36,102,200",
    rounds: Annotated[int, typer.Option(metavar="N", help="Rounds of which medians are taken.")] = 9,
    peers: Annotated[
        str,
        typer.Option(metavar="LIST", help="all, none, or some of gcc, pinocchio, mujoco, exudyn, scipy, by commas."),
    ] = "all",
    quick: Annotated[
        bool,
        typer.Option("--quick", help="A first look in some ten seconds: 6 and 12 joints, 3 rounds, no whole runs."),
    ] = False,
    patience: Annotated[float, typer.Option(metavar="SECONDS", help="After which the C compiler is given up.")] = 20.0,
    json_file: Annotated[
        Path | None, typer.Option("--json", metavar="FILE", help="Also write all figures to this file, or - for here.")
    ] = None,
) -> None:
    """Measure this engine on this machine, side by side with others, and print one table.

    Forward dynamics of a serial chain of rigid links, the same in every engine, whose accelerations are compared with
    extended precision; what a first use costs; what the machine could do at best; and runs at equal error. Contenders
    take turns, medians are shown. What is not installed is left out, and said so. Let nothing else run meanwhile.

    For example:  python -m benchmarks.engines --quick
    python -m benchmarks.engines --sizes 6,36 --peers gcc,mujoco --json figures.json
    """
    from benchmarks.engines.measure import measured

    plan = _plan(sizes, rounds, peers, patience, quick=quick)
    with working() as tell:
        info = measured(plan, tell)
    if json_file and str(json_file) == "-":
        print_json(info)
        return
    if json_file:
        _write(json_file, info)
    print_tables(info)


def _plan(sizes: str, rounds: int, peers: str, patience: float, *, quick: bool) -> Plan:
    from benchmarks.engines.measure import Plan

    if rounds < 1:
        raise InputError("--rounds", str(rounds), "at least 1", "leave it out: 9 is sound")
    if quick:
        return Plan(sizes=(6, 12), rounds=3, peers=_peers(peers), runs=False, patience=patience)
    return Plan(_sizes(sizes), rounds, _peers(peers), patience=patience)


def _sizes(info: str) -> tuple[int, ...]:
    words = info.split(",")
    if not all(word.strip().isdecimal() and 1 <= int(word) <= 1000 for word in words):
        raise InputError("--sizes", ascii(info), "whole numbers from 1 to 1000 with commas", "write --sizes 6,36")
    return tuple(map(int, words))


def _peers(info: str) -> tuple[str, ...]:
    from benchmarks.engines.measure import PEERS

    if info in ("all", "none"):
        return PEERS if info == "all" else ()
    names = tuple(name.strip() for name in info.split(","))
    if unknown := [name for name in names if name not in PEERS]:
        expected = f"all, none, or some of {', '.join(PEERS)}"
        raise InputError("--peers", ascii(unknown[0]), expected, "write --peers gcc,mujoco")
    return names


def _write(target: Path, info: dict[str, Any]) -> None:
    import json

    with atomic_write(target) as temporary:
        temporary.write_text(json.dumps(info, indent=1, allow_nan=False) + "\n", encoding="utf-8")


IDLE = 0.5
"""Programs on average that may run next to it."""


def print_tables(info: dict[str, Any]) -> None:
    """Machine, tables, and who was left out."""
    from benchmarks.engines.tables import left_out, tables

    machine = info["machine"]
    print(f"{machine['processor']}, {machine['cores']} cores, Python {machine['python']}, {machine['date']}\n")
    for table in tables(info):
        print_table(*table)
    if machine["load"] and machine["load"][0] > IDLE:
        notice(f"the machine was not idle ({machine['load'][0]:.1f} programs ran): times on several cores say little")
    for line in left_out(info):
        notice(f"left out: {line}")


if __name__ == "__main__":
    try:
        typer.run(bench)
    except InputError as wrong:
        sys.exit(str(wrong))
