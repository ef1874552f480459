"""Files of shapes that an MJCF names: which of them MuJoCo may open, and the model without the others.

A mesh or texture that is not there, or outside of the robot's folders, is left out before MuJoCo opens any: no motion
depends on it where its body has an inertia of its own, and where it has none, that is an error.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from tmodes.errors import InputError
from tmodes.io.files import Folders
from tmodes.io.unread import few
from tmodes.io.words import shown
from tmodes.io.xml_file import Element

__all__ = ["FILE_KEYS", "SHAPES", "Assets", "without_unread"]

SHAPES = ("mesh", "texture", "skin")
"""Elements whose files are of shapes or looks."""

FILE_KEYS = ("file", "fileright", "fileleft", "fileup", "filedown", "filefront", "fileback")

TRUE = 1
"""Of the compiler's inertiafromgeom: geoms count also where a body says its inertia."""


@dataclass
class Assets:
    """Names of files that may be opened, and those that may not or are not there, each with its reason."""

    allowed: set[str] = field(default_factory=set)
    unread: dict[str, str] = field(default_factory=dict)

    def note(self, element: Element, folders: Folders, bases: Sequence[Path | InputError]) -> None:
        """Look for the files of an element; ``bases``: folders they may start at, or why one of these may not be."""
        for key in FILE_KEYS:
            if name := element.attributes.get(key, ""):
                try:
                    if closed := next((base for base in bases if isinstance(base, InputError)), None):
                        raise closed
                    starts = [base for base in bases if isinstance(base, Path)]
                    found = [folders.find(name, f"{element.label} {key}", element.place, base) for base in starts]
                except InputError as error:
                    self.unread[name] = error.got
                else:
                    if any(found):
                        self.allowed.add(name)
                    else:
                        self.unread[name] = f"{shown(name)}, which is not there"

    def notices(self) -> list[str]:
        """A sentence on what is not read; empty where all is."""
        names = few([why if name in why else f"{shown(name)} ({why})" for name, why in self.unread.items()])
        return (
            [f"Shapes whose files may not be read are left out: {names}; give their folder with --root."]
            if names
            else []
        )


def without_unread(mujoco: Any, path: str, allowed: Iterable[str], source: str) -> Any:
    """The compiled model without all meshes, textures and skins whose files are none of the ``allowed``.

    Raises :class:`tmodes.errors.InputError` for a body whose mass is that of such a mesh, and what MuJoCo raises.
    """
    spec, allowed = mujoco.MjSpec.from_file(path), {*allowed, ""}
    meshes = {mesh.name for mesh in spec.meshes if mesh.file not in allowed}
    for geom in [geom for geom in spec.geoms if geom.meshname and geom.meshname in meshes]:
        body, weightless = geom.parent, geom.mass == 0 or (np.isnan(geom.mass) and geom.density == 0)
        if (
            not weightless
            and (spec.compiler.inertiafromgeom == TRUE or not body.explicitinertial)
            and body.name != "world"
        ):
            got = f"the mass of a mesh that may not be read ({shown(geom.meshname)})"
            raise InputError(f"body {shown(body.name)}", got, "an inertia of its own", "add <inertial>", source)
        spec.delete(geom)
    textures = {texture.name for texture in spec.textures if not {texture.file, *texture.cubefiles} <= allowed}
    for material in [one for one in spec.materials if textures & {*one.textures}]:
        material.textures = ["" if name in textures else name for name in material.textures]
    for group, bad in ((spec.meshes, meshes), (spec.textures, textures)):
        for one in [one for one in group if one.name in bad]:
            spec.delete(one)
    for skin in [skin for skin in spec.skins if skin.file not in allowed]:
        spec.delete(skin)
    return spec.compile()
