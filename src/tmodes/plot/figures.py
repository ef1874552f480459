"""The table of an arm's figures: a new figure is one function and one entry here."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from tmodes.plot.contact import arm_contact
from tmodes.plot.energy import arm_energies
from tmodes.plot.joints import joint_efforts, joint_tracking, no_drives
from tmodes.plot.load import link_loads
from tmodes.plot.paper.contact import no_contact_force
from tmodes.plot.paper.figures import FigureEntry, as_drawings, filled, unfilled
from tmodes.plot.paper.tip import tip_tracking
from tmodes.plot.save import Drawing
from tmodes.plot.shape import arm_shape
from tmodes.plot.spectrum import no_ringing, ringing
from tmodes.plot.split import gear_deflections, link_coordinates, link_tips, no_bending, no_gears
from tmodes.plot.tip import tip_motion, tip_path

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result import Result

__all__ = ["ARM_FIGURES", "all_arm_figures", "arm_drawings", "arm_left_out"]


def _no_reference(data: Any) -> str:
    return "" if "tip_reference" in data else "the run has no reference"


def _has_reference(data: Any) -> str:
    return "" if "tip_reference" not in data else "it is in the figure of the tip and its deviation"


def _no_lines(data: Any) -> str:
    return "" if "line" in data else "no link of this arm has a length"


ARM_FIGURES: dict[str, FigureEntry] = {
    entry.name: entry
    for entry in (
        FigureEntry(
            tip_tracking,
            "Tip and deviation from the reference",
            "Where the curves of (a–c) part, the tip leaves its reference; (d) shows by how much, when and which way.",
            _no_reference,
        ),
        FigureEntry(tip_motion, "Tip", "Where the tip is over time.", _has_reference),
        FigureEntry(tip_path, "Path of the tip", "The path to scale, from where the round mark is to the square one."),
        FigureEntry(
            arm_shape,
            "Shape of the arm",
            "The links at several instants, beside the arm without elasticity at the same motor angles (thin, dashed); "
            "the titles tell how much the difference is enlarged.",
            _no_lines,
        ),
        FigureEntry(
            joint_tracking,
            "Joints",
            "Left, where each joint and its motor are; right, on its own scale, how far that is from what is wanted.",
            no_drives,
        ),
        FigureEntry(
            gear_deflections,
            "Deflection of the gears",
            "Left, what the present forces would hold statically; right, on its own scale, what swings around it.",
            no_gears,
        ),
        FigureEntry(
            link_tips,
            "Deflection of the links",
            "How far the end of each link leaves its root's tangent, in both planes.",
            no_bending,
        ),
        FigureEntry(
            link_coordinates,
            "Coordinates of the links, stationary and oscillatory",
            "The largest coordinates of bending, twist and stretch; left with what the present forces would hold, "
            "right what swings around it.",
            no_bending,
        ),
        FigureEntry(
            ringing,
            "Ringing",
            "Peaks stand on the arm's own frequencies (dotted), of the controlled arm where it is controlled.",
            no_ringing,
        ),
        FigureEntry(
            link_loads,
            "Moments and stress along the links",
            "What each link carries when its bending moment is largest, from its root (0) to its tip (1).",
            no_bending,
        ),
        FigureEntry(
            joint_efforts, "Efforts", "What the motion asks of each motor, and what its gear passes on.", no_drives
        ),
        FigureEntry(
            arm_contact,
            "Contact force",
            "Force by the point on the surface; penetration below zero is distance.",
            no_contact_force,
        ),
        FigureEntry(
            arm_energies,
            "Energy balance",
            "The residual (c) should stay many orders of magnitude below the energies (a) and works (b).",
        ),
    )
}
"""Every figure of an arm, in the order of the report."""


def all_arm_figures(result: Result) -> dict[str, Callable[..., list[Axes]]]:
    """The figures that this result can fill: name -> callable that draws it."""
    return filled(ARM_FIGURES, result)


def arm_left_out(result: Result) -> dict[str, str]:
    """The figures that this result cannot fill: name -> why."""
    return {name: reason for name, reason in unfilled(ARM_FIGURES, result).items() if name != "tip_motion"}


def arm_drawings(result: Result) -> dict[str, Drawing]:
    """The figures of :func:`all_arm_figures` as drawings."""
    return as_drawings(all_arm_figures(result))
