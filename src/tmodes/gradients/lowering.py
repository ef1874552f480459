"""A data sheet as the numbers of a run, and the run with its steps, along which it is differentiated.

Steps of an explicit method that stand at its limit of stability are fine for the run, whose error control keeps what is
fast small; along them, as they were, it grows. How much: the product over the steps of the factors that the method has
for the eigenvalues there (E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, section IV.2).
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from tmodes.equations.recursion.parts import AxisPart
from tmodes.errors import SimulationError
from tmodes.integrate.choice import otherwise
from tmodes.integrate.implicit import EXTRAPOLATION
from tmodes.integrate.method import EULER
from tmodes.integrate.registry import integrator
from tmodes.integrate.settings import Integration
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import RunSetup, run_setup, slipping
from tmodes.simulation.loop import LoopModel, refuse_switches
from tmodes.simulation.recording import MOST_BYTES, Recording
from tmodes.simulation.replay import Replay
from tmodes.simulation.solve import solve
from tmodes.simulation.vary.values import RobotVariant

__all__ = ["Lowered", "lowered", "pieces_at", "rows_of"]

Array = NDArray[np.float64]

_GROWTH, _MOST_GROWTH, _LOOKS = 8, 12, 50
"""Digits by which derivatives may grow along steps beyond the motion before others are taken, and where there are none;
at how many places eigenvalues are looked at."""

_KINKS, _NO_LIMIT = 1e-12, 1e200
"""Relative tolerance of runs in which commands meet their limits; a limit that none meets."""


@dataclass(frozen=True, eq=False)
class Lowered:
    """A run in numbers: its model, the parameters, the state at the start, and how it is integrated.

    ``setup``: the run's setup. The method ``auto`` is chosen as for any run; ``otherwise``: the settings of the one
    that takes its place where derivatives would grow along its steps.
    """

    model: LoopModel
    parameters: Array
    start: Array
    settings: Integration
    setup: RunSetup
    variant: RobotVariant = RobotVariant.ACTUAL
    otherwise: Integration | None = None

    def recorded(self, most_bytes: float = MOST_BYTES) -> Replay:
        """The run, with its steps.

        Raises :class:`tmodes.errors.InputError` for given motions whose rates jump and for dry friction that sticks,
        which are not differentiated, and :class:`tmodes.errors.SimulationError` where a force jumped on the way: how
        the time of the jump moves with the numbers is part of the derivative, and not seen.
        """
        refuse_switches(self.model, "derivatives of a run", "vary the numbers in a batch")
        settings = self.settings
        done = solve(self.setup.problem(), adjoint=most_bytes)
        if (growth := self._growth(done)) > _GROWTH and self.otherwise:
            settings = self.otherwise
            done = solve(self.setup.problem(settings), adjoint=most_bytes)
        elif growth > _MOST_GROWTH:
            raise SimulationError(
                f"derivatives of a run: along steps at the limit of stability of {done.method} they grow by "
                f"1e{growth:.0f}; expected by at most 1e{_MOST_GROWTH}. Set integration.method to extrapolation, or "
                "lower integration.relative_tolerance"
            )
        if self._meets_limits(done):
            done = solve(self.setup.problem(_closer(settings)), adjoint=most_bytes)
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

    def _meets_limits(self, done: Recording) -> bool:
        """Whether a limit cuts a command that moves between samples, at some sample of a run."""
        free = self.parameters.copy()
        for driver in self.model.loop.drivers:
            servo = driver.plan.servo
            free[[driver.numbers.start + place for place in (servo.limit_places if servo else ())]] = _NO_LIMIT
        if np.array_equal(free, self.parameters):
            return False
        rows = done.rows[pieces_at(done.rows, done.times)]
        rates, others = (self.model.rate(done.times, done.samples, rows, one) for one in (self.parameters, free))
        return not np.array_equal(rates, others)

    def _growth(self, done: Recording) -> float:
        """Decimal logarithm of the largest growth along the steps of a run beyond that of the motion.

        Modes are followed by the order of their eigenvalues.
        """
        tableau, grown = integrator(done.method).tableau, [np.zeros(self.model.layout.works.start)]
        if tableau is None:
            return 0.0
        cuts = np.unique(np.linspace(0, len(done.t), _LOOKS + 1).astype(int)).tolist()
        for first, stop in pairwise(cuts):
            step = (first + stop) // 2
            sample = min(int(np.searchsorted(done.times, done.t[step])), len(done.times) - 1)
            state, row = slipping(self.model, done.samples[sample]), done.rows[done.segments[step]]
            values = np.linalg.eigvals(self.model.jacobian(float(done.t[step]), state, row, self.parameters))
            reach = done.h[first:stop, None] * values[np.argsort(-np.abs(values), kind="stable")]
            reach[reach == 0] = np.finfo(float).eps
            factors = np.log(np.maximum(np.abs(tableau.amplification(reach.astype(complex))), np.finfo(float).tiny))
            grown.append(grown[-1] + (factors - np.maximum(reach.real, 0.0)).sum(axis=0))
        most = np.array(grown) - np.minimum.accumulate(grown)
        return float(most.max(initial=0.0)) / np.log(10.0)


def _closer(settings: Integration) -> Integration:
    """Tolerances with which steps are short where a command meets its limit: there a kink costs derivatives more."""
    least = max(_KINKS, integrator(settings.method).least_tolerance)
    share = min(1.0, least / settings.relative_tolerance)
    tolerances = {
        f"{name}_tolerance": share * getattr(settings, f"{name}_tolerance") for name in ("relative", "absolute")
    }
    return settings.model_copy(update=tolerances)


def _jumps(axis: AxisPart) -> bool:
    """Whether the torque of a gear jumps where its teeth meet."""
    gear = axis.axis.joint.gear
    return bool(axis.drive and axis.drive.dead_zone and gear and gear.damping > 0)


def lowered(sheet: Robot, variant: RobotVariant = RobotVariant.ACTUAL) -> Lowered:
    """The run of the actual robot, or of the one that plans the motion.

    Raises :class:`tmodes.errors.InputError` and :class:`tmodes.errors.SimulationError` for what cannot run.
    """
    setup = run_setup(variant.of(sheet.pair()), variant.follow)
    given, own = setup.robot.integration, setup.chosen()
    steady = setup.implicit == EXTRAPOLATION.name  # the other implicit method is not differentiated
    other = otherwise(given, own.robot.integration.method) if steady else None
    return Lowered(own.model, own.model.numbers, own.start, own.robot.integration, own, variant, other)


def rows_of(schedule: SignalPieces, duration: float) -> Array:
    """Start and coefficients of each piece of the signals, (segments, row)."""
    pieces = schedule.until(duration)
    return pieces.rows_at(pieces.knots[:-1])


def pieces_at(rows: Array, times: Array) -> NDArray[np.intp]:
    """The piece of the signals that holds at each of ``times`` (n,)."""
    return np.clip(np.searchsorted(rows[:, 0], times, side="right") - 1, 0, len(rows) - 1)
