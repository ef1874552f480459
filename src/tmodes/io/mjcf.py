"""Look through an MJCF before MuJoCo opens it: no file outside the robot's folders, nothing without bound."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

from tmodes.errors import InputError
from tmodes.io.mesh_paths import Folders, folders_of
from tmodes.io.mjcf_body import sheet_of_model
from tmodes.io.scalars import finite_float
from tmodes.io.words import shown, shown_path
from tmodes.io.xml_file import Element, read_xml
from tmodes.io.yaml_file import Positions

__all__ = ["check_mjcf", "read_mjcf", "sheet_of_mjcf"]

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


UNTOLD = "a model with {}, which no tree of joints with one axis has"


def read_mjcf(
    path: str | os.PathLike[str], roots: Sequence[str | os.PathLike[str]] = (), trust_paths: bool = False
) -> tuple[dict[str, Any], Positions]:
    """Data and positions of the sheet of an MJCF file.

    Raises :class:`tmodes.errors.InputError` for a broken model, one that is more than a robot, a path that leaves the
    folders, and where MuJoCo is not installed.
    """
    return sheet_of_mjcf(path, read_xml(path), roots, trust_paths)


def sheet_of_mjcf(
    path: str | os.PathLike[str],
    root: Element,
    roots: Sequence[str | os.PathLike[str]] = (),
    trust_paths: bool = False,
) -> tuple[dict[str, Any], Positions]:
    """The same of an MJCF file whose root element is read already; see :func:`read_mjcf`."""
    if root.tag != "mujoco":
        raise InputError("the root element", f"<{root.tag[:60]}>", "<mujoco>", "check that this is MJCF", root.place)
    folders = folders_of(path, roots, trust_paths)
    elements = check_mjcf(root, folders)
    source = shown_path(path)
    model = _compiled(path, source, folders)
    _refuse_more(model, source)
    lines = {
        (element.tag, element.attributes["name"]): element.line
        for one in elements
        if one.source == source
        for element in one.within()
        if element.tag in {"body", "joint"} and "name" in element.attributes
    }
    return sheet_of_model(model, _name(root), lines, source)


def _name(root: Element) -> str:
    return root.attributes.get("model", "").strip()[:100] or "mjcf"


def _compiled(path: str | os.PathLike[str], source: str, folders: Folders) -> Any:
    try:
        mujoco: Any = import_module("mujoco")  # its binary module has no types
    except ImportError:
        hint = "install it with `pip install tmodes[peers]`, or write the arm as URDF"
        raise InputError(source, "no MuJoCo", "read with MuJoCo", hint) from None
    try:
        return mujoco.MjModel.from_xml_path(str(folders.home / os.path.basename(path)))  # noqa: PTH119 (bytes paths)
    except ValueError as error:
        got = f"a model that MuJoCo refuses ({shown(' '.join(str(error).split()))})"
        raise InputError("the model", got, "a valid MJCF", "correct what MuJoCo reports", source) from None


def _refuse_more(model: Any, source: str) -> None:
    more = {"equality constraints": model.neq, "tendons": model.ntendon, "mocap bodies": model.nmocap}
    for what, count in more.items():
        if count:
            hint = "remove them, or model the mechanism as an open tree"
            raise InputError("the model", UNTOLD.format(what), "bodies and joints alone", hint, source)
