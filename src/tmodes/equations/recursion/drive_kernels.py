"""Kernels of the drive of one coordinate of a joint. Everything after the reducer.

The formulas are those of the kind of drive (:mod:`tmodes.kinds.drives`). A step h adds hB + h^2 C to the own inertia;
the torques start from the angles and rates that are given.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmodes.chain.chain import Friction, Gear, Joint, Motor
from tmodes.kinds.drives.contract import FRICTION, Angles, DriveKind, DriveLaw
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Kernel, kernel

__all__ = ["DriveKernels", "drive_kernels", "drive_numbers", "mixing_kernel"]


@dataclass(frozen=True)
class DriveKernels:
    """Structure of a drive: ``ranges`` of the gear's stiffness (0: no gear), whether it has a dead zone.

    ``dry_motor``, ``dry_joint``: friction there is more than viscous; ``bare``: no inertia and no friction at all, the
    effort goes to the joint as it is.
    """

    kind: DriveKind
    ranges: int = 0
    dead_zone: bool = False
    dry_motor: bool = False
    dry_joint: bool = False
    bare: bool = False

    @property
    def key(self) -> str:
        """The structure in words."""
        dry = f"{' dry motor' * self.dry_motor}{' dry joint' * self.dry_joint}{' bare' * self.bare}"
        return f"{self.kind.key} ranges {self.ranges}{' dead zone' * self.dead_zone}{dry}"

    @property
    def size(self) -> int:
        """Numbers of its parameters."""
        return 2 * FRICTION + 2 + (2 * self.ranges + 2 if self.ranges else 0) + self.kind.own_numbers

    def _law(self, p: Any) -> DriveLaw:
        return DriveLaw(
            p, ranges=self.ranges, dead_zone=self.dead_zone, dry_motor=self.dry_motor, dry_joint=self.dry_joint,
            own=self.kind.own_numbers,
        )  # fmt: skip

    @kernel("drive {0.key}", ("size", 1, 1, 1, 1, 1, 2, 1), (1, 1, 3))
    def forward(
        self, p: Any, th: Any, thd: Any, ga: Any, gad: Any, effort: Any, feedback: Any, step: Any
    ) -> list[list[Any]]:
        """(parameters, th, th', ga, ga', effort, feedback, h) -> (effort on the joint, own inertia, motor (3)).

        ``motor``: th'' = motor[2] (motor[0] + motor[1] ga''), of an elastic drive. ``feedback``: by how much the effort
        falls per angle and per rate of the motor; it is in the effort already, and helps an implicit step alone.
        """
        law, h = self._law(p), step[0]
        held = h * feedback[1] + h * h * feedback[0]
        found = self.kind.forward(law, Angles(th[0], thd[0], ga[0], gad[0]), effort[0], held, h)
        return [[found.effort], [found.own], list(found.motor)]

    @kernel("motor", (3, 1), (1,))
    def motor(self, motor: Any, joint: Any) -> list[list[Any]]:
        """(motor, ga'') -> th''."""
        return [[motor[2] * (motor[0] + motor[1] * joint[0])]]

    @kernel("followed {0.key}", ("size", 1, 1, 1, 1, 1), (1, 1))
    def followed(self, p: Any, th: Any, thd: Any, ga: Any, gad: Any, step: Any) -> list[list[Any]]:
        """(parameters, th, th', ga, ga', h) -> (effort on the joint, own inertia), of a motor that follows."""
        law, h = self._law(p), step[0]
        joint, joint_slope = law.joint_friction(gad[0])
        torque, stiffness = law.spring(th[0] - ga[0])
        torque = torque + law.damping * (thd[0] - gad[0])
        return [[torque - joint], [h * (law.damping + joint_slope) + h * h * stiffness]]

    @kernel("elastic {0.key}", ("size", 1, 1, 1, 1), (2, 1, 2))
    def elastic(self, p: Any, th: Any, thd: Any, ga: Any, gad: Any) -> list[list[Any]]:
        """Forces of springs, dampers and friction on (ga, th), energy [J], power lost in gear and in friction [W].

        Of (parameters, th, th', ga, ga'); signs as on the left side of the equations of motion.
        """
        found = self.kind.elastic(self._law(p), Angles(th[0], thd[0], ga[0], gad[0]))
        lost = [found.lost_in_gear, found.lost_in_friction]
        return [[found.on_joint, found.on_motor], [found.energy], lost]

    @kernel("coupled {0.key}", ("size", 1, 1, 1, 1), (1, 1))
    def coupled(self, p: Any, angle: Any, speed: Any, ga: Any, gad: Any) -> list[list[Any]]:
        """Gear of a coupled drive, explicit: (parameters, input angle, its rate, ga, ga') -> (effort, gear torque)."""
        law = self._law(p)
        torque = law.spring(angle[0] - ga[0])[0] + law.damping * (speed[0] - gad[0])
        return [[torque - law.joint_friction(gad[0])[0]], [torque]]

    @kernel("coupled motor {0.key}", ("size", 1, 1, 1), (3, 1, 1))
    def coupled_motor(self, p: Any, thd: Any, effort: Any, load: Any) -> list[list[Any]]:
        """(parameters, th', effort, load of all gears) -> (motor (3), force on th of load and friction, loss)."""
        law = self._law(p)
        held = load[0] + law.motor_friction(thd[0])[0]
        return [[effort[0] - held, 0.0, 1 / law.inertia], [held], [law.motor_friction(thd[0])[0] * thd[0]]]

    @kernel("coupled elastic {0.key}", ("size", 1, 1, 1, 1), (1, 1, 2))
    def coupled_elastic(self, p: Any, angle: Any, speed: Any, ga: Any, gad: Any) -> list[list[Any]]:
        """(parameters, input angle, its rate, ga, ga') -> (force on ga, energy, power lost in gear and joint)."""
        law = self._law(p)
        rate, joint = speed[0] - gad[0], law.joint_friction(gad[0])[0]
        torque = law.spring(angle[0] - ga[0])[0] + law.damping * rate
        lost = [law.damping * rate * rate, joint * gad[0]]
        return [[joint - torque], [law.stored(angle[0] - ga[0])], lost]


def mixing_kernel(count: int, *, transposed: bool) -> Kernel:
    """(matrix (count, count), count numbers) -> count numbers: the matrix, or its transpose, times them."""

    def build(matrix: Any, *values: Any) -> list[list[Any]]:
        place = (lambda i, j: j * count + i) if transposed else (lambda i, j: i * count + j)
        return [[v.total([matrix[place(i, j)] * values[j][0] for j in range(count)])] for i in range(count)]

    name = f"mixing {count}{' transposed' * transposed}"
    return Kernel(name, (count * count, *(1,) * count), (1,) * count, build)


def drive_kernels(joint: Joint, kind: DriveKind) -> DriveKernels:
    """The kernels of a drive of a joint's coordinates."""
    gear = joint.gear if kind.has_gear else None
    dry_motor = joint.motor is not None and _is_dry(joint.motor.friction)
    ranges, dead_zone = len(gear.stiffness) if gear else 0, bool(gear and gear.backlash > 0)
    still = joint.motor is None or (joint.motor.inertia == 0 and not _is_rough(joint.motor.friction))
    bare = kind.carries_rotor and still and not _is_rough(joint.friction)
    return DriveKernels(kind, ranges, dead_zone, dry_motor, _is_dry(joint.friction), bare)


def _is_dry(friction: Friction) -> bool:
    return friction.coulomb > 0 or friction.static_extra > 0


def _is_rough(friction: Friction) -> bool:
    return friction.viscous != 0 or _is_dry(friction)


def drive_numbers(joint: Joint, kind: DriveKind) -> list[float]:
    """The parameters of a drive of a joint's coordinates, packed."""
    motor = joint.motor or Motor(0.0)
    numbers = [motor.inertia, joint.rest, *_packed(motor.friction), *_packed(joint.friction)]
    gear = joint.gear if kind.has_gear else None
    if gear:
        numbers += [*gear.stiffness, *_ends(gear), gear.damping, gear.backlash, gear.backlash_rounding]
    return [*numbers, *(joint.drive_parameters if kind.own_numbers else ())]


def _packed(friction: Friction) -> list[float]:
    return [friction.viscous, friction.coulomb, friction.static_extra, friction.stribeck_rate, friction.smoothing]


def _ends(gear: Gear) -> list[float]:
    """Deflections at which the ranges of stiffness end."""
    ends: list[float] = []
    last_torque = last = 0.0
    for stiffness, torque in zip(gear.stiffness, gear.limits, strict=False):
        last += (torque - last_torque) / stiffness
        last_torque = torque
        ends.append(last)
    return ends
