"""What figures of arms need to know, from the dataset of a result: commands, units, and which of many to show."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "MOST_ROWS", "after_move", "command_of", "deformation_unit", "drive_unit", "drives_by", "effort_unit", "largest",
    "motor_of", "move_end", "plain", "rows_height",
]  # fmt: skip

MOST_ROWS = 8
"""Rows of a figure; of more joints or coordinates those are shown that do most."""


def rows_height(rows: int) -> float:
    """Height of a figure of so many rows [in]: few rows are higher."""
    return 0.8 + max(0.95, 1.7 - 0.2 * rows) * rows


_LONGEST = 30
"""Letters of a name in a figure."""

Array = NDArray[Any]


def plain(name: object) -> str:
    """A name as text of a figure: no formula, not too long, and shown also where it begins with an underscore."""
    text = str(name)
    text = text if len(text) <= _LONGEST else f"{text[: _LONGEST - 3]}..."
    text = text.replace("$", r"\$")
    return f" {text}" if text.startswith("_") else text


def largest(names: list[str], sizes: Array, most: int = MOST_ROWS) -> list[str]:
    """At most so many names, those of the largest sizes, in the order in which they stand."""
    chosen = np.argsort(-np.asarray(sizes, dtype=float), kind="stable")[:most]
    return [names[k] for k in sorted(chosen)]


def drives_by(data: Any, variable: str, most: int = MOST_ROWS) -> list[str]:
    """The drives with the largest values of a variable of theirs."""
    names = [str(name) for name in data["drive"].values]
    return largest(names, np.abs(data[variable].transpose("drive", "time").values).max(axis=1), most)


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
    own = name if name in data["coordinate"].values else name.removesuffix(".gear")
    unit = str(data["coordinate_unit"].sel(coordinate=own).values) if own in data["coordinate"].values else "rad"
    return "-" if unit == "1" else unit


def move_end(data: Any) -> float | None:
    """When what moves the arm stops changing [s]; None where it does so up to the end."""
    return json.loads(data.attrs["move_end"])


def after_move(data: Any, least: int) -> tuple[Any, bool]:
    """The part of the run after its move if that has so many samples, else the whole; and whether it is that part."""
    end, time = move_end(data), data["time"].values
    first = len(time) if end is None else int(np.searchsorted(time, end * (1 + 1e-9)))
    rest = len(time) - first
    return (data.isel(time=slice(first, None)), True) if rest >= least else (data, False)
