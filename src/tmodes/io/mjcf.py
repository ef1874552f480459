"""Read an MJCF into the plain data of an arm's sheet, by way of MuJoCo's own compiler (an extra that is installed).

Bodies and their inertias, hinges and slides with limits, armature, damping and dry friction are read. A spring on a
joint that nothing drives becomes an elastic gear with a locked motor. Ball and free joints, constraints and tendons
are refused: they are no part of a tree of joints with one axis. Geometry, contacts and actuators' laws are left out.
Format: https://mujoco.readthedocs.io/en/stable/XMLreference.html.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from importlib import import_module
from typing import Any

from tmodes.errors import InputError
from tmodes.io.mesh_paths import Folders, folders_of
from tmodes.io.mjcf_body import arm_of_model
from tmodes.io.mjcf_paths import check_mjcf
from tmodes.io.words import shown, shown_path
from tmodes.io.xml_file import Element, read_xml
from tmodes.io.yaml_file import Positions

__all__ = ["arm_of_mjcf", "read_mjcf"]

UNTOLD = "a model with {}, which no tree of joints with one axis has"


def read_mjcf(
    path: str | os.PathLike[str], roots: Sequence[str | os.PathLike[str]] = (), trust_paths: bool = False
) -> tuple[dict[str, Any], Positions]:
    """Data and positions of the sheet of an MJCF file.

    Raises :class:`tmodes.errors.InputError` for a broken model, one that is more than an arm, a path that leaves the
    folders, and where MuJoCo is not installed.
    """
    return arm_of_mjcf(path, read_xml(path), roots, trust_paths)


def arm_of_mjcf(
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
    return arm_of_model(model, _name(root), lines, source)


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
