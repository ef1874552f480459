"""Read a mesh: STL, binary or ASCII, and the triangles of Wavefront OBJ. Everything is bounded, and checked before use.

STL: https://www.fabbers.com/tech/STL_Format; OBJ: http://paulbourke.net/dataformats/obj (v and f lines, nothing else).
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.errors import InputError
from tmodes.io.files import read_bytes
from tmodes.io.words import shown_path

__all__ = ["Triangles", "box", "cylinder", "ranks", "read_mesh", "sphere"]

MOST_BYTES = 32 * 1024 * 1024
MOST_TEXT = 6 * 1024 * 1024
MOST_TRIANGLES = 500_000
LARGEST = 1e6
"""Size of a coordinate [m or mm] beyond which a file is damaged."""

_HEAD = 84
_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


class Triangles(NamedTuple):
    """A surface: ``vertices`` (k, 3) in the file's unit, ``faces`` (f, 3) of their indices."""

    vertices: NDArray[np.float64]
    faces: NDArray[np.intp]


def read_mesh(path: str | os.PathLike[str]) -> Triangles:
    """Triangles of an STL or OBJ, equal corners one vertex; InputError for other, damaged, empty or too large files."""
    ending, which = Path(path).suffix.lower(), shown_path(path)
    if ending not in {".stl", ".obj"}:
        raise _fault(which, f"a file with the ending {ending or 'of none'}", "save the mesh as .stl or .obj")
    content = read_bytes(path, MOST_BYTES)
    try:
        found = _obj(content, which) if ending == ".obj" else _stl(content, which)
    except (ValueError, IndexError, OverflowError):
        raise _fault(which, "numbers that cannot be read", "save the mesh once more") from None
    return _checked(found, which)


def _stl(content: bytes, which: str) -> Triangles:
    """Binary where the count of triangles agrees with the length, else ASCII: some binary files begin with `solid`."""
    count = int.from_bytes(content[80:_HEAD], "little") if len(content) >= _HEAD else -1
    if len(content) == _HEAD + count * _RECORD.itemsize:
        _bound(count, which)
        corners = np.frombuffer(content, _RECORD, count, _HEAD)["corners"].astype(float).reshape(-1, 3)
    elif content.lstrip()[:5].lower() == b"solid":
        _refuse_long_text(content, which)
        info = [
            line.split()[1:4]
            for line in content.decode("latin-1").splitlines()
            if line.lstrip()[:6].lower() == "vertex"
        ]
        _bound(len(info) // 3, which)
        corners = np.array(info, dtype=float).reshape(-1, 3)
    else:
        raise _fault(which, "a length that its number of triangles does not have", "use a whole copy of the file")
    if len(corners) % 3:
        raise _fault(which, "a triangle without three corners", "use a whole copy of the file")
    _bound(len(corners) // 3, which)
    faces = ranks(corners)
    return Triangles(corners[np.unique(faces, return_index=True)[1]], faces.reshape(-1, 3))


def ranks(rows: NDArray[Any]) -> NDArray[np.intp]:
    """The place of each row among the different ones in their order; equal rows have the same.

    As the inverse of ``np.unique(rows, axis=0)``, which compares whole rows, takes many times as long, and
    lets no other thread run.
    """
    rank = np.zeros(len(rows), dtype=np.int64)
    for column in rows.T:
        values, own = np.unique(column, return_inverse=True)
        rank = np.unique(rank * len(values) + own, return_inverse=True)[1]
    return rank


def _obj(content: bytes, which: str) -> Triangles:
    """Faces of more than three corners become fans."""
    _refuse_long_text(content, which)
    vertices: list[list[float]] = []
    faces: list[tuple[int, int, int]] = []
    for line in content.decode("latin-1").splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            vertices.append([float(word) for word in words[1:4]])
        elif words[:1] == ["f"]:
            _bound(len(faces) + len(words) - 3, which)
            corners = [int(word.partition("/")[0]) for word in words[1:]]
            ring = [corner - 1 if corner > 0 else len(vertices) + corner for corner in corners]
            faces += [(ring[0], ring[k], ring[k + 1]) for k in range(1, len(ring) - 1)]
    return Triangles(np.array(vertices, dtype=float).reshape(-1, 3), np.array(faces, dtype=np.intp).reshape(-1, 3))


def _checked(found: Triangles, which: str) -> Triangles:
    vertices, faces = found
    if not len(faces):
        raise _fault(which, "no triangle", "check that this is the file you mean")
    if faces.min() < 0 or faces.max() >= len(vertices):
        raise _fault(which, "a face of a vertex that is not there", "use a whole copy of the file")
    if not (np.isfinite(vertices).all() and np.abs(vertices).max() < LARGEST):
        raise _fault(which, f"a coordinate that is no number below {LARGEST:g}", "use a whole copy of the file")
    return found


def _refuse_long_text(content: bytes, which: str) -> None:
    """Text takes some fifty times its size in memory while it is read."""
    if len(content) > MOST_TEXT:
        raise _fault(which, f"{len(content):,} bytes of text", f"save it as binary STL, or in at most {MOST_TEXT:,}")


def _bound(count: int, which: str) -> None:
    if count > MOST_TRIANGLES:
        raise _fault(which, f"{count} triangles", f"simplify it to at most {MOST_TRIANGLES}")


def _fault(which: str, got: str, hint: str) -> InputError:
    return InputError(which, got, "a mesh as STL or OBJ", hint)


_AROUND = 32
_DOWN = 16


def box(sizes: ArrayLike) -> Triangles:
    """A box of the sizes (3,) along x, y and z."""
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * np.asarray(sizes) / 2
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return Triangles(corners, np.array([face for a, b, c, d in sides for face in ((a, b, c), (a, c, d))]))


def cylinder(radius: float, length: float) -> Triangles:
    """A cylinder along z."""
    return _turned(np.array([0, radius, radius, 0.0]), np.array([-1, -1, 1, 1]) * length / 2)


def sphere(radius: float) -> Triangles:
    """A sphere."""
    down = np.linspace(np.pi, 0, _DOWN + 1)
    return _turned(radius * np.sin(down), radius * np.cos(down))


def _turned(radii: np.ndarray, heights: np.ndarray) -> Triangles:
    """The surface of a profile that turns about z, from below to above."""
    angle = 2 * np.pi * np.arange(_AROUND) / _AROUND
    circle = np.column_stack([np.cos(angle), np.sin(angle)])
    rings = [np.column_stack([r * circle, np.full(_AROUND, z)]) for r, z in zip(radii, heights, strict=True)]
    here = np.arange(_AROUND)
    after, above = np.roll(here, -1), here + _AROUND
    below = np.column_stack([here, after, above]), np.column_stack([after, after + _AROUND, above])
    faces = [k * _AROUND + one for k in range(len(radii) - 1) for one in below]
    return Triangles(np.concatenate(rings), np.concatenate(faces))
