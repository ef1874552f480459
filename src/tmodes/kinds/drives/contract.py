"""What a kind of drive says of itself: which coordinates and inputs it has, and its torques, energy and losses.

The angles are those of motor (th) and joint (ga), both after the reducer. Formulas are made of the laws of friction
and gear (:class:`DriveLaw`), sums, products, quotients and :mod:`tmodes.kinds.kernel.functions`.
"""

from __future__ import annotations

from abc import abstractmethod
from enum import StrEnum
from typing import Any, ClassVar, NamedTuple

from tmodes.kinds.kernel.functions import fabs, fmax, sqrt
from tmodes.kinds.registry import NamedKind, Registry
from tmodes.kinds.schema.quantity import DataSheet

__all__ = ["DRIVES", "FRICTION", "Angles", "DriveKind", "DriveLaw", "Dry", "Elastic", "Forward", "Mesh"]

FRICTION = 5
"""Numbers of a friction law."""


class Dry(StrEnum):
    """The structure of dry friction.

    ``SMOOTH`` is a function of the rate. Of the others the force at rest is a set: what keeps it at rest, up to the
    static friction. In motion ``DROPS`` has the level of motion at once, ``FALLS`` follows Stribeck's curve.
    """

    NONE = ""
    SMOOTH = "smooth"
    DROPS = "drops"
    FALLS = "falls"

    @property
    def is_narrow(self) -> bool:
        """Whether it changes with the rate."""
        return self in {Dry.SMOOTH, Dry.FALLS}

    @property
    def is_set(self) -> bool:
        """Whether the force at rest is a set."""
        return self in {Dry.DROPS, Dry.FALLS}


class Mesh(NamedTuple):
    """What a gear does at an instant: ``torque`` on the joint, ``stiffness`` and ``damping`` there, power ``lost``."""

    torque: Any
    stiffness: Any
    damping: Any
    lost: Any


class DriveLaw:
    """The parameters of a drive by name, and the laws that they are in."""

    def __init__(
        self,
        p: Any,
        *,
        ranges: int,
        dead_zone: bool,
        dry_motor: Dry,
        dry_joint: Dry,
        own: int = 0,
        sides: tuple[Any, Any] | None = None,
    ) -> None:
        """``own``: how many numbers of the kind itself there are, the last of ``p``.

        ``sides``: direction in which motor and joint slip, -1, 0 (at rest) or 1, that of their rates by default.
        """
        self._dead_zone, self._dry_motor, self._dry_joint, self._sides = dead_zone, dry_motor, dry_joint, sides
        self.inertia, self.rest = p[0], p[1]
        self._motor, self._joint = [p[2 + i] for i in range(5)], [p[7 + i] for i in range(5)]
        r = ranges
        self.stiffness, self.ends, self.damping, self.backlash = [0.0], [], 0.0, 0.0
        if r:
            self.stiffness = [p[12 + i] for i in range(r)]
            self.ends = [p[12 + r + i] for i in range(r - 1)]
            self.damping, self.backlash = p[11 + 2 * r], p[12 + 2 * r]
        first = 13 + 2 * r if r else 12
        self.own = [p[first + k] for k in range(own)]

    def motor_friction(self, rate: Any) -> tuple[Any, Any]:
        """Torque and its derivative by the rate."""
        return _friction(self._motor, rate, self._dry_motor, self._sides and self._sides[0])

    def joint_friction(self, rate: Any) -> tuple[Any, Any]:
        """Effort and its derivative by the rate."""
        return _friction(self._joint, rate, self._dry_joint, self._sides and self._sides[1])

    @property
    def widths(self) -> tuple[Any, Any]:
        """Rates within which dry friction of motor and joint changes: that of smoothing, else Stribeck's."""
        pairs = ((self._motor, self._dry_motor), (self._joint, self._dry_joint))
        motor, joint = (p[4] if dry is Dry.SMOOTH else p[3] for p, dry in pairs)
        return motor, joint

    @property
    def limits(self) -> tuple[Any, Any]:
        """Largest dry friction of motor and joint at rest."""
        return self._motor[1] + self._motor[2], self._joint[1] + self._joint[2]

    def gear(self, deflection: Any, rate: Any) -> Mesh:
        """Spring and damper of the gear at a deflection and its rate.

        Behind a play they act while its teeth press on each other: nothing acts within the play, and nothing pulls the
        teeth together, so they part where the damper would hold more than the spring gives; what the spring still has
        then is lost.
        """
        if not self._dead_zone:
            torque, stiffness = self.spring(deflection)
            return Mesh(torque + self.damping * rate, stiffness, self.damping, self.damping * rate * rate)
        side, over = _sign(deflection), fabs(deflection) - self.backlash
        spring, stiffness = self._beyond(over)
        push = spring + self.damping * (side * rate)
        meets = over > 0
        presses = meets * (push > 0)
        lost = (presses * push - meets * spring) * (side * rate)
        return Mesh(side * presses * push, presses * stiffness, presses * self.damping, lost)

    def teeth(self, deflection: Any, rate: Any) -> list[Any]:
        """Pairs of numbers, of the teeth on the positive side, then on the negative, each pair positive for a while.

        How deep they are in each other, and their push: while they press on each other. Then the first alone: while
        their spring holds energy.
        """
        found = []
        for side in (1.0, -1.0):
            over = side * deflection - self.backlash
            found += [over, self._beyond(over)[0] + self.damping * (side * rate), over, 1.0]
        return found

    def spring(self, deflection: Any) -> tuple[Any, Any]:
        """Torque of the spring alone and its stiffness at a deflection; none within a play."""
        if not self._dead_zone:
            return self._beyond(deflection)
        over = fabs(deflection) - self.backlash
        torque, stiffness = self._beyond(over)
        meets = over > 0
        return _sign(deflection) * meets * torque, meets * stiffness

    def _beyond(self, x: Any) -> tuple[Any, Any]:
        """Torque and stiffness at a deflection from where the teeth meet."""
        torque, stiffness = self.stiffness[0] * x, self.stiffness[0]
        side = (x > 0) - (x < 0) if self.ends else 0.0
        for end, step in self._steps():
            over = side * x - end
            beyond = over > 0
            torque = torque + side * beyond * step * over
            stiffness = stiffness + beyond * step
        return torque, stiffness

    def stored(self, deflection: Any) -> Any:
        """Energy of the spring.

        Eq. (24) [stated]: Epel_xi = 1/2 Cxi xi^2, with xi = gamma - theta. {test_elastic_energy_terms}
        """
        x = fmax(fabs(deflection) - self.backlash, 0.0) if self._dead_zone else deflection
        energy = self.stiffness[0] * x * x / 2
        for end, step in self._steps():
            over = fabs(x) - end
            energy = energy + (over > 0) * step * over * over / 2
        return energy

    def _steps(self) -> list[tuple[Any, Any]]:
        """Deflection at which each further range begins, and by how much the stiffness changes there."""
        return [(end, self.stiffness[i + 1] - self.stiffness[i]) for i, end in enumerate(self.ends)]


def _sign(x: Any) -> Any:
    return (x > 0) - (x < 0) * 1.0


def _friction(p: list[Any], rate: Any, dry: Dry, side: Any) -> tuple[Any, Any]:
    """Viscous, Coulomb and Stribeck friction, and its derivative; ``side``: where it slips, if that is known."""
    viscous, coulomb, extra, stribeck, smoothing = p
    if dry is Dry.NONE:
        return viscous * rate, viscous
    level, fall, bend = coulomb, 0.0, 0.0
    if dry is not Dry.DROPS:
        ratio = rate / stribeck
        share = 1 / (1 + ratio * ratio)
        level, fall = coulomb + extra * share, -2 * extra * share * share * ratio / stribeck
    if dry is Dry.SMOOTH:
        root = sqrt(rate * rate + smoothing * smoothing)
        side, bend = rate / root, smoothing * smoothing / (root * root * root)
    elif side is None:
        side = (rate > 0) - (rate < 0) * 1.0
    return viscous * rate + level * side, viscous + level * bend + fall * side


class Angles(NamedTuple):
    """Angle and rate of the motor, angle and rate of the joint [rad or m, per s]; of the motor 0 where it has none."""

    motor: Any
    motor_rate: Any
    joint: Any
    joint_rate: Any


class Forward(NamedTuple):
    """What the forward dynamics needs of a drive.

    ``effort`` on the joint [N*m or N]; ``own``: inertia that it adds to the joint's coordinate, with h D + h^2 K of an
    implicit step h; ``motor``: (f, c, i) of the motor's acceleration i (f + c ga'').
    """

    effort: Any
    own: Any
    motor: tuple[Any, Any, Any] = (0.0, 0.0, 0.0)


class Elastic(NamedTuple):
    """Forces on the left side of the equations of joint and motor [N*m or N], energy [J], power lost [W]."""

    on_joint: Any
    on_motor: Any = 0.0
    energy: Any = 0.0
    lost_in_gear: Any = 0.0
    lost_in_friction: Any = 0.0


class DriveKind(NamedKind):
    """A kind of drive of one coordinate of a joint."""

    summary: ClassVar[str]
    """What it does, in a few words."""
    schema: ClassVar[type[DataSheet] | None] = None
    """Further numbers that a data sheet gives under ``drive_parameters``; the law has them as ``law.own``."""
    has_motor: ClassVar[bool] = False
    """The motor has a coordinate of its own."""
    takes_effort: ClassVar[bool] = False
    """An effort is an input: on the motor where it has a coordinate, else on the joint."""
    is_given: ClassVar[bool] = False
    """The joint's motion is an input; there are no forces."""
    has_gear: ClassVar[bool] = False
    """A gear's spring acts between joint and motor, or between joint and where the motor is locked."""

    @property
    def own_numbers(self) -> int:
        """How many further numbers it has."""
        return len(self.schema.model_fields) if self.schema else 0

    @property
    def is_driven(self) -> bool:
        """An input moves it: an effort, or a given motion."""
        return self.takes_effort or self.is_given

    @property
    def carries_rotor(self) -> bool:
        """The rotor turns with the joint, whose inertia it adds to."""
        return self.takes_effort and not self.has_motor

    def wound(self, law: DriveLaw, at: Angles) -> tuple[Any, Any]:
        """Deflection of the gear and its rate."""
        if self.has_motor:
            return at.motor - at.joint, at.motor_rate - at.joint_rate
        return law.rest - at.joint, 0.0 - at.joint_rate

    @abstractmethod
    def forward(self, law: DriveLaw, at: Angles, effort: Any, held: Any, step: Any) -> Forward:
        """Effort, inertia and motor at an instant.

        ``held``: by how much the controller's feedback adds to the inertia along the effort in an implicit step of
        length ``step``; 0 without one.
        """

    @abstractmethod
    def elastic(self, law: DriveLaw, at: Angles) -> Elastic:
        """Forces of springs, dampers and friction, their energy and losses."""


DRIVES: Registry[DriveKind] = Registry("drive", DriveKind, made=lambda kind: kind())
"""Those of tmodes, and what a user registers: ``@DRIVES.register``."""
