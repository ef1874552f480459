"""A stop condition as a person writes it: ``joint2.position > 1.2``, ``abs(elbow.velocity) > 90 deg/s``, ``tip.z < 0``.

The grammar is closed: one name (its size inside of ``abs``), ``>`` or ``<``, one number, perhaps with its unit. Nothing
is ever evaluated as a program.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from tmodes.errors import InputError

__all__ = ["EXPECTED", "LONGEST", "MOST", "Condition"]

LONGEST, MOST = 300, 50
"""Characters of a condition, and how many of them a run takes."""

EXPECTED = "a name, > or <, and a number, such as `joint2.position > 1.2` or `abs(elbow.velocity) > 90 deg/s`"

_NAME = r"[^\s<>=()]+"
_GRAMMAR = re.compile(rf"(?:abs\( *(?P<size>{_NAME}) *\)|(?P<name>{_NAME})) *(?P<sign>[<>]) *(?P<value>[^<>=()]+)")


@dataclass(frozen=True)
class Condition:
    """The parts of a condition: ``name`` of the quantity, whether its ``size`` counts, which side, and the value.

    ``above``: it holds above the value; ``value`` is a number as text, perhaps with a unit.
    """

    name: str
    size: bool
    above: bool
    value: str

    @classmethod
    def parsed(cls, text: str, which: str = "stop") -> Condition:
        """The parts of a text; raises :class:`tmodes.errors.InputError` for one that is none."""
        found = _GRAMMAR.fullmatch(" ".join(text.split())) if isinstance(text, str) and len(text) <= LONGEST else None
        if found is None:
            shown = repr(text if len(str(text)) <= 60 else f"{str(text)[:60]}...")
            raise InputError(which, shown, EXPECTED, _hint(str(text)))
        name = found["size"] or found["name"]
        return cls(name, found["size"] is not None, found["sign"] == ">", found["value"].strip())

    @property
    def quantity(self) -> str:
        """What is compared, in words."""
        return f"abs({self.name})" if self.size else self.name


def _hint(text: str) -> str:
    if "=" in text:
        return "write > or <: a quantity passes a value at one time, with or without it"
    if "<" not in text and ">" not in text:
        return "write what is compared with what, with > or <"
    if text.strip()[-1] in "<>":
        return "write the number after it"
    if text.strip()[0] in "<>":
        return "write the name before it"
    return "write one comparison; several conditions are several items of the list"
