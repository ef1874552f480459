"""How a run ended, when its signals stop changing, and where its numbers come from."""

from __future__ import annotations

import json
import platform
from importlib.metadata import version
from typing import Any

import numpy as np

from tmodes.errors import InputError
from tmodes.kinds.signals.merge import MergedSchedule, merge
from tmodes.result.record import RESULT_FORMAT, STATUSES
from tmodes.sheet import Robot
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.plan import Planned

__all__ = ["ending", "move_end", "provenance"]

_STILL = 1e-9
"""Change of a signal within a piece, over its largest value, that is rounding."""

_BEYOND = 2.0
"""How far signals are looked at, as a multiple of the run's duration."""


def ending(run: RunData) -> tuple[str, str]:
    """Status and sentence of the whole run: its own, or that of the reference where that ended early."""
    planned_run = run.reference
    if planned_run is not None and planned_run.status != "finished":
        return planned_run.status, f"reference: {planned_run.message}"
    return run.status, run.message if run.status in STATUSES[:2] else f"real robot: {run.message}"


def move_end(planned: Planned) -> float | None:
    """When the last signal of a drive, a load or the base stops changing [s]; None where one never does.

    Signals are looked at beyond the end of the run, so that a move that ends there is known to end; noise on what a
    controller receives is no move.
    """
    own = [k for k in range(len(planned.each)) if k not in planned.plan.aside]
    if not own:
        return 0.0
    until = float(planned.signals.knots[-1])
    try:
        longer = merge([planned.each[k].schedule(_BEYOND * until) for k in own])
    except InputError:  # a signal without a value there
        longer = MergedSchedule(planned.signals.knots, planned.signals.coefficients[:, own])
    return _last_change(longer)


def _last_change(signals: MergedSchedule) -> float | None:
    """When signals stop changing [s]; None where that is not before their end."""
    knots, powers = signals.knots, np.array(signals.coefficients)
    size = np.abs(powers[:, :, :1]).max(axis=0, keepdims=True, initial=0.0)
    lengths = np.diff(knots)[:, None, None] ** np.arange(powers.shape[2])
    changes = np.abs(powers * lengths)[:, :, 1:].max(axis=2, initial=0.0) > _STILL * np.maximum(size[..., 0], 1e-12)
    jumps = np.zeros_like(changes)
    jumps[1:] = np.abs(np.diff(signals.at(knots[:-1]), axis=0)) > _STILL * np.maximum(size[0, :, 0], 1e-12)
    moving = np.flatnonzero((changes | jumps).any(axis=1))
    if not len(moving):
        return 0.0
    last = int(moving[-1])
    end = float(knots[last + 1] if changes[last].any() else knots[last])
    return end if end < knots[-1] * (1 - 1e-9) else None


def provenance(run: RunData, known: Robot) -> dict[str, Any]:
    """Where the numbers come from: sheets, versions, what the integration took."""
    from tmodes.io.sheet_check import sheet_data

    packages = ("tmodes", "numpy", "llvmlite", "xarray")
    counts = {"real": run.statistics} | ({"reference": run.reference.statistics} if run.reference else {})
    return {
        "tmodes_format": RESULT_FORMAT,
        "kind": "arm",
        "title": known.title or known.name,
        "robot": json.dumps(sheet_data(known)),
        "robot_real": json.dumps(sheet_data(run.robot)),
        "method": str(run.robot.integration.method),
        "versions": json.dumps({name: version(name) for name in packages} | {"python": platform.python_version()}),
        "statistics": json.dumps(counts),
    }
