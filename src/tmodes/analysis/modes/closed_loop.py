"""Controllers in small motions about a rest: exact slopes of their laws, own states and sample times included.

Between samples the robot and what is held follow linear equations; a sample changes what is held at once. The product
of both over the common period has the eigenvalues z = exp(s T), of which s are the poles in 1/s (K. J. Astrom,
B. Wittenmark, Computer-Controlled Systems, 3rd ed., chapter 2).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import gcd, lcm
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.rigid import driven_joints, rigid_model
from tmodes.analysis.statics.equilibrium import Equilibrium
from tmodes.chain.chain import Motor
from tmodes.equations.loop.control_kernels import Served, Servo, View, Winding
from tmodes.equations.loop.plan import winding_of
from tmodes.equations.loop.signals_kernels import SIGNAL
from tmodes.errors import SimulationError
from tmodes.kinds.controllers.registry import Controller
from tmodes.kinds.kernel.schedule import Numbers, Schedule
from tmodes.model.model import Model
from tmodes.model.passes import derivatives, evaluate
from tmodes.sheet import Robot

__all__ = [
    "Feedback", "Servos", "closed_loop_motions", "common_period", "feedback_of", "is_network", "sample_pattern",
    "servos_together", "settled",
]  # fmt: skip

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

MOST_SAMPLES = 10_000
"""Samples within the common period of several controllers up to which their poles are computed."""

_MOST_HELD = 300
"""States of sampled controllers up to which modes are computed: their time grows with the third power of these."""

_NO_SIZE = 1e-13
"""Singular value over the largest one that is rounding."""

_SETTLED = 1e-9
"""Largest rate of a controller that has settled, as a share of that at first."""

_SETTLES = 3
"""Steps after which controllers have settled: what is limited no more is linear."""

_GONE = 1e-8
"""An eigenvalue of the sampled system below this is a state that each sample overwrites, no motion."""


@dataclass(frozen=True, eq=False)
class Feedback:
    """Controllers about a rest of n coordinates, with k further states: motor currents and controllers' own.

    ``stiffness`` and ``damping`` (n, n): fall of the efforts by coordinates and rates; ``drive`` (n, k): efforts by
    further states; ``by`` (k, n + n + k): rates of these, of which the first ``currents`` are of the motors' currents.
    ``samples``: times [s] up to the next samples, which fill their common period, and the further states after these
    (k, n + n + k); ``held`` (k, n): further states by coordinates, soon after such samples.
    """

    stiffness: Array
    damping: Array
    drive: Array
    by: Array
    currents: int = 0
    samples: tuple[tuple[float, Array], ...] = ()
    held: Array | None = None

    @property
    def springs(self) -> Array:
        """The stiffness (n, n) with sampled controllers as if they worked at all times, and with steady currents."""
        n, m = len(self.stiffness), self.currents
        steady = -np.linalg.solve(self.by[:m, 2 * n : 2 * n + m], self.by[:m])
        effort = self.drive + self.drive[:, :m] @ steady[:, 2 * n :] if m else self.drive
        held = 0.0 if self.held is None else effort @ self.held
        return self.stiffness - self.drive[:, :m] @ steady[:, :n] - held

    def on(self, basis: Array) -> Feedback:
        """The same in the coordinates (m) of which those of the robot are ``basis`` (n, m)."""
        n, k = self.drive.shape
        wide = np.zeros((2 * n + k, 2 * basis.shape[1] + k))
        wide[:n, : basis.shape[1]] = wide[n : 2 * n, basis.shape[1] : 2 * basis.shape[1]] = basis
        wide[2 * n :, 2 * basis.shape[1] :] = np.eye(k)
        return Feedback(
            basis.T @ self.stiffness @ basis, basis.T @ self.damping @ basis, basis.T @ self.drive, self.by @ wide,
            self.currents, tuple((length, by @ wide) for length, by in self.samples),
            None if self.held is None else self.held @ basis,
        )  # fmt: skip


def closed_loop_motions(mass: Array, damping: Array, stiffness: Array, loop: Feedback) -> tuple[Complex, Complex]:
    """Eigenvalues [1/s] and the coordinates' part of the motions of M q'' + D q' + K q = 0 under feedback.

    Raises :class:`tmodes.errors.SimulationError` for sampled controllers of too many states.
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
    if k > _MOST_HELD:
        raise SimulationError(
            f"modes under control: with the values that wait for delays the controllers have {k} states, more than "
            f"{_MOST_HELD}; `tmodes linear --closed` computes the poles, or shorten the delays"
        )
    return _sampled_motions(matrix, loop.samples, n)


def _sampled_motions(matrix: Array, samples: tuple[tuple[float, Array], ...], n: int) -> tuple[Complex, Complex]:
    """The same of a robot that is sampled: at the start of the common period, after the samples there."""
    from scipy.linalg import expm

    whole, product = sum(length for length, _ in samples), np.eye(len(matrix))
    for length, by in samples:
        moved = expm(matrix * length) @ product
        product = np.vstack([moved[: 2 * n], by @ moved])
    basis, lasting = _lasting(product)
    values, vectors = (found.astype(complex) for found in np.linalg.eig(lasting))  # real ones exactly, pairs conjugate
    kept = np.abs(values) > _GONE
    values, vectors = values[kept], (basis @ vectors[:, kept]).astype(complex)
    principal = np.log(values) / whole
    position, rate = vectors[:n], vectors[n : 2 * n]
    size = np.maximum((np.abs(position) ** 2).sum(axis=0), 1e-300)
    guess = (position.conj() * rate).sum(axis=0) / size
    turns = np.round((guess.imag - principal.imag) * whole / (2 * np.pi))  # log knows the angle but for whole turns
    turns[np.abs(guess.imag) * whole < np.pi] = 0.0
    return principal + 2j * np.pi * turns / whole, position


def _lasting(product: Array) -> tuple[Array, Array]:
    """The states that are left after enough periods, as columns, and the ``product`` of a period in these.

    Delays overwrite states one after the other, whose eigenvalues 0 rounding would part widely.
    """
    from scipy.linalg import matrix_balance

    product, (sizes, _) = matrix_balance(product, permute=False, separate=True)
    basis = np.diag(sizes)
    while len(product):
        ways, reached, _ = np.linalg.svd(product)
        kept = ways[:, reached > _NO_SIZE * reached[0]]
        if len(kept.T) == len(product):
            break
        product, basis = kept.T @ product @ kept, basis @ kept
    return basis, product


def settled(
    state: Array, places: Sequence[int] | NDArray[np.intp], rates: Callable[[Array], Array],
    slopes: Callable[[Array], Array],
) -> Array:  # fmt: skip
    """The state, that of controllers at ``places`` (k,) such that its ``rates`` (k,) vanish; ``slopes``: these by it.

    Each that rests at its first value, too, has that: an integral, which goes to its limit while another state is far
    off.
    """
    found = state.copy()
    least = _SETTLED * float(np.abs(rates(state)).max(initial=0.0))
    for _ in range(_SETTLES if least else 0):
        found[places] -= np.linalg.pinv(slopes(found)) @ rates(found)
        for place in places:
            trial = found.copy()
            trial[place] = state[place]
            found = trial if np.abs(rates(trial)).max() <= least else found
    return found


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


def sample_pattern(periods: Sequence[float]) -> tuple[float, list[tuple[float, tuple[int, ...]]]]:
    """The common period [s], and in it each time [s] up to the next samples with those of the ``periods`` due there."""
    whole, instants = common_period([(Fraction(period).limit_denominator(10**7), Fraction(0)) for period in periods])
    return whole, [(length, due) for (length, _), (_, due) in zip(instants, instants[1:] + instants[:1], strict=True)]


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


def is_network(robot: Robot) -> bool:
    """Whether more than laws at drives control a robot: blocks, sensors that laws read, samples or delays of drives."""
    laws = [(one, one.controller) for one in robot.drives if one.controller]
    late = any(law.reads or law.lag or one.delay or one.sample_time is not None for one, law in laws)
    return late or bool(robot.drives and robot.control)


def feedback_of(robot: Robot, rest: Equilibrium) -> Feedback | None:
    """The controllers of a data sheet about its rest, their wanted values where the robot is; None as below.

    Raises :class:`tmodes.errors.SimulationError` for sample times without a common period.
    """
    from tmodes import run_feedback

    if is_network(robot):
        return run_feedback(robot, rest)
    servos = servos_together(robot, rest.model)
    return servos and servos.about(rest.q)


def servos_together(robot: Robot, model: Model) -> Servos | None:
    """The servos of a data sheet, which are all that controls it.

    None where each acts as a spring and a damper of its own drive, which
    :func:`tmodes.analysis.modes.of_sheet.servos_of` gives, and where more controls it (:func:`is_network`).
    """
    found = [] if is_network(robot) else list(_drives(robot, model))
    simple = all(one.law.is_local and not one.servo.has_current for one in found)
    return None if simple else Servos(model.nq, found)


@dataclass(frozen=True)
class _Drive:
    """A drive under control: its servo with its numbers, the coordinate that it moves, and where its own states begin.

    ``current``: place of its current among the motors' that have one, else None.
    """

    law: Controller
    servo: Servo
    numbers: Any
    own: int
    first: int
    current: int | None

    @property
    def rows(self) -> list[int]:
        """Its controller's own states, among all further states."""
        return [*range(self.first, self.first + self.servo.states)]


def _drives(robot: Robot, model: Model) -> Iterator[_Drive]:
    motors: dict[str, Motor | None] = {axis.name: axis.joint.motor for axis in model.chain.axes}
    names, found = model.coordinates, []
    for drive in robot.drives:
        own = next((name for name in (f"{drive.joint}.motor", drive.joint) if name in names), None)
        if drive.controller and own:
            winding, numbers = winding_of(motors.get(drive.joint))
            rigid = rigid_model(robot, driven_joints(robot)) if drive.controller.needs_model else None
            driven = winding is not Winding.NONE and not drive.controller.commands_effort
            servo = Servo(drive.controller, driven=driven, winding=winding, model=rigid)
            found.append((drive, servo, numbers, names.index(own)))
    currents = [servo.has_current for _, servo, *_ in found]
    joints, first = tuple(drive.joint for drive, *_ in found), sum(currents)
    for k, (drive, servo, numbers, own) in enumerate(found):
        seeing = servo.seeing(View(tuple(names), joints, sum(currents), own))
        current = sum(currents[:k]) if currents[k] else None
        yield _Drive(drive.controller, seeing, servo.numbers(numbers), own, first, current)
        first += seeing.states


class Servos:
    """All servos of a robot of ``n`` coordinates by one schedule, their wanted values where the robot is.

    ``numbers``: what it takes. ``further`` states: the ``currents`` of motors, then those of controllers, from
    ``start`` on. ``own``: coordinates that the drives move.
    """

    def __init__(self, n: int, drives: Sequence[_Drive]) -> None:
        self.n, self.drives, self.own = n, drives, [one.own for one in drives]
        self.currents = sum(one.servo.has_current for one in drives)
        self.start = [0.0] * self.currents + [value for one in drives for value in one.servo.start]
        self._numbers = Numbers()
        self._slots = [self._numbers.block(one.numbers) for one in drives]
        self.numbers = self._numbers.vector
        sampled = [one for one in drives if one.servo.is_sampled]
        self.periods, self.sampled = [one.law.period or 0.0 for one in sampled], [one.rows for one in sampled]
        held = {row for rows in self.sampled for row in rows}
        self.rated = [row for row in range(len(self.start)) if row not in held]

    @cached_property
    def schedule(self) -> Schedule:
        """From ``q``, ``v``, ``further`` states, ``setpoints``, and zeros ``still``, to the ``effort`` of each drive.

        Also to the ``rates`` of the states that are ``rated``, and to what the ``samples`` of the ``sampled`` give.
        """
        schedule, n, m = Schedule(self._numbers.size), self.n, self.currents
        q, v, further = (schedule.input(name, k) for name, k in (("q", n), ("v", n), ("further", len(self.start))))
        setpoints, still = schedule.input("setpoints", SIGNAL * len(self.drives)), schedule.input("still", SIGNAL)
        none, outputs = still.part(0, 1), {"effort": [], "currents": [], "rates": [], "samples": []}
        for k, (one, numbers) in enumerate(zip(self.drives, self._slots, strict=True)):
            current = none if one.current is None else further.part(one.current, 1)
            served = Served(
                numbers, setpoints.part(SIGNAL * k, SIGNAL), q.part(one.own, 1), v.part(one.own, 1), current, none,
                states=further.part(one.first, one.servo.states) if one.rows else None,
                seen=(q, v, further.part(0, m), setpoints) if one.servo.view else (),
            )  # fmt: skip
            effort, _, change, _, *rates = one.servo.serve(schedule.call, served)
            outputs["effort"].append(effort)
            outputs["currents"] += [] if one.current is None else [change]
            outputs["rates"] += [] if one.servo.is_sampled else rates
            outputs["samples"] += [one.servo.sample(schedule.call, served, still)] if one.servo.is_sampled else []
        schedule.output("effort", *outputs["effort"])
        schedule.output("rates", *outputs["currents"], *outputs["rates"])
        schedule.output("samples", *outputs["samples"])
        return schedule

    def about(self, q: Array) -> Feedback:
        """Their exact slopes about coordinates (n,), by native code."""
        n, size = self.n, 2 * self.n + len(self.start)
        wanted = [value for own in self.own for value in (q[own], 0.0, 0.0)]
        given = {"q": q, "v": np.zeros(n), "setpoints": wanted, "still": np.zeros(SIGNAL)}
        whole = np.eye(size)
        along = {"q": whole[:, :n], "v": whole[:, n : 2 * n], "further": whole[:, 2 * n :]}

        def values(further: Array) -> dict[str, Array]:
            blocks = {name: np.array(one, dtype=float)[None] for name, one in {**given, "further": further}.items()}
            return {name: one[0] for name, one in evaluate(self.numbers, self.schedule, blocks, 1).items()}

        def slopes(further: Array) -> dict[str, Array]:
            each = {**given, "further": further}
            blocks = {name: np.tile(np.array(one, dtype=float), (size, 1)) for name, one in each.items()}
            found = derivatives(self.numbers, self.schedule, blocks, along, size)
            return {name: one.T for name, one in found.items()}

        own = [2 * n + row for row in self.rated]
        further = settled(np.array(self.start, dtype=float), self.rated, lambda one: values(one)["rates"],
                          lambda one: slopes(one)["rates"][:, own])  # fmt: skip
        further[[row for rows in self.sampled for row in rows]] = values(further)["samples"]
        found = slopes(further)
        effort, by = np.zeros((n, size)), np.zeros((len(self.start), size))
        np.add.at(effort, self.own, found["effort"])
        by[self.rated] = found["rates"]
        springs = -effort[:, :n], -effort[:, n : 2 * n], effort[:, 2 * n :], by, self.currents
        if not self.periods:
            return Feedback(*springs)
        parts, samples = np.split(found["samples"], np.cumsum([len(rows) for rows in self.sampled])[:-1]), []
        for length, due in sample_pattern(self.periods)[1]:
            after = whole[2 * n :].copy()  # all new values are of the state before
            for k in due:
                after[self.sampled[k]] = parts[k]
            samples.append((length, after))
        return Feedback(*springs, tuple(samples), samples[-1][1][:, :n])  # all are due at the end of the period
