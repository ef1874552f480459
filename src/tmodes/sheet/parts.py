"""Parts of a robot's data sheet other than its joints: links, points, loads, drives, base motion, initial state."""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum
from typing import Annotated, Any, Self, Union

from pydantic import (
    Field,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    SerializeAsAny,
    TypeAdapter,
    field_validator,
    model_validator,
)
from pydantic_core import CoreSchema, core_schema

from tmodes.kinds.controllers.registry import Controller
from tmodes.kinds.links.body import BodySheet
from tmodes.kinds.links.registry import LINKS, BendingSheet
from tmodes.kinds.schema.frames import Origin, Vector, list_of_numbers
from tmodes.kinds.schema.quantity import LARGEST, DataSheet, Issue, not_negative, positive, quantity, refuse, too_late
from tmodes.kinds.signals.registry import Signal

__all__ = [
    "BaseMotion",
    "Command",
    "ControlSheet",
    "DriveSheet",
    "Initial",
    "InitialState",
    "LinkSheet",
    "LoadFrame",
    "LoadSheet",
    "Number",
    "PointSheet",
    "Saturation",
    "TipSheet",
    "by_name",
    "several",
]

MOST_BODIES = 200

_Name = Annotated[str, Field(min_length=1, max_length=100)]
Number = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]


def by_name(unit: str, symbol: str, meaning: str) -> Any:
    """A group of numbers by name, empty where it is left out."""
    extra: Any = {"unit": unit, "symbol": symbol, "smallest": 0.0, "plausible": None}
    return Field(default_factory=dict, description=meaning, json_schema_extra=extra)


def several(most: int, meaning: str) -> Any:
    """A list of groups, at most so many, empty where it is left out."""
    return Field(default=(), strict=False, max_length=most, description=meaning)


class _AnyBeam:
    """For the JSON Schema: a sheet of any link kind that is registered by then, or nothing."""

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.any_schema()

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: GetJsonSchemaHandler) -> Any:
        members: Any = (*LINKS.members, None)
        several: Any = Union[members]  # noqa: UP007
        return handler(TypeAdapter(several).core_schema)


class LinkSheet(DataSheet):
    """A link: rigid bodies, and a beam where it bends."""

    name: str = Field(min_length=1, max_length=100, description="name of the link")
    bodies: tuple[BodySheet, ...] = several(MOST_BODIES, "rigid bodies that it carries")
    beam: SerializeAsAny[BendingSheet] | None = Field(default=None, description="the beam; none: the link is rigid")

    @field_validator("beam", mode="plain", json_schema_input_type=_AnyBeam)
    @classmethod
    def _beam_of_its_kind(cls, value: Any) -> Any:
        """The sheet that the word ``model`` chooses among the registered kinds."""
        return None if value is None else BendingSheet.of(value)

    @model_validator(mode="after")
    def _stations_are_on_a_beam(self) -> Self:
        if self.beam is None:
            hint = "remove `at` and give the center in the link's frame"
            refuse(
                [
                    Issue(f"bodies.{index}.at", f"{body.at:g}", "left out: the link has no beam", hint)
                    for index, body in enumerate(self.bodies)
                    if body.at is not None
                ]
            )
        return self


class TipSheet(Origin):
    """The point called tip."""

    link: _Name = Field(description="link that it is on")
    at: float | None = quantity("-", "s", "station on a beam; none: its tip", default=None, at_least=0, at_most=1)


class PointSheet(TipSheet):
    """A named point for loads, contact and output."""

    name: str = Field(min_length=1, max_length=100, description="name of the point")


class LoadFrame(StrEnum):
    """``world``: the force keeps its direction (dead load); ``section``: it turns with the section (follower)."""

    WORLD = "world"
    SECTION = "section"


class LoadSheet(DataSheet):
    """A force and a moment on a point."""

    point: str = Field(default="tip", min_length=1, max_length=100, description="which point it acts on")
    force: Vector = list_of_numbers("N", "F", "force", default=(0.0, 0.0, 0.0))
    moment: Vector = list_of_numbers("N*m", "M", "moment", default=(0.0, 0.0, 0.0))
    frame: LoadFrame = Field(strict=False, description="world or section")
    signal: Signal | None = Field(default=None, description="factor of time on the load; none: constant")


class Command(StrEnum):
    """What a drive's signal is."""

    POSITION = "position"  # of the motor, or of the joint where its gear is rigid; kept by the controller
    VOLTAGE = "voltage"  # of the motor
    TORQUE = "torque"  # of the motor, joint side
    EFFORT = "effort"  # of the joint
    PRESCRIBED = "prescribed"  # the motion itself: of the motor behind an elastic gear, else of the joint

    @property
    def is_motion(self) -> bool:
        """Whether the signal is a position over time."""
        return self in {Command.POSITION, Command.PRESCRIBED}

    @property
    def is_controlled(self) -> bool:
        """Whether a controller keeps the position."""
        return self is Command.POSITION


class Saturation(DataSheet):
    """What a drive can give, at the joint's side of the reducer; every law on it is cut there."""

    voltage: float | None = positive("V", "u_max", "largest voltage", default=None)
    current: float | None = positive("A", "i_max", "largest current", default=None)
    torque: float | None = positive("N*m|N", "tau_max", "largest effort of the motor", default=None)
    speed: float | None = positive("rad/s|m/s", "w_max", "largest speed, at which nothing drives on", default=None)


def _sample_time() -> Any:
    return positive("s", "T", "time between samples; none: as the law says", default=None, plausible=(1e-5, 1.0))


def _delay() -> Any:
    return not_negative("s", "t_d", "from a sample to its command", default=0.0, at_most=10.0)


class ControlSheet(DataSheet):
    """A block of a control system: what it commands, and what it is."""

    name: str = Field(min_length=1, max_length=100, description="name of the block, by which others read its signals")
    drives: tuple[_Name, ...] = several(500, "joints whose drives it commands, in the order of its outputs")
    of: _Name | None = Field(
        default=None, description="joint whose setpoint and motor it sees as its own; none: that of its only drive"
    )
    sample_time: float | None = _sample_time()
    delay: float = _delay()
    block: Controller

    @property
    def joint(self) -> str:
        """The joint that it sees as its own; empty for none."""
        return self.of or (self.drives[0] if len(self.drives) == 1 else "")

    def _issues(self) -> Iterator[Issue]:
        yield from _lateness(self, self.block)


def _lateness(sheet: Any, law: Any) -> Iterator[Issue]:
    """Delays need samples, and a law with a sample time of its own takes no other."""
    own = law.period if law else None
    if own is not None and sheet.sample_time is not None:
        hint = "remove one of the two"
        yield Issue("sample_time", f"{sheet.sample_time:g} s", f"left out: the law samples every {own:g} s", hint)
    if sheet.delay and own is None and sheet.sample_time is None:
        expected = "a sample time, because `delay` is given"
        yield Issue("sample_time", "nothing", expected, "add `sample_time: 0.001`")
    yield from too_late(sheet.delay, sheet.sample_time if own is None else own)


class DriveSheet(DataSheet):
    """What moves a joint in a run."""

    joint: str = Field(min_length=1, max_length=100, description="which joint")
    command: Command = Field(strict=False, description="what the signal is")
    signal: Signal
    controller: Controller | None = Field(default=None, description="what keeps a wanted position")
    noise: Signal | None = Field(
        default=None, description="error on the wanted position as the controller sees it; of a sensor with other sign"
    )
    motion: Signal | None = Field(
        default=None, description="what the joint shall do, where the setpoint leads it; errors are counted from here"
    )
    feed_forward: Signal | None = Field(
        default=None, description="effort of the motor on top of what the controller commands, joint side [N*m, N]"
    )
    brake: Signal | None = Field(
        default=None, description="largest torque of the brake on the motor, or on the joint without one [N*m, N]"
    )
    saturation: Saturation | None = Field(default=None, description="what the drive can give; none: without limits")
    sample_time: float | None = _sample_time()
    delay: float = _delay()

    @property
    def disturbance(self) -> Any:
        """The noise; None where it is zero at all times."""
        silent = getattr(self.noise, "deviation", 1.0) == 0.0 and getattr(self.noise, "mean", 1.0) == 0.0
        return None if silent else self.noise

    def _issues(self) -> Iterator[Issue]:
        yield from _lateness(self, self.controller)
        command = self.command
        for name in ("controller", "noise", "motion", "feed_forward"):
            taken = command.is_motion if name == "motion" else command.is_controlled
            if not taken and getattr(self, name) is not None:
                got = f"a {name} with the command `{command}`"
                yield Issue(name, got, "left out", "remove it, or take the command `position`")
        if self.brake is not None and command is Command.PRESCRIBED:
            yield Issue(
                "brake", "a brake", "left out: the motion itself is given", "remove it, or take another command"
            )
        if self.controller is None and self.sample_time is not None:
            hint = "give them to the block in `control` that commands this drive"
            yield Issue("sample_time", f"{self.sample_time:g} s", "left out: the drive has no controller", hint)
        if self.saturation and self.command is Command.PRESCRIBED:
            hint = "remove `saturation`; `tmodes run` compares what it takes with what there is"
            yield Issue("saturation", "limits", "left out: the motion itself is given", hint)


class BaseMotion(DataSheet):
    """Prescribed motion of the base about its placement: travels [m] and fixed-axis angles [rad] over time."""

    x: Signal | None = None
    y: Signal | None = None
    z: Signal | None = None
    roll: Signal | None = None
    pitch: Signal | None = None
    yaw: Signal | None = None

    @property
    def turns(self) -> tuple[Signal | None, ...]:
        """The angles about x, y and z."""
        return self.roll, self.pitch, self.yaw


class InitialState(StrEnum):
    """How a run starts.

    ``rest``: in equilibrium of the closed loop at the first commands; ``held``: in static equilibrium with every motor
    on its first command, whose controllers set in at t = 0; ``zero``: undeformed, with the coordinates given.
    """

    REST = "rest"
    HELD = "held"
    ZERO = "zero"


class Initial(DataSheet):
    """The state at time 0."""

    state: InitialState = Field(default=InitialState.REST, strict=False, description="rest, held or zero")
    coordinates: dict[str, Number] = by_name("coordinate", "q", "initial value of a coordinate, by its name")
    rates: dict[str, Number] = by_name("coordinate/s", "v", "initial rate of a coordinate, by its name")

    @property
    def names(self) -> tuple[str, ...]:
        """The coordinates that are given."""
        return (*self.coordinates, *self.rates)
