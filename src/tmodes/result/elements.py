"""What each gear and link has of the largest error of a tip, and what the environment has of their deflections."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.error_parts import PARTS, element_steps, straight, tips
from tmodes.analysis.quasistatic import held_shape
from tmodes.analysis.worst import worst_place
from tmodes.model.model import Model
from tmodes.result.paths import error_parts, shapes_of
from tmodes.result.series import run_wrenches
from tmodes.simulation.motion_run import RunData

__all__ = ["element_errors"]

Array = NDArray[np.float64]

Steps = dict[tuple[str, str], Array]
"""Vectors (3,) [m] by part and name."""


def element_errors(run: RunData, count: int) -> dict[str, dict[str, Any]]:
    """What each gear and link has of the largest error against each path, and the environment of their deflections.

    ``elements``: of ``gears``, ``links`` and ``free joints`` (with neither a drive nor a gear) the component of each
    along the error [m], which add up to the parts.
    ``environment``: what of gears and links is by the contact force, by statics with and without it (the forces of the
    motion are in both); no part of its own, None without contact. Of the first ``count`` samples; empty where no drive
    has a setpoint.
    """
    parts = error_parts(run, count)
    if parts is None:
        return {}
    paths = {"commanded": (parts.to_commanded, [(1.0, run)])}
    if parts.to_nominal is not None and run.reference:
        paths["nominal"] = (parts.to_nominal, [(1.0, run), (-1.0, run.reference)])
    found, touches = {}, run.planned.plan.touch is not None
    for name, (error, movers) in paths.items():
        (worst,) = worst_place(np.linalg.norm(error.sum(axis=1), axis=1))
        vectors, touched = Steps(), np.zeros((2, 3))
        for sign, mover in movers:
            one, pressed = _elements(mover, run, slice(worst, worst + 1))
            touched += sign * pressed
            for key, vector in one.items():
                vectors[key] = vectors.get(key, np.zeros(3)) + sign * vector
        total = error[worst].sum(axis=0)
        unit = total / max(float(np.linalg.norm(total)), 1e-300)
        sizes: dict[str, dict[str, float]] = {part: {} for part in PARTS[1:]}
        for (part, element), vector in vectors.items():
            sizes.setdefault(part, {})[element] = float(vector @ unit)
        found[name] = {
            "elements": sizes,
            "environment": dict(zip(PARTS[1:], (touched @ unit).tolist(), strict=True)) if touches else None,
        }
    return found


def _elements(mover: RunData, run: RunData, part: slice) -> tuple[Steps, Array]:
    """The step (3,) [m] that each joint and link of one sample makes, and those (2, 3) of its contact force alone."""
    model, base = mover.model, mover.base[part]
    _, moved, _, actual = shapes_of(mover, run, part)
    names, shapes = element_steps(model, moved, actual)
    steps = np.diff(tips(model, [moved, *shapes], base)[:, 0], axis=0)
    wrenches, touch = run_wrenches(mover)[part], mover.planned.plan.touch
    if touch is None or mover.contact_force is None or not mover.contact_force[part].any():
        return dict(zip(names, steps, strict=True)), np.zeros((2, 3))
    free = wrenches.copy()
    free[:, touch.point, :3] += mover.contact_force[part]
    forces = (mover.v[part], mover.a[part])
    both = [held_shape(model, actual, *forces, wrenches=given, base=base)[0] for given in (wrenches, free)]
    bent = np.array([_behind_gears(model, one, base) for one in both])
    return dict(zip(names, steps, strict=True)), bent[0] - bent[1]


def _behind_gears(model: Model, shape: Array, base: Array) -> Array:
    """The steps (2, 3) [m] of gears and links of one shape."""
    stiff = shape.copy()
    stiff[:, model.deformations] = 0.0
    return np.diff(tips(model, [straight(model, shape), stiff, shape], base)[:, 0], axis=0)
