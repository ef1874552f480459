"""Read states of an arm at which its equations are to be evaluated: JSON records or a table (CSV) of coordinates."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.io.files import read_bytes
from tmodes.io.states import MOST_BYTES, check_keys, is_number, parsed_json
from tmodes.io.words import nearest, shown, shown_path

__all__ = ["ChainStates", "read_arm_states"]

Array = NDArray[np.float64]
Names = tuple[str, ...]

MOST_RECORDS = 100_000

_KEYS = ("q", "v", "effort")
_EXAMPLE = '[{"q": {"shoulder": 0.3}, "v": {}, "effort": {}}]'


@dataclass(frozen=True, eq=False)
class ChainStates:
    """n states: ``q`` and ``v`` (n, coordinates) and ``effort`` (n, efforts), SI."""

    q: Array
    v: Array
    effort: Array


def read_arm_states(path: str, coordinates: Names, efforts: Names) -> ChainStates:
    """States from a file, ``.csv`` or JSON.

    JSON: a list of records ``{"q": ..., "v": ..., "effort": ...}`` or ``{"states": [...]}``; each a list of all
    numbers, or numbers by name, where those that are not named are 0; v and effort may be left out. CSV: a column for
    each coordinate, ``NAME.rate`` and ``effort.JOINT``; a column that is missing is 0. Raises
    :class:`tmodes.errors.InputError` that names the record and the field of the first wrong value.
    """
    source = shown_path(path)
    content = read_bytes(path, MOST_BYTES)
    rows = (
        _table(content, source)
        if Path(path).suffix.lower() == ".csv"
        else _listed(parsed_json(content, source), source)
    )
    if not 0 < len(rows) <= MOST_RECORDS:
        expected = f"1 to {MOST_RECORDS} states"
        raise InputError("the file", f"{len(rows)} states", expected, f"write {_EXAMPLE}", source)
    blocks = {"q": coordinates, "v": coordinates, "effort": efforts}
    arrays = {
        key: np.array([_block(row.get(key, {}), names, f"record {k}: {key}", source) for k, row in enumerate(rows)])
        for key, names in blocks.items()
    }
    return ChainStates(**{key: array.reshape(len(rows), len(blocks[key])) for key, array in arrays.items()})


def _listed(data: Any, source: str) -> list[Mapping[str, Any]]:
    if isinstance(data, Mapping) and "states" in data:
        data = data["states"]
    if not isinstance(data, list):
        raise InputError("the file", shown(data), "a list of records", f"write {_EXAMPLE}", source)
    for k, record in enumerate(data):
        if not isinstance(record, Mapping):
            raise InputError(f"record {k}", shown(record), "a record with the key q", f"write {_EXAMPLE}", source)
        check_keys(record, ("q",), _KEYS[1:], f"record {k}", source)
    return data


def _block(values: Any, names: Names, which: str, source: str) -> list[float]:
    """Numbers in the order of ``names``, given as a list or by name."""
    if isinstance(values, Mapping):
        for name in values:
            if name not in names:
                raise _unknown(which, name, names, source)
        values = [values.get(name, 0.0) for name in names]
    if not isinstance(values, list) or len(values) != len(names):
        got = f"a list of {len(values)}" if isinstance(values, list) else shown(values)
        expected = f"{len(names)} numbers, or numbers by name"
        raise InputError(which, got, expected, f"the names are {_few(names)}", source)
    for name, value in zip(names, values, strict=True):
        if not is_number(value):
            raise InputError(f"{which}: {name}", shown(value), "a finite number", "write a number, SI", source)
    return [float(value) for value in values]


def _unknown(which: str, name: str, names: Names, source: str) -> InputError:
    close = nearest(name, names)
    hint = f"did you mean `{close}`?" if close else "take one of these"
    return InputError(which, shown(name), f"one of {_few(names)}", hint, source)


def _few(names: Iterable[str]) -> str:
    info = list(names)
    return ", ".join(info[:12]) + (", ..." if len(info) > 12 else "")


def _table(content: bytes, source: str) -> list[Mapping[str, Any]]:
    """Rows of a table as records by name."""
    try:
        lines = content.decode("utf-8-sig").splitlines()
    except UnicodeDecodeError:
        raise InputError("the file", "bytes that are not UTF-8", "text in UTF-8", "save it as UTF-8", source) from None
    rows = [row for row in csv.reader(lines) if any(cell.strip() for cell in row)]
    if not rows:
        return []
    head = [cell.strip() for cell in rows[0]]
    if len(set(head)) < len(head):
        raise InputError(
            "the first line", "a name that stands twice", "a list of different names", "remove one column", source
        )
    return [_record(head, row, number, source) for number, row in enumerate(rows[1:])]


def _record(head: list[str], row: list[str], number: int, source: str) -> dict[str, dict[str, float]]:
    if len(row) != len(head):
        expected = f"{len(head)}, as in the first line"
        raise InputError(f"record {number}", f"{len(row)} cells", expected, "complete the line", source)
    record: dict[str, dict[str, float]] = {"q": {}, "v": {}, "effort": {}}
    for name, cell in zip(head, row, strict=True):
        if name.startswith("effort."):
            key, own = "effort", name.removeprefix("effort.")
        elif name.endswith(".rate"):
            key, own = "v", name.removesuffix(".rate")
        else:
            key, own = "q", name
        try:
            record[key][own] = float(cell)
        except ValueError:
            which = f"record {number}: {name}"
            raise InputError(which, shown(cell), "a number", "write a number, SI", source) from None
    return record
