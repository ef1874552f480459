"""Families of kinds: a field of a data sheet that takes any member of a family, those of a user's script too.

A family is a class below :class:`Kind`; its members are subclasses with a field ``Literal[NAME]`` that names them
(``type``, ``law``). A sheet can only name members that are already registered; it never causes an import.
"""

from __future__ import annotations

import hashlib
import inspect
import sys
from collections.abc import Callable
from importlib.metadata import entry_points
from typing import Annotated, Any, ClassVar, Literal, Self, TypeVar, Union, get_args, get_origin

from pydantic import Field, GetCoreSchemaHandler, GetJsonSchemaHandler, TypeAdapter
from pydantic_core import CoreSchema, core_schema

from tmodes.errors import InputError
from tmodes.kinds.schema.quantity import DataSheet

__all__ = ["ENTRY_POINTS", "Kind", "load_entry_points", "source_digest"]

ENTRY_POINTS = "tmodes.kinds"
"""Group of the entry points by which installed packages offer kinds."""

_EXPANDING: list[type[Any]] = []
"""Families whose JSON Schema is being written."""

M = TypeVar("M", bound="type[Kind]")


class Kind(DataSheet):
    """Base of a family (``class Signal(Kind, family="signal", key="type")``) and of its members."""

    family: ClassVar[str] = ""
    """The family in words, for messages."""
    key: ClassVar[str] = "type"
    """The field that names the member."""
    registered: ClassVar[dict[str, type[Any]]]
    root: ClassVar[type[Any]]
    _adapter: ClassVar[tuple[tuple[type[Any], ...], TypeAdapter[Any]] | None]

    def __init_subclass__(cls, *, family: str = "", key: str = "type", **more: Any) -> None:
        super().__init_subclass__(**more)
        if family:
            cls.family, cls.key, cls.root, cls.registered, cls._adapter = family, key, cls, {}, None

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
        return tuple(cls.registered.values()) if cls is cls.root else (cls,)

    @classmethod
    def register(cls) -> Callable[[M], M]:
        """Decorator that adds a class to its family: ``@Signal.register()``.

        Raises :class:`tmodes.errors.InputError` for a class without a name of its kind, and for a name that is taken.
        """

        def add(member: M) -> M:
            name = member.name_of_kind()
            where = f"{cls.family} {member.__qualname__}"
            if not name:
                hint = f"give it the field `{cls.key}: Literal['its_name']`"
                raise InputError(where, f"no field `{cls.key}` that names it", "the name of the kind", hint)
            taken = cls.root.registered.get(name)
            if taken is not None and _identity(taken) != _identity(member):
                expected = f"a name that no {cls.family} has"
                raise InputError(where, repr(name), expected, f"choose another name than {', '.join(cls.registered)}")
            cls.root.registered[name] = member
            return member

        return add

    @classmethod
    def fingerprint(cls) -> str:
        """Name of the kind for keys of compiled code; of a class outside of tmodes with a digest of its source."""
        name = f"{cls.root.family} {cls.name_of_kind() or cls.__qualname__}"
        return f"{name} {source_digest(cls)}".rstrip()

    @classmethod
    def _any_member(cls) -> TypeAdapter[Any]:
        """Checks data against the members that are registered now."""
        members = tuple(cls.root.registered.values())
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
            names = {"enum": sorted(cls.registered)}
            return {"type": "object", "properties": {cls.key: names}, "required": [cls.key]}
        _EXPANDING.append(cls)
        try:
            return handler(cls._any_member().core_schema)
        finally:
            _EXPANDING.remove(cls)


def load_entry_points() -> list[str]:
    """Import what installed packages offer in the group ``tmodes.kinds``; the names of the entry points.

    Only a person asks for this, never a sheet or a result.
    """
    found = entry_points(group=ENTRY_POINTS)
    for point in found:
        point.load()
    return [point.name for point in found]


def source_digest(cls: type[Any]) -> str:
    """Digest of the source of a class and its bases outside of tmodes, for keys of compiled code; empty for our own."""
    known = ("tmodes.", "pydantic", "builtins", "abc", "typing")
    outside = [base for base in cls.__mro__ if not base.__module__.startswith(known)]
    return hashlib.sha256("\n".join(map(_source, outside)).encode()).hexdigest()[:16] if outside else ""


def _identity(member: type[Any]) -> tuple[str, str]:
    return member.__module__, member.__qualname__


def _source(member: type[Any]) -> str:
    """Source of the module of a class, else the byte code of its functions."""
    try:
        return inspect.getsource(sys.modules[member.__module__])
    except (OSError, TypeError, KeyError):
        functions = [value for value in vars(member).values() if inspect.isfunction(value)]
        return repr([(f.__code__.co_code, f.__code__.co_consts, f.__code__.co_names) for f in functions])
