"""What a result must hold to be one, and how it is read: version, attributes, series."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError, InputErrors
from tmodes.integrate.registry import AUTO, INTEGRATORS
from tmodes.io.atomic import file_error
from tmodes.io.words import shown
from tmodes.kinds.contacts.registry import CONTACTS, SURFACES
from tmodes.kinds.controllers.registry import CONTROLLERS
from tmodes.kinds.drives.registry import DRIVES
from tmodes.kinds.joints.registry import JOINTS
from tmodes.kinds.links.registry import LINKS
from tmodes.kinds.registry import Registry, UnknownKindError
from tmodes.kinds.sensors.registry import SENSORS
from tmodes.kinds.signals.registry import SIGNALS
from tmodes.result.content import AGAIN, refuse_not_finite, refuse_wrong_content
from tmodes.sheet.robot import RECURSION

if TYPE_CHECKING:
    from pathlib import Path

    from tmodes.io.labelled import Record
    from tmodes.sheet import Robot

__all__ = ["RESULT_FORMAT", "STATUSES", "absent_kinds", "text_of"]

RESULT_FORMAT = 1
"""Version of the names and meanings in a result (of the file's bytes: ``io.resultfile.FORMAT_VERSION``)."""

STATUSES = (
    "finished", "stopped_by_condition", "diverged", "step_too_small", "not_converged", "chattering", "stopped",
    "interrupted",
)  # fmt: skip
"""How a run ends: at its end, by a stop condition that was asked for, or without having come to either."""

_ATTRIBUTES = ("robot", "status", "message", "frequencies", "statistics", "warnings", "versions")
_SERIES = ("time", "q", "v", "tip", "energy", "work", "energy_balance")
_NEEDED = {
    "arm": ((*_ATTRIBUTES, "robot_real", "move_end", "errors"), (*_SERIES, "a", "position")),
    "robot": ((*_ATTRIBUTES, "reading"), (*_SERIES, "deviation", "deformation", "bending_moment", "line")),
}
"""Attributes and series of a record by its kind; ``robot`` is one of the 2010 robot that an earlier version wrote."""


def read_record(path: str | os.PathLike[str]) -> Record:
    """The record of a result file, whole, of the version that is known here.

    Raises :class:`tmodes.errors.ResultFileError` as :meth:`tmodes.result.result.Result.load`.
    """
    from tmodes.io import resultfile

    data = resultfile.read_record(path)
    version = data.attrs.get("tmodes_format")
    if version != RESULT_FORMAT:
        hint = "read it with the tmodes that wrote it, or run the robot again"
        raise file_error(f"{path}, tmodes_format", repr(version), str(RESULT_FORMAT), hint)
    return data


def write_record(data: Record, path: Path, *, overwrite: bool) -> Path:
    """Store a record as a result file; raises as :meth:`tmodes.result.result.Result.save`."""
    from tmodes.io.resultfile import write_sealed

    if os.path.lexists(path) and not overwrite:
        raise file_error(path, "a file that exists", "a new name", "choose another name, or overwrite=True")
    refuse_not_finite(data)
    write_sealed(data, path, overwrite=overwrite)
    return path


_NOMINAL = ("q", "v", "deformation", "gear_torque", "tip", "contact_force_normal")

RENAMED = "an earlier version wrote this result: its series *_reference, of the nominal run, are shown as *_nominal"


def with_present_names(data: Record) -> Record:
    """The same with the series of the nominal run under the names that they have now, and a notice of that."""
    old = {f"{name}_reference": f"{name}_nominal" for name in _NOMINAL}
    old = {before: now for before, now in old.items() if before in data and now not in data}
    if not old or is_earlier(data):
        return data
    data = data.rename(old)
    try:
        return data.assign_attrs(warnings=json.dumps([*json.loads(data.attrs["warnings"]), RENAMED]))
    except (KeyError, TypeError, ValueError, RecursionError):  # what is wrong there is refused with the other content
        return data


def is_earlier(data: Record) -> bool:
    """Whether it is a record of the 2010 robot by an earlier version, in the paper's coordinates."""
    return _kind(data) == "robot"


def _kind(data: Record) -> str:
    return str(data.attrs.get("kind", "robot"))


def refuse_incomplete(data: Record, path: object) -> None:
    """Refuse what is no whole record of a run, or what no run wrote; ``path`` names it.

    Raises :class:`tmodes.errors.ResultFileError`.
    """
    if (kind := _kind(data)) not in _NEEDED:
        got, hint = f"a result of {shown(kind)}", "read it with the tmodes that wrote it"
        raise file_error(path, got, "a result of a robot", hint)
    attributes, series = _NEEDED[kind]
    missing = [name for name in attributes if name not in data.attrs] + [name for name in series if name not in data]
    if missing:
        raise file_error(f"{path}, {missing[0]}", "nothing", "a result of a run", "run the robot again")
    if data.attrs["status"] not in STATUSES:
        got, expected = repr(data.attrs["status"]), f"one of {STATUSES}"
        raise file_error(f"{path}, status", got, expected, "run the robot again")
    refuse_wrong_content(data, path, whole=kind == "arm")


def text_of(data: Record, name: str) -> str:
    """An attribute; raises :class:`tmodes.errors.ResultFileError` where there is none."""
    if name not in data.attrs:
        raise file_error(f"result, attribute {name}", "nothing", "text", "run the robot again")
    return str(data.attrs[name])


def from_json(data: Record, name: str) -> Any:
    """What the JSON text of an attribute says; raises :class:`tmodes.errors.ResultFileError` where it is none."""
    try:
        return json.loads(text_of(data, name))
    except (ValueError, RecursionError) as error:
        raise file_error(f"result, attribute {name}", "no JSON text", "JSON text", "run the robot again") from error


def stored_robot(data: Record, name: str) -> Robot:
    """The robot of an attribute, rebuilt from its data sheet; raises as :attr:`tmodes.result.result.Result.robot`."""
    from tmodes.io.sheet_check import sheet_from_data

    if absent := absent_kinds(sheet := from_json(data, name)):
        raise absent[0]
    try:
        return sheet_from_data(sheet)
    except (InputError, InputErrors) as error:
        got = f"a data sheet that is wrong ({error})"
        raise file_error(f"result, attribute {name}", got, "that of the robot that ran", AGAIN) from error


NOTICE = "{}; until then the series are shown without what needs the robot's model"

OLDER = "written by an earlier version: without the tip's error by cause; settling and vibration are of its samples"

_HINT = "register it before: tmodes --use FILE ..., or import the script that defines it"

_PLACES: dict[str, Registry[Any]] = {
    "joints.*.type": JOINTS,
    "joints.*.drive": DRIVES,
    "links.*.beam.model": LINKS,
    "drives.*.controller.type": CONTROLLERS,
    "control.*.block.type": CONTROLLERS,
    "sensors.*.type": SENSORS,
    "drives.*.signal.type": SIGNALS,
    "drives.*.signal.signals.*.type": SIGNALS,
    "drives.*.noise.type": SIGNALS,
    "drives.*.motion.type": SIGNALS,
    "drives.*.brake.type": SIGNALS,
    "drives.*.feed_forward.type": SIGNALS,
    "loads.*.signal.type": SIGNALS,
    "base_motion.*.type": SIGNALS,
    "contact.law": CONTACTS,
    "contact.shape.type": SURFACES,
    "integration.method": INTEGRATORS,
}

"""Where a data sheet names kinds, and of which family; ``*``: any item or name."""

_OURS = {"", AUTO, RECURSION}


def absent_kinds(sheet: Mapping[str, Any]) -> list[UnknownKindError]:
    """The kinds that the plain data of a robot name and that are not registered, as the errors of using them."""
    from tmodes.equations.lagrange.registry import SYSTEMS

    found: dict[str, UnknownKindError] = {}
    for path, registry in (_PLACES | {"equations": SYSTEMS}).items():
        for name in _values(sheet, path.split(".")):
            if isinstance(name, str) and name not in registry and name not in _OURS:
                which = f"the {registry.noun} kind of this result" if registry is not SYSTEMS else "equations"
                found[f"{path} {name}"] = UnknownKindError(which, f"`{name}`", "one that is registered here", _HINT)
    return [*found.values()]


def _values(data: Any, steps: Sequence[str]) -> Iterator[Any]:
    if not steps:
        yield data
        return
    inner: Any = ()
    if steps[0] == "*":
        inner = data.values() if isinstance(data, Mapping) else data if isinstance(data, list) else ()
    elif isinstance(data, Mapping) and steps[0] in data:
        inner = (data[steps[0]],)
    for one in inner:
        yield from _values(one, steps[1:])
