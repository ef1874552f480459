"""``path=value`` of the command line: its value is a bare word, a number, quoted text, a list or a group of YAML."""

from __future__ import annotations

import re
from typing import Any

from tmodes.errors import InputError
from tmodes.io.units import scalar
from tmodes.io.words import shown
from tmodes.io.yaml_file import parse_yaml

__all__ = ["parse_assignment"]

LONGEST_VALUE = 2_000

NUMBERS = re.compile(r"\[ *[-+.0-9][^][{},'\"&*!]*(,[ ]*[-+.0-9][^][{},'\"&*!]*)*\]")
"""A flow list of numbers, each perhaps with its unit."""


def parse_assignment(text: str) -> tuple[str, Any]:
    """Path and value of ``path=value``: a bare word, quoted text, a list or a group of YAML; else an InputError."""
    path, equals, value = (part.strip() for part in text.partition("="))
    if not (path and equals and value) or len(value) > LONGEST_VALUE:
        hint = "write it without spaces around =, as in gear.stiffness=900"
        raise InputError("--set", shown(text), "PATH=VALUE", hint)
    if len(value) > 1 and value[0] == value[-1] and value[0] in "'\"":
        return path, value[1:-1]
    if NUMBERS.fullmatch(value):
        return path, [scalar(word.strip()) for word in value[1:-1].split(",")]
    return path, _flow(path, value) if value[0] in "[{" else scalar(value)


def _flow(path: str, value: str) -> Any:
    """A list or a group as YAML writes it in one line; text that begins like a list and is none stays text."""
    try:
        return parse_yaml(f"value: {value}", "--set")[0]["value"]
    except InputError as error:
        if value[0] == "[":
            return value
        hint = "write it in quotes, as in 'drives.0.signal={type: constant, value: 0.4}'"
        raise InputError(f"--set {path}", f"{shown(value)} ({error.got})", "a group in braces", hint) from None
