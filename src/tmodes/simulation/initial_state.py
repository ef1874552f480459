"""A robot in motion: as its drives are planned, or under control as it really is; from its first state on."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.spectrum import Spectrum, spectrum_of
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.analysis.statics.equilibrium import Equilibrium
from tmodes.chain.chain import Chain
from tmodes.errors import InputError, SimulationError
from tmodes.integrate.choice import chosen_method, implicit_method
from tmodes.integrate.registry import AUTO
from tmodes.integrate.settings import Integration
from tmodes.kinds.noted.functions import array
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.model.model import Model
from tmodes.sheet import Robot
from tmodes.sheet.parts import InitialState
from tmodes.simulation.balance import Balance, begun, frozen
from tmodes.simulation.closed_start import Imbalance, balanced, closes
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.parts import Journal, Trajectory
from tmodes.simulation.plan import Follow, Planned, initial_value, planned, refuse_jumps, starts_at_rest
from tmodes.simulation.problem import Problem, problem_of
from tmodes.simulation.solve import solve
from tmodes.simulation.stops import Stops

__all__ = [
    "RunSetup", "closed_balance", "first_state", "held_at_start", "placed_state", "run_setup", "run_trajectory",
    "slipping", "undeformed",
]  # fmt: skip

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class RunSetup:
    """A robot and all that moves it, prepared once for all that a run and its analysis ask of it.

    ``planned``: its chain, drives and signals; ``model``: its closed loop; ``mechanics``: the model of its chain alone;
    ``rest``: the static equilibrium at the start, None where the run does not begin at rest; ``start`` (size,): the
    first state; ``held`` (size,): that with every motor on its first command, which it is where the robot is in
    balance so; ``off``: why the start is no equilibrium of the closed loop, None where it is one or is not meant to be.
    ``otherwise``: the settings with which to continue where the motion turns out stiff; None: those of the
    robot to the end. ``callback``: a Python function takes the place of the sheet's controllers. ``follow``: what its
    motors do.
    """

    robot: Robot
    planned: Planned
    model: LoopModel
    start: Array
    mechanics: Model
    held: Array
    rest: Equilibrium | None = None
    off: Imbalance | None = None
    otherwise: Integration | None = None
    callback: bool = False
    follow: Follow = Follow.SHEET

    @property
    def first_row(self) -> Array:
        """The row of the signals at time 0."""
        return self.planned.first_row

    @cached_property
    def spectrum(self) -> Spectrum:
        """Eigenvalues of the robot under its drives at its start, by exact derivatives; no joint or motor sticks."""
        model = self.model
        matrix = model.jacobian(0.0, slipping(model, self.start), self.first_row)
        return spectrum_of(matrix, model.coordinates, list(model.plan.further_states))

    @property
    def implicit(self) -> str | None:
        """The method for stiff motion: that which takes what may be stiff at the end of a step; None: none does.

        Extrapolation takes explicitly: smooth friction of a contact, contact inside a beam, coupled drives.
        """
        loop, touch = self.model.loop, self.model.plan.touch
        apart = loop.parts.couplings is not None
        if touch:
            sheet, point = touch.touch.sheet, loop.parts.points[touch.point]
            apart |= (sheet.is_rough and not sheet.sticks) or loop.parts.station(point) is not None
        return implicit_method(self.model.layout.works.start, apart=apart)

    def problem(self, settings: Integration | None = None, schedule: SignalPieces | None = None) -> Problem:
        """As the native loops read it; ``settings`` and ``schedule``: in place of its own."""
        given = schedule or self.planned.schedule, self.start, settings or self.robot.integration
        return problem_of(self.model, self.model.numbers, *given, otherwise=self.otherwise)

    def by(self, method: str, otherwise: Integration | None) -> RunSetup:
        """The same with an integrator chosen, and the settings with which to continue where the motion is stiff."""
        robot = self.robot.model_copy(update={"integration": self.robot.integration.chosen(method)})
        made = replace(self, robot=robot, otherwise=otherwise)
        if "spectrum" in self.__dict__:
            made.__dict__["spectrum"] = self.spectrum
        return made

    def chosen(self) -> RunSetup:
        """The same with the integrator of the robot, chosen by the spectrum where none is named, to the end."""
        given = self.robot.integration
        return self.by(
            chosen_method(given, self.spectrum.highest, self.implicit)[0] if given.method == AUTO else given.method,
            None,
        )


def slipping(model: LoopModel, states: Array) -> Array:
    """States (..., size) in which no joint or motor sticks."""
    found = states.copy()
    modes = found[..., model.layout.modes][..., : len(model.loop.slipping)]
    modes[modes == 0] = 1.0
    return found


def run_setup(
    robot: Robot, follow: Follow = Follow.SHEET, like: RunSetup | None = None, chain: Chain | None = None
) -> RunSetup:
    """A robot ready to run; ``like``: a setup whose chain and rest are taken where its robot is the same.

    ``chain``: taken in place of the robot's own.

    Raises :class:`tmodes.errors.InputError` for what cannot be run, and :class:`tmodes.errors.SimulationError` where
    there is no static equilibrium to start from, or the mass matrix is singular.
    """
    like = like if like and _same(robot, like.robot) else None
    plan = planned(robot, follow, like.planned.chain if like else chain)
    refuse_jumps(robot, plan)
    model, mechanics = LoopModel(plan.plan), Model(plan.chain, trials=True)
    held = held_at_start(robot, model)
    rest = None
    if starts_at_rest(robot):
        rest = _same_rest(like, mechanics, held) or robot_rest(robot, model=mechanics, held=held)
    row = plan.schedule.rows_at(np.zeros(1))
    first = first_state(robot, plan, model, rest)
    first = begun(model, first[None], frozen(model, row), model.numbers)[0]
    placed = model.settled(first, row)
    moved, off = (None, None) if rest is None else balanced(robot, model, mechanics, first, placed, row[0])
    start = placed if moved is None else model.settled(moved, row)
    given = [driver.coordinate for driver in model.loop.drivers if driver.plan.servo is None]
    _check_inertia(mechanics, start[model.layout.q], given)
    accelerations = model.observe([0.0], start, row)["a"][0]
    bad = np.flatnonzero(~np.isfinite(accelerations))
    if len(bad):
        raise SimulationError(
            f"the acceleration at the start is {accelerations[bad[0]]} in coordinate "
            f"{model.coordinates[bad[0]]}; give what it moves a mass and an inertia"
        )
    return RunSetup(robot, plan, model, start, mechanics, placed, rest, off, follow=follow)


def closed_balance(setup: RunSetup) -> Balance | None:
    """The equations of rest by which the start of a setup is found; None where it has held motors anyhow."""
    asked = setup.rest is not None and setup.robot.initial.state is not InitialState.HELD
    return Balance(setup.model) if asked and closes(setup.robot, setup.model) else None


def _check_inertia(mechanics: Model, q: Array, given: Sequence[int]) -> None:
    """Raises :class:`tmodes.errors.SimulationError` where the mass matrix at the start is singular to rounding.

    Coordinates whose motion is ``given`` need no mass.
    """
    moved = np.setdiff1d(np.arange(mechanics.nq), [*mechanics.parts.held, *given])
    mass = mechanics.mass_matrix(q)[np.ix_(moved, moved)]
    sizes = np.sqrt(np.maximum(np.diag(mass), 0.0))
    if not len(moved) or not np.isfinite(mass).all():
        return
    if sizes.min() > 0:
        values, shapes = np.linalg.eigh(mass / np.outer(sizes, sizes))
        if values[0] > np.finfo(float).eps * len(moved):
            return
        sizes = -np.abs(shapes[:, 0])
    raise SimulationError(
        f"the mass matrix at the start is singular: {mechanics.coordinates[moved[np.argmin(sizes)]]} moves no mass in "
        "this pose but as other coordinates do; start in another pose, or give the links between them mass and inertia"
    )


def _same(one: Robot, other: Robot) -> bool:
    """Whether two sheets are of the same robot, whatever their `real` factors and settings say."""
    return one is other or _plant(one) == _plant(other)


def _plant(robot: Robot) -> Robot:
    return robot.model_copy(update={"real": {}, "integration": None})


def _same_rest(like: RunSetup | None, mechanics: Model, held: Mapping[str, float]) -> Equilibrium | None:
    """The rest of another setup where it is the same in the same coordinates."""
    if like is None or like.rest is None or like.mechanics.coordinates != mechanics.coordinates:
        return None
    return like.rest if held_at_start(like.robot, like.model) == held else None


def held_at_start(robot: Robot, model: LoopModel) -> dict[str, float]:
    """The coordinates that drives hold at the start, and where [rad, m]."""
    drivers = model.loop.drivers
    return {model.coordinates[driver.coordinate]: initial_value(robot, driver.plan.joint) for driver in drivers}


def first_state(robot: Robot, plan: Planned, model: LoopModel, rest: Equilibrium | None = None) -> Array:
    """The state (size,) at time 0: at ``rest`` or undeformed, with given coordinates and rates on top.

    What sticks, slips or touches has not switched yet.
    """
    q = rest.q if rest else undeformed(model.coordinates, held_at_start(robot, model))
    return placed_state(robot, plan, model, q)


def placed_state(robot: Robot, plan: Planned, model: LoopModel, q: Array) -> Array:
    """The same in the pose ``q`` (nq,)."""
    names, layout = model.coordinates, model.layout
    state = np.zeros(layout.size, dtype=object)
    state[layout.controls] = model.plan.controls
    state[layout.q] = q
    motors = {name.removesuffix(".motor"): name for name in names if name.endswith(".motor")}
    for group, block in (("coordinates", layout.q), ("rates", layout.v)):
        info: Mapping[str, float] = getattr(robot.initial, group)
        for name, value in info.items():
            if name not in names:
                known = ", ".join(names[:8]) + ("..." if len(names) > 8 else "")
                raise InputError(f"initial.{group}.{name}", "an unknown coordinate", f"one of {known}", "correct it")
            state[block][names.index(name)] = value
            if group == "rates" and name in motors and motors[name] not in info:
                state[block][names.index(motors[name])] = value
    positions, rates = (plan.signals_at_start(derivative) for derivative in (0, 1))
    rates[[signal for signal, _ in plan.plan.jolts]] -= rates[[jump for _, jump in plan.plan.jolts]]  # before them
    for driver in model.loop.drivers:
        if driver.plan.servo is None:
            state[layout.q.start + driver.coordinate] = positions[driver.plan.signal]
            state[layout.v.start + driver.coordinate] = rates[driver.plan.signal]
    return array(state)


def undeformed(names: tuple[str, ...], held: Mapping[str, float]) -> Array:
    """Each joint where its motor is, nothing bent."""
    return array([held.get(name, held.get(f"{name}.motor", 0.0)) for name in names])


def run_trajectory(
    setup: RunSetup,
    progress: Callable[[float], None] = lambda share: None,
    journal: Journal | None = None,
    until: float | None = None,
    stops: Stops | None = None,
) -> Trajectory:
    """Integrate from the start of a setup, until the first of ``stops`` triggers.

    ``until`` [s] ends the run before its duration (it is then kept in no journal); 0 gives the first sample alone.
    """
    if until is None:
        return solve(setup.problem(), events=stops, journal=journal, progress=progress)
    if until <= 0:
        return Trajectory(np.zeros(1), setup.start[None, :], "stopped", "not begun")
    settings = setup.robot.integration.model_copy(update={"duration": until})
    return solve(setup.problem(settings), events=stops, progress=progress)
