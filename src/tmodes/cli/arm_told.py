"""What the finished run of an arm says on the terminal."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

__all__ = ["arm_rows"]

_MOST_JOINTS = 8
_MOST_DEFORMATIONS = 8


def arm_rows(summary: dict[str, Any]) -> Iterator[tuple[str, str, str]]:
    """Rows of quantity, value, where and when; of many joints and deformations the largest ones."""
    yield from _tip(summary)
    yield from _deformations(summary["deformations"])
    for name, link in summary["links"].items():
        yield from _link(name, link)
    yield from _efforts(summary["joints"])
    force = summary["contact_force"]
    if force:
        yield "contact force", f"{force['min_N']:.3f} ... {force['max_N']:.3f} N", f"mean {force['mean_N']:.3f} N"
    energy = summary["energy"]
    yield "energy balance", f"{energy['worst_residual_J']:.1e} J", f"of {energy['moved_J']:.3g} J moved"


def _tip(summary: dict[str, Any]) -> Iterator[tuple[str, str, str]]:
    deviation, settling = summary["deviation"], summary["settling"]
    if deviation is None:
        return
    yield "largest tip deviation", f"{deviation['max_m'] * 1e3:.4g} mm", f"t = {deviation['time_of_max_s']:.3f} s"
    yield "tip deviation at the end", f"{deviation['end_m'] * 1e3:.4g} mm", ""
    if settling["time_s"] is not None:
        limit = f"within {settling['limit_m'] * 1e3:.3g} mm"
        yield "settling after the move", f"{settling['time_s']:.3f} s", limit


def _deformations(told: dict[str, dict[str, Any]]) -> Iterator[tuple[str, str, str]]:
    largest = sorted(told, key=lambda name: -told[name]["max"])[:_MOST_DEFORMATIONS]
    for name in (name for name in told if name in largest):
        one = told[name]
        unit = "" if one["unit"] == "1" else f" {one['unit']}"
        value = f"{one['max'] * 1e3:.4g} {'m' + one['unit'] if unit else '1e-3'}"
        parts = f"T_st {one['max_stationary'] * 1e3:.4g}, T_to {one['max_oscillatory'] * 1e3:.4g}"
        yield f"largest {name}", value, parts


def _link(name: str, link: dict[str, Any]) -> Iterator[tuple[str, str, str]]:
    bent, moment, stress = link["deflection"], link["bending_moment"], link["stress"]
    yield f"deflection of {name}", f"{bent['max_m'] * 1e3:.4g} mm", f"t = {bent['time_s']:.3f} s"
    place = f"s = {moment['s']:.2f}, t = {moment['time_s']:.3f} s"
    yield f"bending moment of {name}", f"{moment['max_Nm']:.4g} N m", place
    if stress:
        place = f"s = {stress['s']:.2f}, t = {stress['time_s']:.3f} s"
        yield f"stress of {name}", f"{stress['max_Pa'] / 1e6:.4g} MPa", place


def _efforts(told: dict[str, dict[str, Any]]) -> Iterator[tuple[str, str, str]]:
    largest = sorted(told, key=lambda name: -abs(told[name]["largest_effort"]))[:_MOST_JOINTS]
    for name in (name for name in told if name in largest):
        one = told[name]
        unit = "N" if one["unit"] == "m" else "N m"
        yield f"effort of {name}", f"{one['largest_effort']:.4g} {unit}", f"t = {one['time_of_largest_effort_s']:.3f} s"
