"""Figures of a result: ``tmodes.plot.tip_tracking(result)`` returns matplotlib axes, ``save_figures`` writes them all.

Every figure takes ``(result, ax=None)`` and returns its axes. ``FIGURES`` holds them by name, ``all_figures`` gives
those that a result can fill, ``left_out`` the reasons of the others; ``register`` adds a :class:`Figure` of your own.
"""

from typing import Any

from tmodes.plot.figure import FIGURES, PAPER_FIGURES, Figure, all_figures, left_out, register, save_figures
from tmodes.plot.style import house_style

__all__ = [
    "FIGURES", "PAPER_FIGURES", "Figure", "all_figures", "contact_force", "controller_states", "deformations",
    "elastic_line", "energies", "gear_deflections", "house_style", "joint_efforts", "joint_tracking", "left_out",
    "link_coordinates", "link_deflection", "link_loads", "link_tips", "register", "save_figures", "spectrum",
    "tip_errors", "tip_path", "tip_tracking",
]  # fmt: skip

FIGURES.bring(
    "tmodes.plot.figures",
    {
        "tip_tracking": "series", "tip_errors": "series", "tip_path": "tip",
        "elastic_line": "tip", "joint_tracking": "series", "deformations": "series",
        "gear_deflections": "series", "link_coordinates": "series", "link_tips": "elastic",
        "link_deflection": "elastic", "spectrum": "spectrum", "link_loads": "elastic",
        "joint_efforts": "series", "controller_states": "series", "contact_force": "series",
        "energies": "series",
    },
)  # fmt: skip
"""In the order of the report."""

PAPER_FIGURES.bring("tmodes.plot.figures", dict.fromkeys(("figure_6", "figure_7", "figure_8"), "paper"))

contact_force: Figure
controller_states: Figure
deformations: Figure
elastic_line: Figure
energies: Figure
gear_deflections: Figure
joint_efforts: Figure
joint_tracking: Figure
link_coordinates: Figure
link_deflection: Figure
link_loads: Figure
link_tips: Figure
spectrum: Figure
tip_errors: Figure
tip_path: Figure
tip_tracking: Figure


def __getattr__(name: str) -> Any:
    if name not in FIGURES.names:
        raise AttributeError(f"module 'tmodes.plot' has no attribute {name!r}")
    return FIGURES[name]
