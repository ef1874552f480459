"""What the energies of the 2010 robot need of a chain: its numbers, and which coordinate is which."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from tmodes.chain.chain import Chain
from tmodes.errors import InputError
from tmodes.frame import Placement
from tmodes.kinds.noted.functions import allclose, array, isfinite, number

__all__ = ["COORDINATES", "NUMBERS", "matches", "numbers"]

COORDINATES = ("joint", "azimuth1", "azimuth2", "elevation1", "elevation2")
"""Coordinates of the robot: its joint, and the bending angles of both modes."""

NUMBERS = ("l1", "l2", "m1", "m2", "j1", "j2", "c1", "c2", "b1", "b2")
"""Lengths, point masses, rotary inertias, springs and dampers of the modes."""

_MODES = 2


def numbers(chain: Chain) -> Mapping[str, float]:
    """Lengths, masses, inertias, springs and dampers of the robot's link and of what it carries at its tip.

    Eq. (28) [stated]: mel2, Jel2 at the full length of mode 2 enter here. {test_slip_13_mass}
    Eq. (30) [stated]: mel1, Jel1 at the full length of mode 1 enter here. {test_slip_13_mass}

    Raises :class:`tmodes.errors.InputError` for a robot that is not one joint with one link of two modes.
    """
    link: Any = chain.nodes[-1].link
    modes = getattr(link, "modes", ())
    if len(chain.nodes) != 1 or len(modes) != _MODES:
        expected = "one joint that carries one link of the kind `modes` with two modes"
        raise InputError("equations", "another robot", expected, "take `equations: recursion`, which suits all robots")
    _refuse_elsewhere(chain, number(modes[0].length + modes[1].length))
    mass = [modes[0].tip_mass, modes[1].tip_mass]
    inertia = [modes[0].tip_inertia, modes[1].tip_inertia]
    for s, body in link.carried:
        if s < 1.0 or np.any(body.center) or np.ptp(np.diag(body.inertia)) or not _is_diagonal(body.inertia):
            expected = "bodies at the tip itself, with the same rotary inertia about all axes"
            raise InputError("links", "another body on the link", expected, "take `equations: recursion`")
        mass[1] += body.mass
        inertia[1] += number(body.inertia[0, 0])
    bends = [isfinite(mode.bending_stiffness) for mode in modes]
    springs = [mode.tip_stiffness if free else 0.0 for mode, free in zip(modes, bends, strict=True)]
    dampers = [mode.tip_damping if free else 0.0 for mode, free in zip(modes, bends, strict=True)]
    values = (modes[0].length, modes[1].length, *mass, *inertia, *springs, *dampers)
    return dict(zip(NUMBERS, map(number, values), strict=True))


def _refuse_elsewhere(chain: Chain, length: float) -> None:
    """Refuse a joint, a weight or a tip that the energies do not know of."""
    node, down = chain.nodes[0], array(chain.gravity)
    turned = [*node.joint.axis, *node.joint.placement.rotation.ravel(), *node.joint.placement.position]
    end = chain.points[0].offset if chain.points else Placement()
    expected = np.zeros(3) if node.link.bends else np.array([length, 0.0, 0.0])
    issues = {
        "joints": (chain.sliding or np.any(turned != np.array([0, 0, 1, *np.eye(3).ravel(), 0, 0, 0])),
                   "one revolute joint about z at the base, with the link's root on its axis"),
        "gravity": (down[0] or down[1] or down[2] > 0, "gravity along -z"),
        "tip": (not allclose(end.position, expected) or not allclose(end.rotation, np.eye(3)),
                "the tip at the end of the last mode"),
    }  # fmt: skip
    for path, (wrong, needed) in issues.items():
        if wrong:
            raise InputError(path, "another one", needed, "take `equations: recursion`, which suits all robots")


def _is_diagonal(matrix: Any) -> bool:
    return not np.any(matrix - np.diag(np.diag(matrix)))


def matches(names: Sequence[str]) -> list[str]:
    """A robot's names of the coordinates: its joint is the one without a link's name before it."""
    found = []
    for own in COORDINATES:
        there = [name for name in names if (name.endswith(f".{own}") if own != "joint" else "." not in name)]
        found.append(there[0] if there else "")
    return found
