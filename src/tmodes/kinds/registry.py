"""Members of a package of kinds by name: those of tmodes, and those that a user registers.

A kind is found only after its module has been imported: by the user's script, or by
:func:`tmodes.kinds.schema.kind.load_entry_points`. A data sheet names kinds and never causes an import.
"""

from __future__ import annotations

import hashlib
import marshal
import sys
from difflib import get_close_matches
from functools import cached_property
from pathlib import Path
from typing import ClassVar, Generic, TypeVar

__all__ = ["NamedKind", "Registry", "UnknownKindError"]


class UnknownKindError(KeyError):
    """A name that no registered kind has."""

    def __str__(self) -> str:
        return str(self.args[0])


class NamedKind:
    """A stateless object that holds all that one kind of joint, drive, ... is; two of one class are equal."""

    name: ClassVar[str]
    """The word in data sheets."""

    @cached_property
    def key(self) -> str:
        """The name, for code that is compiled once and cached; of a kind from outside with a digest of its source."""
        module = type(self).__module__
        return self.name if module.startswith("tmodes.") else f"{self.name} {_digest(type(self))}"

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other)

    def __hash__(self) -> int:
        return hash(type(self))

    def __str__(self) -> str:
        return self.name

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.name}>"


def _digest(cls: type) -> str:
    """Of the file that defines a class, or of its compiled methods where it has no file (a notebook)."""
    path = getattr(sys.modules.get(cls.__module__), "__file__", None)
    if path and Path(path).is_file():
        return hashlib.sha256(Path(path).read_bytes()).hexdigest()[:16]
    codes = [each.__code__ for each in vars(cls).values() if hasattr(each, "__code__")]
    return hashlib.sha256(b"".join(map(marshal.dumps, codes))).hexdigest()[:16]


Member = TypeVar("Member", bound=NamedKind)


class Registry(Generic[Member]):
    """The members of one package of kinds, in the order in which they were registered."""

    def __init__(self, noun: str, contract: type[Member]) -> None:
        self.noun, self.contract = noun, contract
        self._members: dict[str, Member] = {}

    def register(self, cls: type[Member]) -> type[Member]:
        """Add a kind, as a decorator of its class; the same class again replaces it (a cell run twice).

        Raises :class:`TypeError` for a class that is not of the contract, :class:`ValueError` for a name that is taken.
        """
        if not issubclass(cls, self.contract):
            raise TypeError(f"{cls.__name__} is not a {self.contract.__name__}")
        known = self._members.get(cls.name)
        same = known is not None and type(known).__qualname__ == cls.__qualname__
        if known is not None and not (same and type(known).__module__ == cls.__module__):
            raise ValueError(f"the {self.noun} kind `{cls.name}` is already registered, by {type(known).__module__}")
        self._members[cls.name] = cls()
        return cls

    def unregister(self, name: str) -> None:
        """Remove a kind."""
        del self._members[name]

    def get(self, name: str) -> Member:
        """The kind of a name; raises :class:`UnknownKindError`."""
        if name not in self._members:
            close = get_close_matches(name, self._members, n=1)
            hint = f"did you mean `{close[0]}`?" if close else "register it before the data sheet is read"
            raise UnknownKindError(f"unknown {self.noun} kind `{name}`; known: {', '.join(self.names)}; {hint}")
        return self._members[name]

    def __contains__(self, name: str) -> bool:
        return name in self._members

    @property
    def names(self) -> tuple[str, ...]:
        """Names of all kinds."""
        return tuple(self._members)

    @property
    def members(self) -> tuple[Member, ...]:
        """All kinds."""
        return tuple(self._members.values())
