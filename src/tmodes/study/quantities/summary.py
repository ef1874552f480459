"""A number of the run's summary by its path: which paths there are, what is wrong with one, what stands there."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import product
from typing import Any, ClassVar, Literal

import numpy as np
from pydantic import Field

from tmodes.analysis.quasistatic import elastic_names
from tmodes.errors import InputError
from tmodes.io.words import meant, shown
from tmodes.kinds.schema.quantity import Issue
from tmodes.model.model import Model
from tmodes.sheet import Robot
from tmodes.study.quantities.contract import QUANTITIES, Asked, Found, Needs, Quantity, in_any

__all__ = ["KEYS", "PATHS", "Summary", "names_in_summary", "path_issues", "summary_number"]

_UNITS = {"s": "s", "m": "m", "Hz": "Hz", "N": "N", "Nm": "N*m", "Pa": "Pa", "J": "J", "rad": "rad"}
"""Units by the ending of a key."""


_ALONE: dict[str, Callable[[Any], Any]] = {
    "settling": lambda result: result.settling,
    "vibration": lambda result: result.vibration,
}
"""Groups that a result gives by themselves, as its summary has them."""


@QUANTITIES.register
class Summary(Quantity):
    """A number of the summary by its ``path``: ``settling.time_s``, ``first_frequency_Hz.controlled``."""

    named: ClassVar[str] = "path"

    type: Literal["summary"] = Field(description="kind of quantity")
    path: str = Field(min_length=1, max_length=200, description="path in the summary, as `tmodes run --json` prints it")

    def needs(self) -> Needs:
        """The result of the run; with estimated errors where it is one of them."""
        first = self.path.partition(".")[0]
        return Needs(result=True, errors=frozenset({first} & {"error", "model_error"}))

    def name_issues(self, names: Sequence[str]) -> Iterator[Issue]:  # noqa: ARG002
        """A path that no summary has, whatever the names of its robot."""
        yield from path_issues(self.path, {})

    def robot_issues(self, robots: Iterable[Robot]) -> Iterator[Issue]:
        """A path with a name that the robot has not."""
        yield from in_any(robots, lambda robot: path_issues(self.path, names_in_summary(robot)))

    def own_unit(self, asked: Asked) -> str:
        """By the ending of its key."""
        return asked.own_unit

    def values(self, asked: Asked) -> Found:
        """What stands there in the summary of each result."""
        assert asked.own is not None  # noqa: S101
        return asked.own, asked.own_reasons

    def of_result(self, result: Any, function: Any = None) -> tuple[float, str, str]:  # noqa: ARG002
        """The number at the path; not-a-number, and why, where a summary says that there is none.

        What one group of the summary needs is computed for it alone, where that is known: the whole summary may take
        longer than the run. Raises :class:`tmodes.errors.InputError` for a path that it does not have.
        """
        first = self.path.partition(".")[0]
        own = _ALONE[first](result) if first in _ALONE else None
        return summary_number(result.summary() if own is None else {first: own}, self.path)


def summary_number(summary: Mapping[str, Any], path: str) -> tuple[float, str, str]:
    """The number at a path of a summary, its unit, and why there is none; raises as :meth:`Summary.of_result`."""
    value, words, group, unit = summary, path.split("."), {}, "-"
    while words:
        if value is None:
            return math.nan, unit, f"the summary has no {path}"
        key, used = _key(value, words)
        if key is None:
            known = ", ".join(map(str, value)) if isinstance(value, Mapping) else "nothing below it"
            hint = meant(words[0], map(str, value), "see: tmodes run --json") if isinstance(value, Mapping) else ""
            raise InputError(path, f"the unknown key {words[0]!r}", known, hint)
        group, value = value, value[key]
        ending = str(key).rpartition("_")[2]
        unit = _UNITS.get(ending, unit) if "_" in str(key) else unit
        words = words[used:]
    if value is None:
        why = group.get("reason") if isinstance(group, Mapping) else ""
        return math.nan, unit, str(why or f"the summary has no {path}")
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        inner = f": one of {', '.join(map(str, value))}" if isinstance(value, Mapping) else ""
        raise InputError(path, shown(value), f"the path of a number{inner}", "write the whole path")
    return float(value), str(group.get("unit", unit)) if isinstance(group, Mapping) and unit == "-" else unit, ""


def _key(value: Any, words: Sequence[str]) -> tuple[Any, int]:
    """The key of a group, or index of a list, that some words name, and how many: names may hold dots."""
    if isinstance(value, Mapping):
        for count in range(len(words), 0, -1):
            if (name := ".".join(words[:count])) in value:
                return name, count
    if isinstance(value, (list, tuple)) and words[0].isdecimal() and int(words[0]) < len(value):
        return int(words[0]), 1
    return None, 0


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
    "verdict.{largest_m|time_s|final_m|tolerance_m}": "largest error, when, and the last; tolerance of the task",
    "verdict.{settling|residual|bends|limits|culprits}.*": "its other parts: `limits.0.share`, the most critical",
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
