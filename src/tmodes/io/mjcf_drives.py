"""The actuators of an MJCF file as drives of a sheet, and the compensation of its bodies' weight as loads.

An actuator on a joint whose force is gain * control + b0 + b1 * length + b2 * velocity (`motor`, `position`,
`velocity`, and `general` like these) is a `pd` about where its control holds the joint, or a constant effort and a
damper. The control is 0, or what of its range is nearest to 0, as in MuJoCo's first step. Several on one joint add up.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from tmodes.io.unread import Left

__all__ = ["Servo", "compensation", "servos"]

ON_JOINT = (0, 1)
"""Transmissions (mjtTrn) by which an actuator acts on a joint; the two are one on a hinge or slide."""

NONE, FIXED, AFFINE = 0, 0, 1
"""Of mjtDyn: no state; of mjtGain: a number; of mjtBias: none, and affine in length and velocity."""

MOST_LOADS = 100


@dataclass
class Servo:
    """What all actuators of a joint do together: push - position * q - velocity * q' [N*m or N].

    ``inertia`` and ``damping``: what they add to the joint's; ``most``: the largest effort that they have together,
    infinite where one of them has no bound.
    """

    push: float = 0.0
    position: float = 0.0
    velocity: float = 0.0
    inertia: float = 0.0
    damping: float = 0.0
    most: float = 0.0

    def drive(self, joint: str) -> dict[str, Any]:
        """The drive of a sheet."""
        if self.position:
            signal = {"type": "constant", "value": self.push / self.position}
            gains = {"type": "pd", "position_gain": self.position, "velocity_gain": self.velocity}
            return {"joint": joint, "command": "position", "signal": signal, "controller": gains}
        return {"joint": joint, "command": "effort", "signal": {"type": "constant", "value": self.push}}

    @property
    def viscous(self) -> float:
        """What it damps next to a servo's own gain."""
        return self.damping + (0.0 if self.position else self.velocity)


def servos(model: Any) -> tuple[dict[int, Servo], list[Left]]:
    """What drives each joint, by its number; and the actuators that are not taken."""
    found: dict[int, Servo] = {}
    left = []
    for k in range(model.nu):
        name, joint = model.actuator(k).name or f"actuator {k + 1}", int(model.actuator_trnid[k, 0])
        if why := _strange(model, k):
            left.append(Left("the force of an actuator", why, name))
        else:
            _add(found.setdefault(joint, Servo()), model, k)
    for joint, servo in [*found.items()]:
        if servo.position < 0 or servo.velocity < 0:
            del found[joint]
            why = "it pushes the joint on along its motion, which no controller here does"
            left.append(Left("the force of an actuator", why, f"of joint {model.joint(joint).name or joint + 1}"))
    return found, left


def _strange(model: Any, k: int) -> str:
    """Why an actuator is not taken; empty for one that is."""
    if int(model.actuator_trntype[k]) not in ON_JOINT:
        return "it acts by a tendon, a site or a body, which is left out"
    if int(model.actuator_dyntype[k]) != NONE:
        return "it has a state of its own, which is left out"
    plugin = int(getattr(model, "actuator_plugin", [-1] * model.nu)[k]) >= 0
    bias = int(model.actuator_biastype[k])
    if plugin or int(model.actuator_gaintype[k]) != FIXED or bias not in (NONE, AFFINE):
        return "its force is no gain times its control with springs and dampers, which is left out"
    return ""


def _add(servo: Servo, model: Any, k: int) -> None:
    gear, gain = float(model.actuator_gear[k, 0]), float(model.actuator_gainprm[k, 0])
    affine = int(model.actuator_biastype[k]) == AFFINE
    constant, by_length, by_rate = map(float, model.actuator_biasprm[k, :3]) if affine else (0.0, 0.0, 0.0)
    low, high = map(float, model.actuator_ctrlrange[k]) if model.actuator_ctrllimited[k] else (-np.inf, np.inf)
    servo.push += gear * (gain * min(max(0.0, low), high) + constant)
    servo.position -= gear**2 * by_length
    servo.velocity -= gear**2 * by_rate
    none = np.zeros(model.nu)  # older versions have neither of the two
    servo.inertia += gear**2 * float(getattr(model, "actuator_armature", none)[k])
    servo.damping += gear**2 * float(getattr(model, "actuator_damping", none)[k])
    if model.actuator_forcelimited[k]:
        most = float(np.abs(model.actuator_forcerange[k]).max())
    elif affine or not model.actuator_ctrllimited[k]:
        most = np.inf
    else:
        most = abs(gain) * max(abs(low), abs(high))
    servo.most += abs(gear) * most


def compensation(
    model: Any, links: Mapping[int, tuple[str, Any]], gravity: Any
) -> Iterator[tuple[dict[str, Any], dict[str, Any]]]:
    """Points and loads that bear each body's compensated share of its weight at its center of mass.

    ``links``: link and center of mass (3,) in its frame of each body with a mass.
    """
    shares = np.asarray(model.body_gravcomp, dtype=float)
    for body, (link, center) in links.items():
        if shares[body] and np.any(gravity):
            force = -shares[body] * float(model.body_mass[body]) * np.asarray(gravity, dtype=float)
            name = f"{link[:90]}_gravcomp"
            point = {"name": name, "link": link, "position": [*map(float, center)]}
            yield point, {"point": name, "frame": "world", "force": force.tolist()}
