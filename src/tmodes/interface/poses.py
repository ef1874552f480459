"""Poses and loads as a person gives them, as text of a command line or as groups of Python."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError
from tmodes.io.units import finite_number
from tmodes.io.words import meant, shown

if TYPE_CHECKING:
    from tmodes.analysis.statics.loads import Load
    from tmodes.sheet import Robot

__all__ = ["Pose", "held_of", "load_of", "pose_of", "pose_words", "three_of"]

Pose = str | Mapping[str, float | str]
"""``shoulder=0.4,elbow=-60deg``, or ``{"shoulder": 0.4, "elbow": "-60 deg"}``."""

KEYS = ("point", "force", "moment", "frame")
FRAMES = ("world", "section")
EXAMPLE = "write it like point=tip,force=0,0,-10"
LARGEST = 1e12


def load_of(given: str | Load | Mapping[str, Any]) -> Load:
    """A load of its own, from ``point=tip,force=0,0,-10`` or the same as a group.

    Raises :class:`tmodes.errors.InputError` that names the part that is wrong.
    """
    from tmodes.analysis.statics.loads import Load

    if isinstance(given, Load):
        return given
    if not isinstance(given, str | Mapping):
        raise InputError("--load", shown(given), "a load, a group or text", EXAMPLE)
    parts = _parts(given) if isinstance(given, str) else dict(given)
    for name in parts:
        if name not in KEYS:
            raise _unknown("--load", name, KEYS)
    if "force" not in parts and "moment" not in parts:
        raise InputError("--load", shown(given), "a force, a moment or both", EXAMPLE)
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
    hint = meant(name, known, EXAMPLE)
    return InputError(which, f"the unknown word {shown(name)}", f"one of {', '.join(known)}", hint)


def three_of(which: str, given: Any, unit: str) -> list[float]:
    """Three numbers, or text with commas between them, each perhaps with its unit."""
    listed = given.tolist() if hasattr(given, "tolist") else given
    words = given.split(",") if isinstance(given, str) else listed
    if not isinstance(words, (list, tuple)) or len(words) != 3:
        raise InputError(which, shown(given), "three numbers", "write x, y and z, like 0,0,-10")
    return [finite_number(which, word, unit, "three finite numbers", most=LARGEST) for word in words]


def pose_of(given: Pose | None, sheet: Robot) -> dict[str, float]:
    """Coordinates and values of ``shoulder=0.4,elbow=-1``, or of a group: of a joint behind an elastic gear, its motor.

    Raises :class:`tmodes.errors.InputError` for what is no joint that moves, and for a value that is no number.
    """
    held = {}
    known = {coordinate: joint for joint in sheet.joints for coordinate in joint.coordinates}
    for name, value in held_of(given, sheet, "--at").items():
        joint = known.get(name.removesuffix(".motor"))
        if joint is None or joint.is_locked:
            raise InputError(
                "--at", shown(name), f"joints that move: {', '.join(k for k, j in known.items() if not j.is_locked)}",
                meant(name, [*known], "correct the name"),
            )  # fmt: skip
        coordinate = f"{name}.motor" if joint.is_active and joint.is_elastic and name in known else name
        if coordinate in held:
            raise _twice("--at", coordinate)
        held[coordinate] = value
    return held


def _twice(which: str, name: str) -> InputError:
    return InputError(which, f"`{name}` a second time", "one value for each coordinate", "leave one of them out")


def held_of(
    given: Pose | Sequence[str] | None, sheet: Robot, which: str = "--hold", units: tuple[str, str] = ("rad", "m")
) -> dict[str, float]:
    """Coordinates and values: of a group, or of texts such as ``shoulder=45deg``.

    ``units``: of values that turn, and of those that slide, as prismatic joints do.
    """
    if isinstance(given, Mapping):
        pairs = [(str(name), value) for name, value in given.items()]
    else:
        texts = given.split(",") if isinstance(given, str) and given else given or ()
        pairs = [_assigned(text, which) for text in texts]
    for name, count in Counter(name for name, _ in pairs).items():
        if count > 1:
            raise _twice(which, name)
    slides = {joint.name for joint in sheet.joints if joint.type == "prismatic"}
    return {
        name: finite_number(f"{which} {name}", value, units[name.removesuffix(".motor") in slides], most=LARGEST)
        for name, value in pairs
    }  # fmt: skip


def _assigned(text: str, which: str) -> tuple[str, str]:
    name, equals, value = (part.strip() for part in text.partition("="))
    if not (name and equals and value):
        raise InputError(which, repr(text), "COORDINATE=VALUE", "write it like shoulder=0.5 or shoulder=45deg")
    return name, value


def pose_words(*given: Pose | Sequence[str] | None) -> str | None:
    """Poses as they were given, in words."""
    words = []
    for one in given:
        if isinstance(one, Mapping):
            words += [f"{name}={value}" for name, value in one.items()]
        elif one:
            words += [one] if isinstance(one, str) else one
    return ",".join(words) or None
