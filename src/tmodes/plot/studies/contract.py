"""What a figure of a study is: drawn from the data of its page, for one quantity."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.io.atomic import atomic_write, check_writable
from tmodes.io.words import meant
from tmodes.kinds.registry import Registry
from tmodes.plot.figure import FORMATS, ROOM, rendered
from tmodes.plot.style import house_style, new_figure
from tmodes.plot.units import pretty

__all__ = [
    "STUDY_FIGURES", "Data", "StudyFigure", "axis_name", "good_rows", "of_quantity", "padded_figure",
    "save_study_figures", "ticks_of", "titles_of", "varied",
]  # fmt: skip

Array = NDArray[np.float64]
Data = Mapping[str, Any]
"""What ``web/src/study/contract.ts`` calls a StudyPage."""


class StudyFigure(ABC):
    """One figure of a study, for one of its quantities; subclasses set the class variables."""

    name: ClassVar[str] = ""
    """Name of the figure and of its files, an identifier."""

    title: ClassVar[str] = ""
    """Title in a few words."""

    each: ClassVar[bool] = True
    """Whether there is one for each quantity; else one for the study."""

    @abstractmethod
    def missing(self, data: Data, quantity: Data) -> str:
        """Why a study has no such figure of a quantity; empty where it has."""

    @abstractmethod
    def draw(self, data: Data, quantity: Data) -> Any:
        """A new matplotlib figure; called inside the house style."""


STUDY_FIGURES: Registry[StudyFigure] = Registry("study figure", StudyFigure, made=lambda cls: cls())
"""Every figure of studies, in the order of a report."""


def padded_figure(height: float) -> Any:
    """A new figure [in] with room for long names, which are wider on paper than where they were measured."""
    figure = new_figure(height)
    engine: Any = figure.get_layout_engine()
    engine.set(w_pad=0.1)
    return figure


def axis_name(column: Data) -> str:
    """Title and unit of a column, for an axis."""
    unit = pretty(column["unit"]) if column["unit"] != "-" else ""
    return f"{column['title'] or column['name']}{f' [{unit}]' if unit else ''}"


def varied(data: Data) -> list[Data]:
    """The parameters that differ between the cases."""
    return [column for column in data["parameters"] if np.ptp(column["values"]) > 0]


def of_quantity(data: Data, part: str, quantity: Data) -> Data | None:
    """What one part of a study says of a quantity, None where it says nothing."""
    return next((one for one in data.get(part, ()) if one["quantity"] == quantity["name"]), None)


def titles_of(data: Data) -> dict[str, str]:
    """What parameters are called, by their names."""
    return {column["name"]: column["title"] or column["name"] for column in data["parameters"]}


def good_rows(data: Data) -> NDArray[np.bool_]:
    """Which cases reached their end."""
    return np.array(data["good"], dtype=bool)[data["status"]]


def ticks_of(axis: Any, column: Data) -> None:
    """Names in place of numbers where a column is chosen from a list."""
    if column["labels"]:
        axis.set_ticks(range(len(column["labels"])), column["labels"], rotation=45, ha="right")


def save_study_figures(
    data: Data,
    folder: Path | str,
    formats: Sequence[str] = ("svg", "png"),
    names: Sequence[str] | None = None,
    progress: Callable[[int, int, str], None] = lambda done, total, name: None,
) -> list[Path]:
    """Write the figures of a study, one file per figure, quantity and format; returns the files.

    ``names``: of figures, None: all. Raises :class:`tmodes.errors.InputError` for a name that no figure has, and
    :class:`tmodes.errors.ResultFileError` when a file cannot be written.
    """
    check_writable(folder, ROOM)
    check_names(names or ())
    for unknown in sorted(set(formats) - set(FORMATS)):
        raise InputError("formats", repr(unknown), f"some of {', '.join(FORMATS)}", "choose one of these")
    wanted = [
        (figure, quantity)
        for name, figure in STUDY_FIGURES.items()
        for quantity in (data["quantities"] if figure.each else data["quantities"][:1])
        if (names is None or name in names) and not figure.missing(data, quantity)
    ]
    written = []
    for done, (figure, quantity) in enumerate(wanted):
        name = re.sub(r"[^A-Za-z0-9]+", "_", quantity["name"]).strip("_")  # an objective may be a formula
        own = f"{figure.name}_{name}" if figure.each else figure.name
        progress(done, len(wanted), own)
        with house_style():
            drawn = figure.draw(data, quantity)
        for kind in formats:
            written.append(Path(folder) / f"{own}.{kind}")
            with atomic_write(written[-1]) as temporary:
                temporary.write_bytes(rendered(drawn, kind))
    progress(len(wanted), len(wanted), "")
    return written


def check_names(names: Sequence[str]) -> None:
    """Raise :class:`tmodes.errors.InputError` for a name that no figure of studies has."""
    for name in names:
        if name not in STUDY_FIGURES:
            hint = meant(name, STUDY_FIGURES, "choose among these")
            raise InputError("figures", repr(name), f"some of {', '.join(STUDY_FIGURES)}", hint)
