"""RunData: a motion as arrays of numbers, frozen; and how it is gathered from a trajectory."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.energy import largest_flow
from tmodes.chain.chain import Chain
from tmodes.equations.loop.layout import BROUGHT_IN, WORKS
from tmodes.model.model import Model, PointMotion
from tmodes.model.rows import StateRows
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import RunSetup
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.parts import Trajectory
from tmodes.simulation.plan import Planned

__all__ = ["RunData", "bytes_per_sample", "energies_of", "gathered", "tip_motion"]

Array = NDArray[np.float64]

_CHUNK = 20_000


@dataclass(frozen=True, eq=False, kw_only=True)
class RunData(Trajectory):
    """A trajectory of ``setup`` at n samples and all that follows from it, SI units.

    ``q``, ``v``, ``a`` (n, nq) in the order of ``coordinates``. Of the drives, in the order of ``drives`` (their
    joints): ``effort`` (n, drives), of the motor after the reducer, or of the joint without a motor; ``voltage`` and
    ``current``, 0 where there is no electric side; ``wanted``, the value of the drive's signal; ``gear_torque``, 0
    where no gear is elastic. ``controls`` (n, states): own states of the controllers, after the samples at each time.
    ``points``: motion of the named points. ``contact_force`` (n, 3), by the point on the surface; ``contact_normal``
    (n,) its part into the surface; ``penetration`` (n,) [m]; ``surface`` (n, 2): displacement [m] and velocity [m/s],
    into it, of a surface with mass that only pushes; ``contact_fold`` (n,), see
    :func:`tmodes.simulation.warnings.jam_warnings`; None without contact. ``base`` (n, 24): acceleration less gravity
    (6) and rate (3) in base axes, pose and velocity in the world (15). ``energies`` and ``works`` (n,) [J] by kind:
    works of ``motor``, ``loads`` and ``base`` are brought in, the others taken out. ``reference``: the same of the
    nominal robot whose motors are where they should be; None where no such motion is possible.
    """

    setup: RunSetup
    q: Array
    v: Array
    a: Array
    effort: Array
    voltage: Array
    current: Array
    wanted: Array
    gear_torque: Array
    controls: Array
    points: PointMotion
    contact_force: Array | None = None
    contact_normal: Array | None = None
    penetration: Array | None = None
    surface: Array | None = None
    contact_fold: Array | None = None
    base: Array
    energies: dict[str, Array]
    works: dict[str, Array]
    warnings: tuple[str, ...] = ()
    reference: RunData | None = None

    @property
    def robot(self) -> Robot:
        """The robot that ran."""
        return self.setup.robot

    @property
    def planned(self) -> Planned:
        """What moves it, and its signals."""
        return self.setup.planned

    @property
    def chain(self) -> Chain:
        """Its chain, driven as planned."""
        return self.setup.planned.chain

    @property
    def model(self) -> Model:
        """The model of its chain."""
        return self.setup.mechanics

    @property
    def drives(self) -> tuple[str, ...]:
        """The joints of its drives."""
        return tuple(drive.joint for drive in self.planned.plan.drives)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the coordinates."""
        return self.model.coordinates

    @property
    def energy_balance(self) -> Array:
        """Residual of the energy balance at each sample [J], shape (n,)."""
        total = np.sum([*self.energies.values()], axis=0)
        brought = np.sum([self.works[name] for name in WORKS[:BROUGHT_IN]], axis=0)
        taken = np.sum([self.works[name] for name in WORKS[BROUGHT_IN:]], axis=0)
        return total - total[0] - brought + taken

    @property
    def energy_moved(self) -> float:
        """The largest change of any kind of energy, work of any kind, or kinetic energy, within the run [J]."""
        return largest_flow(np.column_stack([*self.energies.values()]), np.column_stack([*self.works.values()]))

    @property
    def energy_there(self) -> float:
        """The largest energy of any kind [J]."""
        return float(max(np.abs(values).max() for values in self.energies.values()))


def bytes_per_sample(model: LoopModel) -> int:
    """Memory that one sample takes while a run is gathered [bytes]."""
    n, points, drives = len(model.coordinates), len(model.loop.parts.points), len(model.loop.drivers)
    return 8 * (2 * model.layout.size + 9 * n + 12 * drives + 60 * points + 80 + model.plan.row_size)


def gathered(setup: RunSetup, trajectory: Trajectory, rows: Array | None = None) -> RunData:
    """All that a run shows, of the samples of its trajectory; ``rows`` (n, row) where they are not the schedule's."""
    plan, loop, model = setup.planned, setup.model, setup.mechanics
    times, states = trajectory.times, trajectory.states
    seen = _observed(loop, times, states, plan.schedule.rows_at(times) if rows is None else rows)
    q, v, a, base = (seen[name] for name in ("q", "v", "a", "base"))
    moving = base.copy()
    moving[:, 3:6] += base[:, 9:18].reshape(-1, 3, 3).transpose(0, 2, 1) @ np.asarray(plan.chain.gravity, dtype=float)
    effort, voltage, current, wanted = (seen["drives"][:, :, k] for k in range(4))
    contact: dict[str, Any] = {} if not plan.plan.touch else {
        "contact_force": seen["contact"][:, :3], "contact_normal": seen["contact"][:, 3],
        "penetration": seen["contact"][:, 4], "contact_fold": seen["contact_fold"][:, 0],
    }  # fmt: skip
    if plan.plan.surface_names:
        contact["surface"] = states[:, loop.layout.surface]
    return RunData(
        **vars(trajectory), setup=setup, q=q, v=v, a=a, effort=effort, voltage=voltage, current=current, wanted=wanted,
        gear_torque=seen["gear"], controls=seen["controls"], points=model.points(q, v, a, base=moving), **contact,
        base=base, energies=energies_of(setup, model, q, v, base),
        works=dict(zip(WORKS, states[:, loop.layout.works].T, strict=True)),
    )  # fmt: skip


def tip_motion(setup: RunSetup, times: Array, states: Array) -> tuple[Array, Array]:
    """Position [m] and velocity [m/s] of the tip in the world at n instants (n, 3)."""
    base, layout = None, setup.model.layout
    if setup.planned.plan.base:
        base = setup.model.observe(times, states, setup.planned.schedule.rows_at(times))["base"]
    motion = setup.mechanics.points(states[:, layout.q], states[:, layout.v], base=base)
    return motion.position[:, 0], motion.velocity[:, 0]


def _observed(loop: LoopModel, times: Array, states: Array, rows: Array) -> dict[str, Array]:
    pieces = [
        loop.observe(times[k : k + _CHUNK], states[k : k + _CHUNK], rows[k : k + _CHUNK])
        for k in range(0, len(times), _CHUNK)
    ]
    return {name: np.concatenate([piece[name] for piece in pieces]) for name in pieces[0]}


def energies_of(setup: RunSetup, model: Model, q: Array, v: Array, base: Array) -> dict[str, Array]:
    """Energies by kind [J]; the motion of the base and rotors that follow their signals have theirs too."""
    energies = model.energies(q, v)
    if setup.planned.plan.base:
        energies |= _moved(model, q, v, base)
    for driver in setup.model.loop.drivers:
        motor = driver.part.node.joint.motor
        if driver.part.given >= 0 and motor:
            energies["kinetic"] = energies["kinetic"] + motor.inertia * v[:, driver.part.angle] ** 2 / 2
    return energies


def _moved(model: Model, q: Array, v: Array, base: Array) -> dict[str, Array]:
    """Kinetic energy and that of gravity on a base that moves: half of the rates times their momenta."""
    turned = base[:, 9:18].reshape(-1, 3, 3)
    velocity = np.einsum("nji,nj->ni", turned, base[:, 21:24])
    rates = np.column_stack([base[:, 6:9], velocity])
    row = np.column_stack([rates, np.zeros((len(q), 3)), base[:, 9:21], np.zeros((len(q), 3))])
    found = model.passes.inertia(StateRows(q, 0.0, model.nq, finite=not model.trials), v, row, None)
    kinetic = ((found["forces"] * v).sum(axis=1) + (found["base_force"] * rates).sum(axis=1)) / 2
    return {"kinetic": kinetic, "gravity": -found["moment"] @ np.asarray(model.chain.gravity, dtype=float)}
