"""A contact law as numbers: its force and the slopes of that, for what is asked of a robot at rest."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import casadi as ca

from tmodes.equations.loop.contact_kernels import Touch
from tmodes.kinds.contacts.registry import Contact, Meeting
from tmodes.kinds.kernel import vectors as v

__all__ = ["LawAt", "contact_law"]


class LawAt(NamedTuple):
    """Normal force [N], its stiffness [N/m] and its damping [N*s/m] at a penetration; zeros where none acts."""

    force: float
    stiffness: float
    damping: float


def contact_law(sheet: Contact) -> Callable[[float, float], LawAt]:
    """(penetration [m], its rate [m/s]) -> the law there, but for the moving mass and friction."""
    touch, symbols = Touch(sheet), ca.SX.sym("motion", 2)
    numbers = ca.SX(ca.DM(touch.numbers(v.zero())))
    met = Meeting(v.zero(), symbols[0], symbols[1], 0.0)
    normal, _ = touch.normal(numbers, met)
    law = ca.Function("law", [symbols], [ca.vertcat(normal, *touch.slopes(numbers, met))])
    return lambda depth, rate: LawAt(*(float(x) for x in law([depth, rate]).full()[:, 0]))
