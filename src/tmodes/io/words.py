"""Words of error messages: how a value is shown, and which name was probably meant."""

from __future__ import annotations

import difflib
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from tmodes.errors import InputError

__all__ = ["MEANT", "meant", "nearest", "plain", "several", "shown", "shown_path"]

LONGEST = 60

MEANT = {
    **dict.fromkeys(("actual", "actuals", "true", "uncertainty", "mismatch", "perturbation"), "real"),
    **dict.fromkeys(("controllers", "control", "motors", "actuators", "actuation", "inputs"), "drives"),
    **dict.fromkeys(("masses", "body"), "bodies"),
    **dict.fromkeys(("forces", "wrenches", "external_forces"), "loads"), "end_effector": "tip", "tcp": "tip",
    **dict.fromkeys(("simulation", "solver", "settings"), "integration"), "environment": "contact",
    **dict.fromkeys(("initial_state", "start", "x0"), "initial"), "segments": "links",
    **dict.fromkeys(("E", "youngs_modulus", "modulus", "young_modulus"), "young"), "rho": "density",
    **dict.fromkeys(("kp", "Kp", "p_gain", "stiffness_gain", "p"), "position_gain"),
    **dict.fromkeys(("kd", "Kd", "Kv", "kv", "d_gain", "damping_gain", "d"), "velocity_gain"),
    **dict.fromkeys(("ki", "Ki", "i_gain", "i"), "integral_gain"), "k": "stiffness", "m": "mass", "com": "center",
    "center_of_mass": "center", "cog": "center", "reduction": "ratio", "gear_ratio": "ratio", "t_end": "duration",
    "dt": "output_step", "step_size": "output_step", "time_step": "output_step",
}  # fmt: skip
"""What other programs and books call a key of ours."""

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
        case _:
            text = repr(value)[:LONGEST]
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
    other = [MEANT[word]] if MEANT.get(word) in known else []
    found = other or close or (starts if len(starts) == 1 else [])
    return known[found[0]] if found else None


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
