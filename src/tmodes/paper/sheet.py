"""Robot: the data sheet a person writes. Physics is checked once, here; inner code trusts.

``Robot.split`` parts it into structure and numbers, ``Robot.pair`` into the robot as it is known and as it really is.
"""

from __future__ import annotations

import math
import unicodedata
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BaseModel, Field, model_validator

from tmodes.errors import InputError
from tmodes.integrate.settings import Integration
from tmodes.kinds.schema.quantity import DataSheet, Issue, not_negative, refuse
from tmodes.kinds.signals.schedule import Schedule
from tmodes.paper.environment import DynamicEnvironment
from tmodes.paper.gear import ElasticGear
from tmodes.paper.local_pd import LocalPD
from tmodes.paper.mechanism import Drive, Mechanism, Parameters, Reading
from tmodes.paper.mode import FlexibleLink
from tmodes.paper.motor import Motor
from tmodes.paper.payload import Payload
from tmodes.paper.trapezoidal_move import TrapezoidalMove

__all__ = ["FACTOR", "FORMAT", "PLANT", "PaperPair", "PaperRobot"]

FORMAT = 1
"""Version of the data sheet's format."""

PLANT = ("gravity", "motor", "gear", "link", "payload", "environment", "controller")
"""The groups whose numbers are inputs of the equations."""

_STEERING = ("Cc", "Cf", "Cs", "Co")
"""Unicode categories of letters that are not shown but steer what is: control, direction, surrogates, private."""

FACTOR = not_negative("-", "-", "factor of the real robot on the known value", at_most=1e6)
"""An entry of ``real``: zero takes a damping or a payload away."""


class PaperRobot(DataSheet):
    """A robot's data sheet: motor, elastic gear, flexible link, payload, environment, control and wanted motion."""

    format: Literal[1] = Field(description="version of this format [-]")
    name: str = Field(min_length=1, max_length=100, description="name of the robot")
    title: str = Field(default="", max_length=300, description="what it is, in one line")
    citation: str = Field(default="", max_length=1000, description="where its numbers come from")
    reading: Reading = Field(
        default=Reading.CONSISTENT, strict=False, description="which reading of the paper's equations"
    )
    contact: bool = Field(description="true: the tip presses on the environment; false: free space")
    gravity: float = not_negative("m/s^2", "g", "gravity, along -z", default=9.81, plausible=(0.0, 30.0))
    motor: Motor
    gear: ElasticGear
    link: FlexibleLink
    payload: Payload
    environment: DynamicEnvironment
    controller: LocalPD
    reference: TrapezoidalMove
    real: dict[str, Annotated[float, FACTOR]] = Field(
        default_factory=dict,
        description="the real robot where it differs from the known one: path of a number -> factor on it [-]",
    )
    integration: Integration = Field(default_factory=Integration)

    @model_validator(mode="after")
    def _plain_text(self) -> PaperRobot:
        """Texts go to terminals and pages: letters that steer those are refused."""
        texts = {name: getattr(self, name) for name in ("name", "title", "citation")}
        refuse(
            [
                Issue(name, ascii(text[:60]), "text without control characters", "write it in plain letters")
                for name, text in texts.items()
                if any(unicodedata.category(letter) in _STEERING and letter != "\n" for letter in text)
            ]
        )
        return self

    @classmethod
    def from_data(cls, data: Mapping[str, Any]) -> PaperRobot:
        """A checked robot from plain data (as a YAML file holds it); numbers may be text with a unit.

        Raises :class:`tmodes.errors.InputErrors` with everything that is wrong, where building a ``Robot`` directly
        raises pydantic's own error.
        """
        return cls.model_validate(dict(data))

    def with_(self, changes: Mapping[str, Any]) -> PaperRobot:
        """A new, checked robot with numbers changed by path: ``robot.with_({"gear.stiffness": 900.0})``.

        Raises :class:`tmodes.errors.InputErrors` that name the path when a value is wrong.
        """
        data = self.model_dump(mode="json")
        for path, value in changes.items():
            group, _, rest = path.partition(".")
            words = [group, rest] if group == "real" and rest else path.split(".")
            inner: Any = data
            for word in words[:-1]:
                inner = inner[int(word)] if isinstance(inner, list) else inner[word]
            inner[int(words[-1]) if isinstance(inner, list) else words[-1]] = value
        return PaperRobot.model_validate(data)

    def numbers(self) -> Iterator[tuple[str, float]]:
        """Path and value [SI] of every number that is an input of the equations."""
        for group in PLANT:
            yield from _leaves(getattr(self, group), group)

    def rigid_elements(self) -> frozenset[str]:
        """Names of the elements whose stiffness is infinite: rigid by wish."""
        modes = {f"mode{k}": mode.bending_stiffness for k, mode in enumerate(self.link.modes, 1)}
        stiffness = {"gear": self.gear.stiffness, **modes}
        return frozenset(name for name, value in stiffness.items() if math.isinf(value))

    def split(
        self, drive: Drive = Drive.CONTROLLED, *, reading: Reading | None = None, contact: bool | None = None
    ) -> tuple[Mechanism, Parameters]:
        """Part the robot into its structure and its numbers; ``reading`` and ``contact`` override its own."""
        in_contact = self.contact if contact is None else contact
        mechanism = Mechanism(
            reading=reading or self.reading,
            contact=self.environment.friction_law if in_contact else None,
            drive=drive,
            rigid=self.rigid_elements(),
            reference_degree=self.wanted(drive).degree,
        )
        names, values = zip(*self.numbers(), strict=True)
        return mechanism, Parameters(names, np.array(values))

    def wanted(self, drive: Drive) -> Schedule:
        """The wanted motor angle [rad] over a run: a controller hears it with ``reference.noise``."""
        motion = self.reference.schedule()
        return self.reference.noise.on(motion, self.integration.duration) if drive is Drive.CONTROLLED else motion

    def pair(self) -> PaperPair:
        """The robot as it is known and as it really is.

        Raises :class:`tmodes.errors.InputError` for an entry of ``real`` that names no number, and
        :class:`tmodes.errors.InputErrors` for a factor that makes a number no robot can have.
        """
        numbers = dict(self.numbers())
        unknown = [path for path in self.real if path not in numbers]
        if unknown:
            raise InputError("real", f"{unknown[0]!r}", "the path of a number of the robot", f"one of {list(numbers)}")
        changes = {path: numbers[path] * factor for path, factor in self.real.items()}
        return PaperPair(nominal=self, real=self.with_({**changes, "real": {}}) if changes else self)


@dataclass(frozen=True)
class PaperPair:
    """The robot twice: with the characteristics as known (superscript o in the paper), and as they really are.

    The reference motion is planned with ``nominal``; what happens is simulated with ``real``.
    """

    nominal: PaperRobot
    real: PaperRobot

    def __post_init__(self) -> None:
        for name in ("reading", "contact", "reference", "integration"):
            known, real = getattr(self.nominal, name), getattr(self.real, name)
            if known != real:
                expected = f"the same as the nominal robot's, {known!r}: their motions are compared sample by sample"
                raise InputError(f"NominalRealPair: {name} of the real robot", repr(real), expected, "make them equal")


def _leaves(value: Any, path: str) -> Iterator[tuple[str, float]]:
    if isinstance(value, BaseModel):
        for name in type(value).model_fields:
            yield from _leaves(getattr(value, name), f"{path}.{name}")
    elif isinstance(value, tuple):
        for index, item in enumerate(value):
            yield from _leaves(item, f"{path}.{index}")
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield path, float(value)
