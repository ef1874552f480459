"""Assignments of the command line: ``gear.stiffness=900``."""

from __future__ import annotations

import re
from typing import Any

from tmodes.errors import InputError
from tmodes.io.scalars import scalar
from tmodes.io.words import shown

__all__ = ["parse_assignment"]

LONGEST_VALUE = 2_000

NUMBERS = re.compile(r"\[ *[-+.0-9][^][{},'\"&*!]*(,[ ]*[-+.0-9][^][{},'\"&*!]*)*\]")
"""A flow list of numbers, each perhaps with its unit."""


def parse_assignment(text: str) -> tuple[str, Any]:
    """Path and value of ``path=value``; the value is read as a bare word, quoted text or list of numbers of YAML.

    Raises :class:`tmodes.errors.InputError` for anything else.
    """
    path, equals, value = (part.strip() for part in text.partition("="))
    if not (path and equals and value) or len(value) > LONGEST_VALUE:
        hint = "write it without spaces around =, as in gear.stiffness=900"
        raise InputError("an assignment", shown(text), "path=value", hint)
    if len(value) > 1 and value[0] == value[-1] and value[0] in "'\"":
        return path, value[1:-1]
    if NUMBERS.fullmatch(value):
        return path, [scalar(word.strip()) for word in value[1:-1].split(",")]
    return path, scalar(value)
