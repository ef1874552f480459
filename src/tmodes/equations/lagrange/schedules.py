"""The dynamics alone by Lagrange's equations: forward, inertia, elastic; inputs as of the recursion's."""

from __future__ import annotations

from typing import Any

import casadi as ca

from tmodes.equations.lagrange.kernels import SystemKernels, entries, unpacked
from tmodes.equations.lagrange.motion import ChainedSystem, LagrangeDynamics, LagrangeWay
from tmodes.equations.recursion.driven import Drives
from tmodes.equations.recursion.forces import elastic_of_drives
from tmodes.equations.recursion.forward import ahead_kernel
from tmodes.kinds.kernel.schedule import Kernel, Schedule, Slot

__all__ = ["elastic_forces", "forward_schedule", "inertia_forces"]


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
