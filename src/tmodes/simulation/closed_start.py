"""The first state of a run: the equilibrium of its closed loop where there is one, and why there is none otherwise."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.equations.loop.plan import Driver
from tmodes.kinds.noted.functions import number
from tmodes.model.model import Model
from tmodes.sheet import Robot
from tmodes.sheet.parts import InitialState
from tmodes.simulation.balance import Balance, Search, frozen
from tmodes.simulation.loop import LoopModel

__all__ = ["Imbalance", "balanced", "closes", "uncontrolled"]

Array = NDArray[np.float64]

_FELT = 1e-9
"""Force over the largest one in play that is none."""

_SAME = 1e-12
"""Difference [rad, m] of an initial value and a setpoint that are the same."""


@dataclass(frozen=True)
class Imbalance:
    """A start that is no equilibrium: the ``joint`` that moves off, the effort ``given`` and the one ``needed``.

    Both in ``unit``, N*m or N, at the joint. ``distance``: of the tip from its equilibrium [m], None where there is
    none; ``wanted``: the sheet asks for this start.
    """

    joint: str
    given: float
    needed: float
    unit: str
    distance: float | None
    wanted: bool


def closes(robot: Robot, model: LoopModel) -> bool:
    """Whether the start may be another than with held motors.

    Controllers keep positions, the base is moved, or the surface moves along itself and drags.
    """
    controlled = any(driver.plan.servo and driver.plan.servo.is_controlled for driver in model.loop.drivers)
    drags = robot.contact is not None and any(number(rate) != 0.0 for rate in robot.contact.velocity)
    return (controlled or robot.base_motion is not None or drags) and not placed(robot, model)


def placed(robot: Robot, model: LoopModel) -> list[str]:
    """Coordinates that the sheet puts somewhere: all initial ones but motors on their first setpoint."""
    setpoints = {
        model.coordinates[driver.coordinate]: next(
            number(sheet.signal.schedule(robot.integration.duration).at(0.0))
            for sheet in robot.drives
            if sheet.joint == driver.plan.joint
        )
        for driver in model.loop.drivers
        if driver.plan.servo and driver.plan.servo.is_controlled
    }
    given = robot.initial.coordinates.items()
    return [name for name, value in given if not abs(setpoints.get(name, np.inf) - value) <= _SAME]


def uncontrolled(model: LoopModel) -> list[Driver]:
    """Drives that only give an effort or a voltage."""
    return [driver for driver in model.loop.drivers if driver.plan.servo and not driver.plan.servo.is_controlled]


def balanced(
    robot: Robot, model: LoopModel, mechanics: Model, first: Array, held: Array, row: Array
) -> tuple[Array | None, Imbalance | None]:
    """The first state (size,) in equilibrium at the signals of ``row``, and why the start is none of the closed loop.

    ``first`` (size,): the state with held motors, ``held`` the same after all that sticks, slips or touches has
    switched. None in place of the equilibrium where the robot is in balance so, where its sheet asks for that start or
    places coordinates, and where there is no equilibrium: joints under an effort alone that it does not hold,
    controllers at their limit.
    """
    idle, still = uncontrolled(model), frozen(model, row)
    balance = Balance(model, frozenset(driver.coordinate for driver in idle))
    efforts, begin = _Efforts(robot, balance, mechanics, still, row), balance.at_rest(first[None])[0]
    if not closes(robot, model):
        moving = idle if not (robot.initial.coordinates or robot.initial.rates) else []
        return None, efforts.off(held, begin, moving, None)
    found = Search(balance, begin, still, model.settles.numbers)
    if found.failed or efforts.off(held, found.end, idle, None):
        return None, efforts.off(held, found.end, [*model.loop.drivers] if found.failed else idle, None)
    if not found.moved:
        return None, None
    start = balance.outside(found.end[None], first[None], still[None], model.numbers)[0]
    if robot.initial.state is not InitialState.HELD:
        return start, None
    tips = mechanics.pose(np.stack([held[model.layout.q], start[model.layout.q]]))[0][:, 0]
    return None, efforts.off(held, begin, [*model.loop.drivers], float(np.linalg.norm(tips[1] - tips[0])))


@dataclass(frozen=True, eq=False)
class _Efforts:
    """Efforts of drives in states at rest, and what would hold their joints."""

    robot: Robot
    balance: Balance
    mechanics: Model
    row: Array
    moving: Array
    """The row of the signals as they are, in which those that are at zero for an instant have their size."""

    def off(self, held: Array, state: Array, drivers: list[Driver], distance: float | None) -> Imbalance | None:
        """Of some drives the one whose effort is farthest from holding its joint in a state of the equations of rest.

        None where all hold, by dry friction too. ``held``: a state of the run, for all that is not found.
        """
        model, layout = self.balance.model, self.balance.loop.layout
        modes = dict(zip(model.loop.slipping, held[model.layout.modes], strict=False))
        drivers = [one for one in drivers if one.plan.servo and modes.get(one.coordinate) != 0.0]
        if not drivers:
            return None
        q, still = state[layout.q], np.zeros(layout.q.stop)
        rates = self.balance.loop.rate([0.0], state, self.row)[0]
        left = self.mechanics.mass_matrix(q) @ rates[layout.v]
        loads = self.mechanics.inverse_dynamics(q, still, still), self.mechanics.elastic_forces(q, still)
        worst = max(drivers, key=lambda driver: abs(left[driver.coordinate]))
        place, count = model.loop.drivers.index(worst), model.plan.degree + 1
        first = 1 + count * worst.plan.signal
        sizes = *loads, self.moving[first : first + count]
        level = max(float(np.abs(size).max(initial=0.0)) for size in sizes)
        over = float(left[worst.coordinate])
        if not abs(over) > _FELT * level:
            return None
        run = self.balance.outside(state[None], held[None], self.row[None], model.numbers)
        given = float(model.observe([0.0], run, self.row)["drives"][0, place, 0])
        slides = worst.plan.joint in model.plan.chain.sliding
        wanted = self.robot.initial.state is InitialState.HELD
        return Imbalance(worst.plan.joint, given, given - over, "N" if slides else "N*m", distance, wanted)
