"""A start that is no equilibrium: what moves off, how fast it accelerates, and how far the tip is from where it rests.

Found by the rates of the closed loop at the first state, whatever the reason: coordinates that `initial` places, a base
or a drive that moves at once, efforts of a Python function.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.simulation.balance import Balance, Search, frozen, rounding
from tmodes.simulation.initial_state import RunSetup

__all__ = ["Departure", "departure"]

Array = NDArray[np.float64]

_FELT = 1e-9
"""Force over the largest one in play, and turn or travel [rad, m], that is none."""


@dataclass(frozen=True)
class Departure:
    """What accelerates most at the start: by its acceleration times the force on it that nothing balances.

    ``name``: a joint, with its ``acceleration`` in ``unit``; or a link that ``bends``, with that of the tip as seen by
    the base. ``at_once``: it is because signals begin with rates or accelerations, without which the pose is an
    equilibrium; ``distance``: then of the tip from its equilibrium as base and given joints begin [m], None without.
    """

    name: str
    bends: bool
    acceleration: float
    unit: str
    at_once: bool
    distance: float | None


def departure(setup: RunSetup, row: Array) -> Departure | None:
    """What moves off at the signals of ``row``; None in equilibrium, and where the robot moves at the start already."""
    model, mechanics, layout = setup.model, setup.mechanics, setup.model.layout
    balance, quiet = Balance(model), frozen(model, row, range(model.plan.signals))
    free, q = balance.coordinates, setup.start[layout.q]
    if setup.start[layout.v][free].any():
        return None
    mass, still = mechanics.mass_matrix(q)[np.ix_(free, free)], np.zeros(layout.q.stop)
    loads = mechanics.inverse_dynamics(q, still, still), mechanics.elastic_forces(q, still)
    begun = balance.at_rest(setup.start[None])
    begun[0, balance.loop.layout.v] = setup.start[layout.v]

    def unbalanced(start: Array, signals: Array) -> Array:
        """Accelerations along free coordinates, zero where they are little, or what sensors round and their noise."""
        seen = model.observe([0.0], start, signals)
        exact = balance.loop.rate([0.0], begun, signals)[0, balance.loop.layout.v][free]
        found, efforts = seen["a"][0, free], seen["drives"][0, :, 0]
        level = max(float(np.abs(part).max(initial=0.0)) for part in (*loads, efforts))
        if not np.abs(mass @ found).max(initial=0.0) > _FELT * level:
            return np.zeros(len(free))
        slopes = balance.slopes(begun, signals[None], balance.loop.numbers)[0][: len(free), : len(free)]
        return np.where(np.minimum(np.abs(found), np.abs(exact)) > rounding(slopes, q, _FELT), found, 0.0)

    try:
        accelerations = unbalanced(setup.start, quiet)
    except InputError:  # a block reads what has no value at rest, such as the force of a contact
        return None
    if not accelerations.any():
        return None
    resting = setup.start.copy()
    resting[layout.v] = 0.0
    at_once, distance = not unbalanced(resting, frozen(model, row)).any(), None
    if at_once:
        given = [driver.plan.signal for driver in model.loop.drivers if driver.plan.servo is None]
        row = frozen(model, row, [*model.plan.base, *given])
        found = Search(balance, begun[0], row, balance.loop.numbers)
        tips = mechanics.pose(np.stack([q, found.end[balance.loop.layout.q]]))[0][:, 0]
        distance = float(np.linalg.norm(tips[1] - tips[0])) if found.moved and not found.failed else None
    most = int(np.argmax(np.abs(accelerations * (mass @ accelerations))))
    name = model.coordinates[free[most]]
    if free[most] in mechanics.deformations:
        tip = float(np.linalg.norm(mechanics.jacobian(q)[0, :3, free].T @ accelerations))
        return Departure(name.rpartition(".")[0], True, tip, "m/s^2", at_once, distance)
    unit = setup.model.outputs[f"{name}.acceleration"].unit
    return Departure(name.removesuffix(".motor"), False, float(accelerations[most]), unit, at_once, distance)
