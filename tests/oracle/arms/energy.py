"""Energies and losses of a chain: kinetic, gravity, gears, links; and the forces that lose power."""

from __future__ import annotations

from typing import Any

import casadi as ca
import numpy as np

from oracle.arms.motion import Motion
from oracle.arms.rotation import vee
from tmodes.chain.chain import Axis, Friction, Gear, Motor, Node
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.links.segment import Segment
from tmodes.kinds.links.strain import Beam

__all__ = ["elastic_gear", "elastic_link", "gravity", "kinetic", "lost", "momentum"]


def _rates(motion: Motion, q: Any, v: Any) -> tuple[list[Any], list[Any]]:
    """Velocity of each mass's center (world) and its turning rate (own axes)."""
    places = ca.horzcat(*[mass.frame.place for mass in motion.masses])
    axes = ca.horzcat(*[mass.frame.axes for mass in motion.masses])
    speeds = ca.reshape(ca.jtimes(ca.vec(places), q, v), places.shape)
    turning = ca.reshape(ca.jtimes(ca.vec(axes), q, v), axes.shape)
    rates = [vee(m.frame.axes.T @ turning[:, 3 * i : 3 * i + 3]) for i, m in enumerate(motion.masses)]
    return [speeds[:, i] for i in range(len(motion.masses))], rates


def kinetic(motion: Motion, q: Any, v: Any) -> Any:
    """Kinetic energy [J]: point masses, their turning, and the rotors' own turning."""
    speeds, rates = _rates(motion, q, v)
    total = ca.SX(0)
    for mass, speed, rate in zip(motion.masses, speeds, rates, strict=True):
        total += mass.mass * ca.dot(speed, speed) / 2 + rate.T @ mass.inertia @ rate / 2
    for node in motion.chain.axes:
        if (motor := _rotor(node)) is not None:
            total += motor.inertia * v[_motor_index(motion, node)] ** 2 / 2
    return total


def momentum(motion: Motion, q: Any, v: Any) -> tuple[Any, Any]:
    """Linear momentum [kg*m/s] and angular momentum about the world's origin [kg*m^2/s], without the rotors."""
    speeds, rates = _rates(motion, q, v)
    linear, angular = ca.SX.zeros(3), ca.SX.zeros(3)
    for mass, speed, rate in zip(motion.masses, speeds, rates, strict=True):
        linear += mass.mass * speed
        angular += mass.mass * ca.cross(mass.frame.place, speed) + mass.frame.axes @ ca.SX(mass.inertia) @ rate
    return linear, angular


def gravity(motion: Motion) -> Any:
    """Potential energy of gravity [J], zero at the world's origin."""
    pull = ca.SX(np.asarray(motion.chain.gravity, float))
    return -sum((m.mass * ca.dot(pull, m.frame.place) for m in motion.masses), ca.SX(0))


def elastic_gear(motion: Motion) -> Any:
    """Energy of the gears [J], backlash left out."""
    inputs = _gear_inputs(motion)
    total = ca.SX(0)
    for axis in motion.chain.axes:
        if axis.joint.gear is not None and axis.drive in {drive_kind("elastic"), drive_kind("spring")}:
            total += _wound(axis.joint.gear, inputs[axis.name] - motion.joint[axis.name])
    return total


def _gear_inputs(motion: Motion) -> dict[str, Any]:
    """What each elastic gear is driven by: the coupled motor angles, or the angle of a locked motor."""
    motors = ca.vertcat(*motion.motor.values()) if motion.motor else ca.SX.zeros(0)
    mixed = motors if motion.chain.couplings is None else ca.SX(np.asarray(motion.chain.couplings)) @ motors
    names = [name.removesuffix(".motor") for name in motion.motor]
    inputs: dict[str, Any] = {name: mixed[i] for i, name in enumerate(names)}
    return inputs | {n.name: n.joint.rest for n in motion.chain.axes if n.drive is drive_kind("spring")}


def _wound(gear: Gear, angle: Any) -> Any:
    """Integral of the piecewise linear torque from 0 to ``angle``."""
    size, total, start = ca.fabs(angle), ca.SX(0), 0.0
    torque = 0.0
    for i, stiffness in enumerate(gear.stiffness):
        if i == 0 and not gear.limits:
            return stiffness * angle**2 / 2
        last = i >= len(gear.limits)
        width = np.inf if last else (gear.limits[i] - torque) / stiffness
        inside = ca.fmax(size - start, 0) if last else ca.fmin(ca.fmax(size - start, 0), width)
        total += torque * inside + stiffness * inside**2 / 2
        if not last:
            start, torque = start + width, gear.limits[i]
    return total


def elastic_link(motion: Motion) -> Any:
    """Energy of bent, twisted and stretched links [J]."""
    return sum((_bent(motion, i, _values(motion, n), n) for i, n in enumerate(motion.chain.nodes)), ca.SX(0))


def _values(motion: Motion, node: Node) -> list[Any]:
    return list(motion.link[node.name].values())


def _bent(motion: Motion, index: int, x: list[Any], node: Node, damping: bool = False) -> Any:
    """Half the stiffness (or damping) form of one link in its coordinates (or their rates)."""
    if isinstance(node.link, Beam):
        factor = node.link.damping_time if damping else 1.0
        return factor * _form(motion.lines[index].stiffness(), x)
    if isinstance(node.link, Segment):
        letter = "damping" if damping else "stiffness"
        names = [name for name in ("y", "z") if getattr(node.link, f"bend_{name}")]
        weights = [getattr(node.link, f"{letter}_{name}") * node.link.length**2 for name in names]
        return sum((w * value**2 / 2 for w, value in zip(weights, x, strict=True)), ca.SX(0))
    return ca.SX(0)


def _form(matrices: list[Any], x: list[Any]) -> Any:
    total, first = ca.SX(0), 0
    for matrix in matrices:
        part = ca.vertcat(*x[first : first + len(matrix)]) if len(matrix) else ca.SX.zeros(0)
        total += part.T @ matrix @ part / 2 if len(matrix) else 0
        first += len(matrix)
    return total


def _rotor(node: Axis) -> Motor | None:
    """The joint's motor, if it has one that is not locked."""
    return None if node.drive is drive_kind("spring") else node.joint.motor


def _motor_index(motion: Motion, node: Axis) -> int:
    """Where the rotor's rate stands in v: its own coordinate, or the joint behind a rigid gear."""
    own = f"{node.name}.motor" if node.drive is drive_kind("elastic") else node.name
    return list(motion.coordinates).index(own)


def _rubbed(friction: Friction, rate: Any) -> Any:
    dry = friction.coulomb + friction.static_extra / (1 + (rate / friction.stribeck_rate) ** 2)
    sign = rate / ca.sqrt(rate**2 + friction.smoothing**2) if friction.smoothing else ca.sign(rate)
    return friction.viscous * rate + dry * sign


def lost(motion: Motion, v: Any) -> Any:
    """Generalized forces (nq,) that take power: gear and link damping, friction of motors and joints."""
    names = list(motion.coordinates)
    forces = ca.gradient(_rayleigh(motion, v), v)
    for node in motion.chain.axes:
        rate = names.index(node.name)
        forces[rate] += _rubbed(node.joint.friction, v[rate])
        if (motor := _rotor(node)) is not None:
            rotor = _motor_index(motion, node)
            forces[rotor] += _rubbed(motor.friction, v[rotor])
    return forces


def _rayleigh(motion: Motion, v: Any) -> Any:
    """Half the power lost in linear dampers [W]."""
    names = list(motion.coordinates)
    rates = dict(zip(names, ca.vertsplit(v), strict=True))
    turned = ca.vertcat(*motion.motor.values()) if motion.motor else ca.SX.zeros(0)
    total = ca.SX(0)
    inputs = _gear_inputs(motion)
    for node in motion.chain.axes:
        if node.joint.gear is not None and node.drive in {drive_kind("elastic"), drive_kind("spring")}:
            moved = ca.SX(inputs[node.name])
            speed = ca.jtimes(moved, turned, v[: turned.numel()]) if turned.numel() else 0
            total += node.joint.gear.damping * (speed - rates[node.name]) ** 2 / 2
    for index, node in enumerate(motion.chain.nodes):
        total += _bent(motion, index, [rates[name] for name in motion.link[node.name]], node, damping=True)
    return total
