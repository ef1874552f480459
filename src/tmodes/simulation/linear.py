"""The robot linear about a rest, or about an instant of a run: x' = A x + B u, y = C x + D u, by exact derivatives.

Dry friction that sticks, and impacts, are left out: they have no derivative. States are coordinates, their rates, motor
currents and the own states of controllers; the matrices are derivatives of the compiled right-hand side of a run, and
of the outputs of its table. Sampled loops: K. J. Astrom, B. Wittenmark, Computer-Controlled Systems, 3rd ed., chapters
2 and 3.
"""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import comb
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.modes.closed_loop import Feedback, common_period, settled
from tmodes.analysis.modes.modes import smooth_matrices, without_dry_friction
from tmodes.analysis.rigid import nominal_of
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.analysis.statics.equilibrium import Equilibrium
from tmodes.equations.loop.control_kernels import Winding
from tmodes.kinds.controllers.discrete import held_late, zero_order_hold
from tmodes.kinds.noted.number import follow_no
from tmodes.model.passes import derivatives, evaluate
from tmodes.simulation.balance import Balance, frozen
from tmodes.simulation.initial_state import RunSetup, run_setup, run_trajectory
from tmodes.simulation.linear_inputs import columns, input_unit, opened, with_loads
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.plan import Planned, planned

if TYPE_CHECKING:
    from tmodes.sheet import Robot

__all__ = [
    "Instant", "StateSpace", "closed_loop", "delayed", "growth", "open_loop", "row_at", "run_feedback", "samples_of",
    "start_of", "without_held",
]  # fmt: skip

Array = NDArray[np.float64]

_SAME_REST = 1e-9
"""Difference of coordinates [rad, m] up to which two rests are one."""

_GROWS = 1e-8
"""A sampled pole beyond 1 by less than this is an integrator."""


@dataclass(frozen=True, eq=False)
class StateSpace:
    """Matrices with the names of states, inputs and outputs; ``period`` [s]: of a sampled system, None otherwise.

    About ``x0`` (states,), ``u0`` (inputs,), ``y0`` (outputs,), where the states change by ``rate`` (states,).
    """

    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    units: Mapping[str, str]
    A: Array
    B: Array
    C: Array
    D: Array
    x0: Array
    u0: Array
    y0: Array
    rate: Array
    period: float | None = None


class Instant:
    """Exact derivatives at one state and row of a plan."""

    def __init__(
        self, plan: Planned, state: Array, row: Array, inputs: Sequence[tuple[str, int]], model: LoopModel | None = None
    ) -> None:
        """``model``: of the plan, taken where nothing sticks in it."""
        unstuck = model if model and not model.loop.modes else LoopModel(plan.plan.unstuck)
        self.plan, self.model, self.row = plan, unstuck, row
        self.state = np.resize(np.append(state, np.zeros(self.model.layout.size)), self.model.layout.size)
        self.inputs = tuple(name for name, _ in inputs)
        self.places = [place for _, place in inputs]
        layout = self.model.layout
        self.kept = np.arange(layout.works.start)

    @property
    def names(self) -> tuple[str, ...]:
        """Of the states: coordinates, ``NAME'`` for their rates, currents, own states of controllers and surfaces."""
        found = self.model.coordinates
        return (*found, *(f"{name}'" for name in found), *self.plan.plan.further_states)

    def slopes(self, schedule: Any, output: str, further: Array, row: Array | None = None) -> tuple[Array, Array]:
        """Derivatives of an output by the states and by the inputs."""
        state, size = np.eye(self.model.layout.size)[self.kept], len(self.row)
        push = np.zeros((len(self.places), size))
        push[np.arange(len(self.places)), self.places] = 1.0
        numbers, row = np.concatenate([self.model.numbers, further]), self.row if row is None else row
        return tuple(
            derivatives(numbers, schedule, self._blocks(len(along), row), {name: along}, len(along))[output].T
            if len(along) else np.zeros((schedule.output_size, 0))
            for name, along in (("state", state), ("row", push))
        )  # fmt: skip  # pyright: ignore[reportReturnType]

    def _blocks(self, count: int, row: Array) -> dict[str, Array]:
        given = {"state": np.tile(self.state, (count, 1)), "row": np.tile(row, (count, 1))}
        return {"time": np.full((count, 1), float(row[0])), **given, "step": np.zeros((count, 1))}

    def rates(self) -> Array:
        """What the states change by."""
        return self.model.rate([self.row[0]], self.state, self.row)[0][self.kept]

    def settle(self) -> None:
        """Let currents and own states of controllers settle to the coordinates and the setpoints that there are.

        An integral that nothing settles stays: in what is linear in it, its size is no matter.
        """
        balance, row = Balance(self.model), frozen(self.model, self.row[None])
        own, loop = balance.unknown[len(balance.coordinates) :], balance.loop
        found = settled(
            balance.at_rest(self.state[None])[0], own, lambda one: loop.rate([0.0], one, row)[0, own],
            lambda one: loop.slopes(0.0, one[None], row, None, own)[0, own],
        )  # fmt: skip
        self.state = balance.outside(found[None], self.state[None], row, self.model.numbers)[0]

    def sample(self, row: Array) -> None:
        """Go on to the state after the samples of a row: a rate that is a difference needs a position to remember."""
        self.state = evaluate(self.model.numbers, self.model.loop.sampled, self._blocks(1, row), 1)["state"][0]

    def found(self, outputs: Sequence[str]) -> StateSpace:
        """The linear system with these outputs."""
        table = self.model.outputs
        shown = tuple(table.find(plain_name(name, table), "outputs") for name in outputs)
        by_state, by_input = self.slopes(self.model.loop.rate, "rate", np.zeros(0))
        C, D, y = np.zeros((0, len(self.kept))), np.zeros((0, len(self.places))), np.zeros(0)
        if shown:
            series = self.model.series(shown, 0, after=False, lean=False)
            C, D = self.slopes(series.schedule, "series", series.further)
            y = self.model.seen(shown, [self.row[0]], self.state, self.row, after=False)[0]
        units = {name: input_unit(name, table) for name in self.inputs}
        units |= {name: one.unit for name, one in zip(outputs, shown, strict=True)}
        return StateSpace(
            self.names, self.inputs, tuple(outputs), units, by_state[self.kept], by_input[self.kept], C, D,
            self.state[self.kept], self.row[self.places], y, self.rates(),
        )  # fmt: skip


def plain_name(name: str, outputs: Any) -> str:
    """Behind a rigid gear the motor is where the joint is."""
    return name.replace(".motor.", ".") if name not in outputs else name


def open_loop(
    robot: Robot, inputs: Sequence[str], outputs: Sequence[str], *,
    held: Mapping[str, float | str] | None = None, time: float | None = None, contact: bool = True,
    progress: Any = lambda stage, share: None,
) -> StateSpace:  # fmt: skip
    """The robot without its controllers about the rest at the coordinates ``held`` [rad, m], or at a ``time`` [s].

    ``inputs``: ``JOINT.torque``, ``JOINT.effort`` or ``JOINT.voltage``, ``POINT.force.x`` and ``POINT.moment.x``.
    Efforts hold it there; at a time of its run they are those of its controllers. Raises
    :class:`tmodes.errors.InputError` for unknown names.
    """
    setup, moving = run_setup(robot).chosen() if time is not None else None, {}
    if setup is not None:
        moving, named = _moving(setup, time or 0.0)
    else:
        named = robot_rest(robot, held=held, contact=contact and robot.contact is not None, progress=progress).named
    bare = robot if contact else robot.model_copy(update={"contact": None})
    pushed, loads = with_loads(opened(bare), inputs)
    plan = planned(pushed)
    follow_no("gains that are designed from the robot", plan.plan.drives[0].numbers if plan.plan.drives else ())
    row = plan.first_row.copy() if time is None else row_at(plan, time)
    at = Instant(plan, np.zeros(0), row, columns(pushed, plan, inputs, loads, closed=False))
    names = at.model.coordinates
    at.state[: len(names)] = [named[name] for name in names]
    for driver in at.model.loop.drivers:
        if driver.plan.servo is None:  # a motion that is given stays where it is there
            place = 1 + driver.plan.signal * (plan.plan.degree + 1)
            at.row[place] = named.get(names[driver.coordinate], at.row[place])
    if setup is None:
        _hold(at)
    else:
        _push(at, moving)
    return at.found(outputs)


def _moving(setup: RunSetup, time: float) -> tuple[dict[str, float], dict[str, float]]:
    """Rates, currents and commands by name at a time [s] of a run; and the coordinates [rad, m]."""
    state, row = _state_at(setup, time), row_at(setup.planned, time)
    model, layout, names = setup.model, setup.model.layout, setup.model.coordinates
    pushed = model.observe([time], state, row)["drives"][0]
    found = {f"{name}'": value for name, value in zip(names, state[layout.v], strict=True)}
    found |= {f"{name}.current": value for name, value in zip(model.plan.currents, state[layout.currents], strict=True)}
    for driver, (effort, voltage, *_) in zip(model.loop.drivers, pushed, strict=True):
        found |= {driver.plan.joint: voltage if driver.plan.winding is not Winding.NONE else effort}
    return found, dict(zip(names, state[layout.q], strict=True))


def _push(at: Instant, moving: Mapping[str, float]) -> None:
    """Set rates, currents and commands to those of an instant."""
    layout, plan = at.model.layout, at.plan.plan
    at.state[layout.v] = [moving[f"{name}'"] for name in at.model.coordinates]
    at.state[layout.currents] = [moving[f"{name}.current"] for name in plan.currents]
    for drive in plan.drives:
        if drive.servo:
            at.row[1 + drive.signal * (plan.degree + 1)] = moving[drive.joint]


def _state_at(setup: RunSetup, time: float) -> Array:
    """The state (size,) at a time [s] of a run, before the samples there."""
    return run_trajectory(setup, until=time).states[-1] if time > 0 else setup.start.copy()


def row_at(plan: Planned, time: float) -> Array:
    """The row of the signals at a time [s], as polynomials about it."""
    row, width = plan.schedule.rows_at(np.array([time]))[0].copy(), plan.plan.degree + 1
    pieces, late = row[1:].reshape(-1, width), time - row[0]
    for k in range(width):
        pieces[:, k] = sum(comb(j, k) * late ** (j - k) * pieces[:, j] for j in range(k, width))
    row[0] = time
    return row


def _hold(at: Instant) -> None:
    """Set the commands of all drives, and currents, to what holds the robot where it is: rates are affine in them."""
    plan, layout, n = at.plan.plan, at.model.layout, len(at.model.coordinates)
    width = plan.degree + 1
    free = [drive for drive in plan.drives if drive.servo]
    every = Instant(at.plan, at.state, at.row, [(one.joint, 1 + one.signal * width) for one in free], at.model)
    by_state, by_push = every.slopes(every.model.loop.rate, "rate", np.zeros(0))
    currents = np.arange(layout.currents.start, layout.currents.stop)
    rows = np.append(np.arange(n, 2 * n), currents)
    unknown = np.hstack([by_state[np.ix_(rows, currents)], by_push[rows]])
    found = np.linalg.lstsq(unknown, -every.rates()[rows], rcond=None)[0]
    at.state[currents] += found[: len(currents)]
    at.row[every.places] += found[len(currents) :]


def closed_loop(robot: Robot, inputs: Sequence[str], outputs: Sequence[str], time: float | None = None) -> StateSpace:
    """The robot under its controllers about the start of its run, or a ``time`` [s] of it.

    ``inputs``: ``JOINT.setpoint``, ``JOINT.setpoint_rate``, loads on points.

    Sampled controllers make it a sampled system of their common period, whose inputs are held over it; the state is the
    one before the samples. Raises :class:`tmodes.errors.InputError` for unknown names.
    """
    pushed, loads = with_loads(robot, inputs)
    setup = run_setup(pushed)
    plan, (state, row) = setup.planned, start_of(setup, time)
    if not plan.plan.degree:  # signals that are all constant have rates, too
        plan, row = replace(plan, plan=replace(plan.plan, degree=1)), np.append(row[0], np.c_[row[1:], 0 * row[1:]])
    at = Instant(plan, state, row, columns(pushed, plan, inputs, loads, closed=True))
    found = at.found(outputs)
    return _read(_sampled(at, found) if plan.plan.is_sampled else found, at.model.layout.controls.start)


def _read(found: StateSpace, first: int) -> StateSpace:
    """Without states from ``first`` on that nothing reads, such as the integral of a controller that has no gain."""
    others = np.abs(found.A - np.diag(np.diag(found.A))).max(axis=0) + np.abs(found.C).max(axis=0, initial=0.0)
    return _kept(found, [k for k in range(len(found.A)) if k < first or others[k] > 0])


def without_held(found: StateSpace) -> StateSpace:
    """Without the coordinates that nothing moves."""
    pushed = np.hstack([found.A - (np.eye(len(found.A)) if found.period else 0.0), found.B])
    moved = {name.removesuffix("'") for name, row in zip(found.states, pushed, strict=True) if row.any()}
    n = 2 * next((k for k, name in enumerate(found.states) if name.endswith("'")), 0)
    return _kept(found, [k for k, name in enumerate(found.states) if k >= n or name.removesuffix("'") in moved])


def _kept(found: StateSpace, kept: list[int]) -> StateSpace:
    names = tuple(found.states[k] for k in kept)
    return replace(found, states=names, A=found.A[np.ix_(kept, kept)], B=found.B[kept], C=found.C[:, kept],
                   x0=found.x0[kept], rate=found.rate[kept])  # fmt: skip


def start_of(setup: RunSetup, time: float | None) -> tuple[Array, Array]:
    """State and row at the start of a run, or at a ``time`` [s] of it."""
    if time is None:
        return setup.start.copy(), setup.first_row.copy()
    return _state_at(setup.chosen(), time), row_at(setup.planned, time)


def growth(closed: StateSpace, poles: Any) -> float:
    """How fast the fastest motion of a sampled system grows [1/s]; 0 where none does. ``poles``: its eigenvalues."""
    size = float(np.abs(poles).max(initial=0.0))
    return float(np.log(size) / (closed.period or 1.0)) if size > 1 + _GROWS else 0.0


def _sampled(at: Instant, found: StateSpace) -> StateSpace:
    """The system from one start of the common period of all samples to the next."""
    (n, m), (whole, samples) = found.B.shape, samples_of(at)
    phi, gamma = np.eye(n), np.zeros((n, m))
    for length, _, by_state, by_input in samples:
        Ad, Bd = zero_order_hold(found.A, found.B, length)
        phi, gamma = Ad @ by_state @ phi, Ad @ (by_state @ gamma + by_input) + Bd
    *_, by_state, by_input = samples[0]
    C, D = found.C @ by_state, found.D + found.C @ by_input
    return replace(found, A=phi, B=gamma, C=C, D=D, period=whole)


def samples_of(at: Instant) -> tuple[float, list[tuple[float, Container[int], Array, Array]]]:
    """The common period [s] of all samples, and each instant of it, after the first samples of all.

    Of each the time to the next [s], which clocks are due, and the state after it by the one before and by the inputs.
    """
    exact = [[Fraction(t).limit_denominator(10**9) for t in (one.period, one.after)] for _, one in at.plan.clocks]
    whole, instants = common_period([(period, shift) for period, shift in exact])
    at.sample(_due(at, range(len(exact))))
    return whole, [(length, due, *_after(at, due)) for length, due in instants]


def _after(at: Instant, due: Container[int]) -> tuple[Array, Array]:
    """The state after the samples that are due, by the one before and by the inputs."""
    by_state, by_input = at.slopes(at.model.loop.sampled, "state", np.zeros(0), _due(at, due))
    return by_state[at.kept], by_input[at.kept]


def run_feedback(robot: Robot, rest: Equilibrium) -> Feedback:
    """All that controls a robot about a rest: exact slopes of its run with blocks, samples and delays.

    About the start of its run where that is this rest but for what controllers give way; else with all setpoints where
    the robot rests. Raises as :func:`tmodes.simulation.initial_state.run_setup`.
    """
    bare = robot.model_copy(update={} if rest.contact else {"contact": None})
    vars(bare)["nominal"] = nominal_of(robot)
    setup = run_setup(bare, chain=without_dry_friction(robot.undriven.chain()))
    names, layout, width = setup.model.coordinates, setup.model.layout, setup.planned.plan.degree + 1
    state, row = setup.start.copy(), setup.first_row.copy()
    moved = rest.rates is None and not (setup.rest and np.allclose(setup.rest.q, rest.q, rtol=0.0, atol=_SAME_REST))
    if moved:
        state[layout.q], state[layout.v] = [rest.named[name] for name in names], 0.0
        motions = {drive.joint for drive in robot.drives if drive.command.is_motion}
        for driver in (one for one in setup.model.loop.drivers if one.plan.joint in motions):
            place = 1 + driver.plan.signal * width
            row[place : place + width] = [state[layout.q][driver.coordinate], *[0.0] * (width - 1)]
    at, n = Instant(setup.planned, state, row, ()), len(names)
    if moved:
        at.settle()
    A, _ = (one[at.kept] for one in at.slopes(at.model.loop.rate, "rate", np.zeros(0)))
    own = [names.index(name) for name in rest.model.coordinates]
    order = [*own, *(n + k for k in own), *range(2 * n, len(A))]
    ordered = np.ix_(order, order)
    mass, damping, stiffness = smooth_matrices(rest)
    forces = mass @ A[ordered][n : 2 * n]
    found = Feedback(
        -forces[:, :n] - stiffness, -forces[:, n : 2 * n] - damping, forces[:, 2 * n :], A[ordered][2 * n :],
        len(setup.planned.plan.currents),
    )  # fmt: skip
    if not setup.planned.plan.is_sampled:
        return found
    samples = [(length, by_state[ordered][2 * n :]) for length, _, by_state, _ in samples_of(at)[1]]
    following = [by for _, by in samples[1:] + samples[:1]]
    every, held = _after(at, range(len(setup.planned.clocks)))[0], np.zeros((len(A) - 2 * n, n))
    every = every[ordered][2 * n :]
    for _ in range(1 + setup.planned.plan.most_kept):
        held = every[:, :n] + every[:, 2 * n :] @ held
    return replace(found, samples=tuple(zip([length for length, _ in samples], following, strict=True)), held=held)


def _due(at: Instant, due: Container[int]) -> Array:
    """The row at an instant at which some of the samples are due."""
    row, width = at.row.copy(), at.plan.plan.degree + 1
    for index, (signal, _) in enumerate(at.plan.clocks):
        row[1 + signal * width : 1 + (signal + 1) * width] = 0.0
        row[1 + signal * width] = 0.0 if index in due else 1.0
    return row


def delayed(system: StateSpace, period: float, delay: float = 0.0) -> StateSpace:
    """The system sampled with a zero-order hold: u[k] is held from k T + delay on, for T. Past inputs are states."""
    A, B, C, D = held_late(system.A, system.B, system.C, system.D, period, delay)
    m = B.shape[1]
    kept = (len(A) - len(system.A)) // m if m else 0
    past = tuple(f"{name}[k-{k + 1}]" for k in range(kept) for name in system.inputs)
    x0, rate = np.append(system.x0, np.tile(system.u0, kept)), np.append(system.rate, np.zeros(kept * m))
    return replace(system, states=(*system.states, *past), A=A, B=B, C=C, D=D, x0=x0, rate=rate, period=period)
