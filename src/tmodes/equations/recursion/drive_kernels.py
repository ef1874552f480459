"""Kernels of the drive of one coordinate of a joint. Everything after the reducer.

The formulas are those of the kind of drive (:mod:`tmodes.kinds.drives`). A step h adds hB + h^2 C to the own inertia;
the torques start from the angles and rates that are given.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

from tmodes.chain.chain import Friction, Gear, Joint, Motor
from tmodes.kinds.drives.contract import FRICTION, Angles, DriveKind, DriveLaw, Dry
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Kernel, kernel

__all__ = [
    "LOCK", "SIDES", "TEETH", "DriveKernels", "braked_kernel", "drive_kernels", "drive_numbers", "mixing_kernel",
    "sides_kernel",
]  # fmt: skip

LOCK = 1e30
"""Inertia [kg*m^2, kg] of a coordinate that sticks: it keeps its rate, and this times its acceleration is the force
that dry friction has to bear."""

TEETH = 8
"""Numbers of :meth:`DriveLaw.teeth`."""

RELEASED = 1e-30
"""Torque [N*m, N] of a brake that is released."""

SIDES = 4
"""Of motor and joint: the direction of slip (-1, 0, 1), and the inertia that holds it where it sticks."""


SPRING = 3
"""Numbers of a parallel spring."""


class _Pull(NamedTuple):
    """What a parallel spring takes from a joint: effort, its slopes, energy stored, power lost."""

    torque: Any
    stiffness: Any
    damping: Any
    energy: Any
    lost: Any

    def inertia(self, step: Any) -> Any:
        """What it adds to the joint's inertia in an implicit step."""
        return step * self.damping + step * step * self.stiffness


@dataclass(frozen=True)
class DriveKernels:
    """Structure of a drive: ``ranges`` of the gear's stiffness (0: no gear), whether it has a dead zone.

    ``dry_motor``, ``dry_joint``: structure of the dry friction there; ``bare``: no inertia and no friction at all, the
    effort goes to the joint as it is. ``spring``: a parallel spring acts on the joint, whatever its drive.
    """

    kind: DriveKind
    ranges: int = 0
    dead_zone: bool = False
    dry_motor: Dry = Dry.NONE
    dry_joint: Dry = Dry.NONE
    bare: bool = False
    spring: bool = False

    @property
    def key(self) -> str:
        """The structure in words."""
        dry = f" motor {self.dry_motor} joint {self.dry_joint}{' bare' * self.bare}"
        return f"{self.kind.key} ranges {self.ranges}{' dead zone' * self.dead_zone}{dry}{' spring' * self.spring}"

    @property
    def size(self) -> int:
        """Numbers of its parameters."""
        return self.spring_start + SPRING * self.spring

    @property
    def spring_start(self) -> int:
        """Where the numbers of a parallel spring begin, its stiffness first."""
        return 2 * FRICTION + 2 + (2 * self.ranges + 1 if self.ranges else 0) + self.kind.own_numbers

    @property
    def set_sides(self) -> tuple[bool, bool]:
        """Whether dry friction of motor and of joint is a set at rest, each where it has a coordinate of its own.

        That of a motor behind a rigid gear is the joint's.
        """
        motor = self.dry_motor.is_set
        return motor and self.kind.has_motor, self.dry_joint.is_set or (motor and self.kind.carries_rotor)

    def _law(self, p: Any, sides: Any = None) -> DriveLaw:
        own = None
        if sides is not None:
            own = (sides[0] if self.kind.has_motor else sides[2], sides[2])
        return DriveLaw(
            p, ranges=self.ranges, dead_zone=self.dead_zone, dry_motor=self.dry_motor, dry_joint=self.dry_joint,
            own=self.kind.own_numbers, sides=own,
        )  # fmt: skip

    def _spring(self, p: Any, ga: Any, gad: Any) -> _Pull:
        """What a parallel spring does: nothing where there is none."""
        stiffness, rest, damping = (p[self.spring_start + k] for k in range(SPRING))
        torque, deflection = stiffness * (ga - rest) + damping * gad, ga - rest
        return _Pull(torque, stiffness, damping, stiffness * deflection * deflection / 2, damping * gad * gad)

    @kernel("friction widths {0.key}", ("size",), (2,))
    def widths(self, p: Any) -> list[list[Any]]:
        """Parameters -> rates within which dry friction of motor and of joint changes."""
        return [[*self._law(p).widths]]

    @kernel("friction limits {0.key}", ("size",), (2,))
    def limits(self, p: Any) -> list[list[Any]]:
        """Parameters -> largest dry friction at rest of motor and of joint, each where it is a set."""
        (motor, joint), (own, shared) = self._law(p).limits, self.set_sides
        both = (joint if self.dry_joint.is_set else 0.0) + (motor if self.dry_motor.is_set and not own else 0.0)
        return [[motor if own else 0.0, both if shared else 0.0]]

    @kernel("drive {0.key}", ("size", 1, 1, 1, 1, 1, 2, 1, SIDES), (1, 1, 3))
    def forward(
        self, p: Any, th: Any, thd: Any, ga: Any, gad: Any, effort: Any, feedback: Any, step: Any, sides: Any
    ) -> list[list[Any]]:
        """(parameters, th, th', ga, ga', effort, feedback, h, sides) -> (joint's effort, own inertia, motor (3)).

        ``motor``: th'' = motor[2] (motor[0] + motor[1] ga''), of an elastic drive. ``feedback``: by how much the effort
        falls per angle and per rate of the motor; it is in the effort already, and helps an implicit step alone.
        """
        law, h = self._law(p, sides), step[0]
        held = h * feedback[1] + h * h * feedback[0]
        found = self.kind.forward(law, Angles(th[0], thd[0], ga[0], gad[0]), effort[0], held, h)
        (push, own), (force, pull, share) = (found.effort, found.own), found.motor
        of_motor, of_joint = self.set_sides
        if of_motor:  # what the motor's row gave to the joint's is taken back as far as the motor is held
            kept = share / (1 + share * sides[1])
            given, share = pull * (share - kept), kept
            push, own = push - given * force, own + given * pull
        if self.spring:
            spring = self._spring(p, ga[0], gad[0])
            push, own = push - spring.torque, own + spring.inertia(h)
        return [[push], [own + sides[3] if of_joint else own], [force, pull, share]]

    @kernel("motor", (3, 1), (1,))
    def motor(self, motor: Any, joint: Any) -> list[list[Any]]:
        """(motor, ga'') -> th''."""
        return [[motor[2] * (motor[0] + motor[1] * joint[0])]]

    @kernel("followed {0.key}", ("size", 1, 1, 1, 1, 1, SIDES), (1, 1))
    def followed(self, p: Any, th: Any, thd: Any, ga: Any, gad: Any, step: Any, sides: Any) -> list[list[Any]]:
        """(parameters, th, th', ga, ga', h, sides) -> (effort on the joint, own inertia), of a motor that follows."""
        law, h = self._law(p, sides), step[0]
        joint, joint_slope = law.joint_friction(gad[0])
        gear = law.gear(th[0] - ga[0], thd[0] - gad[0])
        torque, own = gear.torque, h * (gear.damping + joint_slope) + h * h * gear.stiffness
        if self.spring:
            spring = self._spring(p, ga[0], gad[0])
            torque, own = torque - spring.torque, own + spring.inertia(h)
        return [[torque - joint], [own + sides[3] if self.set_sides[1] else own]]

    @kernel("elastic {0.key}", ("size", 1, 1, 1, 1), (2, 1, 2))
    def elastic(self, p: Any, th: Any, thd: Any, ga: Any, gad: Any) -> list[list[Any]]:
        """Forces of springs, dampers and friction on (ga, th), energy [J], power lost in gear and in friction [W].

        Of (parameters, th, th', ga, ga'); signs as on the left side of the equations of motion.
        """
        found = self.kind.elastic(self._law(p), Angles(th[0], thd[0], ga[0], gad[0]))
        on_joint, energy, lost = found.on_joint, found.energy, found.lost_in_gear
        if self.spring:
            spring = self._spring(p, ga[0], gad[0])
            on_joint, energy, lost = on_joint + spring.torque, energy + spring.energy, lost + spring.lost
        return [[on_joint, found.on_motor], [energy], [lost, found.lost_in_friction]]

    @kernel("teeth {0.key}", ("size", 1, 1, 1, 1), (TEETH,))
    def teeth(self, p: Any, th: Any, thd: Any, ga: Any, gad: Any) -> list[list[Any]]:
        """(parameters, th, th', ga, ga') -> see :meth:`DriveLaw.teeth`, of a gear with play; th: at its input."""
        law = self._law(p)
        return [law.teeth(*self.kind.wound(law, Angles(th[0], thd[0], ga[0], gad[0])))]

    @kernel("coupled {0.key}", ("size", 1, 1, 1, 1, SIDES), (1, 1))
    def coupled(self, p: Any, angle: Any, speed: Any, ga: Any, gad: Any, sides: Any) -> list[list[Any]]:
        """Gear of a coupled drive, explicit.

        (parameters, angle and rate of its input, ga, ga', sides) -> (effort on the joint, torque of the gear).
        """
        law = self._law(p, sides)
        torque = law.gear(angle[0] - ga[0], speed[0] - gad[0]).torque
        effort = torque - law.joint_friction(gad[0])[0]
        return [[effort - self._spring(p, ga[0], gad[0]).torque if self.spring else effort], [torque]]

    @kernel("coupled motor {0.key}", ("size", 1, 1, 1, SIDES), (3, 1, 1))
    def coupled_motor(self, p: Any, thd: Any, effort: Any, load: Any, sides: Any) -> list[list[Any]]:
        """(parameters, th', effort, load of all gears, sides) -> (motor (3), force on th but for the effort, loss)."""
        friction, _ = self._law(p, sides).motor_friction(thd[0])
        inertia = self._law(p).inertia + (sides[1] if self.set_sides[0] else 0.0)
        return [[effort[0] - load[0] - friction, 0.0, 1 / inertia], [load[0] + friction], [friction * thd[0]]]

    @kernel("coupled elastic {0.key}", ("size", 1, 1, 1, 1), (1, 1, 2))
    def coupled_elastic(self, p: Any, angle: Any, speed: Any, ga: Any, gad: Any) -> list[list[Any]]:
        """(parameters, input angle, its rate, ga, ga') -> (force on ga, energy, power lost in gear and joint)."""
        law = self._law(p)
        gear, joint = law.gear(angle[0] - ga[0], speed[0] - gad[0]), law.joint_friction(gad[0])[0]
        on_joint, energy, lost = joint - gear.torque, law.stored(angle[0] - ga[0]), gear.lost
        if self.spring:
            spring = self._spring(p, ga[0], gad[0])
            on_joint, energy, lost = on_joint + spring.torque, energy + spring.energy, lost + spring.lost
        return [[on_joint], [energy], [lost, joint * gad[0]]]


@kernel("sides of slip", (SIDES // 2,), (SIDES,))
def sides_kernel(rates: Any) -> list[list[Any]]:
    """Rates of motor and joint -> their sides by these alone, none of them held."""
    return [[entry for k in range(SIDES // 2) for entry in ((rates[k] > 0) - (rates[k] < 0) * 1.0, 0.0)]]


def braked_kernel(size: int, *, on_motor: bool) -> Kernel:
    """(numbers of a drive, signal of its brake) -> the numbers, with the brake in the dry friction of motor or joint.

    Released, it is small, and not 0, by which the load of what sticks is divided.
    """
    place = 3 if on_motor else 3 + FRICTION

    def build(p: Any, signal: Any) -> list[list[Any]]:
        level = f.fmax(signal[0], RELEASED)
        return [[p[k] + level if k == place else p[k] for k in range(size)]]

    return Kernel(f"braked {size} {place}", (size, 3), (size,), build)


def mixing_kernel(count: int, *, transposed: bool) -> Kernel:
    """(matrix (count, count), count numbers) -> count numbers: the matrix, or its transpose, times them."""

    def build(matrix: Any, *values: Any) -> list[list[Any]]:
        place = (lambda i, j: j * count + i) if transposed else (lambda i, j: i * count + j)
        return [[v.total([matrix[place(i, j)] * values[j][0] for j in range(count)])] for i in range(count)]

    name = f"mixing {count}{' transposed' * transposed}"
    return Kernel(name, (count * count, *(1,) * count), (1,) * count, build)


def drive_kernels(joint: Joint, kind: DriveKind) -> DriveKernels:
    """The kernels of a drive of a joint's coordinates."""
    if kind.is_given:  # its motion is an input, so that nothing but energy and effort of a spring is left
        return DriveKernels(kind, spring=joint.spring is not None)
    gear = joint.gear if kind.has_gear else None
    dry_motor = joint.motor.friction.dry if joint.motor else Dry.NONE
    ranges, dead_zone = len(gear.stiffness) if gear else 0, bool(gear and gear.backlash > 0)
    still = joint.motor is None or (joint.motor.inertia == 0 and not _is_rough(joint.motor.friction))
    spring = joint.spring is not None
    bare = kind.carries_rotor and still and not _is_rough(joint.friction) and not spring
    return DriveKernels(kind, ranges, dead_zone, dry_motor, joint.friction.dry, bare, spring)


def _is_rough(friction: Friction) -> bool:
    return friction.viscous != 0 or friction.dry is not Dry.NONE


def drive_numbers(joint: Joint, kind: DriveKind) -> list[float]:
    """The parameters of a drive of a joint's coordinates, packed."""
    motor = joint.motor or Motor(0.0)
    numbers = [motor.inertia, joint.rest, *_packed(motor.friction), *_packed(joint.friction)]
    gear = joint.gear if kind.has_gear else None
    if gear:
        numbers += [*gear.stiffness, *_ends(gear), gear.damping, gear.backlash]
    spring = joint.spring
    own = joint.drive_parameters if kind.own_numbers else ()
    return [*numbers, *own, *((spring.stiffness, spring.rest, spring.damping) if spring else ())]


def _packed(friction: Friction) -> list[float]:
    levels = [friction.viscous, friction.coulomb, friction.static_extra]
    return [*levels, friction.stribeck_rate or 1.0, friction.smoothing]


def _ends(gear: Gear) -> list[float]:
    """Deflections at which the ranges of stiffness end."""
    ends: list[float] = []
    last_torque = last = 0.0
    for stiffness, torque in zip(gear.stiffness, gear.limits, strict=False):
        last += (torque - last_torque) / stiffness
        last_torque = torque
        ends.append(last)
    return ends
