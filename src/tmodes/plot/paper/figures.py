"""The table of figures, and saving them: a new figure is one file and one line here."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError
from tmodes.io.atomic import atomic_write, check_writable
from tmodes.plot.paper.angles import deformations
from tmodes.plot.paper.contact import contact_force, no_contact_force
from tmodes.plot.paper.energy import energies
from tmodes.plot.paper.load import bending_load
from tmodes.plot.paper.motor import drive
from tmodes.plot.paper.shape import elastic_line, mode_deflection
from tmodes.plot.paper.split import stationary_oscillatory
from tmodes.plot.paper.tip import tip_tracking
from tmodes.plot.paper.vibration import no_spectrum, spectrum
from tmodes.plot.save import FORMATS, Drawing

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result.record import PaperResult, RunRecord

__all__ = [
    "FIGURES",
    "FigureEntry",
    "all_figures",
    "as_drawings",
    "drawings",
    "filled",
    "left_out",
    "save_figures",
    "unfilled",
]

ROOM = 10_000_000
"""What all figures together take on the disk, at most [bytes]."""


def _nothing_missing(data: Any) -> str:
    del data
    return ""


def _say_nothing(done: int, total: int, name: str) -> None:
    del done, total, name


@dataclass(frozen=True)
class FigureEntry:
    """One figure: how it is drawn, what to call it, what to look at, and why it may be left out ("": it is not)."""

    draw: Callable[..., list[Axes]]
    title: str
    caption: str
    missing: Callable[[Any], str] = _nothing_missing

    @property
    def name(self) -> str:
        """The name of the figure and of its files."""
        return self.draw.__name__


FIGURES: dict[str, FigureEntry] = {
    entry.name: entry
    for entry in (
        FigureEntry(
            tip_tracking,
            "Tip and deviation from the reference",
            "Where the curves of (a–c) part, the tip leaves its reference; (d) shows by how much, when and which way.",
        ),
        FigureEntry(
            contact_force,
            "Contact force",
            "The radial force from zero (a) and in close-up (b): (a) tells how large its changes are, (b) their way.",
            no_contact_force,
        ),
        FigureEntry(
            deformations,
            "Elastic deformations",
            "Compare mode 1 with mode 2 (note the scales), the vertical angles with their sag at the start, and the "
            "gear (e) with its reference.",
        ),
        FigureEntry(
            spectrum,
            "Vibration within vibration",
            "Peaks stand on the frequencies of the controlled robot (dotted); the slow ones rule the angles (a), the "
            "fast ones show better in the acceleration (b).",
            no_spectrum,
        ),
        FigureEntry(
            elastic_line,
            "The elastic line",
            "The bent arm beside the rigid one at the same motor angle (thin, dashed); the titles tell how much the "
            "difference is enlarged.",
        ),
        FigureEntry(
            mode_deflection,
            "Deflection of each mode",
            "How far each mode bends from its root's tangent; where curves lie together the shape hardly changes.",
        ),
        FigureEntry(
            stationary_oscillatory,
            "Stationary and oscillatory parts",
            "Left, what the present forces would hold statically; right, on its own scale, what swings around it.",
        ),
        FigureEntry(
            bending_load,
            "Bending moment and shear force",
            "The band holds every instant of the run; the line is the worst one, and the dotted mark is where mode 1 "
            "ends.",
        ),
        FigureEntry(
            energies,
            "Energy balance",
            "The residual (c) should stay many orders of magnitude below the energies (a) and works (b).",
        ),
        FigureEntry(
            drive,
            "Motor and gear",
            "What the move asks of the motor, and the torque that the gear passes on beside the reference's.",
        ),
    )
}
"""Every figure, in the order of the report."""


def filled(table: Mapping[str, FigureEntry], result: RunRecord) -> dict[str, Callable[..., list[Axes]]]:
    """The figures of a table that this result can fill: name -> callable that draws it."""
    return {name: partial(entry.draw, result) for name, entry in table.items() if not entry.missing(result.data)}


def unfilled(table: Mapping[str, FigureEntry], result: RunRecord) -> dict[str, str]:
    """The figures of a table that this result cannot fill: name -> why."""
    reasons = {name: entry.missing(result.data) for name, entry in table.items()}
    return {name: reason for name, reason in reasons.items() if reason}


def as_drawings(figures: Mapping[str, Callable[..., list[Axes]]]) -> dict[str, Drawing]:
    """Figures as drawings that keep their bytes: pass them to several writers."""
    return {name: Drawing(draw) for name, draw in figures.items()}


def all_figures(result: PaperResult) -> dict[str, Callable[..., list[Axes]]]:
    """The figures that this result can fill: name -> callable that draws it, ``all_figures(result)["spectrum"]()``."""
    return filled(FIGURES, result)


def left_out(result: PaperResult) -> dict[str, str]:
    """The figures that this result cannot fill: name -> why."""
    return unfilled(FIGURES, result)


def drawings(result: PaperResult) -> dict[str, Drawing]:
    """The figures of :func:`all_figures` as drawings."""
    return as_drawings(all_figures(result))


def save_figures(
    result: PaperResult,
    folder: Path | str,
    formats: Sequence[str] = ("svg", "png"),
    progress: Callable[[int, int, str], None] | None = None,
    figures: Mapping[str, Drawing] | None = None,
) -> list[Path]:
    """Write every figure of the result into ``folder``, one file per figure and format; returns the files.

    ``progress(done, total, name)`` is called before each figure and once at the end; ``figures`` are drawings from
    :func:`drawings`, None makes them. Raises :class:`tmodes.errors.InputError` for an unknown format,
    :class:`tmodes.errors.ResultFileError` when a file cannot be written; a file is either whole or as it was before.
    """
    for unknown in sorted(set(formats) - set(FORMATS)):
        raise InputError("formats", repr(unknown), f"some of {', '.join(FORMATS)}", "choose one of these")
    check_writable(folder, ROOM)
    figures = drawings(result) if figures is None else figures
    tell, written = progress or _say_nothing, []
    for done, (name, drawing) in enumerate(figures.items()):
        tell(done, len(figures), name)
        for kind in formats:
            written.append(Path(folder) / f"{name}.{kind}")
            with atomic_write(written[-1]) as temporary:
                temporary.write_bytes(drawing.content(kind))
    tell(len(figures), len(figures), "")
    return written
