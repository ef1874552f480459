"""Kernels of a joint's drive: motor, elastic gear, friction. Everything after the reducer.

Motor row, Eq. (39) of Filipovic & Djuric 2010, the sign of the gear torque turned: I th'' = u - friction - tg,
tg = C(xi) + B xi', xi = th - ga; the rotor's gyroscopic coupling with the arm is dropped (Spong, "Modeling and control
of elastic joint robots", ASME J. Dyn. Sys. 109, 1987, assumption A2). A step h adds hB + h^2 C to the own inertia; the
torques start from the angles and rates that are given.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmodes.chain.chain import Drive, Friction, Gear, Joint, Motor
from tmodes.equations.recursion.drive_law import FRICTION, DriveLaw
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.kernel import Kernel

__all__ = ["DriveKind", "drive_kind", "drive_numbers", "mixing_kernel"]


@dataclass(frozen=True)
class DriveKind:
    """Structure of a drive: ``ranges`` of the gear's stiffness (0: no gear), whether it has a dead zone.

    ``dry_motor``, ``dry_joint``: friction there is more than viscous; ``bare``: no inertia and no friction at all, the
    effort goes to the joint as it is.
    """

    drive: Drive
    ranges: int = 0
    dead_zone: bool = False
    dry_motor: bool = False
    dry_joint: bool = False
    bare: bool = False

    @property
    def key(self) -> str:
        """The structure in words."""
        dry = f"{' dry motor' * self.dry_motor}{' dry joint' * self.dry_joint}{' bare' * self.bare}"
        return f"{self.drive} ranges {self.ranges}{' dead zone' * self.dead_zone}{dry}"

    @property
    def size(self) -> int:
        """Numbers of its parameters."""
        return 2 * FRICTION + 2 + (2 * self.ranges + 2 if self.ranges else 0)

    def _law(self, p: Any) -> DriveLaw:
        return DriveLaw(
            p, ranges=self.ranges, dead_zone=self.dead_zone, dry_motor=self.dry_motor, dry_joint=self.dry_joint
        )

    def forward(self) -> Kernel:
        """(parameters, th, th', ga, ga', effort, feedback, h) -> (effort on the joint, own inertia, motor (3)).

        ``motor``: th'' = motor[2] (motor[0] + motor[1] ga''), of an elastic drive. ``feedback``: by how much the effort
        falls per angle and per rate of the motor; it is in the effort already, and helps an implicit step alone.
        """

        def build(
            p: Any, th: Any, thd: Any, ga: Any, gad: Any, effort: Any, feedback: Any, step: Any
        ) -> list[list[Any]]:
            law, h = self._law(p), step[0]
            held = h * feedback[1] + h * h * feedback[0]
            joint, joint_slope = law.joint_friction(gad[0])
            if self.drive is Drive.EFFORT:
                motor, motor_slope = law.motor_friction(gad[0])
                inertia = law.inertia + h * (joint_slope + motor_slope) + held
                return [[effort[0] - joint - motor], [inertia], [0.0, 0.0, 0.0]]
            angle, speed = (th[0], thd[0]) if self.drive is Drive.ELASTIC else (law.rest, 0.0)
            torque, stiffness = law.spring(angle - ga[0])
            torque = torque + law.damping * (speed - gad[0])
            added = h * law.damping + h * h * stiffness
            if self.drive is Drive.SPRING:
                return [[torque - joint], [added + h * joint_slope], [0.0, 0.0, 0.0]]
            motor, motor_slope = law.motor_friction(speed)
            share = 1 / (law.inertia + h * motor_slope + held + added)
            rest = effort[0] - torque - motor
            own = added - added * added * share + h * joint_slope
            return [[torque - joint + added * share * rest], [own], [rest, added, share]]

        return Kernel(f"drive {self.key}", (self.size, 1, 1, 1, 1, 1, 2, 1), (1, 1, 3), build)

    def motor(self) -> Kernel:
        """(motor, ga'') -> th''."""
        return Kernel("motor", (3, 1), (1,), lambda motor, joint: [[motor[2] * (motor[0] + motor[1] * joint[0])]])

    def followed(self) -> Kernel:
        """(parameters, th, th', ga, ga', h) -> (effort on the joint, own inertia), of a motor that follows."""

        def build(p: Any, th: Any, thd: Any, ga: Any, gad: Any, step: Any) -> list[list[Any]]:
            law, h = self._law(p), step[0]
            joint, joint_slope = law.joint_friction(gad[0])
            torque, stiffness = law.spring(th[0] - ga[0])
            torque = torque + law.damping * (thd[0] - gad[0])
            return [[torque - joint], [h * (law.damping + joint_slope) + h * h * stiffness]]

        return Kernel(f"followed {self.key}", (self.size, 1, 1, 1, 1, 1), (1, 1), build)

    def elastic(self) -> Kernel:
        """Forces of springs, dampers and friction on (ga, th), energy [J], power lost in gear and in friction [W].

        Of (parameters, th, th', ga, ga'); signs as on the left side of the equations of motion.
        """

        def build(p: Any, th: Any, thd: Any, ga: Any, gad: Any) -> list[list[Any]]:
            law = self._law(p)
            joint, _ = law.joint_friction(gad[0])
            if self.drive is Drive.EFFORT:
                motor, _ = law.motor_friction(gad[0])
                return [[joint + motor, 0.0], [0.0], [0.0, (joint + motor) * gad[0]]]
            angle, speed = (th[0], thd[0]) if self.drive is Drive.ELASTIC else (law.rest, 0.0)
            torque, _ = law.spring(angle - ga[0])
            rate = speed - gad[0]
            torque = torque + law.damping * rate
            motor, _ = law.motor_friction(speed) if self.drive is Drive.ELASTIC else (0.0, 0.0)
            lost = [law.damping * rate * rate, joint * gad[0] + motor * speed]
            return [[joint - torque, torque + motor], [law.stored(angle - ga[0])], lost]

        return Kernel(f"elastic {self.key}", (self.size, 1, 1, 1, 1), (2, 1, 2), build)

    def coupled(self) -> Kernel:
        """Gear of a coupled drive, explicit: (parameters, input angle, its rate, ga, ga') -> (effort, gear torque)."""

        def build(p: Any, angle: Any, speed: Any, ga: Any, gad: Any) -> list[list[Any]]:
            law = self._law(p)
            torque = law.spring(angle[0] - ga[0])[0] + law.damping * (speed[0] - gad[0])
            return [[torque - law.joint_friction(gad[0])[0]], [torque]]

        return Kernel(f"coupled {self.key}", (self.size, 1, 1, 1, 1), (1, 1), build)

    def coupled_motor(self) -> Kernel:
        """(parameters, th', effort, load of all gears) -> (motor (3), force on th of load and friction, loss)."""

        def build(p: Any, thd: Any, effort: Any, load: Any) -> list[list[Any]]:
            law = self._law(p)
            held = load[0] + law.motor_friction(thd[0])[0]
            return [[effort[0] - held, 0.0, 1 / law.inertia], [held], [law.motor_friction(thd[0])[0] * thd[0]]]

        return Kernel(f"coupled motor {self.key}", (self.size, 1, 1, 1), (3, 1, 1), build)

    def coupled_elastic(self) -> Kernel:
        """(parameters, input angle, its rate, ga, ga') -> (force on ga, energy, power lost in gear and joint)."""

        def build(p: Any, angle: Any, speed: Any, ga: Any, gad: Any) -> list[list[Any]]:
            law = self._law(p)
            rate, joint = speed[0] - gad[0], law.joint_friction(gad[0])[0]
            torque = law.spring(angle[0] - ga[0])[0] + law.damping * rate
            lost = [law.damping * rate * rate, joint * gad[0]]
            return [[joint - torque], [law.stored(angle[0] - ga[0])], lost]

        return Kernel(f"coupled elastic {self.key}", (self.size, 1, 1, 1, 1), (1, 1, 2), build)


def mixing_kernel(count: int, *, transposed: bool) -> Kernel:
    """(matrix (count, count), count numbers) -> count numbers: the matrix, or its transpose, times them."""

    def build(matrix: Any, *values: Any) -> list[list[Any]]:
        place = (lambda i, j: j * count + i) if transposed else (lambda i, j: i * count + j)
        return [[v.total([matrix[place(i, j)] * values[j][0] for j in range(count)])] for i in range(count)]

    name = f"mixing {count}{' transposed' * transposed}"
    return Kernel(name, (count * count, *(1,) * count), (1,) * count, build)


def drive_kind(joint: Joint) -> DriveKind:
    """The structure of a joint's drive."""
    gear = joint.gear if joint.drive in (Drive.ELASTIC, Drive.SPRING) else None
    dry_motor = joint.motor is not None and _is_dry(joint.motor.friction)
    ranges, dead_zone = len(gear.stiffness) if gear else 0, bool(gear and gear.backlash > 0)
    still = joint.motor is None or (joint.motor.inertia == 0 and not _is_rough(joint.motor.friction))
    bare = joint.drive is Drive.EFFORT and still and not _is_rough(joint.friction)
    return DriveKind(joint.drive, ranges, dead_zone, dry_motor, _is_dry(joint.friction), bare)


def _is_dry(friction: Friction) -> bool:
    return friction.coulomb > 0 or friction.static_extra > 0


def _is_rough(friction: Friction) -> bool:
    return friction.viscous != 0 or _is_dry(friction)


def drive_numbers(joint: Joint) -> list[float]:
    """The parameters of a joint's drive, packed."""
    motor = joint.motor or Motor(0.0)
    numbers = [motor.inertia, joint.rest, *_packed(motor.friction), *_packed(joint.friction)]
    if drive_kind(joint).ranges and joint.gear:
        gear = joint.gear
        numbers += [*gear.stiffness, *_ends(gear), gear.damping, gear.backlash, gear.backlash_rounding]
    return numbers


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
