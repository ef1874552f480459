"""The task of a robot: a path of its tip, how fast, what the motors know of the robot, and how closely."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from enum import StrEnum
from functools import cache
from typing import Annotated, Any, Union

from pydantic import (
    Field,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    SerializerFunctionWrapHandler,
    TypeAdapter,
    model_serializer,
)
from pydantic_core import CoreSchema, core_schema

from tmodes.kinds.paths.registry import Path
from tmodes.kinds.schema.quantity import DataSheet, Issue, positive, refuse
from tmodes.kinds.shapers.registry import Shaper
from tmodes.kinds.signals.registry import Signal
from tmodes.kinds.timings.registry import Timing

__all__ = ["ENDS", "ReferenceKind", "Task", "accepted_error"]

ENDS = {"start": 0.0, "end": 1.0}
"""Keys of a signal from one value to another that a profile leaves out: it goes from 0 to the length of the path."""

_MOST_PATHS = 100


class ReferenceKind(StrEnum):
    """What the setpoints of the motors know of the robot, from least to most."""

    RIGID = "rigid"  # joints of the rigid robot
    MOTORS = "motors"  # the same, and the efforts that keep the motors on them
    SAG = "sag"  # the tip is on the path at rest
    QUASI_STATIC = "quasi_static"  # the tip is on the path as weight and the inertia of the motion bend the robot
    INVERSE = "inverse"  # the tip is on the path as the robot bends and moves
    OPTIMAL = "optimal"  # rest to rest in the time of the path, within the limits, near it


def accepted_error(**more: Any) -> Any:
    """The field of the error of the tip up to which a run is good."""
    meaning = "largest error from the commanded path that is accepted"
    return positive("m", "tol", meaning, plausible=(1e-7, 1.0), **more)


class _OneOrSeveral:
    """A path, or a list of paths."""

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(cls._read)

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: GetJsonSchemaHandler) -> Any:
        return handler(TypeAdapter(Path | _Several).core_schema)

    @staticmethod
    def _read(value: Any) -> Any:
        return _several().validate_python(value) if isinstance(value, list | tuple) else Path.of(value)


_Several = Annotated[tuple[Path, ...], Field(strict=False, min_length=1, max_length=_MOST_PATHS)]


@cache
def _several() -> TypeAdapter[tuple[Path, ...]]:
    return TypeAdapter(_Several)


class _Profile:
    """A signal from one value to another, without these, or a timing."""

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        plain = core_schema.plain_serializer_function_ser_schema(cls._plain)
        return core_schema.no_info_plain_validator_function(cls._read, serialization=plain)

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: GetJsonSchemaHandler) -> Any:
        moves = [kind.model_json_schema(by_alias=True) for kind in _moves()]
        for one in moves:
            one["properties"] = {key: value for key, value in one["properties"].items() if key not in ENDS}
            one["required"] = [key for key in one["required"] if key not in ENDS]
        timings: Any = Union[Timing.members()]  # noqa: UP007
        return {"anyOf": [*moves, handler(TypeAdapter(timings).core_schema)]}

    @staticmethod
    def _read(value: Any) -> Any:
        if Timing.kind_named(value):
            return Timing.of(value)
        kind = Signal.kind_named(value)
        if kind is not None and kind.model_fields.keys() >= ENDS.keys():
            return kind.model_validate({**value, **ENDS} if isinstance(value, Mapping) else value)
        known = f"one of {', '.join([one.name_of_kind() for one in _moves()] + [*Timing.registry.names])}"
        if not isinstance(value, Mapping):
            expected, hint = f"a group with a type, {known}", "write it as {type: s_curve, ...}"
            return refuse([Issue("", f"{value!r:.60}", expected, hint)])
        got = f"{value['type']!r:.60}" if "type" in value else "nothing"
        return refuse([Issue("type", got, known, "take s_curve, or a timing")])

    @staticmethod
    def _plain(value: Any) -> dict[str, Any]:
        return value.model_dump(mode="json", by_alias=True, exclude_none=True, exclude=set(ENDS))


def _moves() -> list[type[Signal]]:
    """Signals from one value to another."""
    return [kind for kind in Signal.members() if kind.model_fields.keys() >= ENDS.keys()]


class Task(DataSheet):
    """What the tip shall do and how closely; without a path the drives say what is done."""

    tolerance: float | None = accepted_error(default=None)
    path: Annotated[Path | tuple[Path, ...], _OneOrSeveral] | None = Field(
        default=None, description="of the tip, or of the joints; several in a list, each from rest to rest"
    )
    profile: Annotated[Signal | Timing, _Profile] | None = Field(
        default=None, description="of the way along the path: a signal without start and end, or a timing; none: gentle"
    )
    reference: ReferenceKind = Field(
        default=ReferenceKind.RIGID, strict=False, description="what the setpoints of the motors know of the robot"
    )
    shaper: Shaper | None = Field(default=None, description="of the way along the path; none: not shaped")
    least_time: bool = Field(default=False, description="true: as fast as limits of speed and effort allow")
    fit: float = positive(
        "m", "eps", "largest distance of the rigid robot's tip from the path between rows of the references; as much "
        "in rad", default=1e-7, plausible=(1e-12, 1e-2),
    )  # fmt: skip

    @property
    def paths(self) -> tuple[Path, ...]:
        """One after the other; none where there is no path."""
        return self.path if isinstance(self.path, tuple) else () if self.path is None else (self.path,)

    @property
    def timing(self) -> Timing | None:
        """The profile, where it is a timing."""
        given: Any = self.profile
        return given if Timing.kind_named(given) else None

    @property
    def judged(self) -> Task | None:
        """The same without a path; None where nothing is left of it."""
        if self.path is None:
            return self
        return None if self.tolerance is None else Task(tolerance=self.tolerance)

    @model_serializer(mode="wrap")
    def _given(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """Without what is left out."""
        own = type(self).model_fields
        return {name: value for name, value in handler(self).items() if value != own[name].default}

    def _issues(self) -> Iterator[Issue]:
        if self.path is None:
            hint = "add `path: {type: line, to: [0.6, 0.0, 0.2]}`"
            given = [name for name in type(self).model_fields if name in self.model_fields_set - {"path", "tolerance"}]
            for name in given:
                yield Issue(name, f"a {name} without a path", "left out, or a path", hint)
            if not given and self.tolerance is None:
                yield Issue("", "nothing", "a path, or a tolerance", hint)
        if self.least_time and self.timing:
            got, hint = f"the timing `{self.timing.type}`", "leave it out: the timing is found by it"
            yield Issue("least_time", got, "a profile whose time changes", hint)
