"""Controllers in small motions about a rest: exact slopes of their laws, own states and sample times included.

Between samples the robot and what is held follow linear equations; a sample changes what is held at once. The product
of both over the common period has the eigenvalues z = exp(s T), of which s are the poles in 1/s (K. J. Astrom,
B. Wittenmark, Computer-Controlled Systems, 3rd ed., chapter 2).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import gcd, lcm

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.rigid import driven_joints, rigid_model
from tmodes.analysis.statics.equilibrium import Equilibrium
from tmodes.chain.chain import Motor
from tmodes.equations.loop.control_kernels import OUTPUTS, Served, Servo, View, Winding
from tmodes.equations.loop.plan import winding_of
from tmodes.equations.loop.signals_kernels import SIGNAL
from tmodes.errors import SimulationError
from tmodes.kinds.controllers.registry import Controller
from tmodes.kinds.kernel.schedule import Schedule, Slot
from tmodes.model.passes import derivatives
from tmodes.sheet import Robot

__all__ = ["Feedback", "closed_loop_motions", "common_period", "feedback_of"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

MOST_SAMPLES = 10_000
"""Samples within the common period of several controllers up to which their poles are computed."""

_GONE = 1e-8
"""An eigenvalue of the sampled system below this is a state that each sample overwrites, no motion."""


@dataclass(frozen=True)
class _Sample:
    """The samples of one controller: ``period`` [s], the ``rows`` of the further states that they set.

    ``by`` (rows, n + n + k): slopes of the new values by coordinates, rates and further states.
    """

    period: float
    rows: tuple[int, ...]
    by: Array


@dataclass(frozen=True, eq=False)
class Feedback:
    """Controllers about a rest of n coordinates, with k further states: motor currents and controllers' own.

    ``stiffness`` and ``damping`` (n, n): fall of the efforts by coordinates and rates; ``drive`` (n, k): efforts by
    further states; ``by`` (k, n + n + k): rates of these, of which the first ``currents`` are of the motors' currents.
    """

    stiffness: Array
    damping: Array
    drive: Array
    by: Array
    samples: tuple[_Sample, ...] = ()
    currents: int = 0

    @property
    def springs(self) -> Array:
        """The stiffness (n, n) with sampled controllers as if they worked at all times, and with steady currents."""
        n, m = len(self.stiffness), self.currents
        steady = -np.linalg.solve(self.by[:m, 2 * n : 2 * n + m], self.by[:m])
        effort = self.drive + self.drive[:, :m] @ steady[:, 2 * n :] if m else self.drive
        held = (effort[:, list(sample.rows)] @ sample.by[:, :n] for sample in self.samples)
        return self.stiffness - self.drive[:, :m] @ steady[:, :n] - sum(held, np.zeros((n, n)))

    def on(self, basis: Array) -> Feedback:
        """The same in the coordinates (m) of which those of the robot are ``basis`` (n, m)."""
        n, k = self.drive.shape
        wide = np.zeros((2 * n + k, 2 * basis.shape[1] + k))
        wide[:n, : basis.shape[1]] = wide[n : 2 * n, basis.shape[1] : 2 * basis.shape[1]] = basis
        wide[2 * n :, 2 * basis.shape[1] :] = np.eye(k)
        return Feedback(
            basis.T @ self.stiffness @ basis, basis.T @ self.damping @ basis, basis.T @ self.drive, self.by @ wide,
            tuple(replace(sample, by=sample.by @ wide) for sample in self.samples), self.currents,
        )  # fmt: skip


def closed_loop_motions(mass: Array, damping: Array, stiffness: Array, loop: Feedback) -> tuple[Complex, Complex]:
    """Eigenvalues [1/s] and the coordinates' part of the motions of M q'' + D q' + K q = 0 under feedback.

    Raises :class:`tmodes.errors.SimulationError` for sample times without a common period.
    """
    n, k = loop.drive.shape
    matrix = np.zeros((2 * n + k, 2 * n + k))
    matrix[:n, n : 2 * n] = np.eye(n)
    forces = np.hstack([-stiffness - loop.stiffness, -damping - loop.damping, loop.drive])
    matrix[n : 2 * n] = np.linalg.solve(mass, forces)
    matrix[2 * n :] = loop.by
    if not loop.samples:
        values, vectors = np.linalg.eig(matrix)
        return values.astype(complex), vectors[:n].astype(complex)
    return _sampled_motions(matrix, loop.samples, n)


def _sampled_motions(matrix: Array, samples: tuple[_Sample, ...], n: int) -> tuple[Complex, Complex]:
    """The same of a robot that is sampled: at the start of the common period, after the samples there."""
    from scipy.linalg import expm

    whole, steps = _pattern(samples)
    product = np.eye(len(matrix))
    for length, due in steps:
        product = _after(samples, due, len(matrix), 2 * n) @ expm(matrix * length) @ product
    values, vectors = np.linalg.eig(product.astype(complex))
    kept = np.abs(values) > _GONE
    values, vectors = values[kept], vectors[:, kept]
    principal = np.log(values) / whole
    position, rate = vectors[:n], vectors[n : 2 * n]
    size = np.maximum((np.abs(position) ** 2).sum(axis=0), 1e-300)
    guess = (position.conj() * rate).sum(axis=0) / size
    turns = np.round((guess.imag - principal.imag) * whole / (2 * np.pi))  # log knows the angle but for whole turns
    turns[np.abs(guess.imag) * whole < np.pi] = 0.0
    return principal + 2j * np.pi * turns / whole, position


def common_period(clocks: Sequence[tuple[Fraction, Fraction]]) -> tuple[float, list[tuple[float, tuple[int, ...]]]]:
    """The common period [s] of clocks (period, shift), and in it each instant: its length to the next, what is due."""
    whole = _common([period for period, _ in clocks])
    due: dict[Fraction, list[int]] = {Fraction(0): []}
    for k, (period, shift) in enumerate(clocks):
        for j in range(int(whole / period)):
            due.setdefault((period * j + shift) % whole, []).append(k)
    times = sorted(due)
    lengths = [float(b - a) for a, b in zip(times, [*times[1:], whole], strict=True)]
    return float(whole), [(length, tuple(due[time])) for length, time in zip(lengths, times, strict=True)]


def _common(periods: Sequence[Fraction]) -> Fraction:
    """The least common multiple of periods [s]; raises where it holds too many samples."""
    common, scale = lcm(*(p.numerator for p in periods)), gcd(*(p.denominator for p in periods))
    whole = Fraction(common, scale)
    if sum(whole / p for p in periods) > MOST_SAMPLES:
        raise SimulationError(
            f"modes under control: the sample times {', '.join(f'{float(p):g}' for p in periods)} s have no common "
            f"period below {MOST_SAMPLES} samples; choose multiples of one time"
        )
    return whole


def _pattern(samples: tuple[_Sample, ...]) -> tuple[float, list[tuple[float, tuple[int, ...]]]]:
    """The common period [s], and in it each time [s] up to the next sample with the controllers that sample there."""
    periods = [Fraction(sample.period).limit_denominator(10**7) for sample in samples]
    whole = _common(periods)
    counts = [whole / p for p in periods]
    times = sorted({p * j for p, count in zip(periods, counts, strict=True) for j in range(1, int(count) + 1)})
    lengths = [float(b - a) for a, b in zip([Fraction(0), *times[:-1]], times, strict=True)]
    due = [tuple(k for k, p in enumerate(periods) if (time / p).denominator == 1) for time in times]
    return float(whole), list(zip(lengths, due, strict=True))


def _after(samples: tuple[_Sample, ...], due: tuple[int, ...], size: int, first: int) -> Array:
    """What samples do to a state whose further states begin at ``first``: all new values are of the state before."""
    matrix = np.eye(size)
    for k in due:
        matrix[[first + row for row in samples[k].rows]] = samples[k].by
    return matrix


def feedback_of(robot: Robot, rest: Equilibrium) -> Feedback | None:
    """The controllers of a data sheet about its rest, their wanted values where the robot is.

    None where each acts as a spring and a damper of its own drive, which
    :func:`tmodes.analysis.modes.of_sheet.servos_of` gives.
    """
    found = list(_drives(robot, rest))
    simple = all(one.law.is_local and not one.servo.has_current for one in found)
    return None if simple or not found else _Linear(rest, found).feedback()


@dataclass(frozen=True)
class _Drive:
    """A drive under control: its servo with its numbers, the coordinate that it moves, its signal's place."""

    joint: str
    law: Controller
    servo: Servo
    numbers: tuple[float, ...]
    own: int


def _drives(robot: Robot, rest: Equilibrium) -> Iterator[_Drive]:
    motors: dict[str, Motor | None] = {axis.name: axis.joint.motor for axis in rest.model.chain.axes}
    names = rest.model.coordinates
    for drive in robot.drives:
        own = next((name for name in (f"{drive.joint}.motor", drive.joint) if name in names), None)
        if drive.controller and own:
            winding, numbers = winding_of(motors.get(drive.joint))
            model = rigid_model(robot, driven_joints(robot)) if drive.controller.needs_model else None
            driven = winding is not Winding.NONE and not drive.controller.commands_effort
            servo = Servo(drive.controller, driven=driven, winding=winding, model=model)
            yield _Drive(drive.joint, drive.controller, servo, servo.numbers(numbers), names.index(own))


class _Linear:
    """Slopes of all servos at a rest, by native code: directions are coordinates, rates, then further states."""

    def __init__(self, rest: Equilibrium, drives: list[_Drive]) -> None:
        self.rest, self.n = rest, rest.model.nq
        currents = [k for k, one in enumerate(drives) if one.servo.has_current]
        self.current = {k: place for place, k in enumerate(currents)}
        self.first, total = {}, len(currents)
        names = tuple(each.joint for each in drives)
        views = [View(tuple(rest.model.coordinates), names, len(currents), one.own) for one in drives]
        self.drives = [replace(one, servo=one.servo.seeing(view)) for one, view in zip(drives, views, strict=True)]
        for k, one in enumerate(self.drives):
            self.first[k], total = total, total + one.servo.states
        self.further = total
        self.size = 2 * self.n + total

    def feedback(self) -> Feedback:
        """All of them."""
        n, effort, by, samples = self.n, np.zeros((self.n, self.size)), np.zeros((self.further, self.size)), []
        for k, one in enumerate(self.drives):
            found = self._slopes(k, one, sampled=False)
            effort[one.own] += found[0]
            if k in self.current:
                by[self.current[k]] = found[3]
            rows = tuple(range(self.first[k], self.first[k] + one.servo.states))
            if one.servo.is_sampled:
                samples.append(_Sample(one.law.period or 0.0, rows, self._slopes(k, one, sampled=True)))
            elif rows:
                by[list(rows)] = found[4 + OUTPUTS :]
        return Feedback(
            -effort[:, :n], -effort[:, n : 2 * n], effort[:, 2 * n :], by, tuple(samples), len(self.current)
        )

    def _slopes(self, k: int, one: _Drive, *, sampled: bool) -> Array:
        """Of the outputs of a servo, one after the other, by all directions (outputs, size)."""
        schedule = Schedule(len(one.numbers))
        blocks: dict[str, Array] = {}
        along: dict[str, Array] = {}

        def given(values: Array, directions: Array) -> Slot:
            name = f"in{len(blocks)}"
            blocks[name], along[name] = np.tile(values, (self.size, 1)), directions
            return schedule.input(name, len(values))

        served = self._served(k, one, given)
        if sampled:
            found = (one.servo.sample(schedule.call, served, given(np.zeros(SIGNAL), np.zeros((self.size, SIGNAL)))),)
        else:
            found = one.servo.serve(schedule.call, served)
        schedule.output("out", *found)
        return derivatives(np.array(one.numbers), schedule, blocks, along, self.size)["out"].T

    def _served(self, k: int, one: _Drive, given: Callable[[Array, Array], Slot]) -> Served:
        """Inputs of a servo but for its numbers, and by how much each changes along all directions."""
        n, whole, q = self.n, np.eye(self.size), self.rest.q
        setpoints = [np.array([q[each.own], 0.0, 0.0]) for each in self.drives]
        still, none, own = np.zeros((self.size, SIGNAL)), np.zeros((self.size, 1)), np.array(one.servo.start)
        current = whole[:, [2 * n + self.current[k]]] if k in self.current else none
        place, seen = 2 * n + self.first[k], []
        if one.servo.view:
            currents = slice(2 * n, 2 * n + len(self.current))
            seen = [given(q, whole[:, :n]), given(np.zeros(n), whole[:, n : 2 * n])]
            seen.append(given(np.zeros(len(self.current)), whole[:, currents]))
            seen.append(given(np.concatenate(setpoints), np.tile(still, len(setpoints))))
        return Served(
            Slot("parameters", 0, len(one.numbers)), given(setpoints[k], still),
            given(q[[one.own]], whole[:, [one.own]]), given(np.zeros(1), whole[:, [n + one.own]]),
            given(np.zeros(1), current), given(np.zeros(1), none),
            states=given(own, whole[:, place : place + len(own)]) if len(own) else None, seen=tuple(seen),
        )  # fmt: skip
