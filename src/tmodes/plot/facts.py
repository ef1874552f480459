"""What figures need to know, from the dataset of a result: commands, units, instants, and which of many to show."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import joint_of_element
from tmodes.plot.style import INSTANTS

__all__ = [
    "command_of", "deformation_unit", "drive_unit", "effort_unit", "instant_looks", "instants", "largest", "motor_of",
    "move_end", "names_of", "spectral_part",
]  # fmt: skip

_SETTLED = 0.05
"""Share of the largest distance from the final position within which the robot counts as having arrived."""

_KEEPS_RATE = 1e-6
"""Second difference of a setpoint, over its largest, that counts as a constant rate."""

Array = NDArray[Any]


def names_of(data: Any, dimension: str) -> list[str]:
    """The names along a dimension of the dataset; none where it has no such dimension."""
    return [str(name) for name in data[dimension].values] if dimension in data.dims else []


def largest(names: list[str], sizes: Any, most: int = 8) -> list[str]:
    """At most so many names, those of the largest sizes, in the order in which they stand."""
    chosen = np.argsort(-np.asarray(sizes, dtype=float), kind="stable")[:most]
    return [names[k] for k in sorted(chosen)]


def command_of(data: Any, joint: str) -> str:
    """What the signal of a drive is; of a joint without a drive ``held``."""
    drives = json.loads(data.attrs["robot"]).get("drives", [])
    return next((str(drive["command"]) for drive in drives if drive["joint"] == joint), "held")


def motor_of(data: Any, joint: str) -> str | None:
    """The coordinate of a joint's motor; None where it moves with the joint."""
    name = f"{joint}.motor"
    return name if name in data["coordinate"].values else None


def drive_unit(data: Any, joint: str) -> str:
    """Unit of a joint's coordinate."""
    return str(data["coordinate_unit"].sel(coordinate=joint).values)


def effort_unit(data: Any, joint: str) -> str:
    """Unit of a joint's effort."""
    return "N" if drive_unit(data, joint) == "m" else "N m"


def deformation_unit(data: Any, name: str) -> str:
    """Unit of an elastic coordinate."""
    own = name if name in data["coordinate"].values else joint_of_element(name)
    unit = str(data["coordinate_unit"].sel(coordinate=own).values) if own in data["coordinate"].values else "rad"
    return "-" if unit == "1" else unit


def move_end(data: Any) -> float | None:
    """When the signals that move the robot stop changing [s]; None where they change up to the end."""
    return json.loads(data.attrs["move_end"])


def instants(data: Any, most: int = len(INSTANTS)) -> NDArray[np.intp]:
    """At most ``most`` samples from the start until the links stay near where they are at the end, spread evenly.

    The one nearest to the largest deflection is moved there, if it is neither the first nor the last.
    """
    tip = data["tip"].transpose("time", "axis").values
    ends = data["line"].isel(s=-1).transpose("time", "link", "axis").values if "line" in data else tip[:, None]
    away = np.linalg.norm(ends - ends[-1], axis=-1).max(axis=1)
    moving = np.flatnonzero(away > _SETTLED * away.max()) if away.max() > 0 else np.zeros(1, dtype=int)
    last = min(int(moving[-1]) + 1, len(ends) - 1)
    chosen = np.linspace(0, last, most).round().astype(int)
    if "line_rigid" in data and most > 2:
        bend = np.linalg.norm(
            (data["line"] - data["line_rigid"]).transpose("time", "link", "s", "axis").values, axis=-1
        )
        largest_at = int(bend[: last + 1].max(axis=(1, 2)).argmax())
        chosen[1 + int(np.argmin(np.abs(chosen[1:-1] - largest_at)))] = largest_at
    return np.unique(chosen)


def instant_looks(count: int) -> list[dict[str, Any]]:
    """Looks of so many instants, early to late."""
    return [INSTANTS[k] for k in np.linspace(0, len(INSTANTS) - 1, count).round().astype(int)]


def spectral_part(data: Any, least: int) -> Any:
    """The part of a run whose spectrum shows its vibration, without a last sample that is off the even grid.

    The time after the move where it has ``least`` samples; else the longest part in which no setpoint accelerates,
    where that has so many; else the whole run.
    """
    even = _even(data)
    end, time = move_end(data), even["time"].values
    first = len(time) if end is None else int(np.searchsorted(time, end * (1 + 1e-9)))
    if len(time) - first >= least:
        return even.isel(time=slice(first, None))
    first, last = _longest(_coasting(even))
    return even.isel(time=slice(first, last)) if last - first >= least else even


def _even(data: Any) -> Any:
    time = data["time"].values
    odd = len(time) > 2 and abs((time[-1] - time[-2]) / (time[1] - time[0]) - 1) > 1e-6
    return data.isel(time=slice(None, -1)) if odd else data


def _coasting(data: Any) -> NDArray[np.bool_]:
    """Samples at which every position setpoint keeps its rate; none where there is no such setpoint."""
    time = data["time"].values
    known = [name for name in names_of(data, "drive") if command_of(data, name) in ("position", "prescribed")]
    inside = np.zeros(len(time), dtype=bool)
    if len(time) < 3 or not known:
        return inside
    setpoints = data["wanted"].sel(drive=known).transpose("time", "drive").values
    bends = np.abs(np.diff(setpoints, 2, axis=0)).max(axis=1)
    inside[1:-1] = bends <= _KEEPS_RATE * max(bends.max(), np.finfo(float).tiny)
    return inside


def _longest(inside: NDArray[np.bool_]) -> tuple[int, int]:
    """First sample of the longest stretch that is inside, and the one after its last."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], inside, [False]]).astype(int)))
    if not len(edges):
        return 0, 0
    first, last = edges[::2], edges[1::2]
    longest = int(np.argmax(last - first))
    return int(first[longest]), int(last[longest])
