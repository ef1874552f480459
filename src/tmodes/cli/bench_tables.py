"""The figures of a benchmark on the screen."""

from __future__ import annotations

from typing import Any

__all__ = ["print_tables"]

IDLE = 0.5
"""Programs on average that may run next to it."""


def print_tables(info: dict[str, Any]) -> None:
    """Machine, tables, and who was left out."""
    from tmodes.bench.tables import left_out, tables
    from tmodes.cli.output import notice, print_table

    machine = info["machine"]
    print(f"{machine['processor']}, {machine['cores']} cores, Python {machine['python']}, {machine['date']}\n")
    for table in tables(info):
        print_table(*table)
    if machine["load"] and machine["load"][0] > IDLE:
        notice(f"the machine was not idle ({machine['load'][0]:.1f} programs ran): times on several cores say little")
    for line in left_out(info):
        notice(f"left out: {line}")
