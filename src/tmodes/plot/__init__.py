"""Figures of a result: ``tmodes.plot.tip_tracking(result)`` returns matplotlib axes, ``save_figures`` writes them all.

Every figure takes ``(result, ax=None)`` and returns its axes; ``all_figures`` is the table of those that a result can
fill, ``left_out`` tells why the others are not in it.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tmodes.plot.paper.angles import deformations
    from tmodes.plot.paper.contact import contact_force
    from tmodes.plot.paper.energy import energies
    from tmodes.plot.paper.figures import FIGURES, all_figures, drawings, left_out, save_figures
    from tmodes.plot.paper.load import bending_load
    from tmodes.plot.paper.motor import drive
    from tmodes.plot.paper.shape import elastic_line, mode_deflection
    from tmodes.plot.paper.split import stationary_oscillatory
    from tmodes.plot.paper.tip import tip_tracking
    from tmodes.plot.paper.vibration import spectrum
    from tmodes.plot.style import house_style

__all__ = [
    "FIGURES",
    "all_figures",
    "bending_load",
    "contact_force",
    "deformations",
    "drawings",
    "drive",
    "elastic_line",
    "energies",
    "house_style",
    "left_out",
    "mode_deflection",
    "save_figures",
    "spectrum",
    "stationary_oscillatory",
    "tip_tracking",
]

_HOMES = {
    "FIGURES": "paper.figures",
    "all_figures": "paper.figures",
    "bending_load": "paper.load",
    "contact_force": "paper.contact",
    "deformations": "paper.angles",
    "drawings": "paper.figures",
    "drive": "paper.motor",
    "elastic_line": "paper.shape",
    "energies": "paper.energy",
    "house_style": "style",
    "left_out": "paper.figures",
    "mode_deflection": "paper.shape",
    "save_figures": "paper.figures",
    "spectrum": "paper.vibration",
    "stationary_oscillatory": "paper.split",
    "tip_tracking": "paper.tip",
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'tmodes.plot' has no attribute {name!r}")
    return getattr(import_module(f"tmodes.plot.{_HOMES[name]}"), name)


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
