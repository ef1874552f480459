"""Errors as the page gets them: of each wrong value its path, what was got, what is expected, and how to mend it."""

from __future__ import annotations

from typing import Any

from tmodes.errors import InputError, InputErrors, TmodesError

__all__ = ["told_error", "told_errors"]

MOST = 100


def told_errors(error: TmodesError, data: Any = None) -> list[dict[str, Any]]:
    """Each wrong value of an error as plain data; ``data`` is the sheet in which their paths lead.

    ``steps`` are the keys and numbers of the path in the plain data, None where it leads nowhere; ``where`` is the file
    and line. Errors of one sentence have only a ``message``.
    """
    if isinstance(error, InputErrors):
        return [_told(one, data) for one in error.errors[:MOST]]
    if isinstance(error, InputError):
        return [_told(error, data)]
    return [told_error("", str(error))]


def told_error(path: str, message: str, got: str = "", expected: str = "", mend: str = "") -> dict[str, Any]:
    """One error as plain data."""
    return {"path": path, "message": message, "got": got, "expected": expected, "mend": mend, "where": "",
            "steps": None}  # fmt: skip


def _told(error: InputError, data: Any) -> dict[str, Any]:
    message = f"got {error.got}; expected {error.expected}"
    told = told_error(error.which, message, error.got, error.expected, error.mend)
    return told | {"where": error.where, "steps": _steps(error.which, data)}


def _steps(path: str, data: Any) -> list[str | int] | None:
    """The steps of a path with names of joints and links in it; the words of ``real`` hold dots themselves."""
    if not isinstance(data, dict) or not path:
        return None
    group, _, inner = path.partition(".")
    if group == "real" and inner:
        return [group, inner]
    if data.get("kind") != "arm":
        return [int(word) if word.isdecimal() else word for word in path.split(".")]
    from tmodes.io.arm_paths import steps_of

    try:
        return steps_of(path, data)
    except InputError:
        return None
