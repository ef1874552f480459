"""The surfaces of a robot's links, from its URDF into its result, and from there into a scene."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import TmodesError
from tmodes.io.atomic import file_error
from tmodes.io.mesh_file import Triangles, ranks
from tmodes.result import Result
from tmodes.robots.load import urdf_of

if TYPE_CHECKING:
    from tmodes.io.urdf import UrdfRobot
    from tmodes.io.urdf_shapes import LinkShape, Unseen

__all__ = [
    "StoredMesh",
    "few_shapes",
    "kept_meshes",
    "read_shapes",
    "seen_shapes",
    "shapes_of",
    "thinned",
    "with_few_shapes",
    "with_shapes",
]

MOST_TRIANGLES = 40_000
"""Triangles of a whole robot in a result: below a megabyte of its report."""


class StoredMesh(NamedTuple):
    """A surface as a result keeps it: ``vertices`` (k, 3) [m] in the link's frame, ``faces`` (f, 3)."""

    link: str
    colour: str
    vertices: NDArray[np.float32]
    faces: NDArray[np.int32]


def read_shapes(
    robot: str | os.PathLike[str], roots: Sequence[str | os.PathLike[str]] = (), trust_paths: bool = False
) -> tuple[list[LinkShape], list[str]]:
    """The surfaces of a robot by name or file, and sentences about what is not shown; none of what is no URDF.

    Nothing that is wrong with them is an error: a run needs no looks.
    """
    return _with_reasons(lambda: seen_shapes(robot, roots, trust_paths))


def shapes_of(urdf: UrdfRobot | None) -> tuple[list[LinkShape], list[str]]:
    """The same of a URDF that was read before."""
    return _with_reasons(lambda: _shapes_if_any(urdf))


def _with_reasons(shapes: Callable[[], tuple[list[LinkShape], list[Unseen]]]) -> tuple[list[LinkShape], list[str]]:
    try:
        found, unseen = shapes()
    except TmodesError as error:
        return [], [f"the shapes of the links are not shown: {error}"]
    return found, [str(one) for one in unseen]


def seen_shapes(
    robot: str | os.PathLike[str], roots: Sequence[str | os.PathLike[str]] = (), trust_paths: bool = False
) -> tuple[list[LinkShape], list[Unseen]]:
    """The same, with what is not shown link by link; raises :class:`tmodes.errors.TmodesError` where nothing can be."""
    found = urdf_of(robot, roots=roots, trust_paths=trust_paths)
    return _shapes_if_any(found)


def _shapes_if_any(urdf: UrdfRobot | None) -> tuple[list[LinkShape], list[Unseen]]:
    if urdf is None:
        return [], []
    from tmodes.io.urdf_shapes import link_shapes

    return link_shapes(urdf)


def few_shapes(shapes: Sequence[LinkShape]) -> list[LinkShape]:
    """The surfaces simplified to 40,000 triangles in all; those of which nothing is left are left out."""
    share = MOST_TRIANGLES / max(sum(len(shape.surface.faces) for shape in shapes), MOST_TRIANGLES)
    few = (
        shape._replace(surface=thinned(shape.surface, max(int(share * len(shape.surface.faces)), 12)))
        for shape in shapes
    )
    return [shape for shape in few if len(shape.surface.faces)]


def with_shapes(result: Result, shapes: Sequence[LinkShape]) -> Result:
    """The result with the surfaces of its links, simplified as by :func:`few_shapes`.

    Variables ``mesh_vertices`` (mesh_vertex, axis) [m], in the frame of their link, and ``mesh_faces`` (mesh_face,
    corner); the attribute ``meshes`` holds link, colour and numbers of both of each surface.
    """
    return with_few_shapes(result, few_shapes(shapes))


def with_few_shapes(result: Result, few: Sequence[LinkShape]) -> Result:
    """The result with surfaces that :func:`few_shapes` simplified before; see :func:`with_shapes`."""
    if not few:
        return result
    surfaces = [shape.surface for shape in few]
    data = result.record.assign(
        mesh_vertices=(("mesh_vertex", "axis"), _joined([surface.vertices for surface in surfaces], np.float32),
                       {"units": "m", "long_name": "vertices of the links' surfaces, in the frame of each link"}),
        mesh_faces=(("mesh_face", "corner"), _joined([surface.faces for surface in surfaces], np.int32),
                    {"units": "1", "long_name": "vertices of each triangle, counted within its surface"}),
    )  # fmt: skip
    data.attrs["meshes"] = json.dumps([_record(shape) for shape in few])
    return result.with_record(data)


def kept_meshes(data: Any) -> list[StoredMesh]:
    """The surfaces that a result's dataset keeps."""
    try:
        return _kept(data)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise file_error(
            "result, attribute meshes", "no list of surfaces", "a list that a run wrote", "run again"
        ) from error


def _kept(data: Any) -> list[StoredMesh]:
    found, vertex, face = [], 0, 0
    for info in json.loads(data.attrs.get("meshes", "[]")):
        if min(info["vertices"], info["faces"]) < 0:
            raise ValueError("a surface of less than nothing")
        vertices = data["mesh_vertices"].transpose("mesh_vertex", "axis").values[vertex : vertex + info["vertices"]]
        faces = data["mesh_faces"].transpose("mesh_face", "corner").values[face : face + info["faces"]]
        found.append(StoredMesh(info["link"], info["colour"], vertices, faces))
        vertex, face = vertex + info["vertices"], face + info["faces"]
    return found


def _joined(parts: list[Any], kind: Any) -> NDArray[Any]:
    return np.concatenate(parts).astype(kind)


def _record(shape: LinkShape) -> dict[str, Any]:
    vertices, faces = shape.surface
    return {"link": shape.link, "colour": shape.colour, "vertices": len(vertices), "faces": len(faces)}


_FIRST, _STEP, _ROUNDS = 200, 0.8, 24
"""Cells along the longest side at first, and by which factor they get fewer until there are few enough triangles."""


def thinned(surface: Triangles, most: int) -> Triangles:
    """A surface of at most ``most`` triangles, or the coarsest of a few tries; triangles without area are dropped."""
    surface = _clustered(surface, 1e9)
    cells = float(_FIRST)
    found = surface
    for _ in range(_ROUNDS):
        if len(found.faces) <= most:
            return found
        found = _clustered(surface, cells)
        cells *= _STEP
    return found


def _clustered(surface: Triangles, cells: float) -> Triangles:
    low, size = surface.vertices.min(axis=0), np.ptp(surface.vertices, axis=0).max()
    if size == 0:
        return Triangles(surface.vertices[:1], np.zeros((0, 3), dtype=np.intp))
    keys = np.floor((surface.vertices - low) / size * cells).astype(np.int64)
    cell = ranks(keys)
    count = np.bincount(cell)
    means = np.column_stack([np.bincount(cell, surface.vertices[:, k]) for k in range(3)]) / count[:, None]
    faces = cell[surface.faces]
    a, b, c = faces.T
    faces = faces[(a != b) & (b != c) & (c != a)]
    least = np.argmin(faces, axis=1)
    turned = faces[np.arange(len(faces))[:, None], (least[:, None] + np.arange(3)) % 3]
    faces = turned[np.unique(ranks(turned), return_index=True)[1]]
    used, places = np.unique(faces, return_inverse=True)
    return Triangles(means[used], places.reshape(-1, 3))
