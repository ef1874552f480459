"""A Denavit-Hartenberg table as a robot's sheet: each row a joint and the link that it carries.

    format: 1
    kind: dh
    name: two_link
    convention: standard        # or modified (Craig), or paper; see tmodes.kinds.schema.frames.Convention
    rows:
      - {a: 0.3, alpha: 0, d: 0, theta: 0, bodies: [...], limits: {...}, motor: {...}, gear: {...}}
      - {a: 0.2, alpha: 0, d: 0, theta: 0, type: prismatic, name: slide, link: rod}

A row's name is ``joint_1`` and its link's ``link_1`` (counted from 1) unless it says otherwise; a joint is revolute
unless it says otherwise. Every other group of a sheet (loads, drives, tip, ...) may stand next to the rows.
"""

from __future__ import annotations

import copy
from collections.abc import Mapping
from typing import Any

from tmodes.errors import InputError, InputErrors
from tmodes.io.words import meant, shown
from tmodes.io.yaml_file import Positions, nearest_line
from tmodes.kinds.schema.frames import Convention

__all__ = ["sheet_of_table"]

NUMBERS = ("a", "alpha", "d", "theta")
OF_JOINT = ("type", "state", "locked_at", "limits", "friction", "motor", "gear", "spring")
OF_LINK = ("bodies", "beam")
KEYS = ("name", "link", *NUMBERS, *OF_JOINT, *OF_LINK)
OWN = ("kind", "convention", "rows")


def sheet_of_table(data: Mapping[str, Any], positions: Positions, source: str = "") -> tuple[dict[str, Any], Positions]:
    """Data and positions of a table's sheet, the numbers as they are written; InputErrors for a table that is none."""
    wrong = [InputError(*fault, f"{source}:{nearest_line(fault[0], positions, 1)}") for fault in _faults(data)]
    if wrong:
        raise InputErrors(wrong)
    sheet = {key: copy.deepcopy(value) for key, value in data.items() if key not in OWN}
    sheet |= {"kind": "arm", "joints": [], "links": []}
    lines = {path: line for path, line in positions.items() if path.partition(".")[0] not in OWN}
    for index, row in enumerate(data["rows"], start=1):
        _add(sheet, copy.deepcopy(row), index, data["convention"])
    for path, line in positions.items():
        if path.startswith("rows"):
            lines |= dict.fromkeys(_moved(path, data["rows"], sheet["links"]), line)
    return sheet, lines


def _faults(data: Mapping[str, Any]) -> list[tuple[str, str, str, str]]:
    conventions = [str(one) for one in Convention]
    faults = []
    if data.get("convention") not in conventions:
        got = shown(data.get("convention"))
        faults.append(("convention", got, f"one of {', '.join(conventions)}", f"write `convention: {conventions[0]}`"))
    rows = data.get("rows")
    if not isinstance(rows, list) or not rows:
        hint = "write one row for each joint, starting with `- `"
        return [*faults, ("rows", shown(rows), "a list of rows", hint)]
    faults += [
        (key, f"{key} next to `rows`", "rows alone", f"move what it says into the rows, and remove `{key}`")
        for key in ("joints", "links")
        if key in data
    ]
    for index, row in enumerate(rows):
        faults += _row_faults(f"rows.{index}", row)
    return faults


def _row_faults(which: str, row: Any) -> list[tuple[str, str, str, str]]:
    if not isinstance(row, dict):
        return [(which, shown(row), "a group with a, alpha, d, theta", "write {a: 0.3, alpha: 0, d: 0, theta: 0}")]
    faults = [
        (f"{which}.{key}", "nothing", "a number", f"add `{key}: ...`, 0 where there is none")
        for key in NUMBERS
        if key not in row
    ]
    for key in row:
        if key not in KEYS:
            hint = meant(str(key), KEYS, "remove it")
            faults.append((f"{which}.{key}", "an unknown key", f"one of {', '.join(KEYS)}", hint))
    return faults


def _add(sheet: dict[str, Any], row: dict[str, Any], index: int, convention: str) -> None:
    parent = sheet["joints"][-1]["child"] if sheet["joints"] else "base"
    link = row.get("link", f"link_{index}")
    joint = {"name": row.get("name", f"joint_{index}"), "type": "revolute", "parent": parent, "child": link}
    joint["dh"] = {"convention": convention} | {key: row[key] for key in NUMBERS}
    sheet["joints"].append(joint | {key: row[key] for key in OF_JOINT if key in row})
    if inside := {key: row[key] for key in OF_LINK if key in row}:
        sheet["links"].append({"name": link} | inside)


def _moved(path: str, rows: list[dict[str, Any]], links: list[dict[str, Any]]) -> list[str]:
    """Where the sheet holds what stood at a path of the table: every line of a row is one of its joint too."""
    _, _, rest = path.partition(".")
    index, _, inner = rest.partition(".")
    if not rest:
        return ["joints", "links"]
    joint, key = f"joints.{index}", inner.partition(".")[0]
    if key in NUMBERS:
        return [f"{joint}.dh.{inner}"]
    if key not in OF_LINK:
        return [f"{joint}.{inner}" if inner else joint]
    name = rows[int(index)].get("link", f"link_{int(index) + 1}")
    place = next(number for number, link in enumerate(links) if link["name"] == name)
    return [f"links.{place}.{inner}"]
