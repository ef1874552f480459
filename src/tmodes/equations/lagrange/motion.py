"""A system on a chain, and its equations at one instant: the counterpart of the recursion's passes.

The bodies' coordinates are the joints' and the links'; motors behind elastic gears are the drives' own.
"""

from __future__ import annotations

from typing import Any

import casadi as ca
import numpy as np

from tmodes.equations.lagrange.kernels import SystemKernels, entries, unpacked
from tmodes.equations.lagrange.solving import Solver, push_rows_kernel
from tmodes.equations.lagrange.system import System
from tmodes.equations.recursion.driven import Coordinates, Driven, Drives
from tmodes.equations.recursion.forces import elastic_of_drives
from tmodes.equations.recursion.forward import ahead_kernel
from tmodes.equations.recursion.hinge import PLACEMENT
from tmodes.equations.recursion.parts import AxisPart, Parts
from tmodes.equations.recursion.passes import Blocks
from tmodes.errors import InputError
from tmodes.kinds.kernel.schedule import Divisible, Kernel, Schedule, Slot
from tmodes.kinds.noted.functions import allclose, array, number

__all__ = ["ChainedSystem", "LagrangeDynamics", "LagrangeWay", "elastic_forces", "forward_schedule", "inertia_forces"]


class ChainedSystem:
    """A system on a chain: which coordinate is which, which point is which, and its parameters."""

    def __init__(self, system: System, parts: Parts) -> None:
        """Raises :class:`tmodes.errors.InputError` where chain and system do not belong together."""
        self.system, self.parts = system, parts
        self.kernels = SystemKernels(system, _columns(system, parts))
        self.held = tuple(index - parts.joints.start for index in parts.held)
        gravity = array(parts.chain.gravity)
        square = number(gravity @ gravity)
        block = parts.numbers.block
        self.parameters = block(system.values(parts.chain))
        self.unit = block(gravity / square if square else gravity)
        self.straight = block([*np.eye(3).ravel(), *np.zeros(PLACEMENT - 9)])
        self.none = block(np.zeros(self.kernels.own))
        self.points = _points(system, parts)
        placed = parts.chain.base
        if not (allclose(placed.rotation, np.eye(3)) and allclose(placed.position, 0)):
            expected = f"left out: the system `{system.name}` stands in the world's axes"
            raise InputError("base", "a placed base", expected, "remove `base`")

    @property
    def zeros(self) -> tuple[Slot, ...]:
        """Parameters that are zero whatever the robot's numbers."""
        return *self.parts.none.values(), self.none, self.straight.part(9, PLACEMENT - 9)

    def bodies(self, block: Divisible) -> Slot:
        """The joints' and links' part of a block of all coordinates."""
        return block.part(self.parts.joints.start, self.kernels.bodies)

    def blocks(self) -> Blocks:
        """Inputs of a new schedule."""
        blocks = Blocks.as_inputs(self.parts)
        blocks.schedule.zeros = self.zeros
        return blocks


def _columns(system: System, parts: Parts) -> Any:
    """The constant map from the bodies' coordinates to those of the energies; missing coordinates stand at zero."""
    names = parts.names[parts.joints.start :]
    matched = list(system.matches(names) if system.matches else system.coordinates)
    if missing := [name for name in names if name not in matched]:
        got = f"the coordinate `{missing[0]}`, which the system `{system.name}` has not"
        expected = f"those of coordinates among {', '.join(system.coordinates)}"
        raise InputError("equations", got, expected, "name joints as the system's coordinates, or take its robot()")
    selected = np.zeros((len(matched), len(names)))
    for row, name in enumerate(matched):
        if name in names:
            selected[row, names.index(name)] = 1.0
    return system.basis() @ selected


def _points(system: System, parts: Parts) -> list[str | None]:
    """The name in the system of each of the chain's points; the first is the tip, None stands at the origin."""
    names = list(system.expressions.points)
    found: list[str | None] = []
    for k, point in enumerate(parts.points):
        if point.name in names:
            found.append(point.name)
        elif k == 0:
            found.append(names[0] if names else None)
        else:
            expected = f"one of {', '.join(names)}" if names else "no further points"
            got = f"the point `{point.name}`, which the system `{system.name}` has not"
            raise InputError("points", got, expected, "add it to the system's points, or remove it")
    return found


class LagrangeWay(Coordinates):
    """Blocks of one schedule: where the points are, and what acts on them."""

    def __init__(self, chained: ChainedSystem, blocks: Blocks) -> None:
        super().__init__(chained.parts, blocks.schedule, blocks.q, blocks.v)
        self.chained, self.base = chained, blocks.base
        self.contact: tuple[int, Any, Slot, Slot] | None = None

    def call(self, kernel: Kernel, *blocks: Slot) -> tuple[Slot, ...]:
        """Call a kernel; its outputs are new blocks."""
        return self.schedule.call(kernel, *blocks)

    def bodies(self, block: Divisible) -> Slot:
        """The joints' and links' part of a block of all coordinates."""
        return self.chained.bodies(block)

    @property
    def state(self) -> tuple[Slot, Slot, Slot]:
        """Bodies' coordinates and rates, and the system's parameters."""
        return self.bodies(self.q), self.bodies(self.v), self.chained.parameters

    @property
    def pull(self) -> Slot:
        """The base's acceleration less gravity."""
        return self.base.part(3, 3)

    def pose(self, k: int) -> tuple[Slot, Slot]:
        """Pose and velocity of a point, and its rate, in world axes."""
        pose, rate = self.call(self.chained.kernels.pose(self.chained.points[k]), *self.state)
        return pose, rate

    def frame_of(self, k: int) -> tuple[Slot, Slot, Slot]:
        """A point's own frame: its rate is not needed, because nothing is off its origin."""
        pose = self.pose(k)[0]
        return pose, pose, self.none[3]

    def offset(self, k: int) -> Slot:
        """Points stand in their own frames."""
        del k
        return self.chained.straight

    def takes_mass(self, k: int) -> bool:
        """Every point may carry an inertia."""
        del k
        return True

    def touched(self, k: int, touch: Any, numbers: Slot, wrench: Slot, step: Slot | None, mode: Slot) -> None:
        """A contact on a point, which is solved for with the accelerations."""
        del mode
        if touch.sheet.sticks:  # its push is a wrench like any other, and so are those that hold the point
            self.wrenches[k] = wrench
        else:
            self.contact = (k, touch, numbers, step or self.none[1])

    def lever(self, k: int, *, mapped: bool = True) -> Slot:
        """Generalized forces of unit forces and moments on a point."""
        kernels = self.chained.kernels
        (found,) = self.call(kernels.lever(self.chained.points[k], mapped=mapped), *self.state)
        return found

    def link_losses(self) -> list[Slot]:
        """Power lost in the system's dampers [W]."""
        return [self.call(self.chained.kernels.elastic(), *self.state)[2]]

    def pushed(self) -> Slot:
        """Generalized forces of all wrenches on points."""
        own = self.chained.kernels.own
        rows = self.chained.none
        for k, wrench in self.wrenches.items():
            (rows,) = self.call(push_rows_kernel(own), self.lever(k), wrench, rows)
        return rows

    def met(self) -> tuple[Slot, ...]:
        """What the solution needs of a contact: levers, drift, and its affine law; nothing where nothing is touched."""
        if self.contact is None:
            return ()
        k, touch, numbers, step = self.contact
        name = self.chained.points[k]
        (drift,) = self.call(self.chained.kernels.drift(name), *self.state, self.pull)
        law = self.call(touch.affine(), self.pose(k)[0], numbers, step)
        return self.lever(k), self.lever(k, mapped=False), drift, *law, self.bodies(self.v)


class LagrangeDynamics(Driven):
    """The system's rows under drives, springs and forces on points, solved for the accelerations."""

    way: LagrangeWay

    def run(self) -> list[Slot]:
        """Add all calls; the accelerations of the coordinates, in their order."""
        way, chained = self.way, self.way.chained
        kernels, none = chained.kernels, way.none[1]
        first = self.parts.joints.start
        efforts, own = [none] * len(self.parts.joints), [none] * len(self.parts.joints)
        for axis in self.parts.axes:
            efforts[axis.angle - first], own[axis.angle - first] = self.drive(axis)
        self.couple_motors()
        mass, bias = way.call(kernels.terms(), *way.state, way.pull, chained.unit)
        start = way.bodies(self.start[0]), way.bodies(self.start[1])
        force, added = way.call(kernels.soft(), *start, chained.parameters, self.step)
        met = way.met()
        self._solver = Solver(kernels, len(self.parts.joints), chained.held, bool(met))
        self._balance = (mass, bias, force, added, way.pushed())
        found, *solved = way.call(self._solver.solution(), *self._balance, *efforts, *own, *met)
        if solved:
            self.contact, self._balance = solved[0], (*self._balance[:-1], solved[1])
        self.found = found
        motors = self.motor_accelerations({i: found.part(i - first, 1) for i in self.parts.joints})
        self.accelerations = [*(motors[i] for i in self.parts.motors), found]
        return self.accelerations

    def force_along(self, axis: AxisPart) -> Slot:
        """Force that the bodies ask of a prescribed joint, after the run."""
        (forces,) = self.way.call(self._solver.residual(), *self._balance, self.found)
        return forces.part(axis.angle - self.parts.joints.start, 1)

    def point(self, k: int) -> tuple[Slot, ...]:
        """Pose, rate and acceleration (less gravity) of a point in the world."""
        way, kernels = self.way, self.way.chained.kernels
        name = way.chained.points[k]
        return *way.pose(k), *way.call(kernels.acceleration(name), *way.state, way.pull, self.found)

    def at_base(self) -> tuple[Slot, Slot]:
        """A system's base stands still."""
        raise NotImplementedError(f"{self.way.chained.system.name}: the base of a Lagrangian system cannot move")


def forward_schedule(chained: ChainedSystem, *, loaded: bool = False) -> Schedule:
    """(q, v, base, wrenches, effort, given, step) -> accelerations of all coordinates."""
    parts = chained.parts
    way = LagrangeWay(chained, chained.blocks())
    way.take_wrenches(loaded=loaded)
    schedule = way.schedule
    schedule.often = True
    effort, given = schedule.input("effort", len(parts.efforts)), schedule.input("given", len(parts.given))
    step = schedule.input("step", 1)
    (ahead,) = schedule.call(ahead_kernel(parts.size), way.q, way.v, step)
    schedule.output("a", *LagrangeDynamics(way, Drives(effort, given, step, (ahead, way.v))).run())
    return schedule


def inertia_forces(way: LagrangeWay, a: Slot) -> dict[str, list[Slot]]:
    """Forces of inertia and weight, less the wrenches, for accelerations ``a``; ``points`` and ``moment``.

    The reaction of the base does not follow from energies and is left out.
    """
    chained, kernels = way.chained, way.chained.kernels
    moved = chained.bodies(a)
    points: list[Slot] = []
    for k, name in enumerate(chained.points):
        points += way.pose(k)
        points += way.call(kernels.acceleration(name), *way.state, way.pull, moved)
    moment = way.call(kernels.weight(), *way.state, chained.unit)
    mass, bias = way.call(kernels.terms(), *way.state, way.pull, chained.unit)
    (forces,) = way.call(_needed_kernel(kernels), mass, bias, way.pushed(), moved)
    return {"points": points, "moment": [*moment], "forces": [*(way.none[1] for _ in way.parts.motors), forces]}


def elastic_forces(way: LagrangeWay) -> dict[str, list[Slot]]:
    """Forces of springs, dampers and friction, energies and losses: of the drives, then of the system.

    Eq. (26) [stated]: Epel is the sum of (16)-(19) and (24). {test_elastic_energy_terms}
    Eq. (27) [stated]: Phi_el is the sum of (20)-(23) and (25). {test_rayleigh_terms}
    """
    kernels, none, parts = way.chained.kernels, way.none[1], way.parts
    motors, joints, energies, losses = elastic_of_drives(way)
    forces, energy, lost = way.call(kernels.elastic(), *way.state)
    efforts = [joints.get(i, none) for i in parts.joints]
    (total,) = way.call(_sum_kernel(kernels.bodies, len(efforts)), forces, *efforts)
    return {
        "forces": [*(motors.get(i, none) for i in parts.motors), total],
        "energies": [*energies, none, energy],
        "losses": [*losses, way.none[2], lost],
    }


def _needed_kernel(kernels: SystemKernels) -> Kernel:
    """(mass, bias, pushes, z'') -> forces along z."""

    def build(mass: Any, bias: Any, push: Any, a: Any) -> list[list[Any]]:
        columns = ca.sparsify(ca.DM(kernels.columns))
        rest = ca.vertcat(*(bias[i] - push[i] for i in range(kernels.own)))
        return [entries(columns.T @ (unpacked(mass, kernels.own) @ (columns @ ca.SX(a)) + rest))]

    sizes = (kernels.triangle, kernels.own, kernels.own, kernels.bodies)
    return Kernel(f"lagrange needed {kernels.columns.tolist()}", sizes, (kernels.bodies,), build)


def _sum_kernel(size: int, joints: int) -> Kernel:
    """(forces along z, the force on each joint) -> their sum."""

    def build(forces: Any, *efforts: Any) -> list[list[Any]]:
        return [[forces[i] + (efforts[i][0] if i < joints else 0.0) for i in range(size)]]

    return Kernel(f"lagrange sum {size} {joints}", (size, *(1,) * joints), (size,), build)
