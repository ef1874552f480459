"""Read an elasticity file: what a URDF cannot say of a robot, laid over it by the names of its joints and links.

    urdf: ur5.urdf
    joints: {shoulder_pan_joint: {motor: {...}, gear: {...}, state: locked, ...}}
    links: {forearm_link: {beam: {...}, bodies: [...], keep_inertial: rigid}}
    loads, drives, tip, points, gravity, ...: as in a robot's sheet

A link that bends is given in :mod:`tmodes.io.elasticity`. Everything else of the URDF stays as it is.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, InputErrors
from tmodes.io.files import FilePath, Roots, folders_of
from tmodes.io.units import NotANumber, number
from tmodes.io.urdf import UrdfRobot, read_urdf
from tmodes.io.urdf_tree import mimic_notice
from tmodes.io.words import meant, shown, shown_path
from tmodes.io.xacro import read_xacro
from tmodes.io.yaml_file import Positions, nearest_line, read_yaml
from tmodes.kinds.links.body import entries
from tmodes.kinds.schema.axes import matrix_quaternion, rpy_matrix

__all__ = ["give_mass", "length_along", "line_of", "place_beam", "read_elasticity", "riding_body", "section_axes"]

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


OF_JOINT = ("state", "locked_at", "limits", "friction", "motor", "gear", "spring")
OF_LINK = ("beam", "bodies", "keep_inertial")
KEEP = ("rigid", "replaced")
OF_URDF = ("name", "type", "parent", "child", "origin", "from", "axis", "dh")


def read_elasticity(
    path: FilePath,
    roots: Roots = (),
    trust_paths: bool = False,
    read: tuple[dict[str, Any], Positions] | None = None,
    fix_inertia: bool = False,
) -> UrdfRobot:
    """The robot of an elasticity file and the URDF (or xacro) that it names; ``positions`` are the elasticity file's.

    ``read``: its data and positions, where they are read already. Raises :class:`tmodes.errors.InputError` or
    :class:`tmodes.errors.InputErrors` with all that is wrong, each with its file and line.
    """
    data, positions = read or read_yaml(path)
    urdf = _urdf_path(path, data, positions, roots, trust_paths)
    groups = data.get("links")
    weighed = [name for name, group in groups.items() if _weighs(group)] if isinstance(groups, dict) else []
    reader = read_xacro if urdf.suffix.lower() == ".xacro" else read_urdf
    robot = reader(urdf, roots, trust_paths, weighed, fix_inertia=fix_inertia)
    overlay = _Overlay(robot, positions, shown_path(path))
    overlay.lay("joints", data.get("joints"), [joint["name"] for joint in overlay.sheet["joints"]], overlay.joint)
    overlay.lay("links", data.get("links"), [joint["child"] for joint in overlay.sheet["joints"]], overlay.link)
    overlay.couplings()
    overlay.the_rest(data)
    if overlay.errors:
        raise InputErrors(overlay.errors)
    return replace(robot, data=overlay.sheet, positions=overlay.positions)


def _weighs(group: Any) -> bool:
    return isinstance(group, dict) and ("beam" in group or bool(group.get("bodies")))


def _urdf_path(path: FilePath, data: dict[str, Any], positions: Positions, roots: Roots, trust: bool) -> Path:
    name, place = data.get("urdf"), f"{shown_path(path)}:{positions.get('urdf', 1)}"
    if not isinstance(name, str) or not name:
        raise InputError("urdf", shown(name), "the path of a URDF", "write `urdf: robot.urdf`", place)
    found = folders_of(path, roots, trust).find(name, "urdf", place)
    if found is None:
        hint = "check the path, which starts at the elasticity file's folder; for package:// give its folder as --root"
        raise InputError("urdf", f"{shown(name)}, which is not there", "the path of a URDF", hint, place)
    if found.suffix.lower() not in {".urdf", ".xacro", ".xml", ".mjcf", ".sdf"}:  # its root tells what it is
        raise InputError("urdf", shown(name), "a file .urdf, .xacro or .xml", "name the robot's own file", place)
    return found


class _Overlay:
    """The sheet that is being made, and what was found wrong."""

    def __init__(self, robot: UrdfRobot, positions: Positions, source: str) -> None:
        self.robot, self.lines, self.source = robot, positions, source
        self.sheet = copy.deepcopy(robot.data)
        self.positions: Positions = {"": 1}
        self.errors: list[InputError] = []
        self.links: dict[str, dict[str, Any]] = {link["name"]: link for link in self.sheet["links"]}

    def lay(self, kind: str, groups: Any, names: list[str], one: Callable[[str, dict[str, Any]], None]) -> None:
        """Lay each named group over the joint or link of its name."""
        self._copy_lines(kind, kind)
        if groups is None:
            return
        if not isinstance(groups, dict):
            self._wrong(kind, shown(groups), "groups by name", f"write `{names[0]}: {{...}}` below `{kind}:`")
            return
        for name, group in groups.items():
            which = f"{kind}.{name}"
            if name not in names:
                self._unknown(which, name, names, f"a {kind.removesuffix('s')} that the URDF moves")
            elif not isinstance(group, dict):
                self._wrong(which, shown(group), "a group", f"write `{name}: {{...}}`")
            else:
                try:
                    one(name, copy.deepcopy(group))
                except InputError as error:
                    self._wrong(error.which, error.got, error.expected, error.hint)

    def joint(self, name: str, group: dict[str, Any]) -> None:
        """Lay a group over a joint: limits one by one, the others whole."""
        which = f"joints.{name}"
        index = next(i for i, joint in enumerate(self.sheet["joints"]) if joint["name"] == name)
        joint = self.sheet["joints"][index]
        self._copy_lines(which, f"joints.{index}")
        self._known(which, group, OF_JOINT)
        if group.get("state") == "active":
            joint.pop("locked_at", None)
        if isinstance(group.get("limits"), dict):
            group["limits"] = joint.get("limits", {}) | group["limits"]
        joint.update(group)

    def link(self, name: str, group: dict[str, Any]) -> None:
        """Lay a group over a link: more bodies, or a beam in place of its body."""
        which = f"links.{name}"
        if name not in self.links:
            self.links[name] = {"name": name}
            self.sheet["links"].append(self.links[name])
        link = self.links[name]
        self._copy_lines(which, f"links.{self.sheet['links'].index(link)}")
        self._known(which, group, OF_LINK)
        bodies = group.get("bodies", [])
        if not isinstance(bodies, list):
            raise InputError(f"{which}.bodies", shown(bodies), "a list of bodies", "start each with `- `")
        if "beam" in group:
            self._bend(which, link, group["beam"], group.get("keep_inertial"))
        elif "keep_inertial" in group:
            hint = "remove it: the link does not bend"
            raise InputError(f"{which}.keep_inertial", "a link without `beam`", "a link with a beam", hint)
        if bodies:
            link["bodies"] = [*link.get("bodies", []), *bodies]

    def couplings(self) -> None:
        """What is said of joints that mimic others, by the states that they have now."""
        before = mimic_notice(self.robot.followers, self.robot.data["joints"])
        after = mimic_notice(self.robot.followers, self.sheet["joints"])
        if before != after:
            self.sheet["assumed"] = self.sheet["assumed"].replace(before, after)
            self.sheet["notices"] = [after if one == before else one for one in self.sheet["notices"]]

    def the_rest(self, data: dict[str, Any]) -> None:
        """Take over the other groups of a sheet as they are."""
        if data.get("kind", "elasticity") != "elasticity":
            self._wrong("kind", shown(data["kind"]), "elasticity, or no kind", "remove the line `kind: ...`")
        rest = {key: value for key, value in data.items() if key not in {"urdf", "joints", "links", "kind"}}
        for key in rest:
            self._copy_lines(key, key)
        if "assumed" in self.sheet and isinstance(rest.get("assumed"), str):
            rest["assumed"] = f"{rest['assumed']} {self.sheet['assumed']}"
        self.sheet.update(copy.deepcopy(rest))

    def _bend(self, which: str, link: dict[str, Any], beam: Any, keep: Any) -> None:
        if not isinstance(beam, dict):
            raise InputError(f"{which}.beam", shown(beam), "a group", "write `beam: {model: strain, ...}`")
        if keep is not None and keep not in KEEP:
            raise InputError(f"{which}.keep_inertial", shown(keep), "rigid or replaced", "write one of the two")
        body = self.robot.bodies.get(link["name"])
        carried = [joint for joint in self.sheet["joints"] if joint["parent"] == link["name"]]
        mounted = "root_mount" in beam
        if mounted and (beam.keys() & {"from", "to"} or not beam.keys() & {"length", "modes"} or keep == "rigid"):
            got, expected = "a beam with `root_mount`", "given by `length`, without `from`, `to` and riding inertial"
            raise InputError(f"{which}.beam", got, expected, "write `from` and `to` instead of `root_mount`")
        start, end = (np.zeros(3), np.zeros(3)) if mounted else line_of(f"{which}.beam", beam, carried)
        if not mounted:
            place_beam(f"{which}.beam", beam, start, end)
        give_mass(which, beam, body, keep, length_along(f"{which}.beam", beam))
        link.pop("bodies", None)
        link["beam"] = beam
        if body and keep == "rigid":
            link["bodies"] = [riding_body(body, start, end)]

    def _known(self, which: str, group: dict[str, Any], known: tuple[str, ...]) -> None:
        for key in group:
            if key in OF_URDF and known is OF_JOINT:
                self._wrong(f"{which}.{key}", "a key that the URDF gives", f"one of {', '.join(known)}", "remove it")
            elif key not in known:
                self._unknown(f"{which}.{key}", str(key), known, f"one of {', '.join(known)}")

    def _unknown(self, which: str, name: str, names: Iterable[str], expected: str) -> None:
        hint = meant(name, names, "remove it")
        self._wrong(which, f"the unknown name {shown(name)}", expected, hint)

    def _wrong(self, which: str, got: str, expected: str, hint: str) -> None:
        place = f"{self.source}:{nearest_line(which, self.lines, 1)}"
        self.errors.append(InputError(which, got, expected, hint, place))

    def _copy_lines(self, path: str, to: str) -> None:
        """The lines of a group of the elasticity file become those of the sheet's group."""
        for other, line in self.lines.items():
            if other == path or other.startswith(f"{path}."):
                self.positions[to + other[len(path) :]] = line
