"""``tmodes bench`` and ``tmodes cache``: how fast this engine is here, and the compiled code that it keeps."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmodes.cli.options import AsJson
from tmodes.cli.terminal import notice, print_json, print_table, working
from tmodes.errors import InputError, ResultFileError
from tmodes.io.atomic import atomic_write

if TYPE_CHECKING:
    from tmodes.bench.measure import Plan

__all__ = ["Action", "bench", "cache", "print_tables"]


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

    For example:  tmodes bench --quick      tmodes bench --sizes 6,36 --peers gcc,mujoco --json figures.json
    """
    from tmodes.bench.measure import measured

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
    from tmodes.bench.measure import Plan

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
    from tmodes.bench.measure import PEERS

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
    from tmodes.bench.tables import left_out, tables

    machine = info["machine"]
    print(f"{machine['processor']}, {machine['cores']} cores, Python {machine['python']}, {machine['date']}\n")
    for table in tables(info):
        print_table(*table)
    if machine["load"] and machine["load"][0] > IDLE:
        notice(f"the machine was not idle ({machine['load'][0]:.1f} programs ran): times on several cores say little")
    for line in left_out(info):
        notice(f"left out: {line}")


class Action(StrEnum):
    """What can be done to the cache."""

    CLEAR = "clear"


def cache(
    action: Annotated[Action | None, typer.Argument(help="clear: remove all entries.")] = None, as_json: AsJson = False
) -> None:
    """Show where compiled code is kept, or remove it: tmodes cache clear.

    Each robot's equations become native code once; the code is kept so that the next run starts at once. Nothing is
    lost by clearing it but that time. The environment variable TMODES_CACHE names another folder; empty: nothing is
    kept. A damaged entry is made again, and a folder that others can write is not used.
    """
    from tmodes.compile.cache import MAX_BYTES, clear, entries, judged

    place, refusal = judged()
    if action is Action.CLEAR:
        if place is None or refusal:
            hint = "name a folder of your own: TMODES_CACHE=FOLDER"
            raise ResultFileError(f"no cache is used ({place or 'no folder'}): {refusal}; {hint}")
        count, size = clear(place)
        words = f"removed {count} entries, {size / 1e6:.1f} MB, from {place}"
        print_json({"folder": str(place), "removed": count, "bytes": size}) if as_json else print(words)
        return
    found = [] if place is None or refusal else list(entries(place))
    size = sum(entry.size for entry in found)
    if as_json:
        info = {"folder": place and str(place), "used": not refusal, "entries": len(found), "bytes": size}
        print_json(info | {"limit": MAX_BYTES, "why_not": refusal})
        return
    print(f"compiled code  {place or 'no folder'}")
    if refusal:
        print(f"not used       {refusal}")
    print(f"entries        {len(found)}, {size / 1e6:.1f} MB of at most {MAX_BYTES / 1e6:.0f} MB")
    print("what for       a robot's equations are compiled once and cached; a second run of it compiles nothing")
    print("elsewhere      TMODES_CACHE=FOLDER names another folder, by its absolute path; empty: nothing is kept")
    print("remove         tmodes cache clear")
