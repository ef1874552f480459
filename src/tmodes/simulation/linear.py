"""The robot linear about a rest, or about an instant of a run: x' = A x + B u, y = C x + D u, by exact derivatives.

Dry friction that sticks, and impacts, are left out: they have no derivative. States are coordinates, their rates, motor
currents and the own states of controllers; the matrices are derivatives of the compiled right-hand side of a run, and
of the outputs of its table. Sampled loops: K. J. Astrom, B. Wittenmark, Computer-Controlled Systems, 3rd ed., chapters
2 and 3.
"""

from __future__ import annotations

import copy
from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from math import comb
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.modes.closed_loop import common_period
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.equations.lagrange.registry import SYSTEMS
from tmodes.equations.loop.control_kernels import Winding
from tmodes.errors import InputError
from tmodes.kinds.controllers.discrete import held_late, zero_order_hold
from tmodes.kinds.controllers.registry import LinearPlant
from tmodes.kinds.noted.functions import kept, number, total
from tmodes.kinds.noted.number import Lost, is_noted
from tmodes.kinds.schema.kind import Kind
from tmodes.kinds.signals.registry import constant_signal
from tmodes.model.model import Model
from tmodes.model.passes import derivatives, evaluate
from tmodes.sheet.parts import Command, LoadFrame, LoadSheet
from tmodes.simulation.initial_state import RunSetup, run_setup, run_trajectory
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.plan import Planned, planned

if TYPE_CHECKING:
    from tmodes.kinds.controllers.registry import Block
    from tmodes.sheet import Robot
    from tmodes.sheet.parts import DriveSheet

__all__ = ["StateSpace", "all_inputs", "closed_loop", "delayed", "designed_block", "growth", "open_loop"]

Array = NDArray[np.float64]

_GROWS = 1e-8
"""A sampled pole beyond 1 by less than this is an integrator."""

_LOADS = {"force": ("x", "y", "z"), "moment": ("x", "y", "z")}


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


class _Instant:
    """Exact derivatives at one state and row of a plan."""

    def __init__(self, plan: Planned, state: Array, row: Array, inputs: Sequence[tuple[str, int]]) -> None:
        self.plan, self.model, self.row = plan, LoopModel(plan.plan.unstuck), row
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
        units = {name: one.unit for name, one in zip(outputs, shown, strict=True)}
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
    pushed, loads = _with_loads(opened(bare), inputs)
    plan = planned(pushed)
    _refuse_noted(*plan.plan.drives[0].numbers if plan.plan.drives else ())
    row = plan.first_row.copy() if time is None else _row_at(plan, time)
    at = _Instant(plan, np.zeros(0), row, _columns(pushed, plan, inputs, loads, closed=False))
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
    state, row = _state_at(setup, time), _row_at(setup.planned, time)
    model, layout, names = setup.model, setup.model.layout, setup.model.coordinates
    pushed = model.observe([time], state, row)["drives"][0]
    found = {f"{name}'": value for name, value in zip(names, state[layout.v], strict=True)}
    found |= {f"{name}.current": value for name, value in zip(model.plan.currents, state[layout.currents], strict=True)}
    for driver, (effort, voltage, *_) in zip(model.loop.drivers, pushed, strict=True):
        found |= {driver.plan.joint: voltage if driver.plan.winding is not Winding.NONE else effort}
    return found, dict(zip(names, state[layout.q], strict=True))


def _push(at: _Instant, moving: Mapping[str, float]) -> None:
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


def _row_at(plan: Planned, time: float) -> Array:
    """The row of the signals at a time [s], as polynomials about it."""
    row, width = plan.schedule.rows_at(np.array([time]))[0].copy(), plan.plan.degree + 1
    pieces, late = row[1:].reshape(-1, width), time - row[0]
    for k in range(width):
        pieces[:, k] = sum(comb(j, k) * late ** (j - k) * pieces[:, j] for j in range(k, width))
    row[0] = time
    return row


def _hold(at: _Instant) -> None:
    """Set the commands of all drives, and currents, to what holds the robot where it is: rates are affine in them."""
    plan, layout, n = at.plan.plan, at.model.layout, len(at.model.coordinates)
    width = plan.degree + 1
    free = [drive for drive in plan.drives if drive.servo]
    every = _Instant(at.plan, at.state, at.row, [(one.joint, 1 + one.signal * width) for one in free])
    by_state, by_push = every.slopes(every.model.loop.rate, "rate", np.zeros(0))
    currents = np.arange(layout.currents.start, layout.currents.stop)
    rows = np.append(np.arange(n, 2 * n), currents)
    unknown = np.hstack([by_state[np.ix_(rows, currents)], by_push[rows]])
    found = np.linalg.lstsq(unknown, -every.rates()[rows], rcond=None)[0]
    at.state[currents] += found[: len(currents)]
    at.row[every.places] += found[len(currents) :]


def closed_loop(robot: Robot, inputs: Sequence[str], outputs: Sequence[str], time: float | None = None) -> StateSpace:
    """The robot under its controllers about the start of its run, or a ``time`` [s] of it.

    ``inputs``: ``JOINT.setpoint``, loads on points.

    Sampled controllers make it a sampled system of their common period, whose inputs are held over it; the state is the
    one before the samples. Raises :class:`tmodes.errors.InputError` for unknown names.
    """
    pushed, loads = _with_loads(robot, inputs)
    setup = run_setup(pushed)
    plan, state, row = setup.planned, setup.start.copy(), setup.planned.first_row.copy()
    if time is not None:
        state, row = _state_at(setup.chosen(), time), _row_at(plan, time)
    at = _Instant(plan, state, row, _columns(pushed, plan, inputs, loads, closed=True))
    found = at.found(outputs)
    return _sampled(at, found) if plan.plan.is_sampled else found


def growth(setup: RunSetup) -> float:
    """How fast the fastest motion under sampled controllers grows about the start of a run [1/s]; 0 where none does.

    Dry friction that sticks is left out.
    """
    at = _Instant(setup.planned, setup.start.copy(), setup.planned.first_row.copy(), ())
    found = _sampled(at, at.found(()))
    size = float(np.abs(np.linalg.eigvals(found.A)).max(initial=0.0))
    return float(np.log(size) / (found.period or 1.0)) if size > 1 + _GROWS else 0.0


def _sampled(at: _Instant, found: StateSpace) -> StateSpace:
    """The system from one start of the common period of all samples to the next."""
    exact = [[Fraction(t).limit_denominator(10**9) for t in (one.period, one.after)] for _, one in at.plan.clocks]
    whole, steps = common_period([(period, shift) for period, shift in exact])
    n, m, signals = len(found.A), found.B.shape[1], [k for k, _ in at.plan.clocks]
    phi, gamma, first = np.eye(n), np.zeros((n, m)), (np.eye(n), np.zeros((n, m)))
    at.sample(_due(at, signals, range(len(signals))))
    for k, (length, due) in enumerate(steps):
        row = _due(at, signals, due)
        by_state, by_input = (one[at.kept] for one in at.slopes(at.model.loop.sampled, "state", np.zeros(0), row))
        first = (by_state, by_input) if k == 0 else first
        Ad, Bd = zero_order_hold(found.A, found.B, length)
        phi, gamma = Ad @ by_state @ phi, Ad @ (by_state @ gamma + by_input) + Bd
    C, D = found.C @ first[0], found.D + found.C @ first[1]
    return replace(found, A=phi, B=gamma, C=C, D=D, period=whole)


def _due(at: _Instant, signals: Sequence[int], due: Container[int]) -> Array:
    """The row at an instant at which some of the samples, whose times are ``signals``, are due."""
    row, width = at.row.copy(), at.plan.plan.degree + 1
    for index, signal in enumerate(signals):
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


def opened(robot: Robot) -> Robot:
    """The robot whose drives take commands, all constant; its sensors measure at every instant, without noise."""
    axes = {axis.name: axis for axis in robot.undriven.chain().axes}
    drives = []
    for drive in robot.drives:
        motor = axes[drive.joint].joint.motor
        command = Command.EFFORT if motor is None else Command.TORQUE if motor.resistance is None else Command.VOLTAGE
        own = command if drive.command.is_motion else drive.command
        free = {"command": own, "signal": constant_signal(0.0), "controller": None, "noise": None, "saturation": None,
                "sample_time": None, "delay": 0.0}  # fmt: skip
        drives.append(drive.model_copy(update=free))
    ideal = {"sample_time": None, "delay": 0.0, "noise": 0.0}
    sensors = tuple(sensor.model_copy(update=ideal) for sensor in robot.sensors)
    still = {"base_motion": None, "control": (), "sensors": sensors, "drives": tuple(drives)}
    return robot.model_copy(update=still)


def all_inputs(robot: Robot, *, closed: bool) -> tuple[str, ...]:
    """Names of the commands of all drives; under control of their setpoints."""
    if closed:
        return tuple(f"{drive.joint}.setpoint" for drive in robot.drives if drive.command.is_controlled)
    return tuple(f"{drive.joint}.{drive.command}" for drive in opened(robot).drives if not drive.command.is_motion)


def _with_loads(robot: Robot, inputs: Sequence[str]) -> tuple[Robot, dict[str, int]]:
    """The robot with a load of size zero for each input on a point, and the places of these among its loads."""
    points, loads, places = ("tip", *(point.name for point in robot.points)), list(robot.loads), {}
    for name in inputs:
        point, _, rest = name.rpartition(".")
        point, _, kind = point.rpartition(".")
        if point in points and kind in _LOADS and rest in _LOADS[kind]:
            vector: Any = tuple(float(rest == axis) for axis in "xyz")
            places[name] = len(loads)
            loads.append(LoadSheet(point=point, frame=LoadFrame.WORLD, signal=constant_signal(0.0), **{kind: vector}))
    return (robot.model_copy(update={"loads": tuple(loads)}) if places else robot), places


def _columns(
    robot: Robot, plan: Planned, inputs: Sequence[str], loads: Mapping[str, int], *, closed: bool
) -> list[tuple[str, int]]:
    """Each input with its place in the row; raises :class:`tmodes.errors.InputError` for an unknown one."""
    width, known = plan.plan.degree + 1, dict(_known(robot, plan, closed=closed))
    known |= {name: 1 + plan.plan.loads[place].signal * width for name, place in loads.items()}
    found = []
    for name in inputs:
        if name not in known:
            points = ", ".join(f"{point}.force.x" for point in ("tip", *(one.name for one in robot.points[:2])))
            hint = "add --closed for setpoints" if name.endswith(".setpoint") and not closed else "take one of these"
            raise InputError("inputs", f"the unknown input `{name}`", f"one of {', '.join(known)}, {points}", hint)
        found.append((name, known[name]))
    return found


def _known(robot: Robot, plan: Planned, *, closed: bool) -> Iterator[tuple[str, int]]:
    commands = {drive.joint: drive.command for drive in robot.drives}
    for drive in plan.plan.drives:
        if drive.servo and closed == drive.servo.is_controlled and drive.joint in commands:
            place = 1 + drive.signal * (plan.plan.degree + 1)
            yield f"{drive.joint}.{'setpoint' if closed else commands[drive.joint]}", place
            if closed and plan.plan.degree:  # the second number of a piece is its rate
                yield f"{drive.joint}.setpoint_rate", place + 1


def _refuse_noted(*values: object) -> None:
    """Gains follow from an eigenvalue problem, which a program of noted numbers does not hold."""
    if noted := [one for one in values if is_noted(one)]:
        raise Lost("gains that are designed from the robot", noted[0])


def linear_plant(
    robot: Robot, reads: tuple[str, ...], drives: tuple[str, ...], *, start: bool = False, delay: float = 0.0
) -> LinearPlant:
    """The robot about its rest at the last setpoints, or the first (``start``), under the commands of ``drives``.

    ``reads``: outputs and sensors by name; sensors without samples and noise. The commands act ``delay`` [s] late.
    """
    held = {drive.joint: _setpoint(robot, drive, start=start) for drive in robot.drives if drive.command.is_motion}
    return copy.deepcopy(_plant(_read(robot), _Aside(robot), reads, drives, held, delay))


def designed_block(robot: Robot, block: Block, drives: tuple[str, ...], delay: float) -> Block:
    """A block designed for a robot as known; once for all whose numbers that count are the same.

    Raises :class:`tmodes.errors.InputError` where there is no design.
    """
    ends = [[_setpoint(robot, one, start=start) for one in robot.drives if one.command.is_motion]
            for start in (True, False)]  # fmt: skip
    return _block(_read(robot), _Aside(robot), block, drives, ends, delay)


@kept
def _block(read: Any, aside: _Aside, block: Block, drives: tuple[str, ...], ends: Any, delay: float) -> Block:
    del read, ends
    if noted := [one for one in _numbers(block) if is_noted(one)]:
        raise Lost("gains that are designed by these weights", total(noted))
    return block.designed(partial(linear_plant, aside.robot, delay=delay), drives)


def _numbers(value: Any) -> Iterator[Any]:
    """All that a block holds."""
    if not isinstance(value, (dict, Kind, tuple)):
        yield value
        return
    for one in (
        value.values() if isinstance(value, dict) else dict(value).values() if isinstance(value, Kind) else value
    ):
        yield from _numbers(one)


def _read(robot: Robot) -> tuple[Any, ...]:
    """What a linear form reads of a robot, besides setpoints."""
    fields = tuple((name, value) for name, value in opened(robot) if name not in ("real", "task", "integration"))
    return *fields, SYSTEMS.get(robot.equations)


class _Aside:
    """An argument that changes nothing in the answer."""

    def __init__(self, robot: Robot) -> None:
        self.robot = robot

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Aside)

    def __hash__(self) -> int:
        return 0


@kept
def _plant(
    read: Any, aside: _Aside, reads: tuple[str, ...], drives: tuple[str, ...], held: Mapping[str, Any], delay: float
) -> LinearPlant:
    del read
    robot = aside.robot
    chain = robot.undriven.chain()
    _refuse_noted(*held.values(), delay, *chain.gravity, *Model(chain).parameters)
    names = chain.coordinates
    motors = {f"{joint}.motor" if f"{joint}.motor" in names else joint: value for joint, value in held.items()}
    commands = {drive.joint: drive.command for drive in opened(robot).drives}
    found = open_loop(robot, [f"{joint}.{commands[joint]}" for joint in drives], reads, held=motors)
    size = 2 * len(names) + sum(name.endswith(".current") for name in found.states)
    part = slice(0, size)
    return LinearPlant(
        found.states[part], drives, reads, found.A[part, part], found.B[part], found.C[:, part], found.D,
        found.x0[part], found.u0, found.y0, delay,
    )  # fmt: skip


def _setpoint(robot: Robot, drive: DriveSheet, *, start: bool) -> float:
    duration = robot.integration.duration
    return number(drive.signal.schedule(duration).at(0.0 if start else duration))
