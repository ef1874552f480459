"""What a figure is, and every figure of a result: drawn when it is asked for, written to files."""

from __future__ import annotations

import io
import os
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, ClassVar

from tmodes.errors import InputError
from tmodes.io.arguments import checked_arguments
from tmodes.io.atomic import atomic_write, check_writable
from tmodes.io.words import shown
from tmodes.kinds.registry import Registry
from tmodes.plot.charts import Chart, Line, in_units
from tmodes.plot.facts import names_of
from tmodes.plot.panels import Axes, AxesLike, across, draw_chart, draw_charts, panels
from tmodes.plot.style import house_style
from tmodes.result.result import Result

__all__ = [
    "FIGURES", "FORMATS", "PAPER_FIGURES", "ChartFigure", "Figure", "Rows", "all_figures", "captions", "left_out",
    "output_figure", "picture_file", "register", "rendered", "save_figures",
]  # fmt: skip


class Figure(ABC):
    """One figure of a result. Subclasses set the class variables and write :meth:`draw`.

    An instance is called as ``figure(result, ax=None)`` and returns its axes, lettered a), b), ...
    """

    name: ClassVar[str] = ""
    """Name of the figure and of its files, an identifier."""

    title: ClassVar[str] = ""
    """Title in a few words."""

    caption: ClassVar[str] = ""
    """What to look at, in one or two sentences."""

    source: ClassVar[str] = ""
    """A sentence on where the numbers come from, after the caption; empty where that needs no word."""

    serif: ClassVar[bool] = False
    """Whether it is drawn in a journal's font."""

    needs: ClassVar[Mapping[str, str]] = {}
    """Series or dimensions of the result that must exist, each with the reason when it does not."""

    @abstractmethod
    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """Draw into ``ax`` (one axes for each panel), or into a new figure; called inside the house style."""

    def missing(self, data: Any) -> str:
        """Why a result with this dataset cannot fill the figure; empty where it can."""
        reasons = (reason for name, reason in self.needs.items() if name not in data and name not in data.dims)
        return next(reasons, "")

    @checked_arguments
    def __call__(self, result: Result, ax: AxesLike = None, **options: Any) -> list[Axes]:
        """The axes of the figure; ``options`` are those of its :meth:`draw`.

        Raises :class:`tmodes.errors.InputError` where :meth:`missing` gives a reason.
        """
        if reason := self.missing(result.data):
            raise InputError(self.name, reason, "a result that has what it shows", "leave this figure out")
        with house_style(serif=self.serif):
            return self.draw(result, ax, **options)


Rows = Sequence[Sequence[Chart]]


class ChartFigure(Figure):
    """A figure that lays out charts in rows, lettered as one reads them."""

    def __init__(
        self, name: str, title: str, caption: str, rows: Callable[[Result], Rows], shows: str,
        needs: Mapping[str, str] | None = None, cause: str = "",
    ) -> None:  # fmt: skip
        """``shows``: what and which axes, in words; ``cause``: of which, ``gear`` or ``link``, coordinates it is."""
        vars(self).update(name=name, title=title, caption=caption, needs=needs or {}, __doc__=shows)
        self._rows, self._cause = rows, cause

    def missing(self, data: Any) -> str:
        """A robot whose links alone are elastic has no figure of gears, and the other way round."""
        reason, kinds = super().missing(data), names_of(data, "deformation_kind") if self._cause else []
        known = [(name in data["coordinate"].values) == (self._cause == "link") for name in kinds]
        return reason or ("" if any(known) or not self._cause else next(iter(self.needs.values())))

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """One panel for each chart."""
        return draw_charts(ax, self._rows(result))


def _has_words(figure: Figure) -> None:
    if not figure.name.isidentifier():
        raise InputError("figure name", repr(figure.name), "an identifier such as 'joint_power'", "set another `name`")
    if not (figure.title and figure.caption):
        hint = "set the class's `title` and `caption`"
        raise InputError(f"figure {figure.name}", "a class without title or caption", "a class with both", hint)


FIGURES: Registry[Figure] = Registry(
    "figure", Figure, check=_has_words, made=lambda given: given() if isinstance(given, type) else given
)
"""Every figure, in the order of the report."""

register = FIGURES.register

PAPER_FIGURES: Registry[Figure] = Registry("figure of the 2010 paper", Figure, check=_has_words, made=lambda own: own())
"""Figures 6, 7 and 8 of Filipovic & Djuric (2010)."""


FORMATS: dict[str, dict[str, Any]] = {
    "svg": {"Date": None, "Creator": None, "Format": None, "Type": None},
    "png": {"Software": None},
    "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
}
"""The formats of files, and the metadata to leave out: dates and versions change, pictures should not."""

DPI = 200
"""Resolution of a PNG in a file, for print [dots per inch]."""


def rendered(figure: Any, kind: str, dpi: int = DPI, *, serif: bool = False) -> bytes:
    """The figure as the bytes of a file of this ``kind`` (a key of FORMATS), with text as text where it can hold text.

    Its layout is found at the first time, and stays: each file is one pass of drawing, and all have the same places.
    """
    stream = io.BytesIO()
    with house_style(serif=serif):
        if engine := figure.get_layout_engine():
            engine.execute(figure)
            figure.set_layout_engine(None)
        figure.savefig(stream, format=kind, dpi=dpi, metadata=FORMATS[kind])
    return stream.getvalue()


def picture_file(path: str | os.PathLike[str], draw: Callable[[], Any]) -> bytes:
    """A figure as the bytes of a file of the kind that its name ends on.

    Raises :class:`tmodes.errors.InputError` for another ending.
    """
    kind = Path(path).suffix.removeprefix(".")
    if kind not in FORMATS:
        endings = ", ".join(f".{one}" for one in FORMATS)
        raise InputError("figure", shown(str(path)), f"a file that ends on {endings}", "name it so")
    return rendered(draw(), kind)


def output_figure(result: Result, name: str, ax: AxesLike = None) -> list[Axes]:
    """The course of one output of a result by its name, in one panel; raises as :meth:`Result.output`."""
    series = result.output(name)
    line = Line("", "real", series.values)
    ((chart,),) = in_units([[Chart(name, name, "output", series.attrs["units"], series["time"].values, (line,), name)]])
    with house_style():
        axes = panels(ax, [[name]], 2.4)
        draw_chart(axes[0], chart)
        across(axes[0], chart)
    return axes


def _figure(name: str) -> Figure:
    """A figure of either kind."""
    return (PAPER_FIGURES if name in PAPER_FIGURES else FIGURES)[name]


def _files(formats: Sequence[str], result: Result, name: str) -> dict[str, bytes]:
    """A figure as the contents of its files, by format."""
    one = _figure(name)
    figure = one(result)[0].figure
    return {kind: rendered(figure, kind, serif=one.serif) for kind in formats}


ROOM = 10_000_000
"""Disk space of all figures together, at most [bytes]."""


def captions(names: Sequence[str]) -> str:
    """What stands below each of these figures, a paragraph for each."""
    shown = ((name.capitalize().replace("_", " "), _figure(name)) for name in names)
    return "\n\n".join(f"{label}: {one.title}. {one.caption} {one.source}".rstrip() for label, one in shown) + "\n"


def _say_nothing(done: int, total: int, name: str) -> None:
    del done, total, name


@checked_arguments
def all_figures(result: Result) -> dict[str, Callable[..., list[Axes]]]:
    """The figures that this result can fill: name -> callable that draws it, ``all_figures(result)["spectrum"]()``."""
    return {name: partial(figure, result) for name, figure in FIGURES.items() if not figure.missing(result.data)}


@checked_arguments
def left_out(result: Result, *, paper: bool = False) -> dict[str, str]:
    """The figures that this result cannot fill, or those of the 2010 ``paper``: name -> why."""
    reasons = {name: one.missing(result.data) for name, one in (PAPER_FIGURES if paper else FIGURES).items()}
    return {name: reason for name, reason in reasons.items() if reason}


@checked_arguments
def save_figures(
    result: Result,
    folder: Path | str,
    formats: Sequence[str] = ("svg", "png"),
    progress: Callable[[int, int, str], None] | None = None,
    names: Sequence[str] | None = None,
    stored: Path | None = None,
) -> list[Path]:
    """Write figures of the result into ``folder``, one file per figure and format; returns the files.

    ``names``: which of :func:`all_figures` or of ``PAPER_FIGURES``, None: all of the first.
    ``progress(done, total, name)`` is called before each figure and once at the end. ``stored``: a file that holds this
    result, from which processes read it to draw many figures at once where there are cores; a program that calls this
    with it guards its main part by ``__name__``.

    Raises :class:`tmodes.errors.InputError` for an unknown format or name, and
    :class:`tmodes.errors.ResultFileError` when a file cannot be written; a file is either complete or as it was before.
    Where a figure cannot be drawn its error is raised once all others are written.
    """
    for unknown in sorted(set(formats) - set(FORMATS)):
        raise InputError("formats", repr(unknown), f"some of {', '.join(FORMATS)}", "choose one of these")
    check_writable(folder, ROOM)
    figures = all_figures(result)
    reasons = left_out(result) | left_out(result, paper=True)
    for unknown in sorted(set(names or ()) - set(figures) - (set(PAPER_FIGURES) - set(reasons))):
        reason = reasons.get(unknown)
        got = f"{unknown}, which is left out: {reason}" if reason else f"the unknown figure {unknown!r}"
        hint = "choose among these; `tmodes outputs` lists the numbers that `Result.plot(name=...)` draws"
        raise InputError("figures", got, f"some of {', '.join(figures)}", hint)
    chosen, report, written = list(figures if names is None else names), progress or _say_nothing, []
    faults: list[Exception] = []
    from tmodes.plot.drawing import drawn

    with drawn(partial(_files, tuple(formats)), result, chosen, stored) as files:
        for done, name in enumerate(chosen):
            report(done, len(chosen), name)
            try:
                contents = files(done)
            except Exception as error:
                faults.append(error)
                continue
            for kind, content in contents.items():
                written.append(Path(folder) / f"{name}.{kind}")
                with atomic_write(written[-1]) as temporary:
                    temporary.write_bytes(content)
    report(len(chosen), len(chosen), "")
    if faults:
        raise faults[0]
    return written
