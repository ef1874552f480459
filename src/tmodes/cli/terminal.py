"""How commands speak: tables, JSON, notices on standard error; and progress of long work, which Ctrl-C ends."""

from __future__ import annotations

import json
import shutil
import signal
import sys
import threading
import time as clock
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from types import FrameType
from typing import TYPE_CHECKING, Any, TextIO

if TYPE_CHECKING:
    from tmodes.io.printed import CommandResult, Table

__all__ = [
    "TIMES",
    "Stages",
    "letters",
    "notice",
    "print_json",
    "print_json_list",
    "print_parts",
    "print_result",
    "print_table",
    "terminal_columns",
    "warn",
    "working",
]


PIPE = 200
"""Width of a table in a file or a pipe, which have none [characters]; a wider table is printed whole all the same."""

LINES = 25
"""A height, without which the library takes every dumb terminal for one of 80 columns."""

NARROWEST = 6
"""Least width that is left for values next to their names [characters]."""


def print_json(value: Any) -> None:
    """Print a value as JSON; not-a-number is refused rather than written."""
    with working("writing", at_once=True):
        text = json.dumps(value, indent=1, allow_nan=False)
    print(text)


def print_json_list(values: Iterable[Any]) -> None:
    """Print a list as JSON, item by item, so that a long one is never whole in memory."""
    separator = "[\n"
    for value in values:
        print(separator + json.dumps(value, allow_nan=False), end="")
        separator = ",\n"
    print("\n]")


def print_table(title: str, columns: Sequence[str], rows: Sequence[Sequence[str]], piped: int | None = None) -> None:
    """Print a table; columns of numbers stand to the right.

    Words and numbers are never cut. Where the terminal is too narrow, cells wrap between words; where it is narrower
    than the longest words side by side, each row becomes a block of lines, one for each column. ``piped``: the width
    where there is no terminal; None: whatever the table needs.
    """
    title, columns, rows = letters(title), [*map(letters, columns)], [[*map(letters, row)] for row in rows]
    room = terminal_columns() or piped
    frame = 3 * len(columns) + 1
    longest = [_widths(cells) for cells in zip(columns, *rows, strict=True)]
    whole, words = [one[0] for one in longest], [one[1] for one in longest]
    if room is None or sum(whole) + frame <= room:
        _print_grid(title, columns, rows, whole, max(room or PIPE, sum(whole) + frame))
    elif sum(words) + frame <= room:
        _print_grid(title, columns, rows, _shared(whole, words, room - frame), room)
    else:
        _print_blocks(title, columns, rows, room)


def terminal_columns() -> int | None:
    """Columns of the terminal; None where there is none."""
    return shutil.get_terminal_size().columns if sys.stdout.isatty() else None


def print_result(found: CommandResult, as_json: bool, **more: Any) -> None:
    """Print what a command gives: as JSON, with ``more`` of it, or as sentences and tables with its warnings."""
    if as_json:
        print_json(found.info() | more)
    else:
        print_parts(found.tables())
    for text in found.notices:
        notice(text)
    warn(() if as_json else found.warnings)


def print_parts(parts: Iterable[str | Table], piped: int | None = None) -> None:
    """Print sentences and tables; ``piped`` as of :func:`print_table`."""
    for part in parts:
        print(letters(part)) if isinstance(part, str) else print_table(*part, piped)


_PLAIN = str.maketrans("·µ–≈⁻⁰¹²³⁴⁵⁶⁷⁸⁹", " u-~-0123456789") | {ord("Ω"): "ohm", ord("±"): "+-"}
"""Letters for terminals that know no others."""


def letters(text: str) -> str:
    """The text, in letters that the terminal has."""
    try:
        text.encode(sys.stdout.encoding or "ascii")
    except (LookupError, UnicodeEncodeError):
        return text.replace(" × 10", "e").translate(_PLAIN)
    return text


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


def warn(warnings: Iterable[str]) -> None:
    """Say each warning to the person, next to the output."""
    for warning in warnings:
        notice(f"warning: {warning}")


def notice(text: str) -> None:
    """Say something to the person, next to the output."""
    print(text, file=sys.stderr)


TIMES = "wall", "processor"
"""What is measured of each stage."""

PATIENCE = 0.5
"""Seconds of silence before progress is shown."""

LINE_EVERY = 1.5
"""Seconds between lines where there is no terminal, so that no two are 2 s apart on a busy machine."""


class Stages:
    """Progress of stages, ``tell("nominal robot", 0.3)``, not shown for short work.

    The stage and its time are also shown while nothing is reported. A first Ctrl-C interrupts where
    progress is reported, so that all results are whole: Python raises its KeyboardInterrupt anywhere, even where it is
    lost. A second one interrupts at once. ``spent``: wall and processor time [s] of each stage.
    ``last_line``: when the command began, or said a line where there is no terminal: it may do several pieces of work.
    """

    last_line = clock.monotonic()

    def __init__(self) -> None:
        self._interrupted = False
        self._started = clock.monotonic()
        self._bar: Any = None
        self._tasks: dict[str, Any] = {}
        self.spent: dict[str, list[float]] = {}
        self._stage, self._mark = "", (self._started, clock.process_time())
        self._latest, self._drawing, self._ended = (0.0, ""), threading.Lock(), threading.Event()
        watch = self._first_drawn if sys.stderr.isatty() else self._in_silence
        threading.Thread(target=watch, args=(sys.stderr,), daemon=True).start()

    def interrupt(self, number: int, frame: FrameType | None) -> None:
        """What Ctrl-C calls."""
        del number, frame
        if self._interrupted:
            raise KeyboardInterrupt
        self._interrupted = True

    def __call__(self, stage: str, share: float, note: str = "") -> None:
        """Report that a share of a stage is done, and a ``note`` on it; raises KeyboardInterrupt after Ctrl-C."""
        if self._interrupted:
            self._interrupted = False
            raise KeyboardInterrupt
        now = clock.monotonic()
        if stage != self._stage:
            self._take(stage)
        self._latest = share, note
        if now - self._started < PATIENCE:
            return
        if sys.stderr.isatty():
            self._draw(stage, share, note)
        else:
            self._write_line(sys.stderr)

    def _first_drawn(self, stream: TextIO) -> None:
        """Draw the stage once the work is not short; the library draws on by itself."""
        del stream
        if not self._ended.wait(PATIENCE):
            self._draw(self._stage, *self._latest)

    def _in_silence(self, stream: TextIO) -> None:
        """Say the stage again where nothing is reported for long."""
        while not self._ended.wait(max(0.1, self.last_line + LINE_EVERY - clock.monotonic())):
            if clock.monotonic() - self._started >= PATIENCE:
                self._write_line(stream)

    def _write_line(self, stream: TextIO) -> None:
        with self._drawing, suppress(OSError, ValueError):  # of a stream that is gone or closed
            now, (share, note) = clock.monotonic(), self._latest
            if now - self.last_line >= LINE_EVERY and self._stage and not self._ended.is_set():
                Stages.last_line = now
                said = f", {note}" if note else ""
                print(f"{self._stage}: {share:.0%} after {now - self._started:.0f} s{said}", file=stream, flush=True)

    def _take(self, stage: str) -> None:
        """End the stage before: its time is what passed since it began."""
        mark = clock.monotonic(), clock.process_time()
        if self._stage:
            times = self.spent.setdefault(self._stage, [0.0, 0.0])
            self.spent[self._stage] = [t + now - before for t, now, before in zip(times, mark, self._mark, strict=True)]
        self._stage, self._mark = stage, mark

    def _draw(self, stage: str, share: float, note: str = "") -> None:
        with self._drawing:
            if not stage:  # nothing has begun, or all has ended
                return
            if self._bar is None:
                from rich.console import Console
                from rich.progress import BarColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

                columns = SpinnerColumn(), TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn()
                self._bar = Progress(*columns, console=Console(stderr=True), transient=True)
                self._bar.start()
            if stage not in self._tasks:
                for task in self._tasks.values():
                    self._bar.update(task, completed=1.0)
                self._tasks[stage] = self._bar.add_task(stage, total=1.0)
            text = f"{stage} ({note})" if note else stage
            self._bar.update(self._tasks[stage], completed=share, description=text)

    def end(self) -> None:
        """Raise KeyboardInterrupt where Ctrl-C came after the last report."""
        if self._interrupted:
            raise KeyboardInterrupt

    def stop(self) -> None:
        """Remove what is drawn; the last stage ends."""
        self._ended.set()
        self._take("")
        with self._drawing:  # what the timer began is drawn to its end, and then removed
            if self._bar:
                self._bar.stop()


@contextmanager
def working(stage: str = "", *, at_once: bool = False) -> Iterator[Stages]:
    """Within the block what is called with a stage and its share shows the progress, and interrupts at Ctrl-C.

    ``stage``: the first one. ``at_once``: what is done reports nothing and leaves nothing half done; Ctrl-C ends it
    wherever it is.
    """
    stages, before = Stages(), signal.getsignal(signal.SIGINT)
    if stage:
        stages(stage, 0.0)
    listens = before is signal.default_int_handler and not at_once  # a signal that is ignored stays so
    if listens:
        signal.signal(signal.SIGINT, stages.interrupt)
    try:
        yield stages
        stages.end()
    finally:
        stages.stop()
        if listens:
            signal.signal(signal.SIGINT, before)
