"""A page's data as one block of bytes: a JSON head, and the arrays that it names; ``web/src/pack.ts`` reads it.

``TMPK``, length of the head (uint32, little-endian), the head (UTF-8), zeros up to a multiple of 8, then the arrays,
each from a multiple of 8 on. In the head an array is ``{"$array": k}``, and ``arrays[k]`` gives type, shape and place;
``{"$sum": [a, b]}`` is the sum of two. The type ``d2``: whole numbers of two bytes as changes from row to row (modulo
65536), the low bytes of all of them, then the high ones.
``d4``: single precision, its bits given in the same way, in four planes.
"""

from __future__ import annotations

import base64
import gzip
import json
import struct
from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.schema.axes import matrix_quaternion

__all__ = [
    "MOST_FRAMES", "MOST_POINTS", "Coarse", "TwoParts", "colour", "displaced", "embedded", "kept", "pack",
    "quaternions", "scene_frames", "stations_shown", "steady", "thinned",
]  # fmt: skip


_KINDS = {"float64": "f8", "int32": "i4", "uint8": "u1"}


@dataclass(frozen=True, eq=False)
class Coarse:
    """An array that is kept in whole numbers of two bytes: to 1/65000 of its range, which a picture never shows."""

    values: NDArray[Any]


@dataclass(frozen=True, eq=False)
class TwoParts:
    """An array as the sum of two of its shape, such as a place and what it is displaced by, which keeps its digits."""

    large: NDArray[Any] | Coarse
    small: NDArray[Any] | Coarse


@dataclass
class _Arrays:
    info: list[dict[str, Any]] = field(default_factory=list)
    parts: list[bytes] = field(default_factory=list)
    size: int = 0
    known: dict[tuple[Any, ...], dict[str, int]] = field(default_factory=dict)
    """Where each content is: what is equal, such as the times of all charts, is kept once."""

    def add(self, values: NDArray[Any], **more: Any) -> dict[str, int]:
        values = np.ascontiguousarray(values)
        content = values.astype(values.dtype.newbyteorder("<"), copy=False).tobytes()
        own = (_KINDS[values.dtype.name], values.shape, content, *more.values())
        if own not in self.known:
            self.known[own] = {"$array": len(self.info)}
            self.info.append({"dtype": own[0], "shape": values.shape, "offset": self.size, **more})
            self.parts.append(content + bytes(-len(content) % 8))
            self.size += len(self.parts[-1])
        return self.known[own]


def pack(page: Mapping[str, Any]) -> bytes:
    """Plain data with NumPy arrays (float64, float32, int32, uint8), :class:`Coarse` ones and sums anywhere in it.

    Raises ValueError for a number outside of arrays that is not finite, and KeyError for an array of another type.
    """
    arrays = _Arrays()
    head = json.dumps({"page": _plain(page, arrays), "arrays": arrays.info}, allow_nan=False, separators=(",", ":"))
    text = head.encode()
    start = b"TMPK" + struct.pack("<I", len(text)) + text
    return b"".join([start, bytes(-len(start) % 8), *arrays.parts])


def embedded(packed: bytes) -> str:
    """A pack as text that a page can hold: compressed, base64; the same pack gives the same text."""
    return base64.b64encode(gzip.compress(packed, 6, mtime=0)).decode()


def _plain(value: Any, arrays: _Arrays) -> Any:
    match value:
        case Coarse():
            return _coarse(value.values, arrays)
        case TwoParts():
            return {"$sum": [_plain(value.large, arrays), _plain(value.small, arrays)]}
        case np.ndarray():
            return _single(value, arrays) if value.dtype == np.float32 else arrays.add(value)
        case Mapping():
            return {str(key): _plain(item, arrays) for key, item in value.items()}
        case list() | tuple():
            return [_plain(item, arrays) for item in value]
    return value


def _coarse(values: NDArray[Any], arrays: _Arrays) -> dict[str, int]:
    """Changes from row to row, all low bytes before all high ones: what moves smoothly is then compressed to a half."""
    low, high = (float(values.min()), float(values.max())) if values.size else (0.0, 0.0)
    middle, scale = (low + high) / 2, (high - low) / 65000 or 1.0
    whole = np.atleast_1d(np.round((values - middle) / scale).astype("<i2"))
    return arrays.add(_steps(whole, 2), dtype="d2", shape=values.shape, scale=scale, start=middle)


def _single(values: NDArray[Any], arrays: _Arrays) -> dict[str, int]:
    """Single precision, exactly: changes of the bits, read as whole numbers, in planes of bytes as those above."""
    whole = np.atleast_1d(np.ascontiguousarray(values, dtype="<f4").view("<u4"))
    return arrays.add(_steps(whole, 4), dtype="d4", shape=values.shape)


def _steps(whole: NDArray[Any], width: int) -> NDArray[Any]:
    """Changes from row to row, first the lowest bytes of all, last the highest; sums overflow as the reader's do."""
    steps = np.diff(whole, axis=0, prepend=np.zeros_like(whole[:1]))
    return steps.reshape(-1).view(np.uint8).reshape(-1, width).T


MOST_POINTS = 6000
"""Points of a chart's abscissa beyond which it is thinned."""

MOST_FRAMES = 3000
"""Instants at which the robot is kept, at most."""

_RATE = 50.0
"""Instants at which the robot is kept in a simulated second."""

_FEW = 400
"""Instants of a short run, so that its vibration can be seen slowed down."""

_MOST_NUMBERS = 900_000
"""Numbers of one of the robot's arrays over all instants, at most."""

_FEWEST_BINS = 50

Indices = NDArray[np.intp]


def thinned(curves: NDArray[np.float64], most: int = MOST_POINTS) -> Indices:
    """Which of n samples a picture of ``curves``, shape (n, k), needs: in each of equal bins every curve's extremes.

    At most about ``most`` of them (more where there are very many curves); all where there are no more. The first and
    the last are always among them.
    """
    count, width = curves.shape
    if count <= most:
        return np.arange(count)
    bins = min(max(_FEWEST_BINS, most // (2 * max(width, 1))), count)
    edges = np.linspace(0, count, bins + 1).astype(np.intp)
    chosen = [np.array([0, count - 1], dtype=np.intp)]
    for start, end in pairwise(edges):
        part = curves[start:end]
        chosen += [start + part.argmin(axis=0), start + part.argmax(axis=0)]
    return np.unique(np.concatenate(chosen))


def scene_frames(times: NDArray[np.float64], numbers: int = 0) -> Indices:
    """The samples at which the robot is shown: evenly in time, 50 in a second or 400, at most :data:`MOST_FRAMES`.

    ``times`` (n,) [s], rising; ``numbers``: how many each instant takes of one array, which bounds the instants too.
    The first and the last sample are among them.
    """
    if len(times) < 2:
        return np.arange(len(times))
    room = max(2, min(MOST_FRAMES, _MOST_NUMBERS // max(numbers, 1)))
    wanted = max(_FEW, int(np.ceil((times[-1] - times[0]) * _RATE)) + 1)
    even = np.linspace(times[0], times[-1], min(wanted, room))
    after = np.clip(np.searchsorted(times, even), 1, len(times) - 1)
    nearer = even - times[after - 1] < times[after] - even
    return np.unique(np.where(nearer, after - 1, after))


Array = NDArray[np.float64]

_FINE = 30_000
"""Numbers up to which an array keeps the digits of single precision."""

_MOST_PLACES = 400_000
"""Places (frames, links, stations) beyond which fewer stations along each link are shown."""


def kept(values: Array) -> NDArray[np.float32] | Coarse:
    """An array as a picture needs it: in single precision, or, where it is large, in 65,000 steps."""
    return values.astype(np.float32) if values.size <= _FINE else Coarse(values)


def displaced(values: Array, rigid: Array, base: NDArray[np.float32] | Coarse) -> NDArray[np.float32] | TwoParts:
    """Places that differ little from ``rigid``, which is kept as ``base``.

    The difference keeps its own digits, because it is shown enlarged.
    """
    if values.size <= _FINE:
        return values.astype(np.float32)
    return TwoParts(base, kept(values - rigid))


def colour(name: str, label: str, unit: str, values: Array) -> dict[str, Any]:
    """What may colour the links; ``values`` (m, L, S)."""
    return {"id": name, "label": label, "unit": unit, "values": kept(values)}


def quaternions(rotation: Array) -> NDArray[np.float32]:
    """Quaternions x, y, z, w (m, L, 4) of rotations (m, L, 3, 3), along time without jumps of sign."""
    found = matrix_quaternion(rotation.reshape(-1, 3, 3)).reshape(*rotation.shape[:-2], 4)
    return steady(found).astype(np.float32)


def steady(found: Array) -> Array:
    """The same rotations, each quaternion (m, L, 4) on the side of the one before it."""
    turns = np.where((found[1:] * found[:-1]).sum(axis=-1) < 0, -1.0, 1.0)
    signs = np.concatenate([np.ones((1, *turns.shape[1:])), np.cumprod(turns, axis=0)])
    return found * signs[..., None]


def stations_shown(count: int, frames: int, links: int) -> NDArray[np.intp]:
    """Indices of the stations along each link that are shown, root and tip among them."""
    most = max(5, _MOST_PLACES // max(frames * links, 1))
    return np.unique(np.linspace(0, count - 1, min(count, most)).round().astype(np.intp))
