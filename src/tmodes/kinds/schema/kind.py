"""Families of kinds: a field of a data sheet that takes any member of a family, those of a user's script too.

A family is a class below :class:`Kind`, with a registry; its members are subclasses with a field ``Literal[NAME]``
that names them (``type``, ``law``). A sheet can only name members that are registered; it never causes an import.
:class:`NameOf` names a member in a plain field, :class:`NumbersOf` takes the form that a named member asks for.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal, Self, Union, get_args, get_origin

from pydantic import Field, GetCoreSchemaHandler, GetJsonSchemaHandler, TypeAdapter
from pydantic.fields import FieldInfo
from pydantic_core import CoreSchema, PydanticKnownError, core_schema

from tmodes.kinds.registry import Registry, source_digest
from tmodes.kinds.schema.quantity import DataSheet

__all__ = ["Kind", "NameOf", "NumbersOf", "form_of_field", "names_allowed"]

_EXPANDING: list[type[Any]] = []
"""Families whose JSON Schema is being written."""


class Kind(DataSheet):
    """Base of a family (``class Signal(Kind, family="signal", key="type")``) and of its members."""

    family: ClassVar[str] = ""
    """The family in words, for messages."""
    key: ClassVar[str] = "type"
    """The field that names the member."""
    registry: ClassVar[Registry[type[Any]]]
    root: ClassVar[type[Any]]
    _adapter: ClassVar[tuple[tuple[type[Any], ...], TypeAdapter[Any]] | None]

    def __init_subclass__(cls, *, family: str = "", key: str = "type", **more: Any) -> None:
        super().__init_subclass__(**more)
        if family:
            cls.family, cls.key, cls.root, cls._adapter = family, key, cls, None
            cls.registry = Registry(family, cls, names=lambda member: (member.name_of_kind(),))

    @classmethod
    def name_of_kind(cls) -> str:
        """The name by which a sheet asks for this member; empty for a family and for shared bases."""
        info = cls.__annotations__.get(cls.key) and cls.model_fields.get(cls.key)
        return str(get_args(info.annotation)[0]) if info and get_origin(info.annotation) is Literal else ""

    @classmethod
    def of(cls, data: Any) -> Any:
        """The member that plain data name, checked; only this one's module is imported."""
        member = cls.kind_named(data)
        return cls._any_member().validate_python(data) if member is None else member.model_validate(data)

    @classmethod
    def kind_named(cls, data: Any) -> type[Any] | None:
        """The member that data, or an object of it, names; None where they name none that is registered."""
        if cls is not cls.root:
            return cls
        name = data.get(cls.key) if isinstance(data, Mapping) else getattr(data, cls.key, None)
        return cls.registry[name] if isinstance(name, str) and name in cls.registry.names else None

    @classmethod
    def members(cls) -> tuple[type[Self], ...]:
        """All registered members of the family, in the order of their registration; of a member, itself."""
        return cls.registry.members if cls is cls.root else (cls,)

    @classmethod
    def fingerprint(cls) -> str:
        """Name of the kind for keys of compiled code; of a class outside of tmodes with a digest of its source."""
        name = f"{cls.root.family} {cls.name_of_kind() or cls.__qualname__}"
        return f"{name} {source_digest(cls)}".rstrip()

    @classmethod
    def _any_member(cls) -> TypeAdapter[Any]:
        """Checks data against the members that are registered now."""
        members = cls.root.registry.members
        if cls.root._adapter is None or cls.root._adapter[0] != members:
            union: Any = Union[members] if members else Any  # noqa: UP007
            several: Any = Annotated[union, Field(discriminator=cls.key)] if len(members) > 1 else union
            cls.root._adapter = (members, TypeAdapter(several))
        return cls.root._adapter[1]

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        if cls is not getattr(cls, "root", None):
            return handler(source)
        return core_schema.no_info_plain_validator_function(cls.of)

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: GetJsonSchemaHandler) -> Any:
        if cls is not getattr(cls, "root", None):
            return handler(schema)
        if cls in _EXPANDING:  # a member that holds members of its own family: written out once, then by name
            names = {"enum": sorted(cls.registry.names)}
            return {"type": "object", "properties": {cls.key: names}, "required": [cls.key]}
        _EXPANDING.append(cls)
        try:
            return handler(cls._any_member().core_schema)
        finally:
            _EXPANDING.remove(cls)


@dataclass(frozen=True)
class NameOf:
    """Annotation of a text: the name of a kind of ``registry``."""

    registry: Registry[Any]

    def __hash__(self) -> int:
        return id(self.registry)

    @property
    def names(self) -> tuple[str, ...]:
        """The names that are allowed now."""
        return self.registry.names

    def _registered(self, name: str) -> str:
        if name not in self.registry:
            *some, last = (repr(each) for each in self.names)
            raise PydanticKnownError("enum", {"expected": f"{', '.join(some)} or {last}"})
        return name

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> core_schema.CoreSchema:
        """Any text, then its name."""
        return core_schema.no_info_after_validator_function(self._registered, handler(source))

    def __get_pydantic_json_schema__(
        self, schema: core_schema.CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        """The names as an enumeration, for editors."""
        return {**handler(schema), "enum": list(self.names)}


@dataclass(frozen=True)
class NumbersOf:
    """Annotation of a group: the ``schema`` of the member of ``registry`` that another ``field`` of the sheet names."""

    registry: Registry[Any]
    field: str

    def __hash__(self) -> int:
        return id(self.registry)


def names_allowed(info: FieldInfo | None) -> list[str]:
    """The names that a field allows; none of a field that names no kind."""
    if info is None:
        return []
    rules = [*info.metadata, *(rule for one in get_args(info.annotation) for rule in get_args(one)[1:])]
    return [name for rule in rules if isinstance(rule, NameOf) for name in rule.names]


def form_of_field(info: FieldInfo, group: Any) -> Any:
    """The type of what stands in a field of a ``group`` of plain data: of its own, or by the kind that it names."""
    rule = next((rule for rule in info.metadata if isinstance(rule, NumbersOf)), None)
    named = group.get(rule.field) if rule and isinstance(group, Mapping) else None
    schema = rule.registry[named].schema if rule and isinstance(named, str) and named in rule.registry else None
    return schema or info.annotation
