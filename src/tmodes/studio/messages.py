"""Errors as the page gets them: of each wrong value its path, what was got, what is expected, and how to fix it."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from typing import Any

from tmodes.errors import InputError, InputErrors, TmodesError
from tmodes.io.files import ALLOW
from tmodes.io.urdf_shapes import Unseen
from tmodes.studio.folders import NameTaken

__all__ = ["as_sent", "error_record", "error_records", "unseen_records"]

MOST = 100

FOLDER = "choose the folder that holds them both"
"""How a page lets a file lie elsewhere."""


def error_records(error: TmodesError, data: Any = None) -> list[dict[str, Any]]:
    """Each wrong value of an error as plain data; ``data`` is the sheet in which their paths lead.

    ``steps`` are the keys and numbers of the path in the plain data, None where it leads nowhere; ``where`` is the file
    and line. Errors of one sentence have only a ``message``.
    """
    if isinstance(error, InputErrors):
        return [_record(one, data) for one in error.errors[:MOST]]
    if isinstance(error, InputError):
        return [_record(error, data)]
    return [error_record("", str(error)) | {"kind": "exists" if isinstance(error, NameTaken) else ""}]


def error_record(path: str, message: str, got: str = "", expected: str = "", hint: str = "") -> dict[str, Any]:
    """One error as plain data; its ``kind`` is empty but for what a page offers a button for."""
    return {"path": path, "message": message, "got": got, "expected": expected, "hint": hint, "where": "",
            "steps": None, "kind": ""}  # fmt: skip


def unseen_records(reasons: Iterable[Unseen | TmodesError], data: Any, roots: Sequence[str]) -> list[dict[str, Any]]:
    """Why shapes of links are not shown, each at its link of the sheet's plain ``data``; ``roots`` are not reported."""
    found = []
    for reason in reasons:
        error = reason.error if isinstance(reason, Unseen) else reason
        if isinstance(error, InputError):
            error = as_sent(error, roots)
        [info, *_] = error_records(error, data)
        path = info["path"]
        if isinstance(reason, Unseen):  # a damaged file is reported at the link that shows it
            path, info["where"] = f"links.{reason.link}", info["where"] or path
        message = f"a shape is not shown: {info['message']}"
        found.append(info | {"path": path, "message": message, "steps": _steps(path, data)})
    return found[:MOST]


def as_sent(error: InputError, roots: Sequence[str]) -> InputError:
    """The error with files named as they are within ``roots``, and what fixes it in a page instead of a terminal."""

    def own(text: str) -> str:
        for root in roots:
            text = text.replace(f"{root}{os.sep}", "").replace(root, "the folder of the robot's file")
        return text

    hint = own(error.hint).replace(ALLOW, FOLDER).replace("or give --root", "or choose that file too")
    return InputError(own(error.which), own(error.got), own(error.expected), hint, own(error.where))


def _record(error: InputError, data: Any) -> dict[str, Any]:
    message = f"got {error.got}, expected {error.expected}"
    info = error_record(error.which, message, error.got, error.expected, error.hint)
    return info | {"where": error.where, "steps": _steps(error.which, data)}


def _steps(path: str, data: Any) -> list[str | int] | None:
    """The steps of a path with names of joints and links in it; the words of ``real`` hold dots themselves."""
    if not isinstance(data, dict) or not path:
        return None
    group, _, inner = path.partition(".")
    if group == "real" and inner:
        return [group, inner]
    from tmodes.io.sheet_paths import steps_of

    try:
        return steps_of(path, data)
    except InputError:
        return None
