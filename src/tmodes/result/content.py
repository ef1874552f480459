"""What the content of a result file must be: JSON of the right shape, finite series, times that increase.

A seal that matches shows that nothing was damaged, not that a run wrote it.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache
from itertools import chain
from typing import TYPE_CHECKING, Annotated, Any, NotRequired, get_type_hints

import numpy as np
from pydantic import Field, FiniteFloat, TypeAdapter, ValidationError
from typing_extensions import TypedDict

from tmodes.io.atomic import file_error
from tmodes.result.derived import failed_in
from tmodes.sheet.robot import RECURSION

if TYPE_CHECKING:
    from tmodes.io.labelled import Record

__all__ = ["AGAIN", "refuse_not_finite", "refuse_wrong_content"]

AGAIN = "run the robot again"


class _ModeContent(TypedDict):
    """A mode of vibration; further keys may stand next to these."""

    frequency_Hz: float
    damped_frequency_Hz: float | None
    damping_ratio: float
    element: str


class _Settling(TypedDict):
    time_s: FiniteFloat | None
    band: FiniteFloat | None
    limit_m: FiniteFloat | None
    reason: str


class _Vibration(TypedDict):
    """A mode of a residual vibration; of files of earlier versions without ``element``, the frequency a damped one."""

    frequency_Hz: FiniteFloat
    damped_frequency_Hz: NotRequired[FiniteFloat]
    damping_ratio: FiniteFloat
    amplitude_m: FiniteFloat
    element: NotRequired[str]


class _ResidualContent(TypedDict):
    amplitude_m: FiniteFloat | None
    modes: list[_Vibration]
    reason: str


class _Errors(TypedDict):
    how: str
    figures: dict[str, FiniteFloat]
    approximate: NotRequired[list[str]]  # an earlier version had none
    why: NotRequired[str]


class _Elements(TypedDict):
    elements: dict[str, dict[str, FiniteFloat]]
    environment: dict[str, FiniteFloat] | None


_Group = dict[str, Any]
_Empty = Annotated[dict[str, Any], Field(max_length=0)]


class _Attributes(TypedDict, total=False):
    """Attributes that are JSON text, and what it holds."""

    robot: _Group
    robot_real: _Group
    statistics: _Group
    versions: dict[str, str]
    frequencies: dict[str, list[_ModeContent]]
    end_frequencies: dict[str, list[_ModeContent]]
    tip_error_elements: dict[str, _Elements]
    warnings: list[str]
    settling: _Settling | None
    vibration: dict[str, _ResidualContent]
    errors: _Errors | _Empty | None
    model_errors: _Errors | _Empty | None
    move_end: FiniteFloat | None
    not_computed: dict[str, str]
    headline: _Group | None
    meshes: list[_Group]


_JSON = get_type_hints(_Attributes, include_extras=True)

_TEXTS = ("status", "message", "title", "method")

_SERIES = {
    "time": "energy_balance",
    "time axis": "tip tip_velocity",
    "time coordinate": "q v a",
    "time deformation_kind": "deformation",
    "time drive": "wanted effort gear_torque",
    "time energy_kind": "energy",
    "time work_kind": "work",
    "time point axis": "position velocity acceleration",
    "time point axis direction": "rotation",
    "time link s axis": "line line_rigid",
    "time bending_link s": "axial_force",
    "time bending_link s plane": "deflection slope shear_force",
    "time bending_link s moment_kind": "moment elastic_moment",
}
"""Series by their dimensions: a record that has these dimensions has them all."""

_REFERENCE = {
    "time": "deviation",
    "time axis": "tip_nominal",
    "time coordinate": "q_nominal v_nominal",
    "time deformation_kind": "deformation_nominal",
    "time drive": "gear_torque_nominal",
}
"""The same of a run with a reference, which has a deviation from it."""

_OF_LINES = {"time deformation_kind": "deformation_stationary deformation_oscillatory"}
"""The same of what is computed with the lines of the links."""

_SOMETIMES = {
    "time": "contact_force_normal contact_force_normal_nominal penetration surface_displacement surface_velocity",
    "time axis": "contact_force tip_commanded",
    "time error_part axis": "tip_error tip_error_nominal",
    "time drive": "voltage current",
    "time stressed_link s": "stress",
    "time controller_state": "controller_states",
    "event": "event_time event_speed event_direction",
}
"""Series that a record may have, by their dimensions."""

_LABELLED = ("axis", "bending_link", "coordinate", "deformation_kind", "drive", "energy_kind", "error_part", "link",
             "moment_kind", "plane", "point", "s", "stressed_link", "work_kind")  # fmt: skip


def refuse_wrong_content(data: Record, path: object, *, whole: bool) -> None:
    """Refuse a record that no run wrote; ``path`` names it; ``whole``: its series and their names too.

    Raises :class:`tmodes.errors.ResultFileError`.
    """
    checks = [_attributes, _times, *([_series, _labels] if whole else [])]
    for place, got, expected in chain.from_iterable(check(data) for check in checks):
        raise file_error(f"{path}, {place}", got, expected, AGAIN)
    refuse_not_finite(data, f"{path}, ", AGAIN)


def refuse_not_finite(
    data: Record, path: str = "", hint: str = "keep only what is before it: result.data.isel(time=slice(None, n))"
) -> None:
    """Refuse numbers that are not finite; raises :class:`tmodes.errors.ResultFileError`."""
    for name, variable in data.variables.items():
        if np.issubdtype(variable.dtype, np.floating) and not np.isfinite(variable.values).all():
            raise file_error(f"{path}variable {name}", "a number that is not finite", "finite numbers", hint)


Wrong = Iterator[tuple[str, str, str]]
"""Place, what was found, what is expected."""


@cache
def _adapter(name: str) -> TypeAdapter[Any]:
    return TypeAdapter(_JSON[name])


def _attributes(data: Record) -> Wrong:
    for name in _TEXTS:
        if name in data.attrs and not isinstance(data.attrs[name], str):
            yield f"attribute {name}", f"{data.attrs[name]!r:.60}", "text"
    for name in _JSON.keys() & data.attrs.keys():
        try:
            _adapter(name).validate_python(json.loads(data.attrs[name]), strict=True)
        except ValidationError as error:
            first = error.errors(include_url=False)[0]
            at = "".join(f"[{step!r:.40}]" for step in first["loc"])
            yield f"attribute {name}{at}", f"{first['input']!r:.60}", f"JSON as a run writes it ({first['msg']})"
        except (ValueError, TypeError, RecursionError):
            yield f"attribute {name}", "no JSON text", "JSON text"


def _times(data: Record) -> Wrong:
    time, expected = data["time"], "numbers that increase from sample to sample"
    if time.dims != ("time",) or not np.issubdtype(time.dtype, np.floating):
        yield "time", f"{time.dtype} along {time.dims}", expected
    elif not len(time):
        yield "time", "no sample", "at least one sample"
    elif not (np.diff(time.values) > 0).all():
        k = int(np.argmin(np.diff(time.values) > 0)) + 1
        yield "time", f"{time.values[k]:g} s after {time.values[k - 1]:g} s at sample {k}", expected


def _series(data: Record) -> Wrong:
    drawn = "lines" not in failed_in(data)
    asked = [
        (_SERIES, True),
        (_OF_LINES, drawn),
        (_REFERENCE, "deviation" in data or "tip_nominal" in data),
        (_SOMETIMES, False),
    ]
    for table, needed in asked:
        for dims, names in ((tuple(key.split()), names.split()) for key, names in table.items()):
            for name in names:
                expected = f"numbers along {', '.join(dims)}"
                if name not in data:
                    if needed and set(dims) - {"direction"} <= set(data.dims):
                        yield name, "nothing", expected
                elif data[name].dims != dims or not np.issubdtype(data[name].dtype, np.floating):
                    got = f"{data[name].dtype} along {', '.join(map(str, data[name].dims)) or 'no dimension'}"
                    yield name, got, expected


def _labels(data: Record) -> Wrong:
    """Each named dimension has a name for each of its places, none twice, which fit together and the robot."""
    names = {name: [*map(str, data[name].values)] for name in _LABELLED if name in data.coords}
    for name in _LABELLED:
        if name in data.dims and len(set(names.get(name, ()))) < data.sizes[name]:
            yield name, "a name that is missing or given twice", "a name of its own for each place along it"
    robot = json.loads(data.attrs["robot"])
    joints = robot.get("joints", [])
    links = [str(joint.get("child")) for joint in joints if isinstance(joint, dict)]
    links += [name for name in names.get("link", ()) if name.rpartition(".")[0] in links]
    if robot.get("equations", RECURSION) != RECURSION:
        links += [name for name in names.get("link", ()) if "-" in name]  # a system's lines from point to point
    known = {"axis": ["x", "y", "z"], "drive": names.get("coordinate", []), "link": links,
             "bending_link": links, "stressed_link": links}  # fmt: skip
    for name, right in known.items():
        if stray := set(names.get(name, ())) - set(right):
            yield name, f"{min(stray)!r:.60}", "names that the robot has"
    if "coordinate" in data.dims and not (
        "coordinate_unit" in data.coords and {*map(str, data["coordinate_unit"].values)} <= {"rad", "m", "1"}
    ):
        yield "coordinate_unit", "a unit that is missing or unknown", "rad, m or 1 for each coordinate"
    if "s" in data.coords and not (
        np.issubdtype(data["s"].dtype, np.floating) and np.abs(data["s"].values - 0.5).max() <= 0.5
    ):
        yield "s", "a place off the links", "numbers from 0 to 1"
