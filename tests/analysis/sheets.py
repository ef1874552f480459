"""Sheets of single links: a clamped beam, and an arm in which nothing moves."""

from __future__ import annotations

from typing import Any

__all__ = ["clamped_sheet", "locked_sheet"]

SECTION = {"bending_stiffness": [100.0, 100.0], "torsional_stiffness": 60.0, "mass_per_length": 1.0,
           "polar_inertia_per_length": 2e-4}  # fmt: skip


def clamped_sheet(**beam: Any) -> dict[str, Any]:
    """A horizontal beam of 1 m, EI 100 N*m^2, 1 kg, clamped at the base."""
    whole = {"model": "strain", "functions": 3, "length": 1.0, "damping_time": 0.0, "section": SECTION, **beam}
    return {
        "format": 1,
        "kind": "arm",
        "name": "clamped",
        "gravity": 9.81,
        "joints": [{"name": "clamp", "type": "fixed", "parent": "base", "child": "beam"}],
        "links": [{"name": "beam", "beam": {name: value for name, value in whole.items() if value is not None}}],
    }


def locked_sheet() -> dict[str, Any]:
    """One locked joint that carries a rigid rod."""
    body = {"mass": 1.0, "center": [0.5, 0, 0], "inertia": {"xx": 0.02, "yy": 0.03, "zz": 0.025}}
    pivot = {
        "name": "pivot",
        "type": "revolute",
        "axis": [0, 1, 0],
        "state": "locked",
        "parent": "base",
        "child": "rod",
    }
    return {
        "format": 1,
        "kind": "arm",
        "name": "locked",
        "joints": [pivot],
        "links": [{"name": "rod", "bodies": [body]}],
    }
