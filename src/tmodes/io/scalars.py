"""Scalars of YAML 1.2: what a bare word in a file or on the command line means; assignments ``gear.stiffness=900``."""

from __future__ import annotations

import re
from typing import Any

from tmodes.errors import InputError
from tmodes.io.words import shown

__all__ = ["FLOAT", "finite_float", "parse_assignment", "scalar"]

INTEGER = re.compile(r"[-+]?[0-9]+")
FLOAT = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?")
INFINITE = re.compile(r"([-+]?)\.(inf|Inf|INF)")
WORDS = {
    **dict.fromkeys(("", "~", "null", "Null", "NULL")),
    **dict.fromkeys(("true", "True", "TRUE"), True),
    **dict.fromkeys(("false", "False", "FALSE"), False),
    **dict.fromkeys((".nan", ".NaN", ".NAN"), float("nan")),
}
MOST_DIGITS = 4000


def scalar(text: str) -> bool | int | float | str | None:
    """The value of a bare word after the core schema of YAML 1.2 (without octal and hexadecimal integers).

    A number that no double can hold (``1e400``) stays text, so that nothing is rounded to infinity or to zero.
    """
    if text in WORDS:
        return WORDS[text]
    if INTEGER.fullmatch(text) and len(text) <= MOST_DIGITS:
        return int(text)
    if FLOAT.fullmatch(text):
        value = finite_float(text)
        return text if value is None else value
    if infinite := INFINITE.fullmatch(text):
        return float(f"{infinite[1]}inf")
    return text


def finite_float(text: str) -> float | None:
    """The double nearest to a decimal number; None when there is none (overflow, or underflow to zero)."""
    if len(text) > MOST_DIGITS or not FLOAT.fullmatch(text):
        return None
    value = float(text)
    mantissa = re.split("[eE]", text)[0]
    lost = value == 0.0 and any(digit in mantissa for digit in "123456789")
    return None if lost or value in (float("inf"), float("-inf")) else value


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
        raise InputError("--set", shown(text), "PATH=VALUE", hint)
    if len(value) > 1 and value[0] == value[-1] and value[0] in "'\"":
        return path, value[1:-1]
    if NUMBERS.fullmatch(value):
        return path, [scalar(word.strip()) for word in value[1:-1].split(",")]
    return path, scalar(value)
