"""One axis of an industrial manipulator as four masses in a row, behind a gear that hardens: stated by its energies.

S. Moberg, J. Ohr, S. Gunnarsson, A benchmark problem for robust feedback control of a flexible manipulator, IEEE Trans.
Control Systems Technology 17, 1398-1405, 2009. Everything stands on the motor's side of the reducer, as published: the
motor, and three masses of the arm, of which each has friction of its own against the ground.
"""

from __future__ import annotations

from typing import Any

import casadi as ca

from tmodes.equations.lagrange.system import System

__all__ = ["MOBERG"]

_ARMS = (1, 2, 3)


def _hardening(x: Any, low: Any, high: Any, knee: Any) -> Any:
    """Energy of a spring whose stiffness is low + (high - low) (x/knee)^2 up to the knee, and high from there on."""
    more, over = high - low, ca.fabs(x) - knee
    inside = low * x**2 / 2 + more * x**4 / (12 * knee**2)
    at_knee = low * knee**2 / 2 + more * knee**2 / 12
    beyond = at_knee + (low * knee + more * knee / 3) * over + high * over**2 / 2
    return ca.if_else(over > 0, beyond, inside)


def _kinetic(q: Any, v: Any, p: Any) -> Any:
    del q
    arms = [p[f"inertia{k}"] * v[f"arm{k}"] ** 2 for k in _ARMS]
    return (p.motor_inertia * v.motor**2 + sum(arms)) / 2


def _elastic(q: Any, p: Any) -> Any:
    gear = _hardening(q.motor - q.arm1, p.gear_stiffness_low, p.gear_stiffness_high, p.gear_knee)
    return gear + (p.stiffness2 * (q.arm1 - q.arm2) ** 2 + p.stiffness3 * (q.arm2 - q.arm3) ** 2) / 2


def _dissipation(q: Any, v: Any, p: Any) -> Any:
    del q
    own = p.motor_friction * v.motor**2 + sum(p[f"friction{k}"] * v[f"arm{k}"] ** 2 for k in _ARMS)
    row = (v.motor, v.arm1, v.arm2, v.arm3)
    return (own + sum(p[f"damping{k}"] * (row[k - 1] - row[k]) ** 2 for k in _ARMS)) / 2


def _points(q: Any, p: Any) -> dict[str, Any]:
    """Ends of the arms, each turned by its small angle q/n: of the tool z = sum l q/n; and the motor's shaft."""
    along, up, ends = 0.0, 0.0, []
    for k in _ARMS:
        along, up = along + p[f"length{k}"], up + p[f"length{k}"] * q[f"arm{k}"] / p.ratio
        ends.append((along, 0, up))
    cos, sin = ca.cos(q.motor), ca.sin(q.motor)
    turned = ca.blockcat([[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]])
    return {"tip": ends[2], "shoulder": ends[0], "elbow": ends[1], "shaft": (ca.DM.zeros(3), turned)}


MOBERG = System(
    name="moberg2009",
    coordinates=dict.fromkeys(("motor", "arm1", "arm2", "arm3"), "rad"),
    parameters={
        "motor_inertia": 5e-3, "inertia1": 2e-3, "inertia2": 0.02, "inertia3": 0.02,
        "gear_stiffness_low": 16.7, "gear_stiffness_high": 100.0, "gear_knee": 0.064,
        "stiffness2": 110.0, "stiffness3": 80.0, "damping1": 0.08, "damping2": 0.06, "damping3": 0.08,
        "motor_friction": 6e-3, "friction1": 1e-3, "friction2": 1e-3, "friction3": 1e-3,
        "ratio": 220.0, "length1": 0.02, "length2": 0.6, "length3": 1.53,
    },
    kinetic=_kinetic, elastic=_elastic, dissipation=_dissipation, points=_points, inputs=("motor",),
    lines=[["origin", "shoulder", "elbow", "tip"]],
)  # fmt: skip
