"""Which of several files is the robot's own."""

from __future__ import annotations

import re
from collections.abc import Mapping

from tmodes.errors import InputError

__all__ = ["main_file"]

KINDS = ((".yaml", ".yml"), (".urdf",), (".urdf.xacro", ".xacro"), (".xml",))
"""Endings of a robot's own file; where there are several kinds, the first in this order is meant."""

SHEET = re.compile(rb"^\s*[\"']?(urdf|kind|format)[\"']?\s*:", re.MULTILINE)
"""What reports a data sheet from the other YAML files of a package of models."""


def main_file(contents: Mapping[str, bytes]) -> str:
    """The robot's own file among those of an upload, by their names: of its kind the one that lies highest.

    Raises :class:`tmodes.errors.InputError` where none may be it, or several may.
    """
    able = [name for name in contents if name.lower().endswith(sum(KINDS, ())) and not name.endswith("package.xml")]
    sheets = [name for name in able if not name.lower().endswith(KINDS[0]) or SHEET.search(contents[name])]
    for kind in KINDS:
        alike = [name for name in sheets or able if name.lower().endswith(kind)]
        if alike:
            return _highest(alike)
    got = ", ".join(list(contents)[:5])
    expected = f"a file with the ending {', '.join(ending for kind in KINDS for ending in kind)}"
    raise InputError("files", got, expected, "choose the robot's own file too")


def _highest(alike: list[str]) -> str:
    """The one that lies highest; of files for xacro the one that names its result in its ending."""
    least = min(name.count("/") for name in alike)
    found = [name for name in alike if name.count("/") == least]
    if len(whole := [name for name in found if name.lower().endswith(".urdf.xacro")]) == 1:
        return whole[0]
    if len(found) > 1:
        got = f"several files that may be the robot's own: {', '.join(sorted(found)[:5])}"
        raise InputError("files", got, "one of them", "choose one, and what it names, but not the others")
    return found[0]
