"""Robot: the data sheet of any robot that a person writes, checked once, and its way to a Chain.

Robot (YAML, URDF + elasticity, Denavit-Hartenberg)  --chain()-->  Chain  ->  model
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, Any, Literal, Self

from pydantic import Field, field_validator, model_validator

from tmodes.errors import InputError
from tmodes.integrate.settings import RobotIntegration
from tmodes.kinds.contacts.registry import Contact
from tmodes.kinds.joints.joint import JointSheet
from tmodes.kinds.schema.frames import Origin, Vector, list_of_numbers
from tmodes.kinds.schema.quantity import DataSheet, Issue, not_negative, plain_texts, refuse
from tmodes.kinds.sensors.registry import Sensor
from tmodes.sheet.parts import (
    BaseMotion,
    ControlSheet,
    DriveSheet,
    Initial,
    LinkSheet,
    LoadSheet,
    Number,
    PointSheet,
    TipSheet,
    by_name,
    several,
)
from tmodes.sheet.planar import in_plane, planar_issues
from tmodes.sheet.task import Task
from tmodes.sheet.topology import tree_issues

__all__ = ["MOST_JOINTS", "RECURSION", "SHEET_FORMAT", "Robot", "RobotPair", "refuse_other", "yield_strength"]

SHEET_FORMAT = 1
"""Version of the data sheet's format."""

RECURSION = "recursion"
"""Equations of a robot whose sheet names no others."""

MOST_JOINTS = 500
MOST_BLOCKS = 200
MOST_NOTICES = 200
MOST_LETTERS = 2000
"""Longest notice [characters]."""

Notice = Annotated[str, Field(max_length=MOST_LETTERS)]
MOST_POINTS = 200
MOST_LOADS = 100

_FACTOR = not_negative("-", "-", "factor of the real arm on the known value", at_most=1e6)


class Robot(DataSheet):
    """A general robot: joints and links in a tree, what drives and loads it, and how it really is."""

    format: Literal[1] = Field(description="version of this format [-]")
    kind: Literal["arm"] = Field(description="what this sheet is of")
    name: str = Field(min_length=1, max_length=100, description="name of the arm")
    title: str = Field(default="", max_length=300, description="what it is, in one line")
    imported: str = Field(
        default="", max_length=100, description="the format that this was read from, whose paths stay usable"
    )
    citation: str = Field(default="", max_length=1000, description="where its numbers come from")
    assumed: str = Field(default="", max_length=2000, description="what is assumed and not from the source")
    notices: tuple[Notice, ...] = Field(
        default=(), strict=False, max_length=MOST_NOTICES, description="what was changed when a file was read"
    )
    gravity: Vector = list_of_numbers(
        "m/s^2", "g", "gravity in the world; one number: along -z", default=(0.0, 0.0, -9.81)
    )
    planar: bool = Field(default=False, description="true: it moves in one plane, in which alone its beams bend")
    base: Origin | None = Field(default=None, description="placement of the base in the world; none: at its origin")
    joints: tuple[JointSheet, ...] = Field(strict=False, max_length=MOST_JOINTS, description="joints, from the base on")
    equations: str = Field(
        default=RECURSION, min_length=1, max_length=100, description="recursion, or the name of a Lagrangian system"
    )
    parameters: dict[str, Number] = by_name("SI", "p", "numbers of the Lagrangian system that differ from its own [SI]")
    links: tuple[LinkSheet, ...] = several(MOST_JOINTS, "links; one that is not listed has no mass")
    tip: TipSheet | None = Field(default=None, description="the point called tip; none: the end of the last link")
    points: tuple[PointSheet, ...] = several(MOST_POINTS, "named points for loads, contact and output")
    couplings: dict[str, dict[str, Number]] = by_name(
        "-", "S", "gear input of a joint = sum of factor * motor angle of joints [-]"
    )
    loads: tuple[LoadSheet, ...] = several(MOST_LOADS, "forces and moments on points")
    drives: tuple[DriveSheet, ...] = several(MOST_JOINTS, "what moves the joints in a run")
    sensors: tuple[Sensor, ...] = several(MOST_BLOCKS, "what is measured, for the blocks of `control`")
    control: tuple[ControlSheet, ...] = several(MOST_BLOCKS, "blocks that command drives, filter, or estimate")
    base_motion: BaseMotion | None = Field(default=None, description="prescribed motion of the base; none: it stands")
    contact: Contact | None = Field(default=None, description="what a point touches; none: free space")
    contact_off: Contact | None = Field(
        default=None, description="a contact that is switched off: `contact: true` switches it on"
    )
    initial: Initial = Field(default_factory=Initial, description="state at time 0")
    real: dict[str, Annotated[float, _FACTOR]] = by_name(
        "-", "-", "the real arm where it differs: path of a number -> factor on it [-]"
    )
    task: Task | None = Field(default=None, description="what the tip shall do, and how closely; none: drives say it")
    integration: RobotIntegration = Field(default_factory=RobotIntegration)

    @field_validator("gravity", mode="before")
    @classmethod
    def _one_number_is_down(cls, value: Any) -> Any:
        if not isinstance(value, (int, float)) or isinstance(value, bool):
            return value
        if value < 0:
            hint = "write the magnitude, or a list [x, y, z] for another direction"
            refuse([Issue("", f"{value:g}", "a magnitude along -z, not negative, or a list", hint)])
        return (0.0, 0.0, -value if value else 0.0)

    @model_validator(mode="after")
    def _fits_together(self) -> Self:
        from tmodes.sheet.checks import sheet_issues

        refuse(list(self._text_issues()))
        if self.planar and not [*tree_issues(self.joints, [link.name for link in self.links])]:
            refuse([*planar_issues(self)])
            vars(self)["links"] = in_plane(self)
        refuse(sheet_issues(self))
        return self

    def _text_issues(self) -> list[Issue]:
        """Texts go to terminals and pages: letters that steer those are refused."""
        texts = {name: getattr(self, name) for name in ("name", "title", "citation", "assumed")}
        texts |= {f"notices.{index}": notice for index, notice in enumerate(self.notices)}
        for group in ("joints", "links", "points", "sensors", "control"):
            texts |= {f"{group}.{index}.name": item.name for index, item in enumerate(getattr(self, group))}
        texts |= {f"joints.{index}.child": joint.child for index, joint in enumerate(self.joints)}
        texts |= {
            f"links.{k}.bodies.{j}.name": body.name
            for k, link in enumerate(self.links)
            for j, body in enumerate(link.bodies)
        }
        return plain_texts(texts)

    @classmethod
    def from_data(cls, data: Mapping[str, Any]) -> Robot:
        """A checked robot from plain data (as a YAML file holds it); numbers may be text with a unit.

        Raises :class:`tmodes.errors.InputErrors` with everything that is wrong, where building a ``Robot`` directly
        raises pydantic's own error.
        """
        from tmodes import sheet_from_data

        return sheet_from_data(data)

    def with_(self, changes: Mapping[str, Any]) -> Robot:
        """A new, checked robot with values changed by path: ``robot.with_({"joints.shoulder.gear.stiffness": 900.0})``.

        Items of lists go by their name or their index. Raises :class:`tmodes.errors.InputErrors` that name the path.
        """
        from tmodes import changed_robot

        return changed_robot(self, changes)

    def __reduce__(self) -> tuple[Any, ...]:
        """What was pickled is read again as a data sheet, and checked."""
        return type(self).from_data, (self.model_dump(mode="json", by_alias=True, exclude_none=True),)

    @property
    def held_notices(self) -> list[str]:
        """What was assumed when a file was read: joints that are held, links with another name."""
        return [notice for notice in self.notices if notice in self.assumed]

    def link(self, name: str) -> LinkSheet:
        """The link with this name; one that the sheet does not describe is rigid and has no mass.

        >>> robot.link("link").bodies[0].mass
        1.0
        """
        if not isinstance(name, str) or not name:
            raise InputError("link", f"a {type(name).__name__}", "the name of a link", "links have their names as text")
        return next((link for link in self.links if link.name == name), None) or LinkSheet(name=name)

    def chain(self):
        """The robot in the terms of the recursion: placements, joints, links and points, SI, joint side.

        >>> robot.chain().coordinates
        ('joint.motor', 'joint')
        """
        return self._chain

    @cached_property
    def _chain(self):
        from tmodes import lowered_chain

        return lowered_chain(self)

    @cached_property
    def undriven(self) -> Robot:
        """The same without drives: every joint with its motor, none prescribed."""
        return self.model_copy(update={"drives": ()}) if self.drives else self

    def commanded(
        self, progress: Callable[[str, float], None] = lambda stage, share: None, vary: Iterable[str] = ()
    ) -> Robot:
        """The robot whose drives follow the path of its ``task``; without one the same. Found once.

        ``vary``: paths of numbers that change later, of which none may be of a task that is followed.
        Raises :class:`tmodes.errors.InputError` for a path that the robot cannot follow.

        >>> turn = {"path": {"type": "joints", "points": [[0.5]]}}
        >>> still = {"type": "constant", "value": 0.0}
        >>> own = robot.with_({"drives.joint.signal": still, "task": turn}).commanded()
        >>> own.drives[0].signal.type, own.task
        ('trajectory', None)
        """
        if self.stated is not self:
            for path in (one for one in vary if one.startswith("task.")):
                hint = "write a sheet for each, or compare them: `tmodes compare` with {task.reference: sag}"
                raise InputError(path, "a key of the task", "a number of the robot: references are made once", hint)
        if not (self.task and self.task.paths):
            return self
        if "_commanded" not in vars(self):
            from tmodes import commanded_robot

            vars(self)["_commanded"] = found = commanded_robot(self, progress)
            vars(found)["_stated"] = self
        return vars(self)["_commanded"].commanded(vary=vary)

    @property
    def stated(self) -> Robot:
        """The sheet with the path that the drives of this one follow; without one the same."""
        return vars(self).get("_stated", self)

    @property
    def pathless(self) -> Robot:
        """The same without the path of its ``task``: drives do what their own signals say."""
        judged = self.task and self.task.judged
        return self if judged is self.task else self.model_copy(update={"task": judged})

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:
        """As pydantic's; what follows from the fields is computed again."""
        if not isinstance(update, Mapping | None):
            hint = "robot.with_({PATH: VALUE}) checks the values, too"
            raise InputError("update", f"a {type(update).__name__}", "a group of fields and their values", hint)
        copied = super().model_copy(update=update, deep=deep)
        for name in ("_chain", "_commanded", "_stated", "undriven", "designs"):
            vars(copied).pop(name, None)
        return copied

    def pair(self) -> RobotPair:
        """The robot as it is known and as it really is.

        Raises :class:`tmodes.errors.InputErrors` for an entry of ``real`` that names no number, and for a factor that
        makes a number no robot can have.

        >>> robot.with_({"real.gear.stiffness": 0.5}).pair().real.joints[0].gear.stiffness
        (50.0,)
        """
        from tmodes import real_robot

        real = real_robot(self)
        if real is not self:
            vars(real)["nominal"] = self  # by which its laws are designed
        return RobotPair(nominal=self, real=real)


def refuse_other(robot: object, *others: type) -> None:
    """Refuse what is neither a robot nor one of the ``others``; raises :class:`tmodes.errors.InputError`."""
    if not isinstance(robot, (Robot, *others)):
        got, hint = f"a {type(robot).__name__}", "load it first: tmodes.load(NAME or FILE)"
        raise InputError("robot", got, "a tmodes.Robot", hint)


def yield_strength(robot: Robot, name: str) -> float | None:
    """Least yield strength [Pa] of a link's materials, None where unknown. Segments bear their link's name."""
    names = {link.name for link in robot.links}
    beam = robot.link(name if name in names else name.rpartition(".")[0]).beam if robot.links else None
    if beam is None:
        return None
    return min(beam.yield_strengths, default=None)


@dataclass(frozen=True)
class RobotPair:
    """The robot twice: with the numbers as known, by which motions are planned, and as they really are.

    Their motions are compared sample by sample, so that integration, equations and whether there is a contact must be
    the same. Raises :class:`tmodes.errors.InputError` where they differ.
    """

    nominal: Robot
    real: Robot

    def __post_init__(self) -> None:
        for name in ("integration", "equations", "contact"):
            known, real = getattr(self.nominal, name), getattr(self.real, name)
            if name == "contact":
                known, real = known is not None, real is not None
            if known != real:
                expected = f"that of the nominal robot, {known!r}"
                hint = "make them equal: the motions of both robots are compared sample by sample"
                raise InputError(f"{name} of the actual robot", repr(real), expected, hint)
