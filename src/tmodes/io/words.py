"""Words of error messages: how a value is shown, and which name was probably meant."""

from __future__ import annotations

import difflib
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from tmodes.errors import InputError

__all__ = ["count_of", "element_words", "meant", "nearest", "plain", "several", "shown", "shown_path"]

LONGEST = 60

_SAID = {
    "real": "actual actuals true uncertainty mismatch perturbation",
    "drives": "controllers control motors actuators inputs",
    "bodies": "masses body",
    "loads": "forces wrenches external_forces",
    "tip": "end_effector tcp tool",
    "integration": "simulation solver settings",
    "contact": "environment",
    "initial": "initial_state start x0",
    "links": "segments bodies",
    "gravity": "g",
    "format": "version",
    "young": "E youngs_modulus modulus",
    "density": "rho",
    "position_gain": "kp Kp p_gain stiffness_gain p",
    "velocity_gain": "kd Kd Kv kv d_gain damping_gain d",
    "integral_gain": "ki Ki i_gain i",
    "stiffness": "k c",
    "mass": "m",
    "center": "com center_of_mass cog position",
    "ratio": "reduction gear_ratio",
    "duration": "t_end T time",
    "output_step": "dt step_size time_step",
    "length": "L l",
    "lower": "min minimum",
    "upper": "max maximum",
    "damping": "d viscous",
    "revolute": "hinge rotary rotational continuous pin",
    "prismatic": "slider linear sliding translational",
    "strain": "flexible beam elastic euler_bernoulli",
    "box": "rectangle rect square rectangular",
    "round": "circle circular cylinder rod",
    "tube": "pipe hollow annulus",
    "quintic": "minimum_jerk min_jerk polynomial",
    "trapezoid": "ramp trapezoidal",
    "state_feedback": "lqr LQR pole_placement",
    "effort": "force",
    "sine": "sin harmonic",
}
"""Keys and words of ours, and what other programs and books call them."""

SHORTEST = 3
"""Least length of the beginning of a name by which it is known [characters]."""


def shown(value: Any) -> str:
    """A value as a person finds it in the file: short, on one line."""
    match value:
        case None | bool():
            text = {None: "nothing", True: "true", False: "false"}[value]
        case int() if value.bit_length() > 200:
            text = f"a whole number of about {round(value.bit_length() * 0.30103)} digits"
        case float():
            text = repr(float(value)).replace("inf", ".inf").replace("nan", ".nan")
        case str():
            text = repr(value if len(value) <= LONGEST else value[:LONGEST] + "...")
        case Mapping():
            text = f"a group of {len(value)} keys" if len(value) != 1 else "a group of one key"
        case Sequence():
            text = f"a list of {len(value)}"
        case _ if (shape := getattr(value, "shape", None)) is not None:
            text = f"an array of shape {shape}"
        case _:
            text = _represented(value)
    return text


def _represented(value: Any) -> str:
    """An object as it represents itself, where that is one line of text."""
    try:
        text = " ".join(repr(value).split())[:LONGEST]
    except Exception:  # whatever it does
        text = f"a {type(value).__name__}"
    return text


def shown_path(path: str | os.PathLike[str]) -> str:
    """A file's path as text that every terminal can print."""
    text = os.fspath(path).encode("utf-8", "backslashreplace").decode()
    return text if text.isprintable() else repr(text)


def nearest(word: str, names: Iterable[str]) -> str | None:
    """The name that was probably meant, or None: one much like it, or the only one that starts so.

    Case, spaces and hyphens do not count.
    """
    known, meant = {plain(name): name for name in names}, plain(word[:LONGEST])
    close = difflib.get_close_matches(meant, known, n=1, cutoff=0.6)
    starts = [name for name in known if len(meant) >= SHORTEST and name.startswith(meant)]
    other = [said] if (said := _said(word, known)) else []
    found = other or close or (starts if len(starts) == 1 else [])
    return known[found[0]] if found else None


def _said(word: str, known: Iterable[str]) -> str | None:
    """What another program or book calls one of the names."""
    return next((key for key, others in _SAID.items() if key in known and word in others.split()), None)


def meant(word: str, names: Iterable[str], otherwise: str) -> str:
    """The hint for an unknown word: the name that was probably meant, else ``otherwise``."""
    close = nearest(word, names)
    return f"did you mean `{close}`?" if close else otherwise


def several(which: str, words: Any) -> tuple[str, ...]:
    """Texts that a caller gives, one of them perhaps by itself; raises :class:`tmodes.errors.InputError` for others."""
    if isinstance(words, str):
        return (words,)
    listed = tuple(words) if isinstance(words, Iterable) else (words,)
    if not all(isinstance(word, str) for word in listed):
        raise InputError(which, shown(words), "text, or a list of texts", "write each in quotes")
    return listed


def plain(word: str) -> str:
    """A word without what does not count when names are compared: case, hyphens, outer spaces."""
    return word.strip().lower().replace("-", "_").replace(" ", "_")


def count_of(count: int, what: str) -> str:
    """``1 case``, ``1,000 cases``."""
    return f"{count:,} {what}" + ("" if count == 1 else "s")


def element_words(name: str) -> str:
    """``gear elbow`` for the element ``elbow.gear``, ``link arm (bend_z1)`` for the coordinate ``arm.bend_z1``."""
    owner, _, own = name.rpartition(".")
    if own in ("gear", "spring", "controller", "motor"):
        return f"{own} {owner}"
    return f"link {owner} ({own})" if owner else name
