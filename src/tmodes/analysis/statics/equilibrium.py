"""Static equilibrium of a model: the pose, and whether it is stable."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.analysis.quasistatic import gear_inputs, gross_motion, sprung
from tmodes.analysis.statics.loads import Load, acts_of, check_names, coordinate_numbers, surface_act
from tmodes.analysis.statics.path import LoadPath, Progress, follow
from tmodes.analysis.statics.stability import moving_stability
from tmodes.analysis.statics.system import StaticSystem
from tmodes.errors import InputError
from tmodes.frame import rotation_vector
from tmodes.io.arguments import checked_arguments, numbers_of
from tmodes.io.words import several
from tmodes.kinds.contacts.registry import Contact
from tmodes.kinds.noted.functions import array
from tmodes.kinds.signals.contract import Signal
from tmodes.model.model import Model
from tmodes.sheet import Robot

__all__ = [
    "Equilibrium",
    "Load",
    "base_spin",
    "driven",
    "equilibrium",
    "free_coordinates",
    "held_coordinates",
    "is_unsteady",
    "steady_rates",
    "whole_rates",
]

Array = NDArray[np.float64]

_CHANGE = 1e-6
"""Change of forces in motion at constant speed, over their parts, beyond which it is more than rounding."""

_END = 0.9
"""Share of the run from which a speed must stay the same to be the steady one."""

_SAME = 1e-6
"""Change of a speed, over its largest, that is rounding of a fitted signal."""

_STILL = 1e-9
"""Way in the run, over the largest position (at least 1 rad or m), that is rounding."""


def steady_rates(robot: Robot, model: Model) -> dict[str, float]:
    """Coordinates whose position a drive moves at constant speed to the end of the run, and how fast [rad/s, m/s]."""
    found = {}
    for drive in robot.drives:
        names = [name for name in (f"{drive.joint}.motor", drive.joint) if name in model.coordinates]
        rate = _last_rate(drive.signal, robot.integration.duration) if drive.command.is_motion and names else 0.0
        if rate:
            found[names[0]] = rate
    return found


def base_spin(robot: Robot) -> Array | None:
    """Rate (3,) at which the base turns to the end of the run, at constant speed about one of its axes [rad/s]."""
    if robot.base_motion is None:
        return None
    rates = [_last_rate(turn, robot.integration.duration) if turn else 0.0 for turn in robot.base_motion.turns]
    return np.array(rates) if np.count_nonzero(rates) == 1 else None


def _last_rate(signal: Signal, duration: float) -> float:
    """The constant rate at the end of a signal; 0 where it stands, or its rate changes.

    Of a move that comes to its own end: at that end, also where the run is over before.
    """
    until = max(duration, 1.25 * (signal.move_ends() or 0.0))
    schedule = signal.schedule(until)
    times = np.linspace(0.0, until, 201)
    positions, rates = schedule.at(times), schedule.at(times, 1)
    last = rates[times >= _END * until]
    changes = np.ptp(last) > _SAME * np.abs(rates).max()
    stands = abs(last[-1]) * until <= _STILL * max(float(np.abs(positions).max()), 1.0)
    return 0.0 if changes or stands else float(last.mean())


def whole_rates(model: Model, named: Mapping[str, float] | None, *, base: bool) -> Array | None:
    """Rates (nq,): those given by name, and those of the joints whose gears they turn; None: nothing moves."""
    if not (named or base):
        return None
    rates = np.zeros(model.nq)
    for name, value in (named or {}).items():
        rates[model.coordinates.index(name)] = value
    turned = gross_motion(model, rates[None])[0]
    return np.where(rates, rates, turned)


def is_unsteady(system: StaticSystem, stiffness: Array) -> bool:
    """Whether forces along the free coordinates change as a robot (``stiffness`` (nq, nq)) moves on at its rates."""
    if system.rates is None:
        return False
    change, parts = stiffness[system.free] @ system.rates, np.abs(stiffness[system.free]) @ np.abs(system.rates)
    largest = float(np.abs(stiffness).max(initial=0.0) * np.abs(system.rates).max(initial=0.0))
    joints = np.abs(change) / np.maximum(parts, 1e-9 * max(largest, 1e-300))
    return float(joints.max(initial=0.0)) > _CHANGE or not (system.spin is None or _turns_with(system, system.spin))


def _turns_with(system: StaticSystem, spin: Array) -> bool:
    """Whether weight and loads stay the same as seen by a base that turns."""
    row, axis = system.base(1.0), spin / np.linalg.norm(spin)
    along = np.linalg.norm(np.cross(row[3:6], axis)) <= _CHANGE * np.linalg.norm(row[3:6])
    return bool(along) and all(act.turns_with(row[9:18].reshape(3, 3) @ axis) for act in system.acts)


@dataclass(frozen=True)
class UnstableMode:
    """A motion that grows: in which coordinate most, at which rate [1/s]; its frequency [Hz], 0 for buckling."""

    coordinate: str
    rate: float
    frequency_Hz: float


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """A robot at rest in the pose ``q`` (nq,).

    ``residual``: force left over against the largest in play. ``lowest_frequency_Hz``: of the undamped robot with its
    held coordinates fixed; 0 where it is not ``stable``, infinite where nothing is free. ``neutral``: where nothing
    grows, coordinates that move without a force, one for each motion that nothing holds: the robot stays wherever it is
    put along them; it is then not ``stable``. ``load_path`` (stations,
    1 + nq): load factor and pose on the way; ``lost_stability_at``: load factor at which the robot first lost its
    stability (buckled), None where it did not. ``free``: indices of the coordinates that were found. ``matrices``: M,
    D, K (nq, nq) about the pose, with the stiffness of loads and surfaces. ``wrenches`` (points, 6): what acts on the
    points, world axes, None for nothing. ``rates`` (nq,): of the steady motion in which it is at rest relative to what
    turns, None where it stands; in motion ``lowest_frequency_Hz`` is not a number, and ``stable`` counts damping and
    gyroscopic forces. ``efforts``: of drives, by coordinate [N*m, N].
    ``base`` (24,): the row of its base, with its rate; ``unsteady``: weight, loads or joints change that motion.
    ``contact``: the surface that it may touch.
    """

    model: Model
    q: Array
    residual: float
    stable: bool
    neutral: tuple[str, ...]
    lowest_frequency_Hz: float
    unstable_modes: tuple[UnstableMode, ...]
    load_path: Array
    lost_stability_at: float | None
    free: NDArray[np.intp]
    matrices: tuple[Array, Array, Array] = field(repr=False)
    wrenches: Array | None
    unloaded: Array
    """Pose without weight and loads (nq,)."""
    rates: Array | None
    efforts: Mapping[str, float]
    base: Array
    unsteady: bool
    contact: Contact | None

    @property
    def named(self) -> dict[str, float]:
        """Coordinates by name [rad, m]."""
        return dict(zip(self.model.coordinates, self.q.tolist(), strict=True))

    @property
    def moving(self) -> dict[str, float]:
        """What is in steady motion, coordinates and ``base``, and how fast [rad/s, m/s]."""
        rates = np.zeros(0) if self.rates is None else self.rates
        named = dict(zip(self.model.coordinates, rates.tolist(), strict=False))
        return {name: rate for name, rate in {**named, "base": float(self.base[6:9].sum())}.items() if rate}

    def displacement(self, point: int = 0) -> tuple[Array, Array]:
        """Travel (3,) [m] and rotation vector (3,) [rad] of a point from the unloaded robot, world axes."""
        (before, after), turns = self.model.pose(np.stack([self.unloaded, self.q]))
        return after[point] - before[point], rotation_vector(turns[1, point] @ turns[0, point].T)


@checked_arguments
def equilibrium(
    model: Model,
    loads: Sequence[Load] = (),
    *,
    held: Mapping[str, float | str] | None = None,
    free: str | Sequence[str] = (),
    start: Mapping[str, float | str] | None = None,
    contact: Contact | None = None,
    rates: Mapping[str, float | str] | None = None,
    spin: ArrayLike | None = None,
    efforts: Mapping[str, float] | None = None,
    progress: Progress = lambda stage, share: None,
) -> Equilibrium:
    """The pose in which a robot rests under its weight and ``loads``, reached from the unloaded arm.

    Motors and joints that are driven directly or prescribed are held: at ``held`` [rad, m], else at ``start``, else at
    0; a joint behind an elastic gear is held by its motor, unless that is named too; all other coordinates, and those
    named in ``free``, and those on which ``efforts`` [N*m, N] act, are found, from ``start`` on. The load, weight
    included, and with it the centrifugal forces of steady ``rates`` of held coordinates [rad/s, m/s] and of a base that
    turns at ``spin`` (3,) [rad/s] in its own axes, rises from nothing in steps that keep to their branch (Crisfield,
    Non-linear Finite Element Analysis of Solids and Structures 1, 1991, ch. 9); a robot with loose joints first sinks
    to where a thousandth of the load puts it.

    Raises :class:`tmodes.errors.InputError` for an unknown name or a number that is not finite, and
    :class:`tmodes.errors.SimulationError` with the last load factor reached where the whole load finds no rest.
    """
    acts = acts_of(model, loads)
    acts += [surface_act(model, contact)] if contact else []
    turning = None if spin is None else numbers_of(spin, "spin", ((3,),), "rad/s in the axes of the base")
    fixed = held_coordinates(model, coordinate_numbers(model, held))
    first = coordinate_numbers(model, start)
    moving = whole_rates(model, coordinate_numbers(model, rates, rate=True), base=turning is not None)
    pushed = coordinate_numbers(model, efforts, effort=True)
    loose = free_coordinates(model, fixed, [*several("free", free), *pushed])
    system = StaticSystem(model, acts, loose, moving, turning, pushed)
    pose = starting_pose(model, fixed, first)
    return _info(system, follow(system, pose, progress), pose, contact)


def _info(system: StaticSystem, path: LoadPath, pose: Array, contact: Contact | None) -> Equilibrium:
    model, end = system.model, path.end
    matrices, found = system.matrices(end.q, 1.0), end.stability
    if system.rates is not None:
        mass, damping, stiffness = (matrix[system.block] for matrix in matrices)
        found = moving_stability(mass, damping, stiffness, system.reach(end.q))
    growing = (
        UnstableMode(model.coordinates[system.free[one.coordinate]], one.rate, one.frequency_Hz)
        for one in found.growing
    )
    return Equilibrium(
        model=model, q=end.q, residual=end.residual, stable=found.stable,
        neutral=tuple(model.coordinates[system.free[k]] for k in found.neutral),
        lowest_frequency_Hz=found.lowest_frequency_Hz, unstable_modes=tuple(growing),
        load_path=np.array([[station.factor, *station.q] for station in path.stations]),
        lost_stability_at=path.lost_at if system.rates is None else None, free=system.free, matrices=matrices,
        wrenches=system.wrenches(end.q), unloaded=path.stations[0].q if path.stations[0].factor == 0.0 else pose,
        rates=system.rates, efforts=system.efforts, base=system.base(1.0), unsteady=is_unsteady(system, matrices[2]),
        contact=contact,
    )  # fmt: skip


def held_coordinates(model: Model, held: Mapping[str, float]) -> dict[str, float]:
    """The coordinates that are held where a pose is asked for.

    A joint behind an elastic gear is held by its motor and gives way to its load: its name is that of the motor, unless
    that is named too.
    """
    motors = {name: f"{name}.motor" for name in held}
    return {
        motor if motor in model.coordinates and motor not in held else name: held[name]
        for name, motor in motors.items()
    }


def driven(model: Model) -> list[int]:
    """Coordinates that a drive holds: motors before elastic gears, and joints driven directly or prescribed."""
    return sorted(axis.input for axis in model.parts.axes if axis.axis.drive.is_driven)


def free_coordinates(model: Model, held: Mapping[str, float], free: Sequence[str]) -> NDArray[np.intp]:
    """Indices of the coordinates to be found: all but the driven ones and ``held``, and those named ``free``."""
    check_names(model, (*held, *free))
    both = sorted({*held} & {*free})
    if both:
        got, hint = "a coordinate that is also held", "take it out of one of the two"
        raise InputError(f"free: {both[0]}", got, "held or free, not both", hint)
    still = {model.coordinates[k] for k in driven(model)} | {*held}
    names = enumerate(model.coordinates)
    return np.array([k for k, name in names if name in free or name not in still], dtype=np.intp)


def starting_pose(model: Model, held: Mapping[str, float], start: Mapping[str, float]) -> Array:
    """The unloaded pose (nq,): ``held`` and ``start`` as given, joints behind gears where their motors put them."""
    given = {**start, **held}
    q = np.zeros(model.nq, dtype=object)
    names = list(model.coordinates)
    q[model.motors] = [given.get(names[k], given.get(names[k].removesuffix(".motor"), 0.0)) for k in model.motors]
    q[sprung(model)] = gear_inputs(model, array(q)[None], rest=True)[0]
    for name, value in given.items():
        q[names.index(name)] = value
    return array(q)
