"""Kernels of the way out for rates: a revolute joint between rigid links whose frames stand on their axes.

They wait for each joint in turn, and so have time for what follows from the rate alone: the force of the link's body.
See :mod:`tmodes.equations.recursion.screw`.
"""

from __future__ import annotations

from typing import Any

from tmodes.equations.recursion.body_kernels import BODY
from tmodes.equations.recursion.screw import HINGE, SCREW, TURN, Screw
from tmodes.equations.recursion.spin import Spin
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Kernel
from tmodes.kinds.kernel.spatial import FORCE, body_bias

__all__ = ["rates_kernel"]


def rates_kernel(screw: Screw, *, with_body: bool) -> Kernel:
    """(way, rate of the parent, turn, speed) -> (hinge, rate of the root).

    ``with_body``: and the link's body -> and its bias force.
    """

    def build(numbers: Any, parent_rate: Any, turn: Any, speed: Any, *body: Any) -> list[list[Any]]:
        w, linear, before = v.vec(parent_rate), v.zero(), v.zero()
        for spin, shift in screw.way(numbers):
            before = w
            if spin:
                w, linear = spin.back(w), spin.back(linear)
            if shift:
                linear = v.add(linear, v.cross(w, v.cross(w, shift)))
        drift = [w[1] * speed[0], -w[0] * speed[0], *linear]
        rate = _tilted(numbers, before, turn, speed[0]) if screw.tilted else _straight(w, turn, speed[0])
        forces = [body_bias(v.vec(each, 1), v.symmetric(each, 4), rate).packed() for each in body]
        return [[turn[0], turn[1], *drift], rate, *forces]

    key = f"inward{' with body' * with_body} {screw.key}"
    if with_body:
        return Kernel(key, (SCREW, 3, TURN, 1, BODY), (HINGE, 3, FORCE), build, plain=True)
    return Kernel(key, (SCREW, 3, TURN, 1), (HINGE, 3), build, plain=True)


def _straight(w: v.Vector, turn: Any, speed: Any) -> v.Vector:
    """The rate in the link's axes, from that in the joint's."""
    x, y, z = Spin.of(2, turn[0], turn[1]).back(w)
    return [x, y, z + speed]


def _tilted(numbers: Any, w: v.Vector, turn: Any, speed: Any) -> v.Vector:
    """The same from the rate before alpha, by both turns at once: what the next joint waits for is shorter."""
    (c, s), (tilt_c, tilt_s) = (turn[0], turn[1]), (numbers[0], numbers[1])
    return [
        (s * tilt_c) * w[1] + (c * w[0] + (s * tilt_s) * w[2]),
        (c * tilt_c) * w[1] - (s * w[0] - (c * tilt_s) * w[2]),
        (tilt_c * w[2] + speed) - tilt_s * w[1],
    ]
