"""Draws the picture of the README from the shipped robot's run: ``python tools/readme_picture.py``."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

import tmodes
from tmodes import plot
from tmodes.plot.panels import letter
from tmodes.plot.style import new_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw"]

TARGET = Path(__file__).parents[1] / "docs/images/filipovic2010-run.png"


def draw(target: Path = TARGET) -> None:
    """Run the robot and draw how it bends, tracks, rings, and what the ringing is made of."""
    result = tmodes.run(tmodes.load("filipovic2010"))
    with plot.house_style():
        figure = new_figure(5.2)
        figure.set_dpi(170)
        left, right = np.ravel(np.asarray(figure.subfigures(1, 2, width_ratios=(1, 1.25), wspace=0.02)))
        above, side = left.subplots(2, 1, height_ratios=(1.5, 1))
        plot.elastic_line(result, [above, side])
        panels = right.subplots(3, 1)
        _series(panels, result.data)
        letter([above, side, *panels], (*(bare(panel) for panel in (above, side)), *_TITLES))
        target.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(target, dpi=170, metadata={"Software": None})


_LOOKS: tuple[tuple[str, str, dict[str, Any]], ...] = (
    ("deformation", "real", {"color": "#0072b2"}),
    ("deformation_nominal", "nominal", {"color": "#d55e00", "linestyle": "--"}),
)

_TITLES = (
    "Tip deviation from the reference",
    "Mode 2 bends and rings",
    "Gear deflection",
)


def bare(panel: Axes) -> str:
    """The title of a panel without its letter."""
    return panel.get_title(loc="left").partition(") ")[2]


def _series(panels: Sequence[Axes], data: Any) -> None:
    time = data["time"].values
    panels[0].plot(time, data["deviation"].values * 1e3, color="#1a1c20")
    panels[0].set_ylabel("deviation [mm]")
    angles = {"link.azimuth2": r"$\vartheta_{1,2\delta}$ [mrad]", "joint.gear": r"$\xi$ [mrad]"}
    for panel, (name, label) in zip(panels[1:], angles.items(), strict=True):
        for kind, words, look in _LOOKS:
            panel.plot(time, data[kind].sel(deformation_kind=name).values * 1e3, label=words, **look)
        panel.set_ylabel(label)
    panels[1].legend(loc="upper right", ncols=2, bbox_to_anchor=(1.0, 1.28), borderaxespad=0.0)
    panels[2].set_xlabel("time [s]")
    for panel in panels:
        panel.margins(x=0)


if __name__ == "__main__":
    draw()
