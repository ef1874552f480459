"""The figures of a benchmark on the screen."""

from __future__ import annotations

from typing import Any

__all__ = ["print_tables"]


def print_tables(told: dict[str, Any]) -> None:
    """Machine, tables, and who was left out."""
    from tmodes.bench.tables import left_out, tables
    from tmodes.cli.output import notice, print_table

    machine = told["machine"]
    print(f"{machine['processor']}, {machine['cores']} cores, Python {machine['python']}, {machine['date']}\n")
    for table in tables(told):
        print_table(*table)
    for line in left_out(told):
        notice(f"left out: {line}")
