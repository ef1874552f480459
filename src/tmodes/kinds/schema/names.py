"""A field that names a member of a registry, and one whose form follows from a member that another field names.

Any member may be named that is registered when the data sheet is read.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, get_args

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic.fields import FieldInfo
from pydantic_core import PydanticKnownError, core_schema

from tmodes.kinds.registry import Registry

__all__ = ["NameOf", "NumbersOf", "form_of_field", "names_allowed"]


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
