"""Charts of the tip, of the components of the contact force, and of the energies."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmodes.report.drafts import Draft, Line, line_of

__all__ = ["contact_parts", "energy_charts", "tip_charts"]


def tip_charts(data: Any) -> Iterator[Draft]:
    """How far the tip is from its reference (where there is one), and where both are."""
    time, planned = data["time"].values, "tip_reference" in data
    if planned:
        parts = [
            line_of(data, ("tip", k), f"Δ{axis}", "real", less=("tip_reference", k)) for k, axis in enumerate("xyz")
        ]
        lines = (line_of(data, ("deviation", 0), "distance", "real"), *parts)
        yield Draft("tip_deviation", "Tip, actual − reference", "tip", "m", time, lines, "offered")
    for k, axis in enumerate("xyz"):
        lines = (line_of(data, ("tip", k), axis, "real"),)
        if planned:
            lines += (line_of(data, ("tip_reference", k), axis, "reference"),)
        yield Draft(f"tip_{axis}", f"Tip {axis}", "tip", "m", time, lines)


def contact_parts(data: Any, title: str) -> Draft:
    """The components of the contact force [N]."""
    lines = tuple(line_of(data, ("contact_force", k), f"F{axis}", "real") for k, axis in enumerate("xyz"))
    return Draft("contact_parts", title, "contact", "N", data["time"].values, lines)


def energy_charts(data: Any) -> Iterator[Draft]:
    """The residual of the energy balance [J], the energies and the works by kind."""
    time = data["time"].values
    yield Draft("energy", "Energy by kind", "energy", "J", time, _kinds(data, "energy"))
    yield Draft("work", "Work since the start", "energy", "J", time, _kinds(data, "work"))
    residual = (line_of(data, ("energy_balance", 0), "residual", "real"),)
    yield Draft("energy_balance", "Residual of the energy balance", "energy", "J", time, residual, "first")


def _kinds(data: Any, name: str) -> tuple[Line, ...]:
    """Those that are not zero throughout; the first one where all are."""
    labels = [str(label).replace("_", " ") for label in data[f"{name}_kind"].values]
    lines = [line_of(data, (name, k), label, "real") for k, label in enumerate(labels)]
    return tuple(line for line in lines if np.any(line.values)) or tuple(lines[:1])
