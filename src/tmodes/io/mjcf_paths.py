"""Look through an MJCF before MuJoCo opens it: no file outside the robot's folders, nothing without bound."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from tmodes.errors import InputError
from tmodes.io.mesh_paths import Folders
from tmodes.io.scalars import finite_float
from tmodes.io.words import shown
from tmodes.io.xml_file import Element, read_xml

__all__ = ["check_mjcf"]

FOLDER_KEYS = ("meshdir", "texturedir", "assetdir")
FILE_KEYS = ("file", "fileright", "fileleft", "fileup", "filedown", "filefront", "fileback")
NOT_BODIES = {"replicate", "composite", "flexcomp", "flex", "attach", "plugin", "extension"}
SIZES = ("nrow", "ncol", "width", "height", "size")
MOST = {"size": 1e6} | dict.fromkeys(("hfield", "texture", "numeric"), 8192.0)
MOST_FILES = 100


def check_mjcf(root: Element, folders: Folders) -> list[Element]:
    """The root elements of a model and of all that it includes.

    Raises :class:`tmodes.errors.InputError` for a path that leaves the folders and for elements that stand for
    unbounded numbers of others.
    """
    roots, waiting = [], [root]
    while waiting:
        element = waiting.pop()
        roots.append(element)
        if len(roots) > MOST_FILES:
            hint = "look for a file that includes itself"
            raise InputError("include", f"more than {MOST_FILES} files", f"at most {MOST_FILES}", hint, element.place)
        waiting.extend(_included(element, folders))
    bases = [folders.home, *(base for one in roots for base in _asset_folders(one, folders))]
    for one in roots:
        for element in one.within():
            _check(element, folders, bases)
    return roots


def _included(root: Element, folders: Folders) -> Iterator[Element]:
    """Roots of the files that are read as further models."""
    for element in root.within():
        if element.tag in {"include", "model"} and "file" in element.attributes:
            path = folders.find(element.attributes["file"], f"<{element.tag}>", element.place)
            if path is None:
                got = f"{shown(element.attributes['file'])}, which is not there"
                raise InputError(f"<{element.tag}>", got, "a file", "check the path", element.place)
            yield read_xml(path)


def _asset_folders(root: Element, folders: Folders) -> Iterator[Path]:
    for element in root.within():
        if element.tag == "compiler":
            for key in FOLDER_KEYS:
                if name := element.attributes.get(key, ""):
                    found = folders.find(name, f"compiler {key}", element.place)
                    yield found if found is not None else folders.home


def _check(element: Element, folders: Folders, bases: list[Path]) -> None:
    which = f"<{element.tag[:60]}>"
    if element.tag in NOT_BODIES:
        hint = "write the bodies and joints out"
        raise InputError(which, f"the element {which}", "bodies, joints, geoms and assets", hint, element.place)
    for key in FILE_KEYS:
        if name := element.attributes.get(key, ""):
            for base in bases:
                folders.find(name, f"{which} {key}", element.place, base)
    most = MOST.get(element.tag)
    for key, text in element.attributes.items() if most else ():
        if (key in SIZES or element.tag == "size") and (finite_float(text.strip()) or 0.0) > (most or 0.0):
            got, hint = f"{key} = {shown(text)}", "write a sensible size"
            raise InputError(which, got, f"at most {most:g}", hint, element.place)
