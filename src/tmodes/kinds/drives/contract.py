"""What a kind of drive says of itself: which coordinates and inputs it has, and its torques, energy and losses.

The angles are those of motor (th) and joint (ga), both after the reducer. Formulas are made of the laws of friction
and gear (:mod:`tmodes.kinds.drives.laws`), sums, products, quotients and :mod:`tmodes.kinds.kernel.functions`.
"""

from __future__ import annotations

from abc import abstractmethod
from typing import Any, ClassVar, NamedTuple

from tmodes.kinds.drives.laws import DriveLaw
from tmodes.kinds.registry import NamedKind, Registry
from tmodes.kinds.schema.quantity import DataSheet

__all__ = ["DRIVES", "Angles", "DriveKind", "Elastic", "Forward"]


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
