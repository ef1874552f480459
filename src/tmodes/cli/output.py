"""How commands speak: tables for people, JSON for machines, notices on standard error."""

from __future__ import annotations

import json
import shutil
import sys
from collections.abc import Iterable, Sequence
from typing import Any

__all__ = ["notice", "print_json", "print_json_list", "print_table"]

PIPE = 200
"""Width of a table in a file or a pipe, which have none [characters]; a wider table is printed whole all the same."""

LINES = 25
"""A height, without which the library takes every dumb terminal for one of 80 columns."""

NARROWEST = 6
"""Least width that is left for values next to their names [characters]."""


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
    """Print a table; columns of numbers stand to the right.

    Words and numbers are never cut. Where the terminal is too narrow, cells wrap between words; where it is narrower
    than the longest words side by side, each row becomes a block of lines, one for each column.
    """
    room = shutil.get_terminal_size().columns if sys.stdout.isatty() else None
    frame = 3 * len(columns) + 1
    longest = [_widths(cells) for cells in zip(columns, *rows, strict=True)]
    whole, words = [one[0] for one in longest], [one[1] for one in longest]
    if room is None or sum(whole) + frame <= room:
        _print_grid(title, columns, rows, whole, max(room or PIPE, sum(whole) + frame))
    elif sum(words) + frame <= room:
        _print_grid(title, columns, rows, _shared(whole, words, room - frame), room)
    else:
        _print_blocks(title, columns, rows, room)


def _widths(cells: Sequence[str]) -> tuple[int, int]:
    """Width of the longest cell, and of the longest word in it [characters]."""
    from rich.cells import cell_len

    lines = [line for cell in cells for line in cell.splitlines()]
    words = [cell_len(word) for line in lines for word in line.split()]
    return max([1, *map(cell_len, lines)]), max([1, *words])


def _shared(whole: Sequence[int], words: Sequence[int], room: int) -> list[int]:
    """Widths that fill the room: each column gets its longest word, then the narrowest wishes come true first."""
    widths, left = list(words), room - sum(words)
    for index in sorted(range(len(whole)), key=lambda i: whole[i] - words[i]):
        more = min(whole[index] - words[index], left)
        widths[index] += more
        left -= more
    return widths


def _print_grid(
    title: str, columns: Sequence[str], rows: Sequence[Sequence[str]], widths: Sequence[int], room: int
) -> None:
    from rich import box
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    # As Text, a name such as [/b] is itself and no markup.
    table = Table(title=Text(title), title_justify="left", box=box.SIMPLE_HEAD, title_style="bold")
    for index, (column, width) in enumerate(zip(columns, widths, strict=True)):
        numeric = all(row[index][:1] in "0123456789-" for row in rows)
        table.add_column(Text(column), justify="right" if numeric else "left", width=width, overflow="fold")
    for row in rows:
        table.add_row(*map(Text, row))
    Console(width=room, height=LINES).print(table)


def _print_blocks(title: str, columns: Sequence[str], rows: Sequence[Sequence[str]], room: int) -> None:
    """Each row as lines of name and value, which wrap behind the name."""
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    names = min(max(_widths(columns)[0], 1), max(room - NARROWEST - 4, 1))
    console = Console(width=room, height=LINES)
    console.print(Text(title, style="bold"))
    for row in rows:
        block = Table(box=None, show_header=False, pad_edge=False, padding=(0, 2, 0, 0))
        block.add_column(width=names, overflow="fold")
        block.add_column(overflow="fold")
        for column, cell in zip(columns, row, strict=True):
            if cell.strip():
                block.add_row(Text(column), Text(cell))
        console.print()
        console.print(block)
    console.print()


def notice(text: str) -> None:
    """Say something to the person, next to the output."""
    print(text, file=sys.stderr)
