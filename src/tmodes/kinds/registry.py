"""Kinds by name: for each family one registry, with the members of tmodes and those that a user registers.

A member is a class below the contract of its family, or an object of it. A kind of tmodes is imported when it is first
asked for; any other is found only after its module has been imported: by the user's script, or on request
(:mod:`tmodes.kinds.outside`). A data sheet names kinds and never causes an import of other modules.
"""

from __future__ import annotations

import hashlib
import secrets
from collections.abc import Callable, Iterable, Iterator, Mapping
from difflib import get_close_matches
from functools import cache, cached_property
from importlib import import_module
from typing import Any, ClassVar, TypeVar

from tmodes.errors import InputError
from tmodes.kinds.code_identity import UnidentifiedError, code_digest

__all__ = [
    "REGISTRIES", "NamedKind", "Registry", "UnknownKindError", "outside_digest", "source_digest",
]  # fmt: skip

Member = TypeVar("Member")
Given = TypeVar("Given")


class UnknownKindError(InputError, KeyError):
    """A name that no registered kind has."""


class Registry(Mapping[str, Member]):
    """The members of one family by name, in the order in which they were registered."""

    def __init__(
        self,
        noun: str,
        contract: type[Any],
        *,
        names: Callable[[Any], Iterable[str]] = lambda member: (member.name,),
        made: Callable[[Any], Member] = lambda given: given,
        reserved: tuple[str, ...] = (),
        check: Callable[[Any], None] = lambda member: None,
        hint: str = "register a kind of your own before it is named, by your script or by --use",
        replaces: bool = False,
    ) -> None:
        """``names`` of a member, ``made`` of what is registered; ``reserved`` names; ``check`` refuses a member.

        ``hint`` where a name is not known; ``replaces``: a later member takes the place of one with its name.
        """
        self.noun, self.contract, self.reserved, self.hint = noun, contract, reserved, hint
        self._names, self._made, self._check, self._replaces = names, made, check, replaces
        self._members: dict[str, Member | None] = {}
        self._homes: dict[str, str] = {}
        REGISTRIES[noun] = self

    def bring(self, package: str, modules: Mapping[str, str]) -> None:
        """Add kinds of tmodes by their names: each name's module in ``package`` registers it, when it is asked for."""
        self._homes |= {name: f"{package}.{module}" for name, module in modules.items()}
        self._members = dict.fromkeys(modules) | self._members

    def _found(self, name: str) -> Member | None:
        """The member of a name, imported where that is to be done; None where there is none, or not yet."""
        if self._members.get(name) is None and name in self._members:
            import_module(self._homes[name])
        return self._members.get(name)

    def register(self, given: Given) -> Given:
        """Add a kind, as a decorator of its class, or an object; the same class again (a cell run twice) replaces it.

        Raises :class:`tmodes.errors.InputError` for what is not of the contract, has no name, or one that is taken.
        """
        cls = given if isinstance(given, type) else type(given)
        where = f"{self.noun} {cls.__qualname__}"
        if not issubclass(cls, self.contract):
            hint = f"derive it from {self.contract.__module__}.{self.contract.__qualname__}"
            raise InputError(where, f"a class that is no {self.contract.__name__}", self.contract.__name__, hint)
        member = self._made(given)
        names = [name for name in self._names(member) if name]
        if not names:
            raise InputError(where, "no name", "the name of the kind", "give it one, as the contract says")
        for name in names:
            known = self._found(name)
            free = known is None or self._replaces or self._same(known, member)
            if name in self.reserved or not free:
                by = f", by {_class_of(known).__module__}" if known is not None else ""
                hint = f"choose another name than {', '.join((*self.reserved, *self.names))}"
                raise InputError(where, f"`{name}`, which is taken{by}", f"a name that no {self.noun} has", hint)
        self._check(member)
        self._members |= dict.fromkeys(names, member)
        return given

    def _same(self, one: Any, other: Any) -> bool:
        """Whether two members are of the same class; of objects of the contract itself, whether they are equal."""
        first, second = _class_of(one), _class_of(other)
        same = (first.__module__, first.__qualname__) == (second.__module__, second.__qualname__)
        return same and (first is not self.contract or one == other)

    def unregister(self, name: str) -> None:
        """Remove a kind, with all of its names."""
        gone = self[name]
        self._members = {each: member for each, member in self._members.items() if member is not gone}

    def __getitem__(self, name: str) -> Member:
        """The kind of a name; raises :class:`UnknownKindError`."""
        member = self._found(name)
        if member is None:
            known = (*self.reserved, *self.names)
            close = get_close_matches(name, known, n=1)
            hint = f"did you mean `{close[0]}`?" if close else self.hint
            raise UnknownKindError(self.noun, f"`{name}`", f"one of {', '.join(known)}", hint)
        return member

    def __iter__(self) -> Iterator[str]:
        return iter(self._members)

    def __len__(self) -> int:
        return len(self._members)

    def __hash__(self) -> int:
        return id(self)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of all kinds."""
        return tuple(self._members)

    @property
    def members(self) -> tuple[Member, ...]:
        """All kinds, each once."""
        return tuple(dict.fromkeys(self.values()))

    @property
    def outside(self) -> tuple[Member, ...]:
        """Kinds that tmodes does not bring, each once."""
        return tuple(dict.fromkeys(self[name] for name in self._members if name not in self._homes))


REGISTRIES: dict[str, Registry[Any]] = {}
"""The registries of all families that are imported, by their nouns."""


class NamedKind:
    """A stateless object that holds all that one kind of joint, drive, ... is; two of one class are equal."""

    name: ClassVar[str] = ""
    """The word in data sheets."""

    @cached_property
    def key(self) -> str:
        """The name, for code that is compiled once and cached; of a kind from outside with a digest of its source."""
        return f"{self.name} {source_digest(type(self))}".rstrip()

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other)

    def __hash__(self) -> int:
        return hash(type(self))

    def __str__(self) -> str:
        return self.name

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.name}>"


def source_digest(cls: type[Any]) -> str:
    """Digest of the source of a class and its bases outside of tmodes, for keys of compiled code; empty for our own."""
    known = ("tmodes.", "pydantic", "builtins", "abc", "typing")
    outside = [base for base in cls.__mro__ if not base.__module__.startswith(known)]
    return hashlib.sha256("\n".join(map(_source, outside)).encode()).hexdigest()[:16] if outside else ""


def outside_digest() -> str:
    """Digests of the sources of all registered kinds from outside of tmodes; empty where there are none."""
    every = {_class_of(member) for registry in REGISTRIES.values() for member in registry.outside}
    return " ".join(sorted({digest for cls in every if (digest := source_digest(cls))}))


def _class_of(member: Any) -> type[Any]:
    return member if isinstance(member, type) else type(member)


@cache
def _source(member: type[Any]) -> str:
    """Digest of a class and what it names; one that nobody can identify is another in each process."""
    try:
        return code_digest(member)
    except UnidentifiedError:
        return secrets.token_hex()
