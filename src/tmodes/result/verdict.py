"""What a run comes to: how far off it was, why, whether it comes to rest, what limits it; and all of it in words.

The words are phrases that pages carry as data and fill with their own numbers, see :func:`filled`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from tmodes.io.printed import written
from tmodes.kinds.joints.joint import Limits
from tmodes.result.summary import TIP
from tmodes.sheet import Robot
from tmodes.sheet.robot import yield_strength

__all__ = [
    "PHRASES",
    "culprit_words",
    "culprits",
    "damping_words",
    "end_words",
    "filled",
    "jump_of",
    "limits_of",
    "said",
    "unjudged",
    "verdict",
]

Phrases = Sequence[Sequence[str]]
"""The parts of a text, each with its alternatives."""

_SETTLED = "; {it} stays within {within} of its rest from {settled} after the move"

PHRASES: dict[str, Phrases] = {
    "sentence": (
        ("The run did not finish: {failure}. ",),
        (
            "{subject} is up to {largest} off its {path} path ({when}) and ends {final} off",
            "{subject} follows its {path} path",
            "The end of {link} is deflected by up to {deflection} ({at})",
            "Gear {gear} is deflected by up to {deflection} ({at})",
            "No error of {nowhere} is measured",
            "No path is commanded",
        ),
        (", within its tolerance of {kept}", ", beyond its tolerance of {missed}"),
        (
            _SETTLED + " ({frequency}, {damping} damping)",
            _SETTLED,
            "; {it} is within {within} of its rest when the move ends",
            "; {it} is not seen to settle ({frequency}, {damping} damping): {reason}",
            "; {it} is not seen to settle: {reason}",
        ),
        (".",),
        (
            " The command of joint {jumper} jumps at {jumped}, which excites this vibration: smooth it by a profile, "
            "such as quintic, or by a shaper.",
        ),
        (
            " {quantity} of {element} passes its limit: {value} of {limit}; so do {others}.",
            " {quantity} of {element} passes its limit: {value} of {limit}.",
        ),
        (" The run was {condition}.",),
    ),
    "elsewhere": (
        ("The run did not finish: {failure}. ",),
        ("The tip does not show this motion; for errors of another point run the changed sheet by tmodes run --set.",),
    ),
    "culprit": (("{cause} {element}", "{cause}"),),
    "culprits": (("{along}",), (" against {opposed}",)),
}
"""Texts by name: parts in their order, each with alternatives; fields in braces are those of :func:`said`."""

_PASSED = 1 + 1e-6
"""Share of a limit from which on it is passed: a motion planned to its limit keeps it."""

_METHOD = re.compile(r" \(\w+ chosen: [^()]*\)$")
"""Why a method was chosen, which a message ends with: no reason of the end."""

_FIELDS = re.compile(r"\{(\w+)\}")

_EXACT = 1e-9
"""Error [m] up to which a point follows its path, and share of the error below which a part is rounding."""


def filled(phrases: Phrases, known: Mapping[str, str]) -> str:
    """A text: of each part the first alternative whose fields are all ``known``, filled with them; else nothing."""
    chosen = (next((one for one in part if known.keys() >= {*_FIELDS.findall(one)}), "") for part in phrases)
    return "".join(chosen).format_map(known)


def verdict(
    summary: Mapping[str, Any],
    limits: Sequence[Mapping[str, Any]] = (),
    tolerance: float | None = None,
    warnings: Sequence[str] = (),
    message: str = "",
    jump: Mapping[str, Any] | None = None,
) -> dict[str, Any]:
    """Plain data, ``Verdict`` of ``web/src/contract.ts``; from the ``summary`` of a run, and its :func:`limits_of`.

    ``tolerance`` [m] of the sheet's task; ``warnings`` of the run and the ``message`` of its end; ``jump``:
    :func:`jump_of` its commands.
    """
    errors, deviation, settling = summary["tip_error"], summary["deviation"], summary["settling"]
    against = "commanded" if "commanded" in errors else "nominal" if deviation else None
    largest = errors["commanded"] if against == "commanded" else deviation or {}
    vibration = summary["vibration"].get("actual") or {}
    modes = vibration.get("modes")
    found = {
        "point": summary["point"]["name"],
        "against": against,
        "largest_m": largest.get("max_m"),
        "time_s": largest.get("time_of_max_s"),
        "final_m": largest.get("end_m"),
        "bends": None if against else _bends(summary),
        "settling": {"time_s": settling["time_s"], "within_m": settling["limit_m"], "reason": settling["reason"]},
        "residual": {
            "amplitude_m": vibration["amplitude_m"], "frequency_Hz": modes[0]["frequency_Hz"],
            "damping": modes[0]["damping_ratio"],
        } if modes else None,
        "limits": [*limits],
        "culprits": [*culprits(errors.get(against, {}))],
        "jump": jump,
        "tolerance_m": tolerance,
    }  # fmt: skip
    found["level"] = _level(found, summary["status"], warnings)
    return found | {"sentence": filled(PHRASES["sentence"], said(found, summary["status"], message))}


def unjudged(sentence: str) -> dict[str, Any]:
    """The verdict on what did not run, or cannot be judged."""
    settling = {"time_s": None, "within_m": None, "reason": ""}
    nothing = dict.fromkeys(("against", "largest_m", "time_s", "final_m", "bends", "jump"))
    return {"point": "tip"} | nothing | {
        "settling": settling, "residual": None, "limits": [], "culprits": [], "tolerance_m": None, "level": "neutral",
        "sentence": sentence,
    }  # fmt: skip


def _bends(summary: Mapping[str, Any]) -> dict[str, Any] | None:
    """The link whose end is deflected most, else the gear, of those that turn if any: where no errors are known."""
    links = [
        {"cause": "link", "element": name, "value": one["deflection"]["max_m"], "unit": "m",
         "time_s": one["deflection"]["time_s"]} for name, one in summary["links"].items()
    ]  # fmt: skip
    gears = [
        {"cause": "gear", "element": name.removesuffix(".gear"), "value": one["max"], "unit": one["unit"],
         "time_s": one["time_of_max_s"]} for name, one in summary["deformations"].items() if name.endswith(".gear")
    ]  # fmt: skip
    bent, turning = ([one for one in links if one["value"]], [one for one in gears if one["unit"] == "rad"])
    return max(bent or turning or gears or links, key=lambda one: one["value"], default=None)


def culprits(error: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """Of one of the errors of a summary, by the name of each element where it is known, the largest first."""
    elements = error.get("elements_m", {})
    parts = {part: {None: value} for part, value in error.get("parts_m", {}).items() if not _split(part, elements)}
    every = [
        {"cause": part.removesuffix("s"), "element": name, "value_m": value}
        for part, named in (parts | elements).items() for name, value in named.items()
        if abs(value) > _EXACT * error["max_m"]
    ]  # fmt: skip
    yield from sorted(every, key=lambda one: -abs(one["value_m"])) if error.get("max_m", 0.0) > _EXACT else ()


def _split(part: str, elements: Mapping[str, Any]) -> bool:
    """Whether a part of an error, such as ``free joints, gears``, is known by its elements."""
    return all(one in elements for one in part.split(", "))


def _level(found: Mapping[str, Any], status: str, warnings: Sequence[str]) -> str:
    """By the tolerance; of a run that failed bad, and never good where anything else is to be said of it."""
    tolerance, largest = found["tolerance_m"], found["largest_m"]
    if status not in ("finished", "stopped_by_condition"):
        return "bad"
    if tolerance is None or largest is None:
        return "neutral"
    if largest > tolerance:
        return "bad"
    clean = status == "finished" and not warnings and all(one["share"] <= _PASSED for one in found["limits"])
    return "good" if clean else "neutral"


def said(found: Mapping[str, Any], status: str, message: str) -> dict[str, str]:
    """The fields of the sentence, those that are known: numbers to three figures, with units."""
    largest, against, tolerance = found["largest_m"], found["against"], found["tolerance_m"]
    settling, residual, bends, failed = found["settling"], found["residual"], found["bends"], status not in _ENDED
    off, within, settled = largest is not None and largest > _EXACT, settling["within_m"] or 0.0, settling["time_s"]
    seen = residual and (settled is None or residual["amplitude_m"] > within)
    jump = seen and found["jump"]
    worst, *others = [one for one in found["limits"] if one["share"] > _PASSED] or [None]
    said_why = end_words(message)
    known = {
        "failure": said_why if failed else None,
        "condition": said_why if status == _ENDED[1] else None,
        "subject": found["point"][:1].upper() + found["point"][1:] if against else None,
        "it": "it" if against else f"the {(found['point'] or TIP).removeprefix('the ')}",
        "nowhere": None if found["point"] else f"the {TIP}",
        "path": against,
        "largest": off and _written(largest, "m"),
        "final": off and _written(found["final_m"], "m"),
        "when": off and _written(found["time_s"], "s"),
        "link": bends and bends["cause"] == "link" and bends["element"],
        "gear": bends and bends["cause"] == "gear" and bends["element"],
        "deflection": bends and _written(bends["value"], bends["unit"]),
        "at": bends and _written(bends["time_s"], "s"),
        "kept": tolerance and largest is not None and largest <= tolerance and _written(tolerance, "m"),
        "missed": tolerance and largest is not None and largest > tolerance and _written(tolerance, "m"),
        "within": not failed and settled is not None and not settling["reason"] and _written(within, "m"),
        "settled": settled and _written(settled, "s"),
        "reason": not failed and settled is None and settling["reason"],
        "frequency": seen and _written(residual["frequency_Hz"], "Hz"),
        "damping": seen and damping_words(residual["damping"]),
        "jumper": jump and jump["joint"],
        "jumped": jump and _written(jump["time_s"], "s"),
        "quantity": worst and worst["quantity"].capitalize(),
        "element": worst and worst["element"],
        "value": worst and _written(worst["value"], worst["unit"]),
        "limit": worst and _written(worst["limit"], worst["unit"]),
        "others": ", ".join(f"{one['quantity']} of {one['element']}" for one in others if one),
    }
    return {name: text for name, text in known.items() if text}


def end_words(message: str) -> str:
    """How a run ended, without the method that it chose, and without marks of code."""
    return _METHOD.sub("", message).replace("`", "")


def damping_words(ratio: float) -> str:
    """A damping ratio in per cent: tenths where it is small, and no more of what is rounding."""
    return _written(round(100 * ratio, ratio < _TENTHS) + 0.0, "%", 2)


_TENTHS = 0.0995
"""Damping ratio below which tenths of a per cent are said."""

_ENDED = ("finished", "stopped_by_condition")


def _written(value: Any, unit: str, digits: int = 3) -> str:
    return written(value, unit, digits)


def culprit_words(found: Mapping[str, Any], most: int = 4) -> str:
    """The largest culprits of a verdict, those that lessen the error after ``against``; empty where none is known."""
    shown = found["culprits"][:most]
    sides = {"along": [one for one in shown if one["value_m"] > 0]}
    sides["opposed"] = [one for one in shown if one["value_m"] < 0]
    words = {side: ", ".join(map(_culprit, ones)) for side, ones in sides.items() if ones}
    return filled(PHRASES["culprits"], words)


def _culprit(one: Mapping[str, Any]) -> str:
    names = {name: text for name in ("cause", "element") if (text := one[name])}
    return f"{filled(PHRASES['culprit'], names)} {_written(one['value_m'], 'm')}"


def jump_of(robot: Robot, end: float) -> dict[str, Any] | None:
    """The first jump of a commanded position before ``end`` [s]: ``joint`` and ``time_s`` [s]; None without any."""
    whole = robot.integration.duration
    jumps = [
        (float(time), drive.joint)
        for drive in robot.drives if drive.command.is_motion
        for time in drive.signal.schedule(whole).until(whole).jumps() if time < end
    ]  # fmt: skip
    return dict(zip(("time_s", "joint"), min(jumps), strict=True)) if jumps else None


def limits_of(robot: Robot, data: Any, links: Mapping[str, Any]) -> list[dict[str, Any]]:
    """How near a run comes to each limit that its sheet knows, the most critical first.

    ``quantity``: ``stress`` over the yield strength of a link of the summary's ``links``; ``speed``, ``effort`` and
    ``range`` (from its middle) of a joint. ``value`` and ``limit`` [``unit``], ``share`` of the limit [-].
    """
    found = [
        _limit("stress", name, link["stress"]["max_Pa"], strength, "Pa")
        for name, link in links.items()
        if link["stress"] and (strength := yield_strength(robot, name)) is not None
    ]
    names, drives = data["coordinate"].values, data["drive"].values if "drive" in data.dims else ()
    for joint in robot.joints:
        for name in joint.coordinates:
            if joint.limits and name in names:
                found += _of_joint(name, joint.limits, data, driven=name in drives)
    return sorted(found, key=lambda one: -one["share"])


def _of_joint(name: str, limits: Limits, data: Any, *, driven: bool) -> Iterator[dict[str, Any]]:
    unit = str(data["coordinate_unit"].sel(coordinate=name).values)
    q, v = (data[key].sel(coordinate=name).values for key in ("q", "v"))
    if limits.speed:
        yield _limit("speed", name, float(np.abs(v).max()), limits.speed, f"{unit}/s")
    if limits.effort and driven:
        effort = float(np.abs(data["effort"].sel(drive=name).values).max())
        yield _limit("effort", name, effort, limits.effort, "N" if unit == "m" else "N m")
    if limits.lower is not None and limits.upper is not None and limits.upper > limits.lower + _ROUNDING:
        middle, half = (limits.upper + limits.lower) / 2, (limits.upper - limits.lower) / 2
        yield _limit("range", name, float(np.abs(q - middle).max()), half, unit)


_ROUNDING = 1e-15


def _limit(quantity: str, element: str, value: float, limit: float, unit: str) -> dict[str, Any]:
    return {"quantity": quantity, "element": element, "value": value, "limit": limit, "unit": unit,
            "share": value / limit}  # fmt: skip
