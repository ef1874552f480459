"""A beam of an elasticity file: placed so that the undeformed robot is exactly the URDF's, and weighed once.

The beam runs straight from the link's frame to the joint that the link carries, or from and to where the file says.
Its section's z axis is the link's z made square to the beam (the link's x where the beam runs along z). The tip frame
lies at its end with the axes of the link's frame.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.io.units import NotANumber, number
from tmodes.io.words import shown
from tmodes.kinds.links.body import entries
from tmodes.kinds.schema.axes import matrix_quaternion, rpy_matrix

__all__ = ["give_mass", "length_along", "line_of", "place_beam", "riding_body", "section_axes"]

Array = NDArray[np.float64]

SHORTEST = 1e-6
"""Shortest line [m] that has a direction worth taking."""

STEEP = 0.9
"""Cosine of the angle between beam and z axis beyond which the section's z axis is taken from the link's x [-]."""

ENDS = ("from", "to")

MATCH = 1e-6
"""Share of a line by which modes along it may be longer or shorter together [-]."""


def line_of(which: str, beam: dict[str, Any], carried: Sequence[dict[str, Any]]) -> tuple[Array, Array]:
    """Start and end (3,) [m] of a beam in its link's frame; ``carried`` are the joints that sit on the link.

    Takes ``from`` and ``to`` out of the beam's group. Raises :class:`tmodes.errors.InputError` where the file must say
    where the beam ends.
    """
    start, end = (_point(f"{which}.{key}", beam.pop(key, None)) for key in ENDS)
    start = np.zeros(3) if start is None else start
    if end is not None and "length" in beam:
        raise InputError(f"{which}.length", "both `length` and `to`", "one of the two", "remove `length` or `to`")
    if end is None:
        end = _only_joint(which, carried)
    line = end - start
    distance = float(np.linalg.norm(line))
    if distance < SHORTEST:
        got = f"a beam from {_written(start)} to {_written(end)}, which has no direction"
        raise InputError(f"{which}.to", got, "two points apart [m]", "write `to: [x, y, z]` in the link's frame")
    if "length" in beam:
        end = start + line / distance * length_of(f"{which}.length", beam["length"])
    return start, end


def section_axes(direction: Array) -> Array:
    """The axes of a beam's section as columns (3, 3): x along ``direction``, z as said above."""
    x: Array = direction / np.linalg.norm(direction)
    near = np.eye(3)[0 if abs(x[2]) > STEEP else 2]
    z = near - (near @ x) * x
    z /= np.linalg.norm(z)
    return np.array([x, np.cross(z, x), z]).T


def place_beam(which: str, beam: dict[str, Any], start: Array, end: Array) -> None:
    """Give a beam's group the length and mounts that it lacks; InputError for modes of another length than the line."""
    axes, distance = section_axes(end - start), float(np.linalg.norm(end - start))
    if modes := _modes(beam):
        for mode in modes:
            mode.setdefault("length", distance / len(modes))
        if abs((total := length_along(which, beam)) - distance) > MATCH * distance:
            hint = "leave out `length` of all modes for equal ones, or correct them"
            raise InputError(f"{which}.modes", f"modes of {total:g} m", f"{distance:g} m together", hint)
        beam.pop("length", None)
    else:
        beam.setdefault("length", distance)
    beam.setdefault("root_mount", {"position": start.tolist(), "quaternion": matrix_quaternion(axes).tolist()})
    beam.setdefault("tip_mount", {"position": [0.0, 0.0, 0.0], "quaternion": matrix_quaternion(axes.T).tolist()})
    pieces = beam.get("pieces")
    if isinstance(pieces, list) and pieces and isinstance(pieces[-1], dict):
        pieces[-1].setdefault("end", beam["length"])


def length_along(which: str, beam: dict[str, Any]) -> float:
    """The length [m] of a beam's group, or of its modes together; InputError for what is none."""
    if modes := _modes(beam):
        return sum(length_of(f"{which}.modes.{k}.length", mode.get("length")) for k, mode in enumerate(modes))
    return length_of(f"{which}.length", beam["length"])


def _modes(beam: dict[str, Any]) -> list[dict[str, Any]]:
    """The modes of a beam's group; none of one of another model."""
    modes = beam.get("modes")
    return [mode for mode in modes if isinstance(mode, dict)] if isinstance(modes, list) else []


def give_mass(which: str, beam: dict[str, Any], body: dict[str, Any] | None, keep: str | None, length: float) -> None:
    """See to it that a beam's mass is given once: by its sections, or by the URDF's mass over its length.

    ``keep`` is what the file says of the URDF's inertial: rigid, replaced, or None. Raises
    :class:`tmodes.errors.InputError` where both would count, or none.
    """
    sections = list(_sections(beam))
    weighed = [one for one in sections if "mass_per_length" in one or one.get("shape", "given") != "given"]
    if weighed and body and keep is None:
        got = f"a section that has a mass, next to {body['mass']:g} kg of the URDF"
        hint = "write `keep_inertial: rigid` to add both, or `keep_inertial: replaced` to count the section's alone"
        raise InputError(f"{which}.keep_inertial", got, "one of the two masses, or that both count", hint)
    if weighed or not sections:
        return
    if body is None or keep == "rigid":
        why = "the URDF has no mass for this link" if body is None else "the URDF's mass rides on it as a rigid body"
        hint = "add `mass_per_length: ...` in kg/m to the section"
        raise InputError(f"{which}.beam.section.mass_per_length", "nothing", f"a mass, because {why}", hint)
    for section in sections:
        section["mass_per_length"] = body["mass"] / length


def riding_body(body: dict[str, Any], start: Array, end: Array) -> dict[str, Any]:
    """The URDF's body (link frame) as one that rides on the beam at the station next to its center of mass.

    Between the ends a body is given in section axes from the line; at the tip in the tip frame, which has the link's.
    """
    line, center = end - start, np.array(body["center"])
    station = float(np.clip((center - start) @ line / (line @ line), 0.0, 1.0))
    turn = np.eye(3) if station == 1.0 else section_axes(line).T
    riding = body | {"at": station, "center": (turn @ (center - start - station * line)).tolist()}
    axes = turn @ rpy_matrix(*riding.pop("rpy", (0.0, 0.0, 0.0)))
    if "inertia" in riding:
        xx, yy, zz, xy, xz, yz = (riding["inertia"][pair] for pair in ("xx", "yy", "zz", "xy", "xz", "yz"))
        riding["inertia"] = entries(axes @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ axes.T)
    return riding


def _only_joint(which: str, carried: Sequence[dict[str, Any]]) -> Array:
    """Where the one joint that a link carries sits on it; of several, the one that moves."""
    moving = [joint for joint in carried if joint["type"] != "fixed"]
    chosen = carried if len(carried) == 1 else moving
    if len(chosen) != 1:
        names = ", ".join(joint["name"] for joint in carried[:8])
        got = f"a link that carries {len(carried)} joints ({names})" if carried else "a link that carries no joint"
        hint = "write `to: [x, y, z]` [m] in the link's frame"
        raise InputError(f"{which}.to", got, "the point where the beam ends", hint)
    return np.array(chosen[0]["origin"]["position"])


def _point(which: str, value: Any) -> Array | None:
    if value is None:
        return None
    if not isinstance(value, list) or len(value) != 3:
        raise InputError(which, shown(value), "a list of three numbers [m]", "write [x, y, z] in the link's frame")
    return np.array([length_of(which, item, positive=False) for item in value])


def length_of(which: str, value: Any, *, positive: bool = True) -> float:
    """A length [m] as the file gives it, perhaps with its unit; InputError for what is none."""
    try:
        result = number(value, "m")
    except NotANumber as error:
        raise InputError(which, error.got, "a number [m]", error.hint) from None
    if not abs(result) <= 1e6 or (positive and result < SHORTEST):
        bound = f"from {SHORTEST:g} to 1e6 [m]" if positive else "of at most 1e6 [m]"
        raise InputError(which, shown(result), f"a number {bound}", "correct the exponent or the unit")
    return result


def _sections(beam: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Every section that a beam's group holds: its own, the taper's, each piece's; a mode is one, too."""
    yield from _modes(beam)
    pieces = beam.get("pieces")
    for group in (beam, beam.get("taper"), *(pieces if isinstance(pieces, list) else ())):
        if isinstance(group, dict) and isinstance(group.get("section"), dict):
            yield group["section"]


def _written(point: Array) -> str:
    return "[" + ", ".join(f"{value:g}" for value in point) + "]"
