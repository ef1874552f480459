"""A Python function of the result of each case.

A function is given from Python, ``read_study(path, functions={"score": f})``, or registered by a file that a person
names (``tmodes --use my.py study gear.yaml``)::

    from tmodes.study.quantities.function import quantity

    @quantity("score")
    def score(result):
        return float(abs(result.motion["tip"][-1, 2]))

A study file only names functions, it never causes an import. The function is given the :class:`tmodes.Result`, whose
arrays cannot be written, and returns one number; what it raises is the reason of the row. What else it changes is its
own copy, and what it prints goes to standard error. One that takes longer than ``timeout`` seconds is stopped, where a
system has alarms (not on Windows) and it runs Python code; a process of its own that does not come back from other code
is ended, and with it the run of the study, which the same command resumes.

Stored numbers are those of a function as long as all is the same on which it depends
(:mod:`tmodes.kinds.code_identity`); one of which nobody can say that is called again by every run.
"""

from __future__ import annotations

import secrets
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, ClassVar, Literal, NamedTuple

from pydantic import Field

from tmodes.errors import InputError, TmodesError
from tmodes.kinds.code_identity import UnidentifiedError, code_digest
from tmodes.kinds.schema.quantity import Issue
from tmodes.kinds.schema.quantity import quantity as number_field
from tmodes.study.quantities.call import called
from tmodes.study.quantities.contract import QUANTITIES, Asked, Found, Needs, Quantity

__all__ = ["REGISTERED", "Function", "Identity", "function_identities", "function_issues", "function_of", "quantity"]

Own = Callable[[Any], float]

REGISTERED: dict[str, Own] = {}
"""Functions by name, registered by files that a person named."""


def quantity(name: str) -> Callable[[Own], Own]:
    """Decorator that registers a function of a :class:`tmodes.Result` under a name; a later one replaces it."""

    def register(function: Own) -> Own:
        REGISTERED[name] = function
        return function

    return register


@QUANTITIES.register
class Function(Quantity):
    """A number by a Python function of the whole result, which the name ``name`` stands for; slow."""

    named: ClassVar[str] = "name"

    type: Literal["function"] = Field(description="kind of quantity")
    name: str = Field(min_length=1, max_length=100, description="name of a function that was given or registered")
    timeout: float = number_field("s", "t", "longest time of one call", above=0.0, at_most=86_400.0, default=60.0)

    def needs(self) -> Needs:
        """The result of the run."""
        return Needs(result=True)

    def function(self) -> str:
        """That of its name."""
        return self.name

    def of_result(self, result: Any, function: Own | None = None) -> tuple[float, str, str]:
        """What the function returns; not-a-number, and why, where it raises, hangs or gives no number."""
        assert function is not None  # noqa: S101
        try:
            return called(function, result, self.timeout), self.unit or "-", ""
        except TmodesError as error:
            return float("nan"), self.unit or "-", str(error)

    def values(self, asked: Asked) -> Found:
        """What the function returned."""
        assert asked.own is not None  # noqa: S101
        return asked.own, asked.own_reasons


def function_of(name: str, given: Mapping[str, Own], which: str) -> Own:
    """The function of a name, of those ``given`` or registered; raises :class:`tmodes.errors.InputError`."""
    known = {**REGISTERED, **given}
    if name not in known:
        names: Sequence[str] = tuple(known)
        expected = f"one of {', '.join(names)}" if names else "a function that was given or registered"
        hint = "register it in a Python file and name that: `tmodes --use my.py study ...`, or give functions={...}"
        raise InputError(which, f"the unknown function {name!r}", expected, hint)
    return known[name]


def function_issues(one: Quantity, given: Mapping[str, Own]) -> Iterator[Issue]:
    """A quantity whose function is neither given nor registered."""
    if wanted := one.function():
        try:
            function_of(wanted, given, "name")
        except InputError as error:
            yield Issue("name", error.got, error.expected, error.hint)


class Identity(NamedTuple):
    """What a function is known by: a ``digest`` of all that it depends on; of one that has none, and why, any other."""

    digest: str
    unknown: str = ""


def function_identities(quantities: Iterable[Quantity], given: Mapping[str, Own]) -> dict[str, Identity]:
    """The identities of the functions of quantities, by their names, as they are now; without those not known here."""
    known = {**REGISTERED, **given}
    return {name: _identity(known[name]) for name in {one.function() for one in quantities} & known.keys()}


def _identity(function: Own) -> Identity:
    try:
        return Identity(code_digest(function))
    except UnidentifiedError as error:
        return Identity(secrets.token_hex(), str(error))
