"""Small vibrations of a robot about its rest: frequencies, damping, shapes, dominant elements."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.modes.closed_loop import Feedback, closed_loop_motions
from tmodes.analysis.modes.shapes import Undamped, partners, real_pairs, undamped_shapes
from tmodes.analysis.spectrum import GROWING, RINGS, MotorState
from tmodes.analysis.statics.compliance import SpringStiffness, springs_of
from tmodes.analysis.statics.equilibrium import Equilibrium, driven
from tmodes.chain.chain import Chain, Friction
from tmodes.model.model import Model

__all__ = [
    "LinearServo",
    "MotorState",
    "VibrationMode",
    "closed_loop_poles",
    "modes_about",
    "moving_coordinates",
    "smooth_matrices",
    "without_dry_friction",
]  # fmt: skip

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

_SAME = 1e-6
"""Relative difference of |lambda| and the undamped frequency below which damping leaves it as it is."""

ROUNDING = 1e-13
"""Real over absolute value of an eigenvalue below which its motion is undamped."""


class LinearServo(NamedTuple):
    """What a controller is to a coordinate: ``stiffness`` [N*m/rad, N/m], ``damping`` [N*m*s/rad, N*s/m]."""

    stiffness: float
    damping: float


@dataclass(frozen=True, eq=False)
class VibrationMode:
    """One mode of vibration, or one of the two motions without vibration into which damping has parted it.

    ``pole``: real and imaginary part [1/s] of its eigenvalue lambda, of all matrices (mass, damping, stiffness,
    controllers); from it follow the natural frequency ``frequency_Hz`` = |lambda|/2 pi, the damped one
    ``damped_frequency_Hz`` = Im/2 pi and ``damping_ratio`` = -Re/|lambda|. Of what does not ring, because it is
    over-damped, free or buckles, the first is 0, the second None, and the third 1, 0 and -1; ``time_constant_s`` =
    -1/lambda of each real eigenvalue with which an over-damped mode decays, else None; ``undamped_frequency_Hz``:
    of mass and stiffness alone, those of controllers among them, 0 for a free motion and for one that buckles, None
    for the second motion of an over-damped mode;
    ``element``: where most of its elastic energy is, and the ``share`` of it; ``shares`` of all elements; ``stable`` is
    False where it grows, by the factor e in ``growth_time_s``, else None. ``shape`` (nq,): of the undamped mode, its
    largest entry 1. ``motion`` (nq,): complex, as the damped robot moves.
    """

    frequency_Hz: float
    damped_frequency_Hz: float | None
    damping_ratio: float
    element: str
    share: float
    shares: dict[str, float]
    stable: bool
    growth_time_s: float | None
    time_constant_s: float | None
    pole: list[float]
    shape: Array
    undamped_frequency_Hz: float | None = 0.0
    motion: Complex | None = None


def modes_about(
    rest: Equilibrium,
    motors: MotorState = MotorState.LOCKED,
    servos: Mapping[str, LinearServo] | None = None,
    feedback: Feedback | None = None,
) -> list[VibrationMode]:
    """Modes about a robot at rest, by rising frequency of their undamped shapes; over-damped ones last, slowest first.

    ``motors`` locked: the driven coordinates stand still; free: they turn without current; controlled: they are on the
    springs and dampers ``servos`` of their controllers, or under the ``feedback`` of
    :func:`tmodes.analysis.modes.closed_loop.feedback_of`; those without one stand still. Prescribed joints always stand
    still. Dry friction, which has no slope at rest, is left out. Of a robot of more than 120 coordinates the lowest 60
    modes. Raises :class:`SimulationError` for a mass matrix that is not positive definite.
    """
    chosen = servos or {} if motors is MotorState.CONTROLLED else {}
    moving = moving_coordinates(rest, motors, chosen)
    if not len(moving):
        return []
    springs = springs_of(rest.model, rest.q)
    loop = feedback if chosen and feedback else _springs(rest, chosen)
    for name in chosen:
        k = rest.model.coordinates.index(name)
        held = max(0.0, float(loop.springs[k, k]))
        springs[f"{name.removesuffix('.motor')}.controller"] = _single(rest.model.nq, k, held)
    mass, damping, stiffness, loop = _moving_system(rest, moving, loop)
    undamped = undamped_shapes(mass, stiffness + loop.springs)
    eigenvalues, motions, second = _eigenvalues(mass, damping, stiffness, undamped, loop)
    squares, shapes, zero, _ = undamped
    squares, shapes = (np.concatenate([each, each[..., second]], axis=-1) for each in (squares, shapes))
    whole = np.zeros((rest.model.nq, len(squares)), dtype=shapes.dtype)
    moved = np.zeros(whole.shape, dtype=complex)
    whole[moving], moved[moving] = shapes, motions
    stored = {name: spring.energy(whole) for name, spring in springs.items()}
    alone, modes = not chosen and rest.rates is None, []
    for k, square in enumerate(squares):
        energies = {name: float(part[k]) for name, part in stored.items()}
        mode = _mode(float(square), complex(eigenvalues[k]), whole[:, k], energies, zero, alone)
        first = k < len(squares) - len(second)
        modes.append(replace(mode, motion=moved[:, k], **({} if first else {"undamped_frequency_Hz": None})))
    return sorted(modes, key=lambda mode: -(mode.time_constant_s or np.inf))


def closed_loop_poles(
    rest: Equilibrium, servos: Mapping[str, LinearServo], feedback: Feedback | None = None
) -> Complex:
    """All eigenvalues [1/s] under control, by rising absolute value; those of currents and controllers among them."""
    moving = moving_coordinates(rest, MotorState.CONTROLLED, servos)
    if not len(moving):
        return np.zeros(0, dtype=complex)
    mass, damping, stiffness, loop = _moving_system(rest, moving, feedback or _springs(rest, servos))
    undamped = undamped_shapes(mass, stiffness + loop.springs)
    if undamped.spread:
        mass, damping, stiffness, loop = _spanned(undamped.shapes, mass, damping, stiffness, loop)
    values, _ = closed_loop_motions(mass, damping, stiffness, loop)
    return values[np.lexsort((values.imag, np.abs(values).round(9)))]


def _moving_system(rest: Equilibrium, moving: NDArray[np.intp], loop: Feedback) -> tuple[Array, Array, Array, Feedback]:
    """M, D, K and the feedback of the coordinates that move."""
    block = np.ix_(moving, moving)
    mass, damping, stiffness = (matrix[block] for matrix in smooth_matrices(rest))
    return mass, damping, stiffness, loop.on(np.eye(rest.model.nq)[:, moving])


def _spanned(
    basis: Array, mass: Array, damping: Array, stiffness: Array, loop: Feedback
) -> tuple[Array, Array, Array, Feedback]:
    """The same of the motions that the columns of ``basis`` span."""
    mass, damping, stiffness = (basis.T @ matrix @ basis for matrix in (mass, damping, stiffness))
    return mass, damping, stiffness, loop.on(basis)


def _springs(rest: Equilibrium, servos: Mapping[str, LinearServo]) -> Feedback:
    """Controllers that are springs and dampers."""
    n = rest.model.nq
    stiffness, damping = np.zeros((n, n)), np.zeros((n, n))
    for name, servo in servos.items():
        k = rest.model.coordinates.index(name)
        stiffness[k, k], damping[k, k] = servo
    return Feedback(stiffness, damping, np.zeros((n, 0)), np.zeros((0, 2 * n)))


def _single(size: int, k: int, value: float) -> SpringStiffness:
    row = np.zeros((1, size))
    row[0, k] = 1.0
    return SpringStiffness(row, value * row)


def _eigenvalues(
    mass: Array, damping: Array, stiffness: Array, undamped: Undamped, loop: Feedback
) -> tuple[Complex, Complex, NDArray[np.intp]]:
    """Of each mode [1/s], and its damped motion; then those of the modes, by index, that have two real eigenvalues.

    Where only some modes were found, or their frequencies are far apart, by the motions that they span.
    """
    spanned = shapes = undamped.shapes
    if len(shapes) > shapes.shape[1] or undamped.spread:
        mass, damping, stiffness, loop = _spanned(shapes, mass, damping, stiffness, loop)
        shapes = np.eye(len(mass))
    values, damped = closed_loop_motions(mass, damping, stiffness, loop)
    chosen = partners(mass, shapes, values, damped)
    second, others = real_pairs(mass, values, damped, chosen)
    bound = np.abs(undamped.squares[second]) > undamped.zero  # a free motion is one, whatever rounding makes of it
    second, others = second[bound], others[bound]
    chosen = np.concatenate([chosen, others])
    motions = damped[:, chosen]
    return values[chosen], motions if spanned is shapes else spanned @ motions, second


def moving_coordinates(rest: Equilibrium, motors: MotorState, servos: Mapping[str, LinearServo]) -> NDArray[np.intp]:
    """Indices of the coordinates that move in one of the cases of :func:`modes_about`.

    A rotor without inertia has no motion of its own: it is one whose motion is prescribed.
    """
    model = rest.model
    rotors = {axis.input for axis in model.parts.axes if axis.axis.drive.has_motor}
    prescribed = {*model.parts.held, *(k for k in rotors if not model.rotor_inertias[k])}
    added: Sequence[int] = driven(model) if motors is MotorState.FREE else [model.coordinates.index(n) for n in servos]
    return np.array(sorted(({*rest.free.tolist(), *added}) - prescribed), dtype=np.intp)


def smooth_matrices(rest: Equilibrium) -> tuple[Array, Array, Array]:
    """M, D, K about the rest; dry friction has no part in D."""
    mass, damping, stiffness = rest.matrices
    smooth = without_dry_friction(rest.model.chain)
    if smooth is not None:  # what surfaces add stays
        about = {"wrenches": rest.wrenches, "base": rest.base}
        with_dry, without = (one.linearize(rest.q, rest.rates, **about)[1] for one in (rest.model, Model(smooth)))
        damping = damping - with_dry + without
    return mass, damping, stiffness


def without_dry_friction(chain: Chain) -> Chain | None:
    """The chain with viscous friction only; None where it has no other."""

    def viscous(friction: Friction) -> Friction:
        return replace(friction, coulomb=0.0, static_extra=0.0)

    nodes = []
    for node in chain.nodes:
        motor = node.joint.motor
        own = replace(motor, friction=viscous(motor.friction)) if motor else None
        nodes.append(replace(node, joint=replace(node.joint, friction=viscous(node.joint.friction), motor=own)))
    dry = [friction.coulomb or friction.static_extra for node in chain.nodes for friction in (
        node.joint.friction, *((node.joint.motor.friction,) if node.joint.motor else ()))]  # fmt: skip
    return replace(chain, nodes=tuple(nodes)) if any(dry) else None


def _mode(
    square: float, value: complex, shape: Array, stored: Mapping[str, float], zero: float, alone: bool
) -> VibrationMode:
    """A mode with unit modal mass and twice the energies ``stored`` in the springs; squares up to ``zero`` are none.

    ``alone``: only masses, dampers and springs act.
    """
    shown = shape / shape[np.abs(shape).argmax()]
    total = sum(stored.values())
    if abs(square) <= zero and total <= zero:
        return VibrationMode(0.0, None, 0.0, "whole arm, free", 1.0, {}, True, None, None, [0.0, 0.0], shown)
    shares = {name: energy / total for name, energy in stored.items()} if total > zero else {}
    home = max(shares, key=lambda name: shares[name]) if shares else "whole arm, in its weight and loads"
    size, stable = abs(value), bool(value.real <= GROWING * abs(value))
    rings, undamped = value.imag > RINGS * size, float(np.sqrt(max(square, 0.0)))
    natural = undamped if alone and abs(size - undamped) <= _SAME * size else size  # the same number to more digits
    return VibrationMode(
        frequency_Hz=natural / (2 * np.pi) if rings else 0.0,
        damped_frequency_Hz=value.imag / (2 * np.pi) if rings else None,
        damping_ratio=float(-value.real / size) if abs(value.real) > ROUNDING * size else 0.0,
        element=home,
        share=shares.get(home, 1.0),
        shares=shares,
        stable=stable,
        growth_time_s=None if stable else float(1 / value.real),
        time_constant_s=float(-1 / value.real) if stable and not rings and value.real else None,
        pole=[value.real, value.imag],
        shape=shown,
        undamped_frequency_Hz=undamped / (2 * np.pi),
    )
