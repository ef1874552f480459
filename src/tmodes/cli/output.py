"""How commands speak: tables for people, JSON for machines, notices on standard error."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterable, Sequence
from typing import Any

__all__ = ["notice", "print_json", "print_json_list", "print_table"]


def print_json(value: Any) -> None:
    """Print a value as JSON; not-a-number is refused rather than written."""
    print(json.dumps(value, indent=1, allow_nan=False))


def print_json_list(values: Iterable[Any]) -> None:
    """Print a list as JSON, item by item, so that a long one is never whole in memory."""
    separator = "[\n"
    for value in values:
        print(separator + json.dumps(value, allow_nan=False), end="")
        separator = ",\n"
    print("\n]")


def print_table(title: str, columns: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Print a table; columns of numbers stand to the right."""
    from rich import box
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    # As Text, a name such as [/b] is itself and no markup.
    table = Table(title=Text(title), title_justify="left", box=box.SIMPLE_HEAD, title_style="bold")
    for index, column in enumerate(columns):
        numeric = all(row[index][:1] in "0123456789-" for row in rows)
        table.add_column(Text(column), justify="right" if numeric else "left", no_wrap=numeric)
    for row in rows:
        table.add_row(*map(Text, row))
    # A file or a pipe has no width: let nothing wrap there.
    Console(width=None if sys.stdout.isatty() else 200).print(table)


def notice(text: str) -> None:
    """Say something to the person, beside the output."""
    print(text, file=sys.stderr)
