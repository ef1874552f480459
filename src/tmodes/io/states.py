"""Read states at which equations are to be evaluated: JSON records, or a table (CSV), of numbers by name.

Of a sheet of the 2010 robot also records of its angles phi, their speeds phid and the motor's voltage u.
"""

from __future__ import annotations

import csv
import json
import math
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.io.files import read_bytes
from tmodes.io.filipovic2010.importer import COORDINATES
from tmodes.io.words import meant, shown, shown_path
from tmodes.kinds.schema.quantity import LARGEST

__all__ = ["ChainStates", "States", "holds_phi", "read_phi_states", "read_states"]

Array = NDArray[np.float64]
Names = tuple[str, ...]
States = str | os.PathLike[str] | Sequence[Mapping[str, Any]]
"""Records of Python, or the name of a file of them."""

MOST_BYTES = 50_000_000
MOST_RECORDS = 100_000
MOST_BRACKETS = 4_000_000
MOST_NAMES = 12
"""Names listed in one message."""

PHI = ("phi", "phid", "u")
"""What a record of the 2010 robot must hold: angles [rad], angular velocities [rad/s], motor voltage [V]."""

ANSWERS = (
    *("reading", "H", "h", "f_el", "f_di", "Q", "tip", "J", "phidd", "F_tip_on_environment"),
    *("kinetic", "potential_gravity", "potential_elastic", "rayleigh", "energy"),
)
"""What it may hold next to it, and what is not read: another program's answers at that state."""

EXAMPLES = {
    PHI: 'write [{"phi": [...], "phid": [...], "u": 0.0}]',
    ("q",): 'write [{"q": {"shoulder": 0.3}, "v": {}, "effort": {}}]',
}


@dataclass(frozen=True, eq=False)
class ChainStates:
    """n states: ``q`` and ``v`` (n, coordinates) and ``effort`` (n, efforts), SI."""

    q: Array
    v: Array
    effort: Array


class _Repeated(dict[str, Any]):
    """An object of JSON in which a key stands twice."""

    key = ""


def read_phi_states(given: States, coordinates: Names = COORDINATES) -> list[dict[str, Any]]:
    """Records ``{phi, phid, u}`` that are given, or of a JSON file: a list of them, or ``{"states": [...]}``.

    ``phi`` [rad] and ``phid`` [rad/s] are lists of floats, one of each of the ``coordinates``, ``u`` [V] is a float.
    Raises :class:`tmodes.errors.InputError` that names the record and the field of the first wrong value.
    """
    data, source = _read(given)
    rows = _records(data, PHI, ANSWERS, source)
    return [
        {key: _block(row[key], coordinates, f"record {k}: {key}", source) for key in ("phi", "phid")}
        | {"u": _number(row["u"], f"record {k}: u", source)}
        for k, row in enumerate(rows)
    ]


def read_states(given: States, coordinates: Names, efforts: Names) -> ChainStates:
    """States that are given, or from a file, ``.csv`` or JSON.

    JSON: a list of records ``{"q": ..., "v": ..., "effort": ...}`` or ``{"states": [...]}``; each a list of all
    numbers, or numbers by name, where those that are not named are 0; v and effort may be left out. CSV: a column for
    each coordinate, ``NAME.rate`` and ``effort.JOINT``; a column that is missing is 0. Raises
    :class:`tmodes.errors.InputError` that names the record and the field of the first wrong value.
    """
    data, source = _read(given)
    rows = _records(data, ("q",), ("v", "effort"), source)
    blocks = {"q": coordinates, "v": coordinates, "effort": efforts}
    arrays = {
        key: np.array([_block(row.get(key, {}), names, f"record {k}: {key}", source) for k, row in enumerate(rows)])
        for key, names in blocks.items()
    }
    return ChainStates(**{key: array.reshape(len(rows), len(blocks[key])) for key, array in arrays.items()})


def holds_phi(given: States) -> bool:
    """Whether records, or those of a file, are in the coordinates of the 2010 robot and have no ``q``."""
    data, _ = _read(given)
    records = data.get("states", data) if isinstance(data, Mapping) else data
    first = records[0] if isinstance(records, list) and records else records
    return not isinstance(first, Mapping) or "q" not in first


def _read(given: States) -> tuple[Any, str]:
    """Plain data of records, or of a file, and what they are called in messages."""
    if not isinstance(given, str | os.PathLike):
        if not isinstance(given, Sequence) or not all(isinstance(one, Mapping) for one in given):
            raise InputError("states", shown(given), "a list of records, or a file of them", EXAMPLES["q",])
        return [{key: _plain(value) for key, value in one.items()} for one in given], "states"
    source, content = shown_path(given), read_bytes(given, MOST_BYTES)
    return (_table if str(given).lower().endswith(".csv") else _parsed)(content, source), source


def _plain(value: Any) -> Any:
    """Arrays, also of a group, as lists and numbers."""
    if isinstance(value, Mapping):
        return {str(name): _plain(one) for name, one in value.items()}
    return value.tolist() if hasattr(value, "tolist") else value


def _parsed(content: bytes, source: str) -> Any:
    """JSON of a file that may be hostile; raises :class:`tmodes.errors.InputError` that says the line."""
    if content.count(b"[") + content.count(b"{") > MOST_BRACKETS:
        most = f"at most {MOST_BRACKETS} lists and objects"
        raise InputError("the file", "a flood of brackets", most, "check that this is the file you mean", source)
    hint = "look there for a missing quote, bracket or comma"
    try:
        return json.loads(content.decode("utf-8-sig"), object_pairs_hook=_object)
    except json.JSONDecodeError as error:
        where = f"{source}:{error.lineno}"
        raise InputError("the file", f"broken JSON ({error.msg})", "JSON", hint, where) from None
    except UnicodeDecodeError:
        got, hint = "bytes that are not UTF-8", "save the file as UTF-8 text"
        raise InputError("the file", got, "text in UTF-8", hint, source) from None
    except RecursionError:
        got, hint = "lists or objects nested too deep", "remove brackets"
        raise InputError("the file", got, "a list of flat records", hint, source) from None
    except ValueError:  # an integer of more digits than Python converts
        got, hint = "a number of thousands of digits", "write sensible numbers"
        raise InputError("the file", got, "numbers that a double can hold", hint, source) from None


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    record = dict(pairs)
    if len(record) == len(pairs):
        return record
    repeated, seen = _Repeated(record), set[str]()
    repeated.key = next(key for key, _ in pairs if key in seen or seen.add(key))
    return repeated


def _records(data: Any, must: Names, may: Names, source: str) -> list[Mapping[str, Any]]:
    """The records of a file, each with the keys that it must and may have."""
    if isinstance(data, Mapping) and not set(must) & set(data):
        _check_keys(data, ("states",), (), "the file", source)
        data = data["states"]
    if not isinstance(data, list) or not data:
        got = "an empty list" if data == [] else "one record" if isinstance(data, Mapping) else shown(data)
        raise InputError("the file", got, "a list of records", EXAMPLES[must], source)
    if len(data) > MOST_RECORDS:
        raise InputError("the file", f"{len(data)} records", f"at most {MOST_RECORDS}", "split the file", source)
    for k, record in enumerate(data):
        if not isinstance(record, Mapping):
            expected = f"a record with the keys {', '.join(must)}"
            raise InputError(f"record {k}", shown(record), expected, EXAMPLES[must], source)
        _check_keys(record, must, may, f"record {k}", source)
        for key in record.keys() & set(ANSWERS):  # not read, but a file that holds NaN or infinity is no JSON
            if any(isinstance(value, float) and not math.isfinite(value) for value in _leaves(record[key])):
                hint = "write finite ones, or leave the field out"
                raise InputError(f"record {k}: {key}", "one that is not finite", "finite numbers", hint, source)
    return data


def _check_keys(record: Mapping[str, Any], must: Names, may: Names, which: str, source: str) -> None:
    if isinstance(record, _Repeated):
        name = shown(record.key)
        raise InputError(f"{which}: {name}", "a key that stands twice", "given once", "remove one", source)
    for key in record:
        if key not in (*must, *may):
            raise _unknown(f"{which}: {shown(key)}", "an unknown key", key, (*must, *may), source)
    for key in must:
        if key not in record:
            raise InputError(f"{which}: {key}", "nothing", f"the key `{key}`", f"add `{key}`", source)


def _unknown(which: str, got: str, name: str, names: Names, source: str) -> InputError:
    return InputError(which, got, f"one of {_few(names)}", meant(name, names, "remove it"), source)


def _few(names: Iterable[str]) -> str:
    info = list(names)
    return ", ".join(info[:MOST_NAMES]) + (", ..." if len(info) > MOST_NAMES else "")


def _block(values: Any, names: Names, which: str, source: str) -> list[float]:
    """Numbers in the order of ``names``, given as a list or by name."""
    if isinstance(values, Mapping):
        for name in values:
            if name not in names:
                raise _unknown(which, shown(name), name, names, source)
        values = [values.get(name, 0.0) for name in names]
    if not isinstance(values, list) or len(values) != len(names):
        expected = f"a list of {len(names)} numbers, or numbers by name"
        raise InputError(which, shown(values), expected, f"the names are {_few(names)}", source)
    return [_number(value, f"{which}: {name}", source) for name, value in zip(names, values, strict=True)]


def _number(value: Any, which: str, source: str) -> float:
    if type(value) in (float, int) and -LARGEST <= value <= LARGEST:
        return float(value)
    expected = f"a number of magnitude at most {LARGEST:g}"
    raise InputError(which, shown(value), expected, "write a finite number, SI", source)


def _leaves(value: Any) -> Iterator[Any]:
    if isinstance(value, list):
        for item in value:
            yield from _leaves(item)
    else:
        yield value


def _table(content: bytes, source: str) -> list[Mapping[str, Any]]:
    """Rows of a table as records by name."""
    try:
        lines = content.decode("utf-8-sig").splitlines()
    except UnicodeDecodeError:
        raise InputError("the file", "bytes that are not UTF-8", "text in UTF-8", "save it as UTF-8", source) from None
    rows = [row for row in csv.reader(lines) if any(cell.strip() for cell in row)]
    head = [cell.strip() for cell in rows[0]] if rows else []
    if len(set(head)) < len(head):
        got, expected = "a name that stands twice", "a list of different names"
        raise InputError("the first line", got, expected, "remove one column", source)
    return [_record(head, row, number, source) for number, row in enumerate(rows[1:])]


def _record(head: list[str], row: list[str], number: int, source: str) -> dict[str, dict[str, float]]:
    if len(row) != len(head):
        expected = f"{len(head)} cells, as in the first line"
        raise InputError(f"record {number}", f"{len(row)} cells", expected, "complete the line", source)
    record: dict[str, dict[str, float]] = {"q": {}, "v": {}, "effort": {}}
    for name, cell in zip(head, row, strict=True):
        key = "effort" if name.startswith("effort.") else "v" if name.endswith(".rate") else "q"
        try:
            record[key][name.removeprefix("effort.") if key == "effort" else name.removesuffix(".rate")] = float(cell)
        except ValueError:
            which = f"record {number}: {name}"
            raise InputError(which, shown(cell), "a number", "write a number, SI", source) from None
    return record
