"""What a person writes after ``--load``, ``--force``, ``--moment`` and ``--hold``: numbers, perhaps with units."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from tmodes.errors import InputError

if TYPE_CHECKING:
    from tmodes.analysis.statics.loads import Load
    from tmodes.sheet import Robot

__all__ = ["held_of", "load_of", "three_of"]

KEYS = ("point", "force", "moment", "frame")
FRAMES = ("world", "section")
EXAMPLE = "write it like point=tip,force=0,0,-10"
LARGEST = 1e12


def load_of(text: str) -> Load:
    """A load from ``point=tip,force=0,0,-10``; raises an InputError that names the part that is wrong."""
    from tmodes.analysis.statics.loads import Load

    parts = _parts(text)
    if "force" not in parts and "moment" not in parts:
        raise InputError("--load", repr(text), "a force, a moment or both", EXAMPLE)
    frame = parts.get("frame", "world")
    if frame not in FRAMES:
        raise _unknown("--load frame", frame, FRAMES)
    force, moment = (
        three_of(f"--load {name}", parts.get(name, "0,0,0"), unit) for name, unit in (("force", "N"), ("moment", "N*m"))
    )
    return Load(parts.get("point", "tip"), force, moment, follows=frame == "section")


def _parts(text: str) -> dict[str, str]:
    """The value of each key; a comma divides numbers of one value, and values where a key and = follow it."""
    parts: dict[str, str] = {}
    key = ""
    for piece in text.split(","):
        name, equals, value = (part.strip() for part in piece.partition("="))
        if equals and name not in KEYS:
            raise _unknown("--load", name, KEYS)
        if equals and name in parts:
            raise InputError(
                "--load", f"`{name}` a second time", "given each key once", "give another --load for each load"
            )
        if not equals and not key:
            raise InputError("--load", repr(text), "KEY=VALUE,... with the keys " + ", ".join(KEYS), EXAMPLE)
        key = name if equals else key
        parts[key] = value if equals else f"{parts[key]},{name}"
    return parts


def _unknown(which: str, name: str, known: Sequence[str]) -> InputError:
    from tmodes.io.words import nearest, shown

    close = nearest(name, known)
    hint = f"did you mean `{close}`?" if close else EXAMPLE
    return InputError(which, f"the unknown word {shown(name)}", f"one of {', '.join(known)}", hint)


def three_of(which: str, text: str, unit: str) -> list[float]:
    """Three numbers with commas between them, each perhaps with its unit."""
    words = text.split(",")
    if len(words) != 3:
        raise InputError(which, repr(text), "three numbers", "write x, y and z, like 0,0,-10")
    return [_number(which, word, unit, "three finite numbers") for word in words]


def held_of(text: str, arm: Robot) -> tuple[str, float]:
    """Coordinate and value [rad; m of a prismatic joint] of ``shoulder=45deg``."""
    name, equals, value = (part.strip() for part in text.partition("="))
    if not (name and equals and value):
        raise InputError("--hold", repr(text), "COORDINATE=VALUE", "write it like shoulder=0.5 or shoulder=45deg")
    slides = any(joint.name == name.removesuffix(".motor") and joint.type == "prismatic" for joint in arm.joints)
    return name, _number(f"--hold {name}", value, "m" if slides else "rad", "a number")


def _number(which: str, text: str, unit: str, expected: str) -> float:
    from tmodes.io.units import NotANumber, number
    from tmodes.io.words import shown

    try:
        value = number(text, unit)
    except NotANumber as error:
        raise InputError(which, error.got, f"{expected} [{unit}]", error.hint) from None
    if not math.isfinite(value) or abs(value) > LARGEST:
        bounds = f"{expected} [{unit}], at most {LARGEST:g}"
        raise InputError(which, shown(text), bounds, "correct the exponent or the unit")
    return value
