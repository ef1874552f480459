"""Families of kinds: a field of a data sheet that takes any member of a family, those of a user's script too.

A family is a class below :class:`Kind`, with a registry; its members are subclasses with a field ``Literal[NAME]``
that names them (``type``, ``law``). A sheet can only name members that are registered; it never causes an import.
"""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, Literal, Self, Union, get_args, get_origin

from pydantic import Field, GetCoreSchemaHandler, GetJsonSchemaHandler, TypeAdapter
from pydantic_core import CoreSchema, core_schema

from tmodes.kinds.registry import Registry, source_digest
from tmodes.kinds.schema.quantity import DataSheet

__all__ = ["Kind"]

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
        """The member that plain data name, checked."""
        return cls._any_member().validate_python(data)

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
        return core_schema.no_info_plain_validator_function(lambda value: cls._any_member().validate_python(value))

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
