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
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["Coarse", "TwoParts", "embedded", "pack"]

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
    return base64.b64encode(gzip.compress(packed, 9, mtime=0)).decode()


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
