"""Scalars as YAML text that every reader takes for the same value."""

from __future__ import annotations

import math
import re
from typing import Any

from tmodes.io.scalars import scalar

__all__ = ["scalar_text", "text"]

WORD = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
YAML_1_1 = {"y", "n", "yes", "no", "on", "off"}
"""Words that older readers take for true and false."""


def scalar_text(value: Any, quantity: bool) -> str:
    """A value of plain data as YAML; ``quantity``: text stands for an infinite number."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int):
        return str(value)
    if quantity and isinstance(value, str):
        value = float(value)
    return _float(value) if isinstance(value, float) else text(str(value))


def _float(value: float) -> str:
    """All digits; with a point, so that readers of YAML 1.1 see a number too."""
    if math.isinf(value):
        return ".inf" if value > 0 else "-.inf"
    digits, exponent, power = repr(value).partition("e")
    return f"{digits if '.' in digits else digits + '.0'}{exponent}{power}"


def text(value: str) -> str:
    """A text as a bare word where that is safe, else in quotes."""
    if WORD.fullmatch(value) and scalar(value) == value and value.lower() not in YAML_1_1:
        return value
    return '"' + "".join(_escaped(letter) for letter in value) + '"'


def _escaped(letter: str) -> str:
    if letter in '"\\':
        return f"\\{letter}"
    return letter if letter.isprintable() else f"\\U{ord(letter):08x}"
