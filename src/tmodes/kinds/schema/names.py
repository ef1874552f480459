"""A field that names a member of a registry: any that is registered when the data sheet is read."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import PydanticKnownError, core_schema

from tmodes.kinds.registry import Registry

__all__ = ["NameOf"]


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
