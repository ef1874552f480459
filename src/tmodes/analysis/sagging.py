"""References that hold the tip on its path where the robot bends: quasi-static compensation along a motion.

At each row of the references of the rigid robot the tip is where that robot's would be, at rest under weight and loads;
the motors follow from it (inverse kinematics of the robot as it bends). What accelerations bend is left out.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.follow import Followed
from tmodes.analysis.statics.inverse import Target, tip_problem
from tmodes.errors import InputError
from tmodes.model.model import Model
from tmodes.sheet import Robot

__all__ = ["rigid_tips", "sagged"]

Array = NDArray[np.float64]

_DEGREE = 5
"""Of the spline through what is added to the references."""

_MOVED = 1e-9

_WHOLE = 6
"""Joints from which on the tip keeps its attitude, too."""


def _rigid(robot: Robot, model: Model, found: Followed, values: Array) -> Array:
    """Poses (n, nq) of the undeformed robot, its motors where its joints are."""
    names, q = list(model.coordinates), np.zeros((len(values), model.nq))
    for name, value in robot.initial.coordinates.items():
        q[:, names.index(name)] = value
    for joint, column in zip(found.joints, values.T, strict=True):
        for name in (joint, f"{joint}.motor"):
            if name in names:
                q[:, names.index(name)] = column
    return q


def rigid_tips(robot: Robot, found: Followed, values: Array) -> Array:
    """Places (n, 3) [m] of the tip of the undeformed robot for ``values`` (n, joints) of its joints."""
    model = Model(robot.chain())
    return model.pose(_rigid(robot, model, found, values))[0][:, 0]


def sagged(robot: Robot, found: Followed) -> Followed:
    """The references with which the tip of the robot at rest is on the path of the rigid one, at every row.

    Raises :class:`tmodes.errors.InputError` where the robot as it bends does not reach a row.
    """
    problem, _ = tip_problem(robot)
    model = problem.system.model
    q = _rigid(robot, model, found, found.values)
    places, turned = model.pose(q)[:2]
    whole, moves = len(found.joints) >= _WHOLE, np.abs(model.jacobian(q)[:, 0, :3]).max(axis=(0, 2))
    free = np.where(moves > _MOVED * moves.max(initial=0.0), 0.0, np.nan)  # a direction in which no joint moves it
    targets = [
        Target(place[0] + free, rotation[0] if whole else None) for place, rotation in zip(places, turned, strict=True)
    ]
    held = problem.solve(q, targets)
    if not held.reached.all():
        first = int(np.flatnonzero(~held.reached)[0])
        got = f"no pose at rest that holds the tip at t = {found.times[first]:.4g} s"
        raise InputError("--sag", got, "a path that the robot as it bends reaches", "leave out --sag, or move the path")
    names = list(model.coordinates)
    motors = [names.index(name if (name := f"{joint}.motor") in names else joint) for joint in found.joints]
    return _with(found, problem.motors(held.q)[:, motors] - found.values)


def _with(found: Followed, added: Array) -> Followed:
    """The references with what is ``added`` (n, joints) to them, smoothly between the rows."""
    from scipy.interpolate import make_interp_spline

    spline = make_interp_spline(found.times, added, k=min(_DEGREE, len(found.times) - 1))
    rates, accelerations = (spline.derivative(order)(found.times) for order in (1, 2))
    return replace(
        found, values=found.values + added, rates=found.rates + rates, accelerations=found.accelerations + accelerations
    )
