"""The house style of the figures: readable in print at 16 cm width, colour-blind-safe, headless, reproducible bytes.

Figures are built without pyplot, so no window system and no global state is needed, and every setting is made inside
:func:`house_style`: the user's own matplotlib settings are neither used nor changed.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = [
    "CAUSES", "COMPONENTS", "CYCLE", "DASHES", "GRID", "INK", "INSTANTS", "PALETTE", "PAPER", "PARTS", "QUIET", "REAL",
    "REFERENCE", "SERIES", "colour", "colours", "house_style", "new_figure", "stylesheet",
]  # fmt: skip

WIDTH = 6.3
"""Width of every figure [in], 16 cm."""

INK, QUIET, GRID, PAPER = "#1d2329", "#5d6873", "#d9dee3", "#ffffff"
"""Text and axes; what stands back; the grid; the background."""

PALETTE = {
    "blue": ("#0072b2", "#4fb0ea"), "red": ("#d55e00", "#ff8f45"), "green": ("#00875f", "#3ecf9b"),
    "violet": ("#a2488f", "#e08acb"), "ochre": ("#8c6a00", "#d9b13a"), "sky": ("#2a7fb8", "#9fd3f5"),
}  # fmt: skip
"""Okabe and Ito's colours on white, three of them darkened to keep a contrast of 3, and on a dark page."""

BLUE, RED, GREEN, VIOLET, OCHRE, SKY = (light for light, _ in PALETTE.values())

CAUSES = {
    "controller": ("#6d2e8c", "#d6b0ee"), "gear": ("#9c6a00", "#f0bf4a"), "link": ("#00875f", "#3ecf9b"),
    "free joint": ("#2590cf", "#3b8fdd"), "contact": ("#a01830", "#d9485f"), "geometry": ("#7d8994", "#8f9aa5"),
    "total": (INK, "#e6eaee"),
}  # fmt: skip
"""What an error or an energy is of: its colour in every report, on white and on a dark page.

Any two differ by 19 or more (CIE 1976) for those who see no red or no green, too.
"""


PARTS = {
    "real": ("actual", "blue"), "reference": ("nominal", "red"), "commanded": ("commanded", "quiet"),
    "motor": ("motor", "sky"), "stationary": ("static part", "violet"), "oscillatory": ("dynamic part", "sky"),
}  # fmt: skip
"""What a curve may be of a quantity, by its role: in a word, and its colour where nothing else has one."""

DASHES: dict[str, tuple[float, ...]] = {
    "real": (), "reference": (6, 3), "commanded": (2, 3), "motor": (10, 3), "stationary": (9, 2, 2, 2),
    "oscillatory": (2, 2),
}  # fmt: skip
"""Lengths of dashes and gaps of a role [pixels of a page]; nothing: a line without gaps."""

SERIES: tuple[tuple[float, ...], ...] = (
    (), (7, 2), (6, 2, 2, 2), (2, 2), (9, 2, 2, 2, 2, 2), (12, 4)
)  # fmt: skip
"""The same of curves that are compared, in their order."""


CYCLE = ("blue", "red", "violet", "ochre", "green", "sky")
"""Names in :data:`PALETTE` that curves without a cause take, in their order."""


def colour(name: str) -> str:
    """A colour on white, by its name as a custom property."""
    return QUIET if name == "quiet" else (CAUSES | PALETTE)[name.removeprefix("of-").replace("-", " ")][0]


def colours() -> dict[str, dict[str, str]]:
    """The colours of causes as a page holds them."""
    return {name: {"light": light, "dark": dark} for name, (light, dark) in CAUSES.items()}


def stylesheet() -> str:
    """The colours as custom properties of a page: ``--blue``, ``--of-gear``, ``--of-free-joint``."""
    table = PALETTE | {f"of-{name.replace(' ', '-')}": both for name, both in CAUSES.items()}
    light, dark = ("".join(f"--{name}:{both[k]};" for name, both in table.items()) for k in (0, 1))
    return f":root{{{light}}}\n@media screen and (prefers-color-scheme:dark){{:root:not(.printing){{{dark}}}}}\n"


REAL: dict[str, Any] = {"color": BLUE, "linestyle": "-", "linewidth": 1.3}
REFERENCE: dict[str, Any] = {"color": RED, "linestyle": (0, (4, 2)), "linewidth": 1.1}
COMPONENTS: tuple[dict[str, Any], ...] = (
    {"color": BLUE, "linestyle": "-", "linewidth": 1.1},
    {"color": RED, "linestyle": (0, (5, 1.5)), "linewidth": 1.1},
    {"color": VIOLET, "linestyle": (0, (5, 1.2, 1.2, 1.2)), "linewidth": 1.1},
    {"color": OCHRE, "linestyle": (0, (1.5, 1.2)), "linewidth": 1.2},
    {"color": GREEN, "linestyle": (0, (7, 1, 1, 1, 1, 1)), "linewidth": 1.1},
)
"""Curves that are compared, distinct in colour, in the order of :data:`CYCLE`, and in line style."""
BAND = "#bcd9ea"
"""The inside of a range, a tint of blue."""

INSTANTS: tuple[dict[str, Any], ...] = tuple(
    {"color": color, "linestyle": style, "linewidth": 1.3}
    for color, style in (
        ("#123f70", "-"),
        ("#1f74a8", (0, (6, 1.5))),
        ("#168477", (0, (5, 1.2, 1.2, 1.2))),
        ("#a06800", (0, (3, 1.2))),
        ("#c1272d", (0, (1.5, 1))),
    )
)
"""Curves in the order of time, early to late."""

SETTINGS: dict[str, Any] = {
    **dict.fromkeys(("text.color", "axes.labelcolor", "xtick.labelcolor", "ytick.labelcolor"), INK),
    **dict.fromkeys(("axes.edgecolor", "xtick.color", "ytick.color"), QUIET),
    **dict.fromkeys(("font.size", "axes.labelsize"), 8),
    **dict.fromkeys(("xtick.labelsize", "ytick.labelsize", "legend.fontsize"), 7.5),
    **dict.fromkeys(("axes.linewidth", "xtick.major.width", "ytick.major.width"), 0.6),
    **dict.fromkeys(("axes.grid", "axes.axisbelow", "path.simplify"), True),
    **dict.fromkeys(("axes.spines.top", "axes.spines.right", "axes.formatter.useoffset", "legend.frameon"), False),
    "figure.dpi": 100, "savefig.dpi": 200, "figure.facecolor": PAPER, "savefig.facecolor": "auto",
    "font.family": ["DejaVu Sans", "sans-serif"], "mathtext.fontset": "dejavusans",
    "axes.titlesize": 8.5, "axes.titleweight": "bold", "axes.titlelocation": "left", "axes.titlepad": 5,
    "axes.facecolor": "none", "axes.xmargin": 0.0, "axes.ymargin": 0.07, "axes.formatter.limits": (-4, 5),
    "legend.handlelength": 2.6, "legend.borderaxespad": 0.2,
    "grid.color": GRID, "grid.linewidth": 0.5,
    "lines.linewidth": 1.1, "lines.solid_capstyle": "round", "path.simplify_threshold": 0.15,
    "svg.fonttype": "none", "svg.hashsalt": "tmodes", "pdf.fonttype": 42,
}  # fmt: skip


_SERIF = ("Times New Roman", "Liberation Serif", "STIXGeneral")
"""Fonts of journals, the first that is there is taken; the last one comes with matplotlib."""


@contextmanager
def house_style(*, serif: bool = False) -> Iterator[None]:
    """Draw and save inside this, ``serif``: in a journal's font; what the user had set is as before afterwards."""
    from matplotlib import font_manager, style

    known = {font.name for font in font_manager.fontManager.ttflist} if serif else ()
    families = [name for name in _SERIF if name in known][:1]
    journal = {"font.family": [*families, "serif"], "font.serif": _SERIF, "mathtext.fontset": "stix"} if serif else {}
    with style.context(["default", SETTINGS | journal]):
        yield


def new_figure(height: float) -> Figure:
    """An empty figure of the house width, ``height`` [in], with room kept for labels and outside legends."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(WIDTH, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure
