"""Writes docs/performance.md from docs/performance.json: ``python tools/performance_doc.py [--check] [--measure]``.

``--measure`` runs the whole benchmark first, on a machine that should do nothing else meanwhile: some five minutes.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import generated
from performance_aims import aims

__all__ = ["page"]

FIGURES = generated.ROOT / "docs" / "performance.json"
PAGE = generated.ROOT / "docs" / "performance.md"


def page(info: dict[str, Any]) -> str:
    """The page as Markdown."""
    from benchmarks.engines.tables import tables

    first, *rest = tables(info)
    return "\n".join([*_head(info), *_table(*first), *_words(info), *_notes(info), *_aims(info), *_rest(rest)])


def _head(info: dict[str, Any]) -> Iterator[str]:
    machine = info["machine"]
    known = ("tmodes", "casadi", "llvmlite", "numpy", "scipy", "pin", "mujoco", "exudyn")
    versions = ", ".join(f"{name} {machine[name]}" for name in known if name in machine)
    yield from ("# Performance", "")
    yield f"Measured on {machine['date']} on one machine: {machine['processor']}, {machine['cores']} cores,"
    yield f"{machine['system']}, Python {machine['python']};"
    yield f"{versions}."
    yield from _load(machine)
    yield from (
        "On yours: `python -m benchmarks.engines`, in a checkout. This page is written by",
        "`python tools/performance_doc.py` from [performance.json](performance.json); `--measure` measures it again.",
        "",
        "The robot is a serial chain of rigid links with joints about all axes, the same in every engine. Contenders",
        "take turns, and processor time is counted, so that a noisy machine troubles all alike; only what works on",
        "several cores is timed by the wall. Each time has its largest error of the accelerations (relative)",
        "against a computation of its own in extended precision.",
        "",
    )


def _load(machine: dict[str, Any]) -> Iterator[str]:
    """What else the machine did, without which times by the wall say little."""
    if machine["load"] and machine["load"][0] > 0.5:
        busy = f"{machine['load'][0]:.1f} programs were running on it already"
        yield f"**The machine was not idle: {busy}; what is timed by the wall, on several cores, says nothing then.**"


def _words(info: dict[str, Any]) -> Iterator[str]:
    """A sentence on each size."""
    for size in info["sizes"]:
        ours = size["contenders"][0]["seconds"]["median"]
        others = [_compared(one, ours) for one in size["contenders"] if not one["name"].startswith("tmodes")]
        yield f"- With {size['n']} joints one evaluation takes {ours * 1e6:.3g} µs: {', '.join(others) or 'no peers'}."
        if size.get("limit"):
            best = size["limit"]["throughput"]
            yield f"  The same list could take at best {best * 1e6:.3g} µs, {100 * best / ours:.0f} % of what is taken."
    yield ""


def _compared(one: dict[str, Any], ours: float) -> str:
    ratio = one["seconds"]["median"] / ours
    name = one["name"].split(",")[0]
    return f"{ratio:.1f} times less than {name}" if ratio >= 1 else f"{1 / ratio:.1f} times more than {name}"


def _notes(info: dict[str, Any]) -> Iterator[str]:
    from benchmarks.engines.tables import left_out

    yield from (
        "- *gcc, same list*: all calls of the recursion written into one C function, operation by operation; what",
        "  follows from the parameters alone is computed once, as here.",
        "- *Pinocchio* is called from Python, as its users do; *MuJoCo* and *Exudyn* are inside their own loops in C.",
        "- *limit*: from that list and the measured time of each operation here. Throughput: all operations as",
        "  fast as independent ones go, products and sums fused where they can be, sums next to products where there",
        "  are units for both. Critical path: the longest chain of operations that wait for each other. Loads and",
        "  stores are left out, so nothing quite reaches it.",
        "- *compile* is in a fresh process with an empty cache; *from the cache* in one that finds it full.",
    )
    yield from (f"- Left out: {line}." for line in left_out(info))
    yield ""


def _aims(info: dict[str, Any]) -> Iterator[str]:
    known = list(aims(info))
    reached = sum(aim.reached for aim in known)
    yield from ("## What was aimed at", "", f"{reached} of {len(known)} aims are reached on this machine.", "")
    rows = [
        [
            aim.words,
            f"{aim.got:.3g}{aim.unit}",
            f"{'at least' if aim.at_least else 'at most'} {aim.bound:g}{aim.unit}",
            "yes" if aim.reached else "**no**",
        ]
        for aim in known
    ]
    yield from _table("", ("", "measured", "aim", "reached"), rows)


def _rest(found: Sequence[tuple[str, Sequence[str], list[list[str]]]]) -> Iterator[str]:
    for title, columns, rows in found:
        yield from (f"## {title}", "")
        yield from _table("", columns, rows)


def _table(title: str, columns: Sequence[str], rows: Sequence[Sequence[str]]) -> Iterator[str]:
    if title:
        yield from (f"## {title}", "")
    yield f"| {' | '.join(columns)} |"
    yield "|---" * len(columns) + "|"
    for row in rows:
        yield f"| {' | '.join(row)} |"
    yield ""


def _measure(target: Path) -> None:
    """The whole benchmark, in a process of its own."""
    subprocess.run([sys.executable, "-m", "benchmarks.engines", "--json", str(target)], cwd=generated.ROOT, check=True)


if __name__ == "__main__":
    if "--measure" in sys.argv[1:]:
        _measure(FIGURES)
    sys.exit(generated.main(PAGE, page(json.loads(FIGURES.read_text(encoding="utf-8"))), "performance_doc"))
