"""The series of a result, one by one: what each is called, its unit, and its values over time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    from tmodes.io.labelled import Labelled, Record

__all__ = ["ASCII", "BLOCKS", "StoredSeries", "series_of_result", "sparkline", "steps_for"]


@dataclass(frozen=True, eq=False)
class StoredSeries:
    """One course over time: values [unit, SI], shape (n,)."""

    variable: str
    of: str
    unit: str
    values: NDArray[np.float64]

    @property
    def name(self) -> str:
        """The variable and what it is of."""
        return f"{self.variable} {self.of}".rstrip()


def series_of_result(data: Record) -> Iterator[StoredSeries]:
    """Every series; of what is known along a link the value of the largest size at each instant, with its sign."""
    for name, variable in data.data_vars.items():
        if variable.dims[:1] == ("time",) and np.issubdtype(variable.dtype, np.floating):
            yield from _parts(data, str(name), variable, _coordinate_units(data))


def _farthest(variable: Labelled) -> tuple[list[str], NDArray[np.float64]]:
    """Dimensions and values; of those along a link the one of the largest size at each instant."""
    values, dims = np.asarray(variable.values, dtype=float), [str(dim) for dim in variable.dims]
    if "s" not in dims:
        return dims, values
    axis = dims.index("s")
    places = np.expand_dims(np.abs(values).argmax(axis=axis), axis)
    return [dim for dim in dims if dim != "s"], np.take_along_axis(values, places, axis=axis).squeeze(axis)


def _coordinate_units(data: Record) -> dict[str, str]:
    """Unit of each coordinate of a robot; the deflection of a gear or spring has that of its joint."""
    if "coordinate_unit" not in data.coords:
        return {}
    info = dict(zip(map(str, data["coordinate"].values), map(str, data["coordinate_unit"].values), strict=True))
    return info | {f"{name}.{element}": unit for name, unit in info.items() for element in ("gear", "spring")}


def _own_unit(info: str, word: str, units: dict[str, str]) -> str:
    """The unit of one column of ``(rad, m along prismatic joints, 1 of stretch)/s``; others stay as they are."""
    inner, _, per = info.removeprefix("(").partition(")")
    choices = inner.split(", ")
    if len(choices) == 1:
        return info
    place = ("rad", "m", "1").index(units.get(word, "rad"))
    return choices[min(place, len(choices) - 1)].partition(" along ")[0].partition(" of ")[0] + per


def _parts(data: Record, name: str, variable: Labelled, units: dict[str, str]) -> Iterator[StoredSeries]:
    dims, values = _farthest(variable)
    labels = [
        [str(one) for one in (data[dim].values if dim in data.coords else range(data.sizes[dim]))] for dim in dims[1:]
    ]
    values = values.reshape(len(values), -1)
    unit = str(variable.attrs.get("units", ""))
    for column, words in enumerate(product(*labels)):
        yield StoredSeries(name, " ".join(words), _own_unit(unit, words[0] if words else "", units), values[:, column])


BLOCKS = "▁▂▃▄▅▆▇█"
ASCII = "_.-~=+*#"
"""Eight heights, from low to high."""


def sparkline(values: ArrayLike, width: int, steps: str = BLOCKS) -> str:
    """``values`` (n,) as at most ``width`` heights from their least to their largest; a constant is a flat line.

    Each height is of the value of its part that is farthest from the middle of the range, so that no peak is lost.
    """
    course = np.asarray(values, dtype=float)
    low, high = float(course.min()), float(course.max())
    middle = (low + high) / 2
    parts = np.array_split(course, min(width, len(course)))
    extremes = np.array([part[np.argmax(np.abs(part - middle))] for part in parts])
    if not high > low:
        return steps[0] * len(extremes)
    heights = np.rint((extremes - low) / (high - low) * (len(steps) - 1)).astype(int)
    return "".join(steps[height] for height in heights)


def steps_for(encoding: str | None) -> str:
    """The heights that text of an encoding can hold."""
    try:
        BLOCKS.encode(encoding or "ascii")
    except (LookupError, UnicodeEncodeError):
        return ASCII
    return BLOCKS
