"""A data sheet as the numbers of a run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.arm import Arm
from tmodes.equations.arm.closed_loop import ClosedLoop
from tmodes.integrate.settings import Integration, Method
from tmodes.mechanism import Drive, Mechanism
from tmodes.model import Model
from tmodes.model_derivatives import rate_schedule
from tmodes.motion.plan import Planned, planned
from tmodes.motion.regime import ArmRegime, arm_regime
from tmodes.reference.schedule import Schedule
from tmodes.robot import Robot
from tmodes.trajectory import Moving, Numbers

__all__ = ["Lowered", "lowered", "replanned", "rows_of", "structure"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Lowered:
    """A run in numbers: its model, the parameters, the signals, the state at the start, and how it is integrated.

    ``rates``: the schedule of the rates; ``regime``: of an arm. The method ``auto`` is dormand_prince here.
    """

    model: Moving
    rates: Any
    parameters: Numbers
    schedule: Schedule
    start: Array
    settings: Integration
    regime: ArmRegime | None = None


def lowered(sheet: Arm | Robot) -> Lowered:
    """The run of an arm, or of the 2010 robot under control, as its sheet says it."""
    if isinstance(sheet, Robot):
        mechanism, parameters = sheet.split(Drive.CONTROLLED)
        start = Model(mechanism).rest(sheet.reference.start, parameters)
        rates, schedule = rate_schedule(mechanism), sheet.wanted(Drive.CONTROLLED)
        return Lowered(Model(mechanism), rates, parameters, schedule, start, sheet.integration)
    regime, settings = arm_regime(sheet), sheet.integration
    model = regime.model
    if settings.method is Method.AUTO:
        settings = settings.chosen(Method.DORMAND_PRINCE)
    return Lowered(model, model.loop.rate, model.numbers, regime.planned.schedule, regime.start, settings, regime)


def replanned(sheet: Arm) -> tuple[Planned, ClosedLoop]:
    """An arm's plan and its numbers, without a state at the start."""
    plan = planned(sheet)
    return plan, ClosedLoop(plan.plan)


def rows_of(schedule: Schedule, duration: float) -> Array:
    """Start and coefficients of each piece of the signals, (segments, row)."""
    pieces = schedule.until(duration)
    return np.column_stack([pieces.knots[:-1], pieces.coefficients])


def structure(of: Mechanism | ClosedLoop) -> object:
    """What the numbers do not tell: runs of one structure have the same code."""
    if isinstance(of, Mechanism):
        return of
    nodes = tuple((part.hinge, part.drive, part.link and part.link.kernels) for part in of.parts.nodes)
    return nodes, tuple((drive.servo, drive.winding) for drive in of.plan.drives), of.parts.numbers.size
