"""A data sheet as the numbers of a run."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.equations.recursion.parts import AxisPart
from tmodes.errors import SimulationError
from tmodes.integrate.method import EULER
from tmodes.integrate.registry import integrator
from tmodes.integrate.settings import Integration
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import RunSetup, run_setup
from tmodes.simulation.loop import LoopModel, refuse_switches
from tmodes.simulation.recording import MOST_BYTES
from tmodes.simulation.replay import Replay
from tmodes.simulation.solve import solve
from tmodes.simulation.vary.values import RobotVariant

__all__ = ["Lowered", "lowered", "pieces_at", "rows_of"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Lowered:
    """A run in numbers: its model, the parameters, the state at the start, and how it is integrated.

    ``setup``: the run's setup. The method ``auto`` is chosen as for any run; one that turns out stiff underway
    continues with it here.
    """

    model: LoopModel
    parameters: Array
    start: Array
    settings: Integration
    setup: RunSetup
    variant: RobotVariant = RobotVariant.ACTUAL

    def recorded(self, most_bytes: float = MOST_BYTES) -> Replay:
        """The run, with its steps.

        Raises :class:`tmodes.errors.InputError` for given motions whose rates jump and for dry friction that sticks,
        which are not differentiated, and :class:`tmodes.errors.SimulationError` where a force jumped on the way: how
        the time of the jump moves with the numbers is part of the derivative, and not seen.
        """
        refuse_switches(self.model, "derivatives of a run", "vary the numbers in a batch")
        done = solve(self.setup.problem(), adjoint=most_bytes)
        contact, loop = self.setup.robot.contact, self.model.loop
        if done.contact_changes and contact and contact.jumps:
            raise SimulationError(
                "derivatives of a run: contact started or ended on a unilateral surface with a damper or a preload, "
                "whose force jumps there; expected a force without jumps. End the run before, or set "
                "contact.damping and contact.preload to 0"
            )
        damped = [axis.axis for axis in loop.parts.axes if _jumps(axis)]
        if done.contact_changes and damped:
            raise SimulationError(
                f"derivatives of a run: in the play of the gear of {damped[0].name} teeth met or parted, where the "
                "torque of its damper jumps; expected a torque without jumps. End the run before, or set "
                f"joints.{damped[0].joint.name}.gear.damping to 0"
            )
        rates = loop.euler_rate if integrator(done.method).asks == EULER else loop.rate
        return Replay(rates, self.parameters, done, len(self.model.coordinates))


def _jumps(axis: AxisPart) -> bool:
    """Whether the torque of a gear jumps where its teeth meet."""
    gear = axis.axis.joint.gear
    return bool(axis.drive and axis.drive.dead_zone and gear and gear.damping > 0)


def lowered(sheet: Robot, variant: RobotVariant = RobotVariant.ACTUAL) -> Lowered:
    """The run of the actual robot, or of the one that plans the motion.

    Raises :class:`tmodes.errors.InputError` and :class:`tmodes.errors.SimulationError` for what cannot run.
    """
    setup = run_setup(variant.of(sheet.pair()), variant.follow).chosen()
    return Lowered(setup.model, setup.model.numbers, setup.start, setup.robot.integration, setup, variant)


def rows_of(schedule: SignalPieces, duration: float) -> Array:
    """Start and coefficients of each piece of the signals, (segments, row)."""
    pieces = schedule.until(duration)
    return pieces.rows_at(pieces.knots[:-1])


def pieces_at(rows: Array, times: Array) -> NDArray[np.intp]:
    """The piece of the signals that holds at each of ``times`` (n,)."""
    return np.clip(np.searchsorted(rows[:, 0], times, side="right") - 1, 0, len(rows) - 1)
