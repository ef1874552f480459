"""A joint as a person writes it: where it is, about what it moves, what drives it."""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum
from itertools import chain
from typing import Annotated, Any

import numpy as np
from pydantic import ConfigDict, Field, SerializeAsAny, ValidationInfo, field_validator
from pydantic_core import PydanticKnownError

from tmodes.kinds.drives.drive import FrictionSheet, GearSheet, MotorSheet, SpringSheet
from tmodes.kinds.drives.registry import DRIVES
from tmodes.kinds.joints.registry import JOINTS, JointKind
from tmodes.kinds.noted.functions import hypot, number
from tmodes.kinds.schema.frames import DenavitHartenberg, Origin, Vector, list_of_numbers
from tmodes.kinds.schema.kind import NameOf, NumbersOf
from tmodes.kinds.schema.quantity import DataSheet, Issue, any_sign, not_negative

__all__ = ["JointSheet", "JointState", "JointType", "Limits", "MeasuredFrom"]

SHORTEST_AXIS = 1e-9
"""Length below which an axis is zero but for round-off, and has no direction [-]."""


JointType = Annotated[str, NameOf(JOINTS)]
"""The name of a registered kind of joint."""

DriveName = Annotated[str, NameOf(DRIVES)]
"""The name of a registered kind of drive."""


class JointState(StrEnum):
    """Whether a joint's motor moves, or is locked; a free joint has none, and nothing holds it."""

    ACTIVE = "active"
    LOCKED = "locked"
    FREE = "free"


class MeasuredFrom(StrEnum):
    """From which frame of its parent link a joint's origin is measured.

    ``tip``: the frame at the parent's end, which moves with it; ``frame``: the parent's own frame, as it is undeformed
    (what URDF means). A rigid link's tip frame is its own frame.
    """

    TIP = "tip"
    FRAME = "frame"


class Limits(DataSheet):
    """What a joint may do; a limit that is left out does not bound."""

    lower: float | None = any_sign("rad|m", "q_min", "lowest position", default=None, plausible=(-700.0, 700.0))
    upper: float | None = any_sign("rad|m", "q_max", "highest position", default=None, plausible=(-700.0, 700.0))
    speed: float | None = not_negative("rad/s|m/s", "v_max", "highest speed", default=None, plausible=(1e-3, 1e3))
    effort: float | None = not_negative("N*m|N", "tau_max", "highest effort", default=None, plausible=(1e-4, 1e6))
    acceleration: float | None = not_negative(
        "rad/s^2|m/s^2", "a_max", "highest acceleration of its setpoint", default=None, plausible=(1e-2, 1e4)
    )
    jerk: float | None = not_negative(
        "rad/s^3|m/s^3", "j_max", "highest jerk of its setpoint", default=None, plausible=(1e-2, 1e6)
    )

    def _issues(self) -> Iterator[Issue]:
        if self.lower is not None and self.upper is not None and self.lower > self.upper:
            expected = f"at most `upper`, {self.upper!r}"
            yield Issue("lower", repr(self.lower), expected, "exchange the two, or correct one")


class JointSheet(DataSheet):
    """A joint and the link it carries."""

    model_config = ConfigDict(validate_by_name=True, validate_by_alias=True, serialize_by_alias=True)

    name: str = Field(min_length=1, max_length=100, description="name of the joint")
    type: JointType = Field(description="how it moves")
    parent: str | None = Field(
        default=None, min_length=1, max_length=100, description="link that holds it; none: child of the joint before"
    )
    child: str = Field(min_length=1, max_length=100, description="link that it carries")
    origin: Origin | None = Field(default=None, description="where it is; none: at its parent's tip")
    measured_from: MeasuredFrom = Field(
        default=MeasuredFrom.TIP, alias="from", strict=False, description="frame of the parent that origin is given in"
    )
    axis: Vector | None = list_of_numbers("-", "e", "direction of the joint's axis, in its frame", default=None)
    dh: DenavitHartenberg | None = Field(default=None, description="Denavit-Hartenberg row for origin and axis")
    parameters: Annotated[SerializeAsAny[DataSheet] | None, NumbersOf(JOINTS, "type")] = Field(
        default=None, validate_default=True, description="further numbers of its type; none: it has none"
    )
    drive: DriveName | None = Field(
        default=None, description="kind of drive; none: by its state, its gear and the command"
    )
    drive_parameters: Annotated[SerializeAsAny[DataSheet] | None, NumbersOf(DRIVES, "drive")] = Field(
        default=None, validate_default=True, description="further numbers of its kind of drive; none: it has none"
    )
    state: JointState = Field(default=JointState.ACTIVE, strict=False, description="active, locked, or free")
    locked_at: float = any_sign("rad|m", "q_0", "position at which it is locked", default=0.0, plausible=(-6.3, 6.3))
    limits: Limits | None = Field(default=None, description="what it may do")
    friction: FrictionSheet | None = Field(default=None, description="friction at the joint; none: no friction")
    motor: MotorSheet | None = Field(default=None, description="motor; none: the joint's effort is the input")
    gear: GearSheet | None = Field(default=None, description="elastic gear; none: rigid")
    spring: SpringSheet | None = Field(
        default=None, description="spring between the joint's links, beside motor and gear; none: no spring"
    )

    @field_validator("parameters", mode="before")
    @classmethod
    def _parameters_of_type(cls, given: Any, info: ValidationInfo) -> Any:
        """The parameters are those of the schema of the joint's kind."""
        if "type" not in info.data:
            return None
        return _checked(JOINTS[info.data["type"]].schema, given)

    @field_validator("drive_parameters", mode="before")
    @classmethod
    def _parameters_of_drive(cls, given: Any, info: ValidationInfo) -> Any:
        """Those of the schema of the drive's kind."""
        if "drive" not in info.data:
            return None
        named = info.data["drive"]
        return _checked(DRIVES[named].schema if named else None, given)

    def _issues(self) -> Iterator[Issue]:
        return chain(self._axis_issues(), self._place_issues(), self._drive_issues())

    def _axis_issues(self) -> Iterator[Issue]:
        if not self.kind.has_axis or self.dh is not None:
            if self.axis is not None:
                why = "a joint with `dh`, which moves along its z" if self.kind.has_axis else f"a {self.type} joint"
                yield Issue("axis", f"an axis of {why}", "left out", "remove the line `axis: ...`")
        elif self.axis is None:
            yield Issue("axis", "nothing", f"the axis of a {self.type} joint", "add the line `axis: [0, 0, 1]`")
        elif (length := hypot(*self.axis)) < SHORTEST_AXIS:
            got = f"an axis of {f'length {length:g}' if length else 'zeros'}, which has no direction"
            yield Issue("axis", got, f"a direction, of length {SHORTEST_AXIS:g} or more", "write [0, 0, 1] for z")

    def _place_issues(self) -> Iterator[Issue]:
        if self.dh is not None and self.origin is not None:
            yield Issue("origin", "an origin next to `dh`", "one of the two", "remove `origin` or `dh`")
        if self.parent == self.child:
            got = f"`{self.child}`, the link that it carries"
            yield Issue("parent", got, "another link", "name the link that holds the joint")

    def _drive_issues(self) -> Iterator[Issue]:
        active = self.is_active
        if not self.kind.moves:
            for name in ("motor", "gear", "spring", "friction", "limits"):
                if getattr(self, name) is not None:
                    hint = f"remove `{name}`, or make the joint revolute or prismatic"
                    yield Issue(name, f"a {name} on a {self.type} joint", "left out: the joint does not move", hint)
        elif active and self.is_elastic and self.motor is None:
            hint = "add `motor`, write `state: locked`, or remove the gear"
            yield Issue("motor", "nothing", "a motor, because the joint has an elastic gear", hint)
        elif self.is_locked and self.spring is not None:
            hint = "write `state: free` for a joint on its spring alone, or remove `spring`"
            yield Issue("spring", "a spring on a locked joint", "left out: the joint does not move", hint)
        yield from self._named_drive_issues()
        if self.friction and self.friction.normal_force is not None and self.unit != "m":
            got, hint = f"{self.friction.normal_force:g} N", "give the torques `coulomb` and `static_extra`"
            yield Issue("friction.normal_force", got, "left out: the joint does not slide", hint)
        if active and self.locked_at:
            hint = "write `state: locked`, or give the position under `initial`"
            yield Issue("locked_at", repr(self.locked_at), "0 for an active joint", hint)
        for name in ("motor", "gear", "locked_at") if self.state is JointState.FREE else ():
            if getattr(self, name):
                hint = f"remove `{name}`, or take another `state`"
                yield Issue(name, f"`{name}` of a free joint", "left out: nothing drives or holds the joint", hint)

    def _named_drive_issues(self) -> Iterator[Issue]:
        if self.drive is None:
            return
        kind = DRIVES[self.drive]
        if not self.is_active or not self.kind.moves:
            yield Issue("drive", f"`{self.drive}` of a joint that is not driven", "none", "remove `drive`")
        elif not kind.takes_effort:
            hint = "write `state: locked` or `free`, or a drive with the command `prescribed`"
            yield Issue("drive", f"`{self.drive}`, which takes no effort", "a drive that an effort moves", hint)
        elif kind.has_gear != self.is_elastic:
            got = "an elastic gear" if self.is_elastic else "no elastic gear"
            expected = f"{'an' if kind.has_gear else 'no'} elastic gear of a joint with the drive `{self.drive}`"
            yield Issue("gear", got, expected, "change the gear, or the drive")
        elif kind.has_motor and self.motor is None:
            yield Issue("motor", "nothing", f"a motor of the drive `{self.drive}`", "add `motor`")

    @property
    def kind(self) -> JointKind:
        """Its type with all that belongs to it."""
        return JOINTS[self.type]

    @property
    def coordinates(self) -> list[str]:
        """Names of its coordinates, were it not locked."""
        return [each.of(self.name) for each in self.kind.coordinates]

    @property
    def unit(self) -> str:
        """Of its coordinates: m where it slides, else rad."""
        return next((each.unit for each in self.kind.coordinates), "rad")

    @property
    def numbers(self) -> tuple[float, ...]:
        """The parameters of its type."""
        return _numbers(self.parameters)

    @property
    def drive_numbers(self) -> tuple[float, ...]:
        """The parameters of its kind of drive."""
        return _numbers(self.drive_parameters)

    @property
    def is_active(self) -> bool:
        """True when it is neither locked nor free."""
        return self.state is JointState.ACTIVE

    @property
    def is_elastic(self) -> bool:
        """True when a gear between motor and joint gives."""
        return self.gear is not None and not self.gear.is_rigid

    @property
    def is_locked(self) -> bool:
        """True when it does not move at all: fixed, or locked behind a rigid gear."""
        return not self.kind.moves or (self.state is JointState.LOCKED and not self.is_elastic)

    def notice(self) -> str:
        """What was put right in reading its axis; empty when nothing was."""
        length = float(np.linalg.norm(self.axis)) if self.axis else 1.0
        return "" if abs(length - 1) <= 1e-12 else f"axis of length {length:.9g} taken as a direction of length 1"


def _checked(schema: type[DataSheet] | None, given: Any) -> DataSheet | None:
    """Further numbers by the schema of a kind, which may have none."""
    if schema is None and given is not None:
        raise PydanticKnownError("none_required")
    return None if schema is None else schema.model_validate({} if given is None else given)


def _numbers(given: DataSheet | None) -> tuple[float, ...]:
    return tuple(number(getattr(given, name)) for name in type(given).model_fields) if given else ()
