"""The paths of numbers in a run's summary, which a study's quantities name: they are checked before anything runs."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import product

import numpy as np

from tmodes.analysis.quasistatic import elastic_names
from tmodes.io.words import meant
from tmodes.kinds.schema.quantity import Issue
from tmodes.model.model import Model
from tmodes.sheet import Robot

__all__ = ["KEYS", "PATHS", "names_in_summary", "path_issues"]

PATHS = {
    "first_frequency_Hz.{locked|controlled}": "lowest natural frequency that rings",
    "deviation.{max_m|time_of_max_s|end_m}": "distance of the actual tip from the nominal one",
    "tip_error.{commanded|nominal}.{max_m|time_of_max_s|end_m}": "error of the actual tip against that path",
    "tip_error.{commanded|nominal}.parts_m.{part}": "its parts along the largest error",
    "tip_error.{commanded|nominal}.vectors_m.{part}.{0|1|2}": "its parts as vectors",
    "tip_error.{commanded|nominal}.{elements_m|environment_m}.*": "its parts of each gear and link, and of a contact",
    "settling.{time_s|band|limit_m|move_m|continued_s}": "time until the tip stays within the band of the move",
    "settling.rest_m.{0|1|2}": "where it comes to rest",
    "vibration.{actual|nominal}.*": "residual vibration: amplitude_m, and modes.0.frequency_Hz, damping_ratio, ...",
    "joints.{drive}.{least|largest|fastest|largest_effort|time_of_largest_effort_s|largest_gear_torque}":
    "a driven joint",
    "deformations.{elastic}.{max|max_stationary|max_oscillatory|max_nominal|time_of_max_s}":
    "a gear, a function of a link",
    "links.{link}.deflection.{max_m|time_s|s}": "deflection of the end of a link",
    "links.{link}.bending_moment.{max_Nm|time_s|s}": "largest bending moment of a link",
    "links.{link}.stress.{max_Pa|time_s|s}": "largest stress of a link",
    "contact_force.{min_N|max_N|mean_N|deepest_m}": "force into the surface, and how deep",
    "energy.{moved_J|worst_residual_J|worst_residual_over_moved}": "balance of energy",
    "{error|model_error}.figures.*": "estimated error of a number of the summary, by its path",
}  # fmt: skip
"""Paths by their pattern, and what they are: ``{one|other}`` are words, ``{drive}`` and so on names, ``*`` the rest."""

KEYS = tuple(dict.fromkeys(key for pattern in PATHS for key in pattern.partition(".")[0].strip("{}").split("|")))
"""First keys of a summary that lead to numbers."""

_PLACES = re.compile(r"(\{[^}]*\}|\*)")


def names_in_summary(robot: Robot) -> dict[str, list[str]]:
    """Names of a robot that stand in paths: its driven joints, gears and functions of links, links, parts of an error.

    Raises as :meth:`tmodes.Robot.chain`.
    """
    model, ends = Model(robot.pair().real.chain()), np.array([0.0, 1.0])
    bending = [node for node in model.chain.nodes if node.link.bends]
    lines = [f"{node.name}{line.suffix}" for node in bending for line in node.link.lines((), ends)]
    parts = ["controller", "gears", "free joints", "free joints, gears", "gears, free joints", "links", "geometry"]
    return {
        "drive": [drive.joint for drive in robot.drives],
        "elastic": [*elastic_names(model)],
        "link": [node.name for node in model.chain.nodes if node.link.bends or node.link.mass_line] + lines,
        "part": parts,
    }


def path_issues(path: str, names: Mapping[str, Sequence[str]]) -> Iterator[Issue]:
    """A path that no summary has, or none of a robot with these ``names``; without names each may stand there."""
    if any(_expression(pattern, names).fullmatch(path) for pattern in PATHS):
        return
    first = path.partition(".")[0]
    if first not in KEYS:
        yield Issue("path", f"the unknown key {first!r}", f"one of {', '.join(KEYS)}", meant(first, KEYS, _SEE))
        return
    own = [pattern for pattern in PATHS if _expression(pattern.partition(".")[0], names).fullmatch(first)]
    parts = [[_choices(part, names) or [] for part in _PLACES.split(pattern)] for pattern in own]
    known = ["".join(words) for choices in parts for words in product(*choices)]
    yield Issue("path", f"the unknown path {path!r}", " or ".join(own), meant(path, known, _SEE))


_SEE = "docs/studies.md lists the paths, `tmodes run --json` prints them"


def _choices(part: str, names: Mapping[str, Sequence[str]]) -> Sequence[str] | None:
    """What may stand at a part of a pattern: itself, one of its words, or one of the names; None: anything."""
    if not part.startswith("{"):
        return None if part == "*" else [part]
    words = part.strip("{}").split("|")
    return words if len(words) > 1 else names.get(words[0])


def _expression(pattern: str, names: Mapping[str, Sequence[str]]) -> re.Pattern[str]:
    parts = (_choices(part, names) for part in _PLACES.split(pattern))
    return re.compile("".join(".+" if words is None else _one_of(words) for words in parts))


def _one_of(words: Sequence[str]) -> str:
    return f"(?:{'|'.join(map(re.escape, words))})" if words else "(?!)"
