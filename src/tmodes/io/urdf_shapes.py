"""What the links of a URDF look like: boxes, cylinders, spheres and meshes, each placed in its link's frame."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tmodes.errors import InputError
from tmodes.io.mesh_file import Triangles, box, cylinder, read_mesh, sphere
from tmodes.io.urdf import UrdfRobot
from tmodes.io.words import shown
from tmodes.io.xml_file import Element
from tmodes.kinds.schema.axes import rpy_matrix

__all__ = ["LinkShape", "Unseen", "link_shapes"]

PLAIN = "#b4bec8"
"""The colour of what has none."""

READABLE = {".stl", ".obj"}
MOST_FACES = 1_000_000
"""Triangles of all shapes of a robot."""

MOST_SHAPES = 500

Read = Callable[[Path], Triangles]


class LinkShape(NamedTuple):
    """A surface of a link in the link's frame [m], and its colour ``#rrggbb``."""

    link: str
    colour: str
    surface: Triangles


class Unseen(NamedTuple):
    """A shape of a link that cannot be shown, and why."""

    link: str
    error: InputError

    def __str__(self) -> str:
        return f"a shape of link {self.link} is not shown: {self.error}"


def link_shapes(robot: UrdfRobot) -> tuple[list[LinkShape], list[Unseen]]:
    """The surfaces of all links, and those that cannot be shown.

    Of each link its visual shapes; where one is a file of another format than STL and OBJ, the collision shapes.
    """
    found: list[LinkShape] = []
    unseen: list[Unseen] = []
    faces, read = 0, _reading_once()
    for number, (name, shape, colour) in enumerate(_chosen(robot)):
        which = f"link {name}: {shape.tag}"
        if number == MOST_SHAPES or faces > MOST_FACES:
            most = f"{MOST_SHAPES} shapes" if number == MOST_SHAPES else f"{MOST_FACES:,} triangles"
            got, expected = "more, from this link on", f"at most {most} of all links"
            unseen.append(Unseen(name, shape.fault(which, got, expected, "simplify them")))
            break
        try:
            found.append(LinkShape(name, colour, _placed(shape, robot, which, read)))
            faces += len(found[-1].surface.faces)
        except InputError as error:
            unseen.append(Unseen(name, error))
    return found, unseen


def _chosen(robot: UrdfRobot) -> Iterator[tuple[str, Element, str]]:
    """Link, element and colour of each shape that is to be shown."""
    for name, element in robot.links.items():
        visual, collision = element.all("visual"), element.all("collision")
        colours = [_colour(shape, robot.root) for shape in visual] or [PLAIN]
        chosen = visual if visual and all(map(_is_readable, visual)) else collision or visual
        for index, shape in enumerate(chosen):
            yield name, shape, colours[min(index, len(colours) - 1)]


def _reading_once() -> Read:
    """Read a mesh, each file once: many shapes may be of one, and a damaged one takes as long as a whole one."""
    known: dict[Path, Triangles | InputError] = {}

    def read(path: Path) -> Triangles:
        if path not in known:
            try:
                known[path] = read_mesh(path)
            except InputError as error:
                known[path] = error
        surface = known[path]
        if isinstance(surface, InputError):
            raise surface
        return surface

    return read


def _is_readable(shape: Element) -> bool:
    files = [one.attributes.get("filename", "") for one in shape.within() if one.tag == "mesh"]
    return all(Path(file).suffix.lower() in READABLE for file in files)


def _placed(shape: Element, robot: UrdfRobot, which: str, read: Read) -> Triangles:
    geometry = shape.only("geometry", which)
    if geometry is None or len(geometry.children) != 1:
        raise shape.fault(which, "no geometry, or several", "<geometry> with one shape", "give each shape its own")
    surface = _surface(geometry.children[0], robot, which, read)
    a, b, c = (surface.vertices[surface.faces[:, k]] for k in range(3))
    if not np.cross(b - a, c - a).any():
        got, expected = "a surface without area", "lengths and scales other than 0"
        raise geometry.children[0].fault(which, got, expected, "write its size, or leave it out")
    origin = shape.origin(which)
    return Triangles(surface.vertices @ rpy_matrix(*origin["rpy"]).T + origin["position"], surface.faces)


def _surface(element: Element, robot: UrdfRobot, which: str, read: Read) -> Triangles:
    match element.tag:
        case "box":
            if "size" not in element.attributes:
                raise element.fault(which, "<box> without the attribute `size`", 'size="x y z"', "add it")
            return box(_positive(element, "size", which, element.triple("size", which)))
        case "cylinder":
            return cylinder(_length(element, "radius", which), _length(element, "length", which))
        case "sphere":
            return sphere(_length(element, "radius", which))
        case "mesh":
            return _mesh(element, robot, which, read)
    raise element.fault(which, f"<{element.tag[:40]}>", "box, cylinder, sphere or mesh", "use one of these shapes")


def _mesh(element: Element, robot: UrdfRobot, which: str, read: Read) -> Triangles:
    name = element.text("filename", which) if len(element.attributes.get("filename", "")) <= 100 else ""
    path = robot.folders.find(name or element.attributes["filename"].strip(), which, element.place)
    if path is None:
        raise element.fault(which, "a file that is not there", "the path of a mesh", "check the path, or give --root")
    scale = element.triple("scale", which) if "scale" in element.attributes else [1.0, 1.0, 1.0]
    surface = read(path)
    return Triangles(surface.vertices * scale, surface.faces)


def _length(element: Element, name: str, which: str) -> float:
    return _positive(element, name, which, [element.number(name, which)])[0]


def _positive(element: Element, name: str, which: str, lengths: list[float]) -> list[float]:
    if min(lengths) < 0:
        got = f"{name}={shown(element.attributes[name])}, which is negative"
        raise element.fault(which, got, "lengths in metres that are positive", "leave the minus sign out")
    return lengths


def _colour(shape: Element, root: Element) -> str:
    """Of its material, given there or by name at the top of the file."""
    material = shape.first("material")
    if material is None:
        return PLAIN
    named = [one for one in root.all("material") if one.attributes.get("name") == material.attributes.get("name")]
    for color in filter(None, (one.first("color") for one in (material, *named))):
        words = color.attributes.get("rgba", "").split()
        try:
            red, green, blue = (round(255 * min(max(float(word), 0.0), 1.0)) for word in words[:3])
        except ValueError:
            continue
        return f"#{red:02x}{green:02x}{blue:02x}"
    return PLAIN
